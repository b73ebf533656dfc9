// An answer of the shim: an operation carried out, timed, and kept from throwing or printing.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace shim {

using Duration = std::chrono::nanoseconds;

// The text of an answer, of what ANSWER returns or throws, in memory of the C library.
char* answered(const std::function<std::string()>& answer);

// What COMPUTE returns, and how long it took.
template <class Compute>
auto timed(const Compute& compute, Duration& time) {
  const auto start = std::chrono::steady_clock::now();
  auto result = compute();
  time = std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - start);
  return result;
}

}  // namespace shim
