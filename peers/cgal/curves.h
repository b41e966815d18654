// What the CGAL drivers of arrangements share: the reader of curves, the report, and the operations for any traits class.
#pragma once

#include <CGAL/Arr_batched_point_location.h>
#include <CGAL/Arr_default_overlay_traits.h>
#include <CGAL/Arr_overlay_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/version.h>

#include <sys/resource.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "measure.h"

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

// One line of a file of curves: its first word, and the numbers that follow.
struct Line {
  std::string kind;
  std::vector<std::int64_t> numbers;

  // Coordinates of up to 53 bits are doubles.
  double at(std::size_t index) const { return static_cast<double>(numbers.at(index)); }
};

// All lines, and the hash of all numbers in order, which names the input.
struct Lines {
  std::vector<Line> lines;
  std::uint64_t hash = 0xcbf29ce484222325ULL;
};

inline Lines read_lines(const std::string& name) {
  std::ifstream file(name);
  if (!file) throw std::runtime_error("cannot open " + name);
  Lines r;
  const auto fold = [&](std::int64_t value) {
    r.hash = (r.hash ^ static_cast<std::uint64_t>(value)) * 0x100000001B3ULL;
  };
  for (std::string text; std::getline(file, text);) {
    std::istringstream words(text);
    Line line;
    words >> line.kind;
    for (std::int64_t value; words >> value;) {
      fold(value);
      line.numbers.push_back(value);
    }
    r.lines.push_back(std::move(line));
  }
  return r;
}

// The point of that number on a line, in the plane.
inline Epeck::Point_2 kernel_point(const Line& line, std::size_t index) {
  return {line.at(2 * index), line.at(2 * index + 1)};
}

// What models of curves in the plane have in common.
template <class Geometry>
struct Planar {
  using Traits = Geometry;
  using Arrangement = CGAL::Arrangement_2<Traits>;

  static typename Traits::Point_2 point(const Traits&, const Line& line) { return kernel_point(line, 0); }

  // Halfedges on the outer boundary.
  template <class Face>
  static std::size_t around(const Face& face) {
    if (face->is_unbounded()) return 0;
    std::size_t halfedges = 0;
    const auto first = face->outer_ccb();
    auto edge = first;
    do ++halfedges;
    while (++edge != first);
    return halfedges;
  }
};

// The largest resident set of this process so far. (The one of getrusage would count the process that started this one.)
inline long peak_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind("VmHWM:", 0) == 0) return 1024 * std::stol(line.substr(6));
  throw std::runtime_error("peak memory needs Linux");
}

inline double user_seconds() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

// What was found and what it cost, printed as one JSON object on one line.
struct Answer {
  std::size_t vertices = 0, edges = 0, faces = 0;
  bool is_location = false;
  // Vertices, edges and faces where points were located or that curves met, each as often as it was found, and the lengths of
  // the boundaries of these faces, as the model measures them, added up.
  std::size_t on_vertices = 0, on_edges = 0, in_faces = 0, around = 0;
  // How many of the points the time is for, if not for all.
  std::size_t asked = 0;
  std::uint64_t hash = 0;
  std::vector<double> seconds, user;
  long peak = 0;

  void print(const std::string& method) const {
    std::printf("{\"method\": \"%s\", \"version\": \"CGAL %s\", \"input_hash\": \"%016llx\", \"repetitions\": %zu, "
                "\"seconds\": %.9f, \"user_seconds\": %.9f, \"peak_bytes\": %ld, "
                "\"vertices\": %zu, \"edges\": %zu, \"faces\": %zu",
                method.c_str(), CGAL_VERSION_STR, static_cast<unsigned long long>(hash), seconds.size(),
                median(seconds), median(user), peak, vertices, edges, faces);
    if (is_location)
      std::printf(", \"located\": {\"vertices\": %zu, \"edges\": %zu, \"faces\": %zu, \"around\": %zu}", on_vertices,
                  on_edges, in_faces, around);
    if (asked > 0) std::printf(", \"asked\": %zu", asked);
    std::printf("}\n");
  }
};

// The operations on arrangements of one traits class. `Model` has the types `Traits` and `Arrangement`, makes curves and points of
// lines, and measures the boundary of a face.
template <class Model>
struct Operations {
  using Traits = typename Model::Traits;
  using Arrangement = typename Model::Arrangement;
  using Curve = typename Traits::Curve_2;
  using Point = typename Traits::Point_2;
  using Cell = typename CGAL::Arr_point_location_result<Arrangement>::Type;

  // How many files an operation reads; none if there is no such operation.
  static int files(const std::string& operation) {
    return operation == "build" ? 1 : operation == "overlay" || operation == "locate" ? 2 : 0;
  }

  void perform(const std::string& operation, const std::vector<Lines>& inputs) {
    if (operation == "build") build(inputs.at(0));
    if (operation == "overlay") overlay(inputs.at(0), inputs.at(1));
    if (operation == "locate") locate(inputs.at(0), inputs.at(1));
  }

  Traits traits;
  std::size_t least;
  double budget;
  Answer answer;

  std::vector<Curve> curves(const Lines& input) {
    std::vector<Curve> r;
    r.reserve(input.lines.size());
    for (const auto& line : input.lines) r.push_back(Model::curve(traits, line));
    return r;
  }

  std::vector<Point> points(const Lines& queries) {
    std::vector<Point> r;
    r.reserve(queries.lines.size());
    for (const auto& line : queries.lines) r.push_back(Model::point(traits, line));
    return r;
  }

  // The time of `action` alone; the first run is looked at while its result is in memory.
  template <class Make, class Action, class Look>
  void measure(Make&& make, Action&& action, Look&& look) {
    repeat(least, budget, 1, [&] {
      auto result = make();
      const double t0 = cpu_seconds(), u0 = user_seconds();
      action(*result);
      const double t1 = cpu_seconds();
      answer.user.push_back(user_seconds() - u0);
      answer.seconds.push_back(t1 - t0);
      if (answer.seconds.size() == 1) {
        answer.peak = peak_bytes();
        look(*result);
      }
      return std::vector<double>{t1 - t0};
    });
  }

  template <class Any>
  void count(const Any& arrangement) {
    answer.vertices = arrangement.number_of_vertices();
    answer.edges = arrangement.number_of_edges();
    answer.faces = arrangement.number_of_faces();
  }

  template <class Any = Arrangement>
  std::unique_ptr<Any> empty() { return std::make_unique<Any>(&traits); }

  std::unique_ptr<Arrangement> made(const Lines& input) {
    const auto all = curves(input);
    auto arrangement = empty();
    CGAL::insert(*arrangement, all.begin(), all.end());
    return arrangement;
  }

  // Aggregated insertion of all curves into an empty arrangement.
  void build(const Lines& input) {
    const auto all = curves(input);
    measure([&] { return empty(); }, [&](Arrangement& r) { CGAL::insert(r, all.begin(), all.end()); },
            [&](const Arrangement& r) { count(r); });
  }

  // Overlay of two arrangements that are made before the clock starts.
  void overlay(const Lines& red_input, const Lines& blue_input) {
    const auto red = made(red_input), blue = made(blue_input);
    measure([&] { return empty(); },
            [&](Arrangement& r) {
              CGAL::Arr_default_overlay_traits<Arrangement> nothing;
              CGAL::overlay(*red, *blue, r, nothing);
            },
            [&](const Arrangement& r) { count(r); });
  }

  // Batched location of points in an arrangement that is made before the clock starts.
  void locate(const Lines& input, const Lines& queries) {
    using Place = std::pair<Point, Cell>;
    const auto arrangement = made(input);
    const auto asked = points(queries);
    measure([] { return std::make_unique<std::vector<Place>>(); },
            [&](std::vector<Place>& r) {
              CGAL::locate(*arrangement, asked.begin(), asked.end(), std::back_inserter(r));
            },
            [&](const std::vector<Place>& r) {
              for (const auto& place : r) look_at(place.second);
            });
    answer.is_location = true;
    count(*arrangement);
  }

  // Insertion of all curves one by one, in their order, into an empty arrangement; places are found by the default strategy, which
  // needs no preparation.
  template <class Any>
  void insert(const Lines& input) {
    const auto all = curves(input);
    measure([&] { return empty<Any>(); },
            [&](Any& r) {
              for (const auto& curve : all) CGAL::insert(r, curve);
            },
            [&](const Any& r) { count(r); });
  }

  // One point after the other, by a strategy that is made ready before the clock starts.
  template <class Strategy, class Question>
  void ask(const Lines& input, const Lines& queries, Question&& question) {
    const auto arrangement = made(input);
    const Strategy strategy(*arrangement);
    const auto asked = points(queries);
    measure([] { return std::make_unique<std::vector<Cell>>(); },
            [&](std::vector<Cell>& r) {
              for (const auto& point : asked) r.push_back(question(strategy, point));
            },
            [&](const std::vector<Cell>& r) {
              for (const auto& cell : r) look_at(cell);
            });
    answer.is_location = true;
    count(*arrangement);
  }

  template <class Any>
  void look_at(const Any& cell) {
    if (boost::get<typename Arrangement::Vertex_const_handle>(&cell)) {
      ++answer.on_vertices;
    } else if (boost::get<typename Arrangement::Halfedge_const_handle>(&cell)) {
      ++answer.on_edges;
    } else {
      ++answer.in_faces;
      answer.around += Model::around(boost::get<typename Arrangement::Face_const_handle>(cell));
    }
  }
};

// `driver OPERATION FILE... [LEAST [SECONDS]]`; `Operations` and what derives from it know the operations.
template <class Operations>
int run_driver(const char* method, int count, char** values) try {
  const std::string operation = count > 1 ? values[1] : "";
  const int files = Operations::files(operation);
  if (files == 0 || count < 2 + files)
    throw std::runtime_error("usage: OPERATION FILE... [LEAST [SECONDS]]; no such operation, or too few files");
  Operations operations;
  operations.least = count > 2 + files ? std::stoul(values[2 + files]) : 3;
  operations.budget = count > 3 + files ? std::stod(values[3 + files]) : 1.0;
  std::vector<Lines> inputs;
  for (int i = 0; i < files; ++i) inputs.push_back(read_lines(values[2 + i]));
  operations.perform(operation, inputs);
  operations.answer.hash = inputs.front().hash;
  operations.answer.print(method);
  return EXIT_SUCCESS;
} catch (const std::exception& error) {
  std::cerr << method << ": " << error.what() << '\n';
  return EXIT_FAILURE;
}
