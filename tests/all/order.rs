//! The convolution order (MS 7.1; memo E6): where its fourth rule ends, and that each rule matters. Without a rule, cells that
//! are free come up inside of the sum, or cells of negative winding number.
//!
//! The cases were found by search: a region and its copy a few units in the last place off, so that sum segments nearly
//! coincide.

use arcsum::region::{Node, Region};
use arcsum_tests::cases;
use arcsum_tests::chains::{Chain, chains, concave, convolved, rings};
use arcsum_tests::shapes::{Lattice, simple};
use proptest::prelude::*;
use rug::Rational;

fn polygon(corners: &[(f64, f64)]) -> Region {
    Region { loops: vec![corners.iter().map(|&(x, y)| Node::line(x, y)).collect()], ..Region::default() }
}

/// The lower and the upper chain that begin at a left convex turning point, a corner of an integer polygon.
fn chains_from(region: &Region, corner: (i32, i32)) -> [Chain; 2] {
    let p = [Rational::from(corner.0), Rational::from(corner.1)];
    let all = chains(&rings(region)[0]);
    let lower = all.iter().find(|chain| !chain.upper && chain.path.first() == Some(&p));
    let upper = all.iter().find(|chain| chain.upper && chain.path.last() == Some(&p));
    [lower, upper].map(|chain| chain.expect("a left turning point").clone())
}

/// How far right a chain reaches.
fn reach(chain: &Chain) -> &Rational {
    chain.path.iter().map(|p| &p[0]).max().expect("vertices")
}

/// The ordinates of L1+L2 and U1+U2 at an abscissa where both are.
fn crusts(a: &[Chain; 2], b: &[Chain; 2], x: &Rational) -> Option<[Rational; 2]> {
    let crust = |kind: usize| convolved(&a[kind].path, &b[kind].path, x, kind == 1);
    Some([crust(0)?, crust(1)?])
}

/// The abscissa up to which rule 4 holds.
fn common(a: &[Chain; 2], b: &[Chain; 2]) -> Rational {
    let shorter = |chains: &[Chain; 2]| reach(&chains[0]).min(reach(&chains[1])).clone();
    shorter(a) + shorter(b)
}

/// Rule 4 of MS, L1+L2 <= U1+U2 wherever both are, is wrong beyond the sum of the shorter chains.
#[test]
fn the_fourth_rule_ends_with_the_shorter_chains() {
    let a = chains_from(&polygon(&[(2.0, 3.0), (3.0, 1.0), (1.0, 0.0), (4.0, 0.0)]), (2, 3));
    let b = chains_from(&polygon(&[(2.0, 1.0), (4.0, 4.0), (0.0, 3.0), (3.0, 3.0)]), (2, 1));
    assert_eq!(common(&a, &b), 6);
    let beyond = crusts(&a, &b, &Rational::from((13, 2))).expect("both crusts go on to 7");
    assert_eq!(beyond, [Rational::from((17, 4)), Rational::from((15, 4))]);
}

proptest! {
    #![proptest_config(cases(400))]

    /// Up to there it holds.
    #[test]
    fn the_fourth_rule_holds_as_far_as_the_shorter_chains(
        a in simple(8, 0.0, Lattice::Integers(4)),
        b in simple(8, 0.0, Lattice::Integers(4)),
        part in 1..20,
    ) {
        let (all_a, all_b) = (left_convex(&a), left_convex(&b));
        for (p, q) in all_a.iter().flat_map(|p| all_b.iter().map(move |q| (p, q))) {
            let start = Rational::from(&p[0].path[0][0] + &q[0].path[0][0]);
            let x = (common(p, q) - &start) * part / 20 + &start;
            let [lower, upper] = crusts(p, q, &x).expect("both run up to there");
            prop_assert!(lower <= upper);
        }
    }
}

/// The pairs of chains that begin at the left convex turning points of a polygon.
fn left_convex(region: &Region) -> Vec<[Chain; 2]> {
    let all = chains(&rings(region)[0]);
    let concave = concave(&all);
    let pair = |k: usize| {
        let (before, after) = (&all[k], &all[(k + 1) % all.len()]);
        let is_one = before.upper && !concave.contains(&after.path[0]);
        is_one.then(|| [after.clone(), before.clone()])
    };
    (0..all.len()).filter_map(pair).collect()
}
