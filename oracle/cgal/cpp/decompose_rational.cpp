// The decompositions with the rational kernel.

#include "decompositions.h"

std::string shim::decompose_rational(Strategy strategy, const Operands& of) { return decompose<Rational>(strategy, of); }
