// Sums by decomposition into convex pieces, with the exact kernel; and what makes a polygon with holes valid, in the same
// file because both instantiate the same sweeps, which are heavy to compile.

#include <CGAL/Boolean_set_operations_2/Gps_polygon_validation.h>
#include <CGAL/Gps_segment_traits_2.h>
#include <CGAL/Polygon_convex_decomposition_2.h>
#include <CGAL/Polygon_triangulation_decomposition_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>
#include <CGAL/minkowski_sum_2.h>

#include "sums.h"

namespace {

using namespace shim;

// By a decomposition that takes polygons with holes.
template <class Decomposition>
std::string with_holes(const Operands& of) {
  return sum_with<Exact>(of, [](const Region<Exact>& a, const Region<Exact>& b) {
    return CGAL::minkowski_sum_2(a, b, Decomposition(), Decomposition());
  });
}

// By one that does not.
template <class Decomposition>
std::string without_holes(const Operands& of) {
  return sum_with<Exact>(of, [](const Region<Exact>& a, const Region<Exact>& b) {
    if (a.has_holes() || b.has_holes()) throw Refusal("this decomposition takes no holes");
    return CGAL::minkowski_sum_2(a.outer_boundary(), b.outer_boundary(), Decomposition(), Decomposition());
  });
}

std::string name(std::size_t i) { return "loop " + std::to_string(i); }

void check_simple(const std::vector<Loop<Exact>>& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].size() < 3) throw Refusal(name(i) + " has fewer than three vertices");
    if (!all[i].is_simple()) throw Refusal(name(i) + " is not simple");
  }
}

}  // namespace

std::string shim::decompose_exact(Strategy strategy, const Operands& of) {
  switch (strategy) {
    case SMALL_SIDE: return without_holes<CGAL::Small_side_angle_bisector_decomposition_2<Exact>>(of);
    case OPTIMAL: return without_holes<CGAL::Optimal_convex_decomposition_2<Exact>>(of);
    case HERTEL_MEHLHORN: return without_holes<CGAL::Hertel_Mehlhorn_convex_decomposition_2<Exact>>(of);
    case GREENE: return without_holes<CGAL::Greene_convex_decomposition_2<Exact>>(of);
    case VERTICAL: return with_holes<CGAL::Polygon_vertical_decomposition_2<Exact>>(of);
    case TRIANGULATION: return with_holes<CGAL::Polygon_triangulation_decomposition_2<Exact>>(of);
    default: throw Refusal("not a decomposition");
  }
}

std::size_t shim::outer_loop(const std::string& text) {
  const std::vector<Loop<Exact>> all = loops<Exact>(text);
  if (all.empty()) throw Refusal("an empty region");
  check_simple(all);
  std::size_t outer = all.size();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].orientation() != CGAL::COUNTERCLOCKWISE) continue;
    if (outer != all.size()) throw Refusal("more than one outer loop");
    outer = i;
  }
  if (outer == all.size()) throw Refusal("no outer loop, all run clockwise");
  if (all.size() > 1) {
    const CGAL::Gps_segment_traits_2<Exact> traits;
    if (!CGAL::is_valid_polygon_with_holes(region<Exact>(text, outer), traits)) {
      throw Refusal("a hole crosses another loop or lies outside");
    }
  }
  return outer;
}
