// The convolutions with the exact kernel.

#include "convolutions.h"

std::string shim::convolve_exact(Strategy strategy, const Operands& of) { return convolve<Exact>(strategy, of); }
