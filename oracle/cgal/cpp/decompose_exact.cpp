// The decompositions with the exact kernel; and what makes a polygon with holes valid, in the same file because both instantiate the same sweeps, which are heavy to compile.

#include <CGAL/Boolean_set_operations_2/Gps_polygon_validation.h>
#include <CGAL/Gps_segment_traits_2.h>

#include "decompositions.h"

namespace {

using namespace shim;

std::string name(std::size_t i) { return "loop " + std::to_string(i); }

void check_simple(const std::vector<Loop<Exact>>& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].size() < 3) throw Refusal(name(i) + " has fewer than three vertices");
    if (!all[i].is_simple()) throw Refusal(name(i) + " is not simple");
  }
}

}  // namespace

std::string shim::decompose_exact(Strategy strategy, const Operands& of) { return decompose<Exact>(strategy, of); }

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
