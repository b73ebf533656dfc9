// The decompositions with the inexact kernel.

#include "decompositions.h"

std::string shim::decompose_inexact(Strategy strategy, const Operands& of) { return decompose<Inexact>(strategy, of); }
