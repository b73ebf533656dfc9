// The convolutions with the inexact kernel.

#include "convolutions.h"

std::string shim::convolve_inexact(Strategy strategy, const Operands& of) { return convolve<Inexact>(strategy, of); }
