// Numbers of the kernels from and to exact text.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <sstream>
#include <stdexcept>
#include <string>

namespace shim {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;

// Input that CGAL is not asked about, and why.
struct Refusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// The integer or fraction as a number of a rational type.
template <class Q>
Q fraction(const std::string& text) {
  const auto integer = [&](const std::string& digits) {
    const std::size_t start = digits.compare(0, 1, "-") == 0 ? 1 : 0;
    if (digits.size() == start || digits.find_first_not_of("0123456789", start) != std::string::npos) {
      throw Refusal("not a rational number: " + text.substr(0, 40));
    }
    Q value;
    std::istringstream(digits) >> value;
    return value;
  };
  const std::size_t bar = text.find('/');
  if (bar == std::string::npos) return integer(text);
  const Q denominator = integer(text.substr(bar + 1));
  if (denominator <= 0) throw Refusal("not a rational number: " + text.substr(0, 40));
  return integer(text.substr(0, bar)) / denominator;
}

// How a kernel's numbers are read, made exact and written.
template <class Kernel>
struct Numbers;

template <>
struct Numbers<Exact> {
  using FT = Exact::FT;
  using Q = Exact::Exact_kernel::FT;
  static FT read(const std::string& text) {
    const Q exact = fraction<Q>(text);
    // As a user would give a double: its interval is a point, and no rational number hangs on it.
    const double near = CGAL::to_double(exact);
    return CGAL::is_finite(near) && Q(near) == exact ? FT(near) : FT(exact);
  }
  static void force(const FT& x) { CGAL::exact(x); }
  static void write(std::ostream& out, const FT& x) { out << CGAL::exact(x); }
};

template <>
struct Numbers<Rational> {
  static CGAL::Gmpq read(const std::string& text) { return fraction<CGAL::Gmpq>(text); }
  static void force(const CGAL::Gmpq&) {}
  static void write(std::ostream& out, const CGAL::Gmpq& x) { out << x; }
};

template <>
struct Numbers<Inexact> {
  static double read(const std::string& text) {
    const CGAL::Gmpq exact = fraction<CGAL::Gmpq>(text);
    const double near = CGAL::to_double(exact);
    if (!CGAL::is_finite(near) || CGAL::Gmpq(near) != exact) throw Refusal("not a double: " + text.substr(0, 40));
    return near;
  }
  static void force(double) {}
  static void write(std::ostream& out, double x) {
    if (!CGAL::is_finite(x)) throw std::overflow_error("a coordinate of the result is not finite");
    out << CGAL::Gmpq(x);
  }
};

}  // namespace shim
