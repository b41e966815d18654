// What all CGAL drivers share: the clock and the repetition rule.
#pragma once

#include <time.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

// CPU time of this process: the machine may be shared, and no driver uses a second thread.
inline double cpu_seconds() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

inline double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

// Repeats `run` in a warm process, at least `least` times and for about `budget` seconds; `run` returns the times of its
// phases, of which only the first `counted` make the total.
struct Samples {
  std::vector<std::vector<double>> phases;
  std::vector<double> totals;
};

template <class Run>
Samples repeat(std::size_t least, double budget, std::size_t counted, Run&& run) {
  Samples samples;
  const double start = cpu_seconds();
  while (samples.totals.size() < least || (cpu_seconds() - start < budget && samples.totals.size() < 2000)) {
    const std::vector<double> phases = run();
    samples.phases.resize(phases.size());
    for (std::size_t i = 0; i < phases.size(); ++i) samples.phases[i].push_back(phases[i]);
    samples.totals.push_back(std::accumulate(phases.begin(), phases.begin() + static_cast<long>(counted), 0.0));
  }
  return samples;
}
