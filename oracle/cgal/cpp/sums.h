// What the shim can do, a kernel a file: each file instantiates what is heavy to compile, once.
#pragma once

#include <sstream>

#include "answer.h"
#include "regions.h"
#include "shim.h"

namespace shim {

// The operands of a sum, validated.
struct Operands {
  std::string a, b;
  std::size_t outer_a, outer_b;
};

// Computes SUM of two regions of a kernel; returns the text of the result.
template <class Kernel, class Sum>
std::string sum_with(const Operands& of, const Sum& sum) {
  const Region<Kernel> a = region<Kernel>(of.a, of.outer_a), b = region<Kernel>(of.b, of.outer_b);
  Duration time;
  const Region<Kernel> result = timed(
      [&] {
        Region<Kernel> found = sum(a, b);
        force(found);
        return found;
      },
      time);
  std::ostringstream out;
  out << "ok " << time.count() << ';';
  write(out, result);
  return out.str();
}

// The convolutions and the decompositions with each kernel.
std::string convolve_exact(Strategy strategy, const Operands& of);
std::string convolve_rational(Strategy strategy, const Operands& of);
std::string convolve_inexact(Strategy strategy, const Operands& of);
std::string decompose_exact(Strategy strategy, const Operands& of);
std::string decompose_rational(Strategy strategy, const Operands& of);
std::string decompose_inexact(Strategy strategy, const Operands& of);

// Offsets, and a set operation.
std::string offset_exact(const std::string& of, std::size_t outer, const std::string& radius);
std::string offset(const std::string& of, std::size_t outer, const std::string& radius, double error);
std::string combine(Operation operation, const std::string& a, const std::string& b);

}  // namespace shim
