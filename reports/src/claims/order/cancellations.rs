//! M29: where two segments cancel, two others are in order (MS 7.1; memo E6, E7), on ordinates of polygons in rationals.

use super::exact::{between, excess, lattice, pair};
use crate::bridge::plain;
use crate::cases::rng::Rng;
use crate::claims::control::Control;
use crate::claims::draw;
use crate::claims::finding::Measured;
use crate::claims::input::Input;
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::kept;
use arcsum_oracle::turnings::{Ordinates, Turning, turnings};
use rug::Rational;

/// Where the rows about cancellations begin in the order table.
const FIRST: usize = 7;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "greatest height of the lower one above the upper one",
        unit: "input units",
        rule: Rule::AtMost(0.0),
        draws: [1_500, 150_000],
        draw: curled,
        measure: |input| measured(input, where_they_cancel),
        kept: kept!("M29"),
        control: Control::Measure {
            plants: "the inequalities also where nothing cancels",
            measure: |input| measured(input, everywhere),
        },
    };
    [Claim {
        id: "M29",
        place: "MS 7.1",
        says: "At two concave turning points, where p1+U2 cancels U1+U2, U1+p2 is not above p1+L2; the other three \
               cancellations are analogous.",
        erratum: "",
        test: Test::Sup(sup),
    }]
}

/// Polygons of many corners on a lattice, which have concave turning points mostly, and any.
fn curled(rng: &mut Rng, number: usize) -> Input {
    if number.is_multiple_of(6) {
        return pair(rng, number);
    }
    let side = 4 + rng.below(3);
    draw::input("curled", lattice(rng, side, 10), lattice(rng, side, 10))
}

/// How far an inequality is broken at pairs of concave turning points; none where there is none to look at.
fn measured(input: &Input, rows: fn(Ordinates) -> Vec<[Rational; 2]>) -> Option<Measured> {
    let case = input.as_pair().filter(|case| case.is_polygonal())?;
    let concave = |region| turnings(&plain(region)).into_iter().filter(|turning| turning.concave).collect::<Vec<_>>();
    let (of_a, of_b) = (concave(&case.a), concave(&case.b));
    let pairs = of_a.iter().flat_map(|p| of_b.iter().filter(|q| q.left == p.left).map(move |q| (p, q)));
    let excesses = pairs.flat_map(|(p, q)| abscissas(p, q).into_iter().map(move |x| Ordinates::new(p, q, &x)));
    let greatest = excesses.flat_map(rows).map(|found| excess(&found)).reduce(f64::max);
    greatest.map(Measured::exactly)
}

/// What the order table says where something cancels.
fn where_they_cancel(ordinates: Ordinates) -> Vec<[Rational; 2]> {
    let of_a = ordinates.rows([true; 2]).into_iter().skip(FIRST).flatten().collect::<Vec<_>>();
    of_a.into_iter().chain(ordinates.exchanged().rows([true; 2]).into_iter().skip(FIRST).flatten()).collect()
}

/// The same wherever the segments are.
fn everywhere(Ordinates { of_a, of_b, .. }: Ordinates) -> Vec<[Rational; 2]> {
    let [[low_a, high_a], [low_b, high_b]] = [of_a, of_b];
    [high_a.zip(low_b), high_b.zip(low_a)].into_iter().flatten().map(|(lower, upper)| [lower, upper]).collect()
}

/// Abscissas on the side of the sum of two turning points where segments are.
fn abscissas(p: &Turning, q: &Turning) -> Vec<Rational> {
    let start = Rational::from(&p.point[0] + &q.point[0]);
    let far = |turning: &Turning| {
        let ends = [&turning.lower, &turning.upper].map(|chain| {
            let xs = chain.path.iter().map(|v| Rational::from(&v[0] - &turning.point[0]).abs());
            xs.max().expect("vertices")
        });
        let [lower, upper] = ends;
        lower.max(upper)
    };
    let reach = far(p) + far(q);
    let end = if p.left { Rational::from(&start + &reach) } else { Rational::from(&start - &reach) };
    let ends = if p.left { [&start, &end] } else { [&end, &start] };
    let whole = between(ends);
    // Most cancellations are near the turning points.
    let near = (Rational::from(&start * 7) + &end) / 8;
    let ends = if p.left { [&start, &near] } else { [&near, &start] };
    whole.into_iter().chain(between(ends)).collect()
}
