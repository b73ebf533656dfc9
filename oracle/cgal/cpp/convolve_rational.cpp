// The convolutions with the rational kernel.

#include "convolutions.h"

std::string shim::convolve_rational(Strategy strategy, const Operands& of) { return convolve<Rational>(strategy, of); }
