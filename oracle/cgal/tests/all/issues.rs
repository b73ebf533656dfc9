//! Wrong answers that CGAL's users reported, rebuilt from their descriptions: what is true, by both references and by
//! membership, and what the version of Debian 12 says. Another version may say something else, but is held to the truth.

use crate::common::{Ring, child, exact_methods, loops, rectangle, references, reversed, square};
use crate::verdict::{Verdict, region, verdict};
use arcsum_cgal::error::CgalError;
use arcsum_cgal::method::Method;

/// What each exact method says about a sum of regions with holes.
fn verdicts(a: &[Ring], b: &[Ring]) -> Vec<(Method, Verdict)> {
    let (a, b, mut child) = (loops(a), loops(b), child());
    let methods = exact_methods(true).filter(|_| arcsum_cgal::built_in());
    methods.map(|method| (method, verdict(&mut child, method, &a, &b))).collect()
}

fn is_debian_12() -> bool {
    arcsum_cgal::version().is_some_and(|version| version == "5.5.1")
}

/// CGAL issue 5830: the reduced convolution decides whether a cell is a hole at a point that is not inside the cell, and
/// loses the hole. The decompositions keep it.
#[test]
fn issue_5830_a_hole_is_lost() {
    let plate = [rectangle(-60, -60, 240, 120), vec![(32, 42), (5, 3), (39, 59), (46, 43)]];
    let part = [square(1)];
    let sum = references(&region(&loops(&plate)), &region(&loops(&part)));
    assert_eq!(sum.holes(), 1);
    assert!((sum.area().to_f64() - 54352.34).abs() < 0.005);
    for (method, verdict) in verdicts(&plate, &part) {
        let lost = is_debian_12() && method.to_string().starts_with("reduced");
        let expected = if lost { Verdict::Wrong { belongs: false } } else { Verdict::Agrees { holes: 1 } };
        assert_eq!(verdict, expected, "{method}");
    }
}

/// CGAL issue 5839, pull request 7339: a hole that stays and holes that the part closes. CGAL removes the latter from a list
/// by places that earlier removals have moved, and goes on with a list that is broken. The smallest such case: a hole that
/// stays, followed by two that do not. With the one that stays at the end nothing is broken.
#[test]
fn issue_5839_removing_small_holes_breaks_the_list() {
    let large = reversed(&rectangle(10, 10, 40, 40));
    let small = |x| reversed(&rectangle(x, 2, x + 1, 3));
    let part = [square(2)];
    let truth = references(&region(&loops(&[square(50), large.clone()])), &region(&loops(&part)));
    let first = [square(50), large.clone(), small(2), small(6)];
    let last = [square(50), small(2), small(6), large];
    for plate in [&first, &last] {
        assert_eq!(references(&region(&loops(plate)), &region(&loops(&part))), truth);
    }
    for (method, verdict) in verdicts(&last, &part) {
        assert_eq!(verdict, Verdict::Agrees { holes: 1 }, "{method}");
    }
    for (method, verdict) in verdicts(&first, &part) {
        // What a broken list leads to is not determined: an exception or a dead process, or a hole that is lost.
        let harmed = match &verdict {
            Verdict::None(CgalError::Failed(_) | CgalError::Died(_)) | Verdict::Wrong { .. } => true,
            Verdict::Agrees { .. } => false,
            other @ Verdict::None(_) => panic!("{method}: {other:?}"),
        };
        assert_eq!(harmed, is_debian_12(), "{method}: {verdict:?}");
    }
}

/// An error that the random comparison found, made small by hand: CGAL's partition into the fewest convex pieces leaves out
/// part of a polygon of eight vertices, in which vertices of different edges are collinear. In a debug build an assertion
/// stops it.
#[test]
fn the_optimal_partition_leaves_out_a_part() {
    let hook: [Ring; 1] = [vec![(0, 0), (1, 0), (1, 1), (2, 1), (2, 3), (1, 3), (1, 2), (0, 2)]];
    let method: Method = "optimal:exact".parse().expect("a method");
    if is_debian_12() {
        let verdict = verdict(&mut child(), method, &loops(&hook), &loops(&[square(1)]));
        assert_eq!(verdict, Verdict::Wrong { belongs: true });
    }
}
