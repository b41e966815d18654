// The peer of arrangements of segments: the caching traits class, exact kernel.
#include <CGAL/Arr_segment_traits_2.h>

#include "location.h"

struct Segments : Planar<CGAL::Arr_segment_traits_2<Epeck>> {
  static Traits::Curve_2 curve(const Traits&, const Line& line) {
    return {kernel_point(line, 0), kernel_point(line, 1)};
  }
};

int main(int count, char** values) { return run_driver<Location<Segments>>("arr_segments", count, values); }
