// The peer of arrangements of geodesic arcs on the sphere, exact kernel. Arcs are cut where they cross the identification.
#include <CGAL/Arr_geodesic_arc_on_sphere_traits_2.h>
#include <CGAL/Arr_naive_point_location.h>
#include <CGAL/Arr_spherical_topology_traits_2.h>
#include <CGAL/Arrangement_on_surface_2.h>

#include <algorithm>

#include "curves.h"

struct Geodesics {
  using Traits = CGAL::Arr_geodesic_arc_on_sphere_traits_2<Epeck>;
  using Arrangement = CGAL::Arrangement_on_surface_2<Traits, CGAL::Arr_spherical_topology_traits_2<Traits>>;

  static Traits::Point_2 direction(const Traits& traits, const Line& line, std::size_t index) {
    return traits.construct_point_2_object()(line.at(3 * index), line.at(3 * index + 1), line.at(3 * index + 2));
  }

  static Traits::Point_2 point(const Traits& traits, const Line& line) { return direction(traits, line, 0); }

  // The shorter arc.
  static Traits::Curve_2 curve(const Traits& traits, const Line& line) {
    return traits.construct_curve_2_object()(direction(traits, line, 0), direction(traits, line, 1));
  }

  // Halfedges on all boundaries, those that come to a vertex of degree two left out: where arcs are cut depends on the program.
  template <class Face>
  static std::size_t around(const Face& face) {
    std::size_t halfedges = 0;
    const auto walk = [&](const auto& first) {
      auto edge = first;
      do halfedges += edge->target()->degree() != 2;
      while (++edge != first);
    };
    for (auto ccb = face->outer_ccbs_begin(); ccb != face->outer_ccbs_end(); ++ccb) walk(*ccb);
    for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) walk(*ccb);
    return halfedges;
  }
};

struct Sphere : Operations<Geodesics> {
  using Base = Operations<Geodesics>;
  using Naive = CGAL::Arr_naive_point_location<Arrangement>;

  // A query takes tens of milliseconds.
  static constexpr std::size_t few = 20;

  static int files(const std::string& operation) {
    if (operation == "insert") return 1;
    return operation == "naive" || operation == "trapezoids" || operation == "landmarks" ? 2 : Base::files(operation);
  }

  void perform(const std::string& operation, const std::vector<Lines>& inputs) {
    const auto locate = [](const Naive& strategy, const Point& point) { return strategy.locate(point); };
    if (operation == "insert") insert<Arrangement>(inputs.at(0));
    else if (operation == "naive") ask<Naive>(inputs.at(0), inputs.at(1), locate);
    else if (operation == "trapezoids" || operation == "landmarks") ask_few(inputs.at(0), inputs.at(1));
    else Base::perform(operation, inputs);
  }

  // On the identification, where the batch gives wrong faces.
  static bool is_on_side(const Line& line) { return line.numbers.at(0) <= 0 && line.numbers.at(1) == 0; }

  // On the sphere cells of single points are found by looking at every cell: CGAL's trapezoids crash there, and landmarks and walks
  // do not compile. So the time is for the first points only; the cells that are counted are those of all points, located in a batch
  // but for the few on the identification.
  void ask_few(const Lines& input, const Lines& queries) {
    const auto arrangement = made(input);
    const Naive naive(*arrangement);
    const auto all = points(queries);
    answer.asked = std::min(few, all.size());
    measure([] { return std::make_unique<std::vector<Cell>>(); },
            [&](std::vector<Cell>& r) {
              for (std::size_t i = 0; i < answer.asked; ++i) r.push_back(naive.locate(all[i]));
            },
            [](const std::vector<Cell>&) {});
    std::vector<Point> inside;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (is_on_side(queries.lines[i])) look_at(naive.locate(all[i]));
      else inside.push_back(all[i]);
    }
    std::vector<std::pair<Point, Cell>> places;
    CGAL::locate(*arrangement, inside.begin(), inside.end(), std::back_inserter(places));
    for (const auto& place : places) look_at(place.second);
    answer.is_location = true;
    count(*arrangement);
  }
};

int main(int count, char** values) { return run_driver<Sphere>("arr_sphere", count, values); }
