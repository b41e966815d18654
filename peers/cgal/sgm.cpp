// The peer "sgm": spherical Gaussian maps of both operands, their overlay, and exact coordinates of the sum.
//
// Timed: building both maps from the facets, the overlay, and forcing the lazy coordinates of the primal vertices, since a
// result whose coordinates are still expression trees is not finished.
// Timed apart, as phase "exact_normals" outside the total: forcing the lazy coordinates of the facet normals.
// Not timed: the exact hull of each operand with coplanar triangles joined. CGAL needs maximal facets and does not check it.
#include "soup.h"

#include <CGAL/Arr_spherical_gaussian_map_3/Arr_polyhedral_sgm.h>
#include <CGAL/Arr_spherical_gaussian_map_3/Arr_polyhedral_sgm_initializer_visitor.h>
#include <CGAL/Arr_spherical_gaussian_map_3/Arr_polyhedral_sgm_polyhedron_3.h>
#include <CGAL/Arr_spherical_gaussian_map_3/Arr_polyhedral_sgm_traits.h>

#include <cstdlib>
#include <iostream>

using Traits = CGAL::Arr_polyhedral_sgm_traits<Epeck, -1, 0>;
using Map = CGAL::Arr_polyhedral_sgm<Traits>;
using Polyhedron = CGAL::Arr_polyhedral_sgm_polyhedron_3<Map, CGAL::Polyhedron_traits_with_normals_3<Epeck>>;
using Initializer = CGAL::Arr_polyhedral_sgm_initializer<Map, Polyhedron>;

// The hull of the points of `soup` with maximal facets.
static Soup maximal_facets(const Soup& soup) {
  const auto points = kernel_points(soup);
  Hull hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  const Merged merged = merge_coplanar(hull);
  Soup result;
  std::vector<std::size_t> index(hull.number_of_vertices());
  for (auto v : hull.vertices()) {
    if (!merged.is_vertex[v]) continue;
    index[v] = result.points.size();
    const auto& p = hull.point(v);
    result.points.push_back({Rational(p.x().exact()), Rational(p.y().exact()), Rational(p.z().exact())});
  }
  // The boundary of a class: successor of each vertex over the halfedges whose twin lies in another class.
  std::map<std::size_t, std::map<std::size_t, std::size_t>> successor;
  for (auto h : hull.halfedges()) {
    const auto here = merged.class_of[hull.face(h)], there = merged.class_of[hull.face(hull.opposite(h))];
    if (here != there) successor[here][hull.source(h)] = hull.target(h);
  }
  for (const auto& [facet, next] : successor) {
    std::vector<std::size_t> cycle;
    const std::size_t start = next.begin()->first;
    std::size_t v = start;
    do {
      if (merged.is_vertex[v]) cycle.push_back(index[v]);
      v = next.at(v);
    } while (v != start);
    result.facets.push_back(cycle);
  }
  return result;
}

static void build(const Soup& soup, Map& map) {
  auto points = kernel_points(soup);
  Initializer initializer(map);
  initializer(points.data(), points.data() + points.size(), points.size(), soup.facets.begin(), soup.facets.end(),
              soup.facets.size());
}

int main(int count, char** values) try {
  Arguments in = arguments(count, values);
  in.a = maximal_facets(in.a);
  in.b = maximal_facets(in.b);
  std::size_t vertices = 0, edges = 0, facets = 0;
  const Samples samples = repeat(in.least, in.budget, 3, [&] {
    Map a, b, sum;
    const double t0 = cpu_seconds();
    build(in.a, a);
    build(in.b, b);
    const double t1 = cpu_seconds();
    sum.minkowski_sum(a, b);
    const double t2 = cpu_seconds();
    for (auto face = sum.faces_begin(); face != sum.faces_end(); ++face) face->point().exact();
    const double t3 = cpu_seconds();
    for (auto vertex = sum.vertices_begin(); vertex != sum.vertices_end(); ++vertex) {
      const auto& normal = vertex->point();
      normal.dx().exact();
      normal.dy().exact();
      normal.dz().exact();
    }
    const double t4 = cpu_seconds();
    vertices = sum.number_of_vertices();
    edges = sum.number_of_edges();
    facets = sum.number_of_facets();
    return std::vector<double>{t1 - t0, t2 - t1, t3 - t2, t4 - t3};
  });
  report("sgm", samples, {"build", "sum", "exact_points", "exact_normals"}, vertices, edges, facets);
} catch (const std::exception& error) {
  std::cerr << "sgm: " << error.what() << '\n';
  return EXIT_FAILURE;
}
