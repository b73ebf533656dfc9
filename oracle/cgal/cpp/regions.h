// Polygons with holes from and to text, and what makes one valid.
#pragma once

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <string>
#include <vector>

#include "numbers.h"

namespace shim {

template <class Kernel>
using Loop = CGAL::Polygon_2<Kernel>;
template <class Kernel>
using Region = CGAL::Polygon_with_holes_2<Kernel>;

// The loops of a text, each ended by a semicolon.
template <class Kernel>
std::vector<Loop<Kernel>> loops(const std::string& text) {
  std::vector<Loop<Kernel>> found;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ';');) {
    std::istringstream words(part);
    Loop<Kernel> loop;
    for (std::string x, y; words >> x;) {
      if (!(words >> y)) throw Refusal("a vertex without an ordinate");
      loop.push_back(typename Kernel::Point_2(Numbers<Kernel>::read(x), Numbers<Kernel>::read(y)));
    }
    found.push_back(loop);
  }
  return found;
}

// Which loop of the text is the outer one. Refuses what is no polygon with holes: loops that are not simple, none or
// several outer loops, holes that cross another loop or lie outside. Loops may touch at points.
std::size_t outer_loop(const std::string& text);

// The region of the text, which has been found valid, with this loop outside.
template <class Kernel>
Region<Kernel> region(const std::string& text, std::size_t outer) {
  std::vector<Loop<Kernel>> all = loops<Kernel>(text);
  const Loop<Kernel> boundary = all[outer];
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(outer));
  return Region<Kernel>(boundary, all.begin(), all.end());
}

// All loops of a region, the outer one first.
template <class Kernel>
std::vector<Loop<Kernel>> loops_of(const Region<Kernel>& region) {
  std::vector<Loop<Kernel>> all{region.outer_boundary()};
  all.insert(all.end(), region.holes_begin(), region.holes_end());
  return all;
}

// Has all coordinates computed exactly, as whoever uses the result would have to.
template <class Kernel>
void force(const Region<Kernel>& region) {
  for (const Loop<Kernel>& loop : loops_of(region)) {
    for (const auto& p : loop) {
      Numbers<Kernel>::force(p.x());
      Numbers<Kernel>::force(p.y());
    }
  }
}

template <class Kernel>
void write(std::ostream& out, const Region<Kernel>& region) {
  for (const Loop<Kernel>& loop : loops_of(region)) {
    for (const auto& p : loop) {
      Numbers<Kernel>::write(out, p.x());
      out << ' ';
      Numbers<Kernel>::write(out, p.y());
      out << ' ';
    }
    out << ';';
  }
}

}  // namespace shim
