//! The convolution order (MS 7.1; memo E6): where its fourth rule ends, and that rows 0 to 3 and 8 of the table matter.
//! Without one of them, free cells come up inside of the sum, or cells of negative winding number. No case is known that
//! needs any other row.
//!
//! The cases were found by search: a region and its copy a few units in the last place off, so that sum segments nearly
//! coincide.

use arcsum::arrangement::cross::{CrossingModule, Crossings};
use arcsum::arrangement::curve::Curve as Sweeped;
use arcsum::arrangement::known::Known;
use arcsum::arrangement::{arrange_with, module};
use arcsum::convolution::ordered::Ordered;
use arcsum::convolution::{monotonic, ordered};
use arcsum::frame::Frame;
use arcsum::region::{Curve, Node, Region};
use arcsum::robustness::{Robustness, Step};
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_oracle::chains::{Chain, chains, concave, convolved, rings};
use arcsum_reports::bridge::plain;
use arcsum_reports::cases::shape::disc;
use arcsum_tests::cases;
use arcsum_tests::shapes::{Lattice, simple};
use glam::DVec2;
use proptest::prelude::*;
use rug::Rational;

fn polygon(corners: &[(f64, f64)]) -> Region {
    Region { loops: vec![corners.iter().map(|&(x, y)| Node::line(x, y)).collect()], ..Region::default() }
}

/// The lower and the upper chain that begin at a left convex turning point, a corner of an integer polygon.
fn chains_from(region: &Region, corner: (i32, i32)) -> [Chain; 2] {
    let p = [Rational::from(corner.0), Rational::from(corner.1)];
    let all = chains(&rings(&plain(region))[0]);
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

/// The abscissa that the shorter chains reach: up to there rule 4 holds.
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
    let all = chains(&rings(&plain(region))[0]);
    let concave = concave(&all);
    let pair = |k: usize| {
        let (before, after) = (&all[k], &all[(k + 1) % all.len()]);
        let is_one = before.upper && !concave.contains(&after.path[0]);
        is_one.then(|| [after.clone(), before.clone()])
    };
    (0..all.len()).filter_map(pair).collect()
}

/// The number of cells of winding number 0, of which the one outside is one, and of those below 0.
fn cells(a: &Region, b: &Region, row: Option<usize>, robustness: Robustness) -> [usize; 2] {
    let frames = Frame::pair(a, b);
    let (x, y) = (Smooth::new(a, &frames.0).expect("valid"), Smooth::new(b, &frames.1).expect("valid"));
    let (pieces, mut order) = monotonic(&x, &y, Rounding::Correct).expect("bounded");
    order.without = row;
    let windings = ordered::arrange(&pieces, &order, robustness).graph.windings;
    [windings.iter().filter(|w| w[0] == 0).count(), windings.iter().filter(|w| w[0] < 0).count()]
}

/// With the whole order only the outside is free, and without a row there are more such cells, or negative ones.
fn assert_row_needed(row: usize, a: &Region, b: &Region, without: [usize; 2]) {
    assert_eq!(cells(a, b, None, Robustness::ALL), [1, 0]);
    assert_eq!(cells(a, b, Some(row), Robustness::ALL), without);
}

fn bent<const N: usize>(corners: [(f64, f64, f64); N]) -> Region {
    let node = |(x, y, bulge)| Node { x, y, curve: if bulge == 0.0 { Curve::Line } else { Curve::Bulge(bulge) } };
    Region { loops: vec![corners.map(node).to_vec()], ..Region::default() }
}

/// Two copies of a sickle, some units in the last place apart.
fn sickles() -> (Region, Region) {
    let (first, second) = (0.5999327185768859, 0.6367238647639679);
    let a = bent([(1.0, 0.0, first), (1.0, 3.0, 0.0), (0.0, -2.0, second)]);
    let b = bent([
        (1.0, -1.3877787807814457e-17, first),
        (1.0000000000000007, 2.9999999999999996, 0.0),
        (-4.163336342344337e-17, -1.9999999999999996, second),
    ]);
    (a, b)
}

/// A dart and a disc.
fn dart() -> (Region, Region) {
    let dart = polygon(&[
        (0.3950550589739455, 0.0),
        (-0.3535088885540677, 0.9300429166182153),
        (-0.22277371960016698, 0.15403072482114194),
        (-0.3178423565775972, -0.2889689090905155),
    ]);
    (dart, disc(0.34327067490750013))
}

#[test]
fn a_lower_crust_stays_below_a_lower_chain_of_a() {
    let (a, b) = sickles();
    assert_row_needed(0, &a, &b, [2, 0]);
}

/// A bent triangle and its negative, turned by a thousandth.
#[test]
fn a_lower_crust_stays_below_a_lower_chain_of_b() {
    let bulges = [0.4530499560958409, 0.18350758145245255, 0.5480051090414139];
    let triangle = |corners: [(f64, f64); 3]| {
        let [p, q, r] = corners;
        bent([(p.0, p.1, bulges[0]), (q.0, q.1, bulges[1]), (r.0, r.1, bulges[2])])
    };
    let a = triangle([
        (0.36689049330429546, 0.0),
        (0.03366889216046678, 0.8753411065641479),
        (-0.48537920503645154, -0.7311754307108267),
    ]);
    let b = triangle([
        (-0.36774515957537496, -0.0003258290632768279),
        (-0.03366889216046678, -0.8753411065641479),
        (0.4838100939784832, 0.7316815474909593),
    ]);
    assert_row_needed(1, &a, &b, [2, 0]);
}

/// A region and itself.
#[test]
fn an_upper_crust_stays_above_an_upper_chain_of_a() {
    let a = bent([(1.0, 0.0, 0.30902281918509444), (0.0, 2.0, 0.2695905120622876), (0.0, -1.0, 0.815692771508225)]);
    assert_row_needed(2, &a, &a, [3, 0]);
}

#[test]
fn an_upper_crust_stays_above_an_upper_chain_of_b() {
    let (a, b) = dart();
    assert_row_needed(3, &a, &b, [2, 0]);
}

/// Two copies of a blade, some units in the last place apart.
#[test]
fn crusts_of_convex_turning_points_stay_in_order() {
    let bulges = [0.07551601473192357, -0.10983189858373917, 0.07273582446293715];
    let a = bent([
        (0.3460513438891418, 0.0, bulges[0]),
        (0.11690135519151552, 0.4060825700454957, bulges[1]),
        (-0.49510743990534956, -0.5068399625343308, bulges[2]),
    ]);
    let b = bent([
        (0.34605134388914194, 4.163336342344337e-17, bulges[0]),
        (0.11690135519151555, 0.40608257004549586, bulges[1]),
        (-0.49510743990534967, -0.5068399625343305, bulges[2]),
    ]);
    assert_row_needed(8, &a, &b, [1, 1]);
}

/// Both uses of the order are needed.
#[test]
fn swaps_and_insertion_need_the_order() {
    let ((a, b), (c, d)) = (dart(), sickles());
    assert_eq!(cells(&a, &b, None, Robustness::ALL), [1, 0]);
    assert_eq!(cells(&a, &b, None, Robustness::ALL.without(Step::OrderedSwaps)), [2, 0]);
    assert_eq!(cells(&c, &d, None, Robustness::ALL), [1, 0]);
    assert_eq!(cells(&c, &d, None, Robustness::ALL.without(Step::OrderedInsertion)), [3, 0]);
}

/// A module that has the sweep ask again about every pair, every so often.
struct Curious<M> {
    module: M,
    step: f64,
}

impl<M: CrossingModule> CrossingModule for Curious<M> {
    fn cross(&self, f: &Sweeped, g: &Sweeped) -> Crossings {
        self.module.cross(f, g)
    }

    fn above(&self, p: DVec2, curve: &Sweeped) -> f64 {
        self.module.above(p, curve)
    }

    fn tolerance(&self) -> f64 {
        self.module.tolerance()
    }

    fn known(&self, f: &Sweeped, g: &Sweeped, x: f64) -> Known {
        let known = self.module.known(f, g, x);
        let next = x + self.step;
        let asks = known.below.is_some() && next < f.end.x.min(g.end.x);
        Known { until: if asks { known.until.min(next) } else { known.until }, only: None, ..known }
    }

    fn agrees(&self, _below: bool, _f: &Sweeped, _g: &Sweeped) -> bool {
        false
    }

    fn placed(&self, f: &Sweeped, g: &Sweeped, x: f64) -> Option<bool> {
        self.module.placed(f, g, x)
    }

    fn related(&self, piece: u32, x: f64, found: &mut Vec<u32>) {
        self.module.related(piece, x, found);
    }
}

/// A refused swap counts once, however often the sweep asks about the pair.
#[test]
fn a_refused_swap_counts_once() {
    let mut refused = 0;
    for (a, b) in [dart(), sickles()] {
        let frames = Frame::pair(&a, &b);
        let (x, y) = (Smooth::new(&a, &frames.0).expect("valid"), Smooth::new(&b, &frames.1).expect("valid"));
        let (pieces, order) = monotonic(&x, &y, Rounding::Correct).expect("bounded");
        let ordered = Ordered { module: module(&pieces), order: &order, robustness: Robustness::ALL };
        let plain = arrange_with(&pieces, &ordered).audit;
        let asked = arrange_with(&pieces, &Curious { module: ordered, step: 1e-3 }).audit;
        assert!(asked.stale > plain.stale, "the sweep asked no more often");
        assert_eq!(asked.cancelled, plain.cancelled);
        refused += plain.cancelled;
        let without = Robustness::ALL.without(Step::OrderedSwaps);
        assert_eq!(ordered::arrange(&pieces, &order, without).audit.cancelled, 0);
    }
    assert!(refused > 0, "no swap was refused");
}
