//! What the robustness steps are good for: without each of them there are sums that come out wrong, or less accurate, and
//! right with it; and without any of them the engine still ends with some answer (MS 8.3).
//!
//! The cases were found by search and made small. The exact oracle is the judge.

use arcsum::arrangement::cross::EPS;
use arcsum::region::{Curve, Node, Region};
use arcsum::robustness::{Robustness, Step};
use arcsum::sum::{Convolution, Options, Sum, sum};
use arcsum_reports::cases::Case;
use arcsum_reports::cases::shape::disc;
use arcsum_reports::engine::Answer;
use arcsum_reports::engine::registry::engine;
use arcsum_reports::judge::{Judgement, judge};
use arcsum_tests::cases;
use arcsum_tests::shapes::{any_region, nudged_copies};
use proptest::prelude::*;

/// An error that no rounding explains, in unit-box lengths.
const WRONG: f64 = 1e-6;

fn polygon(loops: &[&[(f64, f64)]]) -> Region {
    let nodes = |l: &&[(f64, f64)]| l.iter().map(|&(x, y)| Node::line(x, y)).collect();
    Region { loops: loops.iter().map(nodes).collect(), ..Region::default() }
}

fn judged(name: &str, a: &Region, b: &Region) -> (Answer, Judgement) {
    let case = Case { name: name.into(), family: "kept".into(), a: a.clone(), b: b.clone(), seed: None, golden: None };
    let answer = engine(name).expect("known").sum(a, b).expect("valid");
    let judgement = judge(&case, name, &answer);
    (answer, judgement)
}

/// The certified bounds of the error of an engine's answer.
fn errors(name: &str, a: &Region, b: &Region) -> [f64; 2] {
    let (_, judgement) = judged(name, a, b);
    [judgement.mu_lo, judgement.mu_hi].map(|mu| mu.expect("measured"))
}

fn inconsistent(name: &str, a: &Region, b: &Region) -> bool {
    !judged(name, a, b).0.failed_checks.expect("it checks").is_empty()
}

/// Both convolutions are right with all steps and wrong without this one.
fn assert_needed(step: &str, a: &Region, b: &Region) {
    for convolution in ["kinetic", "monotonic"] {
        let [_, with] = errors(convolution, a, b);
        assert!(with <= 20.0 * EPS, "{convolution}: {with}");
        assert!(!inconsistent(convolution, a, b), "{convolution}");
        let [without, _] = errors(&format!("{convolution}-without-{step}"), a, b);
        assert!(without >= WRONG, "{convolution} without {step}: {without}");
    }
}

fn sum_without(step: Step, convolution: Convolution, a: &Region, b: &Region) -> Sum {
    sum(a, b, &Options { convolution, robustness: Robustness::ALL.without(step), ..Options::default() }).expect("valid")
}

/// Nearly upright bars: closed forms place crossings of steep lines a rounding outside of them.
#[test]
fn closed_forms_need_point_tests() {
    let (left, right) = (0.058823529411764705, 0.11764705882352942);
    let a = polygon(&[
        &[(0.0, -0.4764810066927297), (0.05882352941176472, -0.4764810066927297), (left, 0.1), (0.0, 0.1)],
        &[(right, -0.1), (0.17647058823529413, -0.1), (0.17647058823529413, 0.1), (0.11764705882352941, 0.1)],
    ]);
    let b = polygon(&[&[(0.0, -0.3541493669362388), (left, -0.1), (left, 0.1), (0.0, -0.12620654659726593)]]);
    assert_needed("crossings", &a, &b);
}

/// Nearly level bars: neighbours that are found in the wrong order later than where they cross.
#[test]
fn neighbours_in_the_wrong_order_need_late_swaps() {
    let (low, high) = (-1.3877787807814457e-17, 0.058823529411764705);
    let a = polygon(&[&[
        (1.0300497260700057, low),
        (0.9647906849740835, high),
        (-0.8333801654597082, 0.05882352941176473),
        (-1.062285899730487, low),
    ]]);
    let b = polygon(&[
        &[(0.1, 0.0), (0.1, high), (-1.6505650210512184, 0.05882352941176468), (-1.6505650210512184, 0.0)],
        &[
            (0.1, 0.11764705882352944),
            (0.1, 0.17647058823529413),
            (-1.528900688542454, 0.17647058823529413),
            (-1.528900688542454, 0.11764705882352942),
        ],
    ]);
    assert_needed("late-swaps", &a, &b);
}

/// Nearly level bars again: curves that end at a vertex with others between them.
#[test]
fn strangers_need_to_be_swapped_out() {
    let high = 0.058823529411764705;
    let a = polygon(&[
        &[(1.1272065641541988, 0.0), (1.1272065641541988, high), (-0.1, high), (-0.1, 0.0)],
        &[
            (0.1, 0.11764705882352941),
            (-0.0456231727094106, 0.17647058823529413),
            (-1.4946925451412811, 0.17647058823529413),
            (-1.4946925451412811, 0.11764705882352941),
        ],
    ]);
    let b = polygon(&[&[
        (0.1, 0.0),
        (-0.012599014728764138, 0.05882352941176472),
        (-1.1359200760120685, high),
        (-1.1359200760120685, 0.0),
    ]]);
    assert_needed("gather", &a, &b);
}

/// A sum segment that is convexly compatible by its curvature has been rounded to a vertical: with it the convolution is not
/// closed (claim M21).
#[test]
fn the_curvature_rule_opens_the_monotonic_convolution() {
    let a = polygon(&[&[(1.0, 0.0), (2.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (2.0, -2.0), (1.0, -1.0)]]);
    let b = polygon(&[&[(1.0, 0.0), (0.0, 1.0), (-1.3877787807814457e-17, -1.0), (2.0, -2.0)]]);
    assert!(errors("monotonic", &a, &b)[1] <= 20.0 * EPS);
    assert!(!inconsistent("monotonic", &a, &b));
    assert!(inconsistent("monotonic-without-forward", &a, &b));
}

/// A rounded triangle and a disc of the same radius: three lines and three arcs, one of them in two parts as the disc is made of
/// two. Without agreement at the joints there are slivers.
#[test]
fn joints_that_do_not_agree_leave_slivers() {
    let node = |x, y, radius| Node { x, y, curve: Curve::Radius(radius) };
    let nodes = vec![
        node(1.5150711968681787, -0.16164293437727376, 0.25),
        Node::line(1.5746893044202765, 0.28354046371981567),
        node(-0.6113249509436927, 1.7408833006291284, 0.25),
        Node::line(-1.0, 1.5328707270446675),
        node(-1.0, -0.6531435283193017, 0.25),
        Node::line(-0.6709430584957905, -0.8903143528319302),
    ];
    let a = Region { loops: vec![nodes], ..Region::default() };
    for convolution in [Convolution::Kinetic, Convolution::Monotonic] {
        let with = sum(&a, &disc(0.25), &Options { convolution, ..Options::default() }).expect("valid");
        assert_eq!(with.region.segments(), 7, "{convolution:?}");
        assert!(sum_without(Step::Joints, convolution, &a, &disc(0.25)).region.segments() > 7, "{convolution:?}");
    }
}

/// Integer coordinates give the exact map, with one vertex a place, only if lines are cut where vertices lie on them.
#[test]
fn vertices_on_lines_need_cuts() {
    let a = polygon(&[&[(0.0, 2.0), (2.0, 2.0), (2.0, 3.0), (0.0, 3.0)]]);
    let b = polygon(&[&[(0.0, 0.0), (1.0, 1.0), (0.0, 1.0)], &[(1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0)]]);
    let repeated = |sum: &Sum| {
        let points = &sum.arrangement.graph.points;
        points.iter().enumerate().filter(|(i, p)| points[..*i].contains(p)).count()
    };
    let with = sum(&a, &b, &Options::default()).expect("valid");
    assert_eq!(repeated(&with), 0);
    assert!(repeated(&sum_without(Step::Cuts, Convolution::Kinetic, &a, &b)) > 0);
}

/// The certified error is larger when end points are rounded twice.
#[test]
fn rounding_twice_costs_accuracy() {
    let line = Node::line;
    let bent = |x, y, bulge| Node { x, y, curve: Curve::Bulge(bulge) };
    let a = vec![
        line(0.6118981866879157, 0.0),
        line(-0.7077634044684337, 0.08359783709140395),
        bent(-0.0930270638211932, -0.4071638479892029, -0.19991762666858862),
    ];
    let b = vec![
        bent(0.8999694026067789, 0.0, 0.33978038609708305),
        line(-0.36450990257091015, 0.1603904272236657),
        line(-0.8019672532768755, -0.35053417483671984),
    ];
    let [a, b] = [a, b].map(|nodes| Region { loops: vec![nodes], ..Region::default() });
    assert!(errors("kinetic", &a, &b)[1] < errors("kinetic-without-rounding", &a, &b)[0]);
}

/// And when angles are stored in radians.
#[test]
fn radians_cost_accuracy() {
    let line = Node::line;
    let bent = |x, y, bulge| Node { x, y, curve: Curve::Bulge(bulge) };
    let a = vec![
        line(2.0, 0.0),
        bent(0.0, 1.0, -0.04391138642142923),
        bent(-2.0, 1.0, -0.44783299768964324),
        bent(-1.0, -1.0, 0.012542739911734439),
        line(0.0, -1.0),
        bent(1.0, -1.0, 0.15721434416648591),
    ];
    let b = vec![
        line(2.0, 0.0),
        line(1.0, 1.0),
        bent(0.0, 3.0, -0.04295230178225536),
        bent(-2.0, 2.0, -0.5407776381494546),
        line(-1.0, 0.0),
        bent(0.0, -2.0, -0.6768022320424962),
    ];
    let [a, b] = [a, b].map(|nodes| Region { loops: vec![nodes], ..Region::default() });
    assert!(errors("kinetic", &a, &b)[1] < errors("kinetic-without-angles", &a, &b)[0]);
}

proptest! {
    #![proptest_config(cases(1500))]

    /// Whatever steps are left out, there is an answer with finite numbers.
    #[test]
    fn the_naive_engine_ends(
        (a, copy) in nudged_copies(any_region()),
        other in any_region(),
        same in any::<bool>(),
        steps in prop::sample::subsequence(Step::ALL.to_vec(), 0..=Step::ALL.len()),
        convolution in prop_oneof![Just(Convolution::Kinetic), Just(Convolution::Monotonic)],
    ) {
        let robustness = steps.iter().fold(Robustness::ALL, |all, (step, _)| all.without(*step));
        let b = if same { copy.negated() } else { other };
        let sum = sum(&a, &b, &Options { convolution, robustness, ..Options::default() }).expect("valid");
        prop_assert!(sum.region.loops.iter().flatten().all(|n| n.x.is_finite() && n.y.is_finite()));
        prop_assert!(sum.arrangement.graph.edges.iter().all(|e| e.to != u32::MAX));
        if robustness.takes(Step::Gather) {
            prop_assert_eq!(sum.arrangement.audit.apart, 0);
        }
    }
}
