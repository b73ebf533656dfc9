// Offsets of polygons by a disc, approximated, and set operations on regions of line and circle segments, with the exact
// kernel: both through CGAL's circle-segment polygons, which are exact for rational centres and squared radii.

#include <CGAL/Boolean_set_operations_2/Gps_polygon_validation.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/approximated_offset_2.h>

#include <list>

#include "sums.h"

namespace {

using namespace shim;

using Traits = CGAL::Gps_circle_segment_traits_2<Exact>;
using Curved = Traits::Polygon_with_holes_2;
using CurvedLoop = Traits::Polygon_2;
using Point = Exact::Point_2;
using Coordinate = Traits::CoordNT;

// A vertex of the input, and the way to the next one.
struct Corner {
  Point at, centre;
  bool arc, left;
};

std::vector<Corner> corners(const std::string& text) {
  std::vector<Corner> found;
  std::istringstream words(text);
  const auto point = [&](const std::string& x) {
    std::string y;
    if (!(words >> y)) throw Refusal("a vertex without an ordinate");
    return Point(Numbers<Exact>::read(x), Numbers<Exact>::read(y));
  };
  for (std::string x, bend; words >> x;) {
    Corner corner{point(x), Point(), false, false};
    if (!(words >> bend)) throw Refusal("a vertex without a bend");
    if (bend != "l") {
      corner.arc = true;
      corner.left = bend == "+";
      if (!(words >> x)) throw Refusal("an arc without a centre");
      corner.centre = point(x);
    }
    found.push_back(corner);
  }
  return found;
}

Traits::Curve_2 curve(const Corner& from, const Corner& to) {
  if (from.at == to.at) throw Refusal("a segment of no length");
  if (!from.arc) return Traits::Curve_2(from.at, to.at);
  const auto radius = CGAL::squared_distance(from.at, from.centre);
  if (radius != CGAL::squared_distance(to.at, from.centre)) throw Refusal("an arc that misses its end");
  const Exact::Circle_2 circle(from.centre, radius, from.left ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE);
  const auto end = [](const Point& p) { return Traits::Point_2(p.x(), p.y()); };
  return Traits::Curve_2(circle, end(from.at), end(to.at));
}

CurvedLoop curved_loop(const std::string& text) {
  const std::vector<Corner> all = corners(text);
  if (all.size() < 2) throw Refusal("a loop of fewer than two vertices");
  const Traits traits;
  CurvedLoop loop;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::list<CGAL::Object> pieces;
    traits.make_x_monotone_2_object()(curve(all[i], all[(i + 1) % all.size()]), std::back_inserter(pieces));
    for (const CGAL::Object& piece : pieces) {
      Traits::X_monotone_curve_2 monotone;
      if (CGAL::assign(monotone, piece)) loop.push_back(monotone);
    }
  }
  return loop;
}

// A region of one outer loop and its holes, in any order.
Curved curved(const std::string& text) {
  const Traits traits;
  std::vector<CurvedLoop> outer, holes;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ';');) {
    const CurvedLoop loop = curved_loop(part);
    if (!CGAL::is_closed_polygon(loop, traits) || !CGAL::is_simple_polygon(loop, traits)) {
      throw Refusal("a loop is not simple");
    }
    (loop.orientation() == CGAL::COUNTERCLOCKWISE ? outer : holes).push_back(loop);
  }
  if (outer.size() != 1) throw Refusal("not one outer loop");
  const Curved region(outer[0], holes.begin(), holes.end());
  if (!holes.empty() && !CGAL::is_valid_polygon_with_holes(region, traits)) {
    throw Refusal("a hole crosses another loop or lies outside");
  }
  return region;
}

void write(std::ostream& out, const Coordinate& x) {
  const auto part = [&](const Exact::FT& number) {
    Numbers<Exact>::write(out, number);
    out << ' ';
  };
  part(x.a0());
  part(x.is_extended() ? x.a1() : Exact::FT(0));
  part(x.is_extended() ? x.root() : Exact::FT(0));
}

void write(std::ostream& out, const CurvedLoop& loop) {
  for (auto edge = loop.curves_begin(); edge != loop.curves_end(); ++edge) {
    write(out, edge->source().x());
    write(out, edge->source().y());
    if (edge->is_linear()) {
      out << "l ";
      continue;
    }
    const auto circle = edge->supporting_circle();
    out << (edge->orientation() == CGAL::COUNTERCLOCKWISE ? "+ " : "- ");
    for (const auto& number : {circle.center().x(), circle.center().y(), circle.squared_radius()}) {
      Numbers<Exact>::write(out, number);
      out << ' ';
    }
  }
  out << ';';
}

// The text of a result. Writing makes it exact, and counts: an exact result is what was asked for.
std::string text(Duration time, const std::list<Curved>& result) {
  std::ostringstream loops;
  Duration exact;
  timed(
      [&] {
        for (const Curved& region : result) {
          write(loops, region.outer_boundary());
          for (auto hole = region.holes_begin(); hole != region.holes_end(); ++hole) write(loops, *hole);
        }
        return 0;
      },
      exact);
  return "ok " + std::to_string((time + exact).count()) + ";" + loops.str();
}

}  // namespace

std::string shim::offset(const std::string& of, std::size_t outer, const std::string& radius, double error) {
  const Region<Exact> polygon = region<Exact>(of, outer);
  const Exact::FT r = Numbers<Exact>::read(radius);
  if (r <= 0) throw Refusal("a radius that is not positive");
  // Beyond that CGAL's own integer for the inverse root overflows.
  if (!(error > 1e-18) || !CGAL::is_finite(error)) throw Refusal("an error that is not positive, or too small");
  Duration time;
  const Curved result = timed([&] { return CGAL::approximated_offset_2(polygon, r, error); }, time);
  return text(time, {result});
}

std::string shim::combine(Operation operation, const std::string& a, const std::string& b) {
  const Curved first = curved(a), second = curved(b);
  Duration time;
  const std::list<Curved> result = timed(
      [&] {
        CGAL::General_polygon_set_2<Traits> set(first);
        switch (operation) {
          case UNION: set.join(second); break;
          case INTERSECTION: set.intersection(second); break;
          case DIFFERENCE: set.difference(second); break;
          case SYMMETRIC_DIFFERENCE: set.symmetric_difference(second); break;
        }
        std::list<Curved> regions;
        set.polygons_with_holes(std::back_inserter(regions));
        return regions;
      },
      time);
  return text(time, result);
}
