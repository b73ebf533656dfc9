// Sums by decomposition into convex pieces, whatever the kernel.
#pragma once

#include <CGAL/Polygon_convex_decomposition_2.h>
#include <CGAL/Polygon_triangulation_decomposition_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>
#include <CGAL/minkowski_sum_2.h>

#include "sums.h"

namespace shim {

// By a decomposition that takes polygons with holes.
template <class Kernel, class Decomposition>
std::string with_holes(const Operands& of) {
  return sum_with<Kernel>(of, [](const Region<Kernel>& a, const Region<Kernel>& b) {
    return CGAL::minkowski_sum_2(a, b, Decomposition(), Decomposition());
  });
}

// By one that does not.
template <class Kernel, class Decomposition>
std::string without_holes(const Operands& of) {
  return sum_with<Kernel>(of, [](const Region<Kernel>& a, const Region<Kernel>& b) {
    if (a.has_holes() || b.has_holes()) throw Refusal("this decomposition takes no holes");
    return CGAL::minkowski_sum_2(a.outer_boundary(), b.outer_boundary(), Decomposition(), Decomposition());
  });
}

template <class K>
std::string decompose(Strategy strategy, const Operands& of) {
  switch (strategy) {
    case SMALL_SIDE: return without_holes<K, CGAL::Small_side_angle_bisector_decomposition_2<K>>(of);
    case OPTIMAL: return without_holes<K, CGAL::Optimal_convex_decomposition_2<K>>(of);
    case HERTEL_MEHLHORN: return without_holes<K, CGAL::Hertel_Mehlhorn_convex_decomposition_2<K>>(of);
    case GREENE: return without_holes<K, CGAL::Greene_convex_decomposition_2<K>>(of);
    case VERTICAL: return with_holes<K, CGAL::Polygon_vertical_decomposition_2<K>>(of);
    case TRIANGULATION: return with_holes<K, CGAL::Polygon_triangulation_decomposition_2<K>>(of);
    default: throw Refusal("not a decomposition");
  }
}

}  // namespace shim
