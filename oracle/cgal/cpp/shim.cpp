// The C functions: which file does what, and how an answer is kept from throwing or printing.

#include "shim.h"

#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>
#include <CGAL/version_macros.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "sums.h"

namespace {

using namespace shim;

void be_silent(const char*, const char*, const char*, int, const char*) {}

// One line without the folders of the machine that built it.
std::string reason(const CGAL::Failure_exception& e) {
  const std::string file = e.filename();
  return e.library() + ": " + (e.expression().empty() ? e.message() : e.expression()) + " in " +
         file.substr(file.find_last_of('/') + 1) + ":" + std::to_string(e.line_number());
}

std::string sum(int strategy, int kernel, const char* a, const char* b) {
  if (strategy < REDUCED || strategy > TRIANGULATION) throw Refusal("no such strategy");
  const Strategy how = static_cast<Strategy>(strategy);
  const Operands of{a, b, outer_loop(a), outer_loop(b)};
  const bool convolves = how == REDUCED || how == FULL;
  switch (kernel) {
    case EXACT: return convolves ? convolve_exact(how, of) : decompose_exact(how, of);
    case RATIONAL: return convolves ? convolve_rational(how, of) : decompose_rational(how, of);
    case INEXACT: return convolves ? convolve_inexact(how, of) : decompose_inexact(how, of);
    default: throw Refusal("no such kernel");
  }
}

}  // namespace

char* shim::answered(const std::function<std::string()>& answer) {
  CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  CGAL::set_error_handler(be_silent);
  CGAL::set_warning_handler(be_silent);
  std::string text;
  try {
    text = answer();
  } catch (const Refusal& e) {
    text = std::string("refused ") + e.what();
  } catch (const CGAL::Failure_exception& e) {
    text = "failed " + reason(e);
  } catch (const std::exception& e) {
    text = std::string("failed ") + e.what();
  } catch (...) {
    text = "failed without a word";
  }
  // What others say may have lines.
  std::replace(text.begin(), text.end(), '\n', ' ');
  return strdup(text.c_str());
}

const char* arcsum_cgal_version() { return CGAL_VERSION_STR; }

char* arcsum_cgal_sum(int strategy, int kernel, const char* a, const char* b) {
  return answered([&] { return sum(strategy, kernel, a, b); });
}

char* arcsum_cgal_offset(const char* region, const char* radius, double error) {
  return answered([&] { return offset(region, outer_loop(region), radius, error); });
}

char* arcsum_cgal_offset_exact(const char* region, const char* radius) {
  return answered([&] { return offset_exact(region, outer_loop(region), radius); });
}

char* arcsum_cgal_combine(int operation, const char* a, const char* b) {
  return answered([&] {
    if (operation < UNION || operation > SYMMETRIC_DIFFERENCE) throw Refusal("no such operation");
    return combine(static_cast<Operation>(operation), a, b);
  });
}

void arcsum_cgal_free(char* answer) { std::free(answer); }
