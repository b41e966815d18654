// The peer "hull": the convex hull of all pairwise sums of vertices, exact kernel.
//
// Timed: making the pairwise sums from the points of both operands, and convex_hull_3 over them.
// Not timed: joining coplanar triangles, which is needed only to count facets.
#include "soup.h"

#include <cstdlib>
#include <iostream>

int main(int count, char** values) try {
  const Arguments in = arguments(count, values);
  Hull hull;
  const Samples samples = repeat(in.least, in.budget, 2, [&] {
    hull = Hull();
    const double t0 = cpu_seconds();
    const auto a = kernel_points(in.a), b = kernel_points(in.b);
    std::vector<Point> sums;
    sums.reserve(a.size() * b.size());
    for (const auto& p : a)
      for (const auto& q : b) sums.push_back(q + (p - CGAL::ORIGIN));
    const double t1 = cpu_seconds();
    CGAL::convex_hull_3(sums.begin(), sums.end(), hull);
    return std::vector<double>{t1 - t0, cpu_seconds() - t1};
  });
  const Merged merged = merge_coplanar(hull);
  report("hull", samples, {"pairwise_sums", "hull"}, merged.vertices, merged.edges, merged.facets);
} catch (const std::exception& error) {
  std::cerr << "hull: " << error.what() << '\n';
  return EXIT_FAILURE;
}
