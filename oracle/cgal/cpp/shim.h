// The C ABI of the shim, and what its files share.
//
// A region crosses as text on one line, a loop x y x y ... ended by a semicolon, each number an integer p or a fraction p/q
// in decimal, so that nothing is rounded on the way. An answer is one line too, in memory that arcsum_cgal_free gives back:
//
//     ok NANOSECONDS; LOOPS    the result; the time is that of the operation with an exact result forced, without reading,
//                              validating and writing
//     refused REASON           the input is none that CGAL promises an answer for; CGAL was not asked
//     failed REASON            CGAL gave up: an exception, or an assertion where those are compiled in
//
// The shim never throws, and never prints. What it cannot prevent is a process that dies inside CGAL.
#pragma once

extern "C" {
// CGAL's version, as 5.5.1; static memory.
const char* arcsum_cgal_version();

// The sum of two regions, each an outer loop and its holes in any order. The numbers of strategies and kernels are those
// of the enumerations below.
char* arcsum_cgal_sum(int strategy, int kernel, const char* a, const char* b);

// The offset of a region by a disc of a radius, a number in text: a region of line and circle segments whose distance from
// the exact offset is at most the error.
char* arcsum_cgal_offset(const char* region, const char* radius, double error);

// The same without an error. A vertex of the result is x dx y dy, each coordinate at most d off, followed by the way to the
// next one: l for a line, + CX CY RR or - CX CY RR for a circle segment of a squared radius.
char* arcsum_cgal_offset_exact(const char* region, const char* radius);

// A set operation, by its number below, on two regions of line and circle segments. A vertex is x y followed by the way to
// the next one: l for a line, + CX CY or - CX CY for a circle segment about a centre, counter-clockwise or clockwise.
// Results of this function and of the offset with an error have three numbers p q r for a coordinate p + q sqrt(r), and
// the squared radius behind each centre.
char* arcsum_cgal_combine(int operation, const char* a, const char* b);

// Frees an answer; none is freed without harm.
void arcsum_cgal_free(char* answer);
}

namespace shim {

enum Strategy { REDUCED, FULL, SMALL_SIDE, OPTIMAL, HERTEL_MEHLHORN, GREENE, VERTICAL, TRIANGULATION };
enum Operation { UNION, INTERSECTION, DIFFERENCE, SYMMETRIC_DIFFERENCE };
enum Kernel { EXACT, RATIONAL, INEXACT };

}  // namespace shim
