//! Whether CGAL is there, and what is said if it is not.

use crate::common::{loops, square};
use arcsum_cgal::error::CgalError;
use arcsum_cgal::method::Method;
use arcsum_cgal::question::Question;
use arcsum_cgal::sum::Sum;

/// `tests/run` sets the variable unless told to do without.
#[test]
fn cgal_is_built_in_where_it_is_required() {
    let required = std::env::var_os("ARCSUM_REQUIRE_CGAL").is_some();
    assert!(!required || arcsum_cgal::built_in(), "CGAL was not found: install libcgal-dev, or leave it out");
}

#[test]
fn a_missing_cgal_says_so() {
    let method: Method = "reduced:exact".parse().expect("a method");
    let answer = Sum { method, a: loops(&[square(1)]), b: loops(&[square(1)]) }.ask();
    assert_eq!(answer == Err(CgalError::NotBuiltIn), !arcsum_cgal::built_in());
    assert_eq!(arcsum_cgal::version().is_some(), arcsum_cgal::built_in());
}
