// The peer "nef": Gaussian maps as Nef polyhedra on the sphere (NGM), by the Minkowski sum of Nef polyhedra.
//
// Timed: making the Nef polyhedra of both operands, and their sum. Operands are convex, so no decomposition is needed, but the
// sum looks for one.
// Not timed: the exact hull of each operand with coplanar triangles joined.
#include "soup.h"

#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/minkowski_sum_3.h>

#include <cstdlib>
#include <iostream>

using Polyhedron = CGAL::Polyhedron_3<Epeck>;
using Nef = CGAL::Nef_polyhedron_3<Epeck>;

// Fills a polyhedron with the facets of a soup.
class Fill : public CGAL::Modifier_base<Polyhedron::HalfedgeDS> {
 public:
  explicit Fill(const Soup& soup) : soup_(soup) {}
  void operator()(Polyhedron::HalfedgeDS& target) override {
    CGAL::Polyhedron_incremental_builder_3<Polyhedron::HalfedgeDS> builder(target, true);
    builder.begin_surface(soup_.points.size(), soup_.facets.size());
    for (const auto& point : kernel_points(soup_)) builder.add_vertex(point);
    for (const auto& facet : soup_.facets) builder.add_facet(facet.begin(), facet.end());
    builder.end_surface();
    if (builder.error()) throw std::runtime_error("the facets are no closed surface");
  }

 private:
  const Soup& soup_;
};

static Nef nef(const Soup& soup) {
  Polyhedron polyhedron;
  Fill fill(soup);
  polyhedron.delegate(fill);
  return Nef(polyhedron);
}

int main(int count, char** values) try {
  Arguments in = arguments(count, values);
  std::size_t vertices = 0, edges = 0, facets = 0;
  const Samples samples = repeat(in.least, in.budget, 2, [&] {
    const double t0 = cpu_seconds();
    Nef a = nef(in.a), b = nef(in.b);
    const double t1 = cpu_seconds();
    const Nef sum = CGAL::minkowski_sum_3(a, b);
    const double t2 = cpu_seconds();
    vertices = sum.number_of_vertices();
    edges = sum.number_of_edges();
    facets = sum.number_of_facets();
    return std::vector<double>{t1 - t0, t2 - t1};
  });
  report("nef", samples, {"operands", "sum"}, vertices, edges, facets);
} catch (const std::exception& error) {
  std::cerr << "nef: " << error.what() << '\n';
  return EXIT_FAILURE;
}
