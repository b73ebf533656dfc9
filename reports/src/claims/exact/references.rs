//! F1: sums in exact arithmetic are right whatever the input (FH 1, 2; memo I1, I2).

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::draw;
use crate::bridge::plain;
use crate::kept;
use arcsum_oracle::convex;
use arcsum_oracle::error::{Budget, OracleError};
use arcsum_oracle::number::Number;
use arcsum_oracle::plain::PlainRegion;
use arcsum_oracle::region::ExactRegion;
use arcsum_oracle::trapezoid::{Convex, trapezoids};
use arcsum_oracle::{convolve, decompose, union};
use num_rational::BigRational;
use rug::Rational;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "sums that differ from the first one: by convolution and by decomposition and union, in two number types",
        unit: "1",
        rule: Rule::AtMost(0.0),
        draws: [150, 5_000],
        draw: draw::pair,
        measure: |input| differing(input, all_pieces),
        kept: kept!("F1"),
        control: Control::Measure {
            plants: "the union of the decomposition lacks its largest sum of convex pieces",
            measure: |input| differing(input, all_but_one),
        },
    };
    [Claim {
        id: "F1",
        place: "FH 1, 2",
        says: "With exact numbers the Minkowski sum of polygonal sets is computed exactly and robustly by convex decomposition \
               and union, degenerate input included.",
        erratum: "",
        test: Test::Sup(sup),
    }]
}

/// Vertices in digits: what two number types can be compared by.
type Digits = Vec<Vec<[String; 2]>>;

type Decomposition = fn(&ExactRegion<Rational>, &ExactRegion<Rational>) -> Result<ExactRegion<Rational>, OracleError>;

/// How many of the other three sums differ.
fn differing(input: &Input, decomposition: Decomposition) -> Option<Measured> {
    let case = input.as_pair().filter(|case| case.is_polygonal())?;
    let (a, b) = (plain(&case.a), plain(&case.b));
    let [x, y] = [read::<Rational>(&a)?, read(&b)?];
    let [u, v] = [read::<BigRational>(&a)?, read(&b)?];
    let first = digits(&decomposition(&x, &y).ok()?);
    let others = [
        digits(&convolve::unfiltered_sum(&x, &y, Budget::default()).ok()?),
        digits(&convolve::sum(&u, &v, Budget::default()).ok()?),
        digits(&decompose::sum(&u, &v, Budget::default()).ok()?),
    ];
    Some(Measured::count(others.iter().filter(|other| **other != first).count()))
}

fn read<Q: Number>(region: &PlainRegion) -> Option<ExactRegion<Q>> {
    ExactRegion::from_plain(region).ok()
}

fn digits<Q: Number>(region: &ExactRegion<Q>) -> Digits {
    let vertex = |p: &arcsum_oracle::point::Point<Q>| [p.x.digits(), p.y.digits()];
    let mut loops: Digits = region.loops().iter().map(|ring| ring.iter().map(vertex).collect()).collect();
    loops.push(vec![[region.unbounded().to_string(), String::new()]]);
    loops
}

fn all_pieces(a: &ExactRegion<Rational>, b: &ExactRegion<Rational>) -> Result<ExactRegion<Rational>, OracleError> {
    decompose::sum(a, b, Budget::default())
}

fn all_but_one(a: &ExactRegion<Rational>, b: &ExactRegion<Rational>) -> Result<ExactRegion<Rational>, OracleError> {
    let [p, q] = [a, b].map(|region| trapezoids(region.edges().map(|(t, h)| (t.clone(), h.clone())).collect()));
    let mut sums: Vec<Convex<Rational>> = p.iter().flat_map(|p| q.iter().map(|q| convex::sum(p, q))).collect();
    let area = |piece: &Convex<Rational>| {
        let ring: Vec<_> = piece.iter().map(|place| place.exact.clone()).collect();
        arcsum_oracle::region::ring_area(&ring)
    };
    let largest = (0..sums.len()).max_by_key(|&i| area(&sums[i]));
    largest.map(|i| sums.remove(i));
    ExactRegion::from_edges(union::boundary(&sums, Budget::default())?, false)
}
