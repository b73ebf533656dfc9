// Sums by the reduced and the full convolution, for any kernel.
#pragma once

#include <CGAL/minkowski_sum_2.h>

#include "sums.h"

namespace shim {

template <class Kernel>
std::string convolve(Strategy strategy, const Operands& of) {
  return sum_with<Kernel>(of, [&](const Region<Kernel>& a, const Region<Kernel>& b) {
    if (strategy == REDUCED) return CGAL::minkowski_sum_by_reduced_convolution_2(a, b);
    // CGAL has no full convolution of polygons with holes.
    if (a.has_holes() || b.has_holes()) throw Refusal("the full convolution takes no holes");
    return CGAL::minkowski_sum_by_full_convolution_2(a.outer_boundary(), b.outer_boundary());
  });
}

}  // namespace shim
