// The peer of arrangements of lines, rays and segments, exact kernel. Vertices at infinity are not counted.
#include <CGAL/Arr_linear_traits_2.h>

#include "curves.h"

struct Linear : Planar<CGAL::Arr_linear_traits_2<Epeck>> {
  static Traits::Curve_2 curve(const Traits&, const Line& line) {
    const auto p = kernel_point(line, 0), q = kernel_point(line, 1);
    if (line.kind == "line") return Epeck::Line_2(p, q);
    if (line.kind == "ray") return Epeck::Ray_2(p, q);
    return Epeck::Segment_2(p, q);
  }
};

int main(int count, char** values) { return run_driver<Operations<Linear>>("arr_linear", count, values); }
