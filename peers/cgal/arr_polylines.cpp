// The peer of arrangements of polylines over caching segments, exact kernel. Polylines are split where they turn back in x.
#include <CGAL/Arr_polyline_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>

#include "curves.h"

struct Polylines : Planar<CGAL::Arr_polyline_traits_2<CGAL::Arr_segment_traits_2<Epeck>>> {
  static Traits::Curve_2 curve(const Traits& traits, const Line& line) {
    std::vector<Epeck::Point_2> points;
    for (std::size_t i = 0; 2 * i < line.numbers.size(); ++i) points.push_back(kernel_point(line, i));
    return traits.construct_curve_2_object()(points.begin(), points.end());
  }
};

int main(int count, char** values) { return run_driver<Operations<Polylines>>("arr_polylines", count, values); }
