// The exact offset of a polygon by a disc: lines and circle segments of rational conics, vertices that are algebraic numbers
// of CORE. Each vertex crosses the ABI as a rational number close by, together with a bound of its distance.

#include "core.h"

#include <CGAL/Arr_conic_traits_2.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>
#include <CGAL/Gps_traits_2.h>
#include <CGAL/offset_polygon_2.h>

#include "sums.h"

namespace shim {

using Core = CGAL::CORE_algebraic_number_traits;
using Plain = CGAL::Cartesian<Core::Rational>;

template <>
struct Numbers<Plain> {
  static Core::Rational read(const std::string& text) { return fraction<Core::Rational>(text); }
};

}  // namespace shim

namespace {

using namespace shim;

using Traits = CGAL::Gps_traits_2<CGAL::Arr_conic_traits_2<Plain, CGAL::Cartesian<Core::Algebraic>, Core>>;

// Bits to which vertices are computed, relative to their size. The bound that is told leaves eight of them aside.
constexpr unsigned BITS = 200;

// A rational number near an algebraic one, and how far it may be off.
void write(std::ostream& out, const Core::Algebraic& x) {
  // Where x is 0, or so small that BITS of it are not known, CORE stops at this many bits after the point.
  constexpr unsigned LEAST = 2000;
  const CORE::BigFloat near = x.approx(BITS, LEAST).BigFloatValue();
  const Core::Rational value = near.BigRatValue();
  const Core::Rational told(CORE::BigInt(1), CORE::BigInt(1) << (BITS - 8)), least(CORE::BigInt(1), CORE::BigInt(1) << (LEAST - 8));
  out << value << ' ' << Core::Rational(abs(value) * told + least) << ' ';
}

// The circle r (x² + y²) + u x + v y + w = 0 by centre and squared radius.
template <class Edge>
void write_circle(std::ostream& out, const Edge& edge) {
  if (edge.r() != edge.s() || edge.t() != 0) throw std::logic_error("a conic that is no circle");
  const Core::Rational r(edge.r()), x = -Core::Rational(edge.u()) / (2 * r), y = -Core::Rational(edge.v()) / (2 * r);
  out << (edge.orientation() == CGAL::COUNTERCLOCKWISE ? "+ " : "- ");
  out << x << ' ' << y << ' ' << Core::Rational(x * x + y * y - Core::Rational(edge.w()) / r) << ' ';
}

template <class Loop>
void write_loop(std::ostream& out, const Loop& loop) {
  for (auto edge = loop.curves_begin(); edge != loop.curves_end(); ++edge) {
    write(out, edge->source().x());
    write(out, edge->source().y());
    if (edge->orientation() == CGAL::COLLINEAR) {
      out << "l ";
    } else {
      write_circle(out, *edge);
    }
  }
  out << ';';
}

}  // namespace

std::string shim::offset_exact(const std::string& of, std::size_t outer, const std::string& radius) {
  const Region<Plain> polygon = region<Plain>(of, outer);
  const Core::Rational r = Numbers<Plain>::read(radius);
  if (r <= 0) throw Refusal("a radius that is not positive");
  const Traits traits;
  Duration time, exact;
  const auto result = timed([&] { return CGAL::offset_polygon_2(polygon, r, traits); }, time);
  std::ostringstream loops;
  // Vertices are computed when they are asked for, so this counts.
  timed(
      [&] {
        write_loop(loops, result.outer_boundary());
        for (auto hole = result.holes_begin(); hole != result.holes_end(); ++hole) write_loop(loops, *hole);
        return 0;
      },
      exact);
  return "ok " + std::to_string((time + exact).count()) + ";" + loops.str();
}
