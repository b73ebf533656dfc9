// CORE's messages: its warnings are dropped and its errors thrown, where CORE itself appends both to a file in the working
// directory and ends the process for an error. To be included before anything of CORE.
#pragma once

#include <stdexcept>
#include <string>

// What CORE has for this takes another name, and nobody calls it.
#define core_error core_error_to_file
#include <CGAL/CORE/CoreAux.h>
#undef core_error

namespace CORE {

inline void core_error(std::string message, std::string, int, bool is_error) {
  if (is_error) throw std::runtime_error("CORE: " + message);
}

}  // namespace CORE
