//! The order table of memo E6 (MS 7.1) by definition: ordinates of crusts and moved chains of integer polygons, in rationals,
//! at abscissas between their vertices. Every row is met, and met with strict order, so that none could stand the other way
//! round.

use arcsum::region::Region;
use arcsum_reports::cases::rng::Rng;
use arcsum_tests::chains::{Chain, chains, concave, convolved, extreme, rings};
use arcsum_tests::shapes::{Lattice, simple};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use rug::Rational;

/// A left turning point with its lower and its upper chain.
struct Turning {
    lower: Chain,
    upper: Chain,
    concave: bool,
}

/// The ordinates of the six kinds of segments at an abscissa, where there are such.
struct Ordinates {
    crust: [Option<Rational>; 2],
    of_a: [Option<Rational>; 2],
    of_b: [Option<Rational>; 2],
}

fn turnings(region: &Region) -> Vec<Turning> {
    let all = chains(&rings(region)[0]);
    let concave = concave(&all);
    let turning = |k: usize| {
        let (upper, lower) = (&all[k], &all[(k + 1) % all.len()]);
        let is_concave = concave.contains(&lower.path[0]);
        upper.upper.then(|| Turning { lower: lower.clone(), upper: upper.clone(), concave: is_concave })
    };
    (0..all.len()).filter_map(turning).collect()
}

impl Turning {
    fn point(&self) -> &[Rational; 2] {
        &self.lower.path[0]
    }

    /// The ordinates of the lower and the upper chain moved by a point.
    fn moved(&self, by: &[Rational; 2], x: &Rational) -> [Option<Rational>; 2] {
        let own = Rational::from(x - &by[0]);
        [&self.lower, &self.upper].map(|chain| Some(extreme(&chain.path, &own, chain.upper)? + &by[1]))
    }
}

impl Ordinates {
    fn new(p: &Turning, q: &Turning, x: &Rational) -> Self {
        let crust =
            [convolved(&p.lower.path, &q.lower.path, x, false), convolved(&p.upper.path, &q.upper.path, x, true)];
        Self { crust, of_a: p.moved(q.point(), x), of_b: q.moved(p.point(), x) }
    }

    /// The same with the two regions exchanged.
    fn exchanged(self) -> Self {
        Self { of_a: self.of_b, of_b: self.of_a, ..self }
    }

    /// What the rows say that are about A first, as pairs of ordinates of which the first is not above the second. The other
    /// rows are these with the regions exchanged.
    fn rows(&self, [concave_a, concave_b]: [bool; 2]) -> [Option<(Rational, Rational)>; 10] {
        let Self { crust: [low, high], of_a: [low_a, high_a], of_b: [low_b, high_b] } = self;
        let row = |holds: bool, f: &Option<Rational>, g: &Option<Rational>| {
            if holds { f.clone().zip(g.clone()) } else { None }
        };
        let (convex, mixed, both) = (!concave_a, !concave_a && concave_b, concave_a && concave_b);
        let along = |crust: &Option<Rational>, chain: &Option<Rational>| both && crust.is_some() && crust == chain;
        [
            row(concave_b, low, low_a),
            row(concave_b, high_a, high),
            row(concave_b && convex, low_a, high_a),
            row(concave_b && concave_a, high_a, low_a),
            row(mixed && low_a.is_some() && high_a.is_some(), low, high),
            row(mixed && low_a.is_some(), low, high_a),
            row(mixed && high_a.is_some(), low_a, high),
            row(along(high, high_b), high_a, low_b),
            row(along(low, low_a), high_a, low_b),
            row(along(high, high_a) || along(low, low_b), high_b, low_a),
        ]
    }
}

#[test]
fn every_row_holds_and_is_met() {
    let (mut runner, mut random) = (TestRunner::deterministic(), Rng::new(1, "tests"));
    let polygons = simple(16, 0.0, Lattice::Integers(6));
    let mut met = [[0_usize; 2]; 10];
    for _ in 0..3000 {
        let [a, b] = [0, 1].map(|_| polygons.new_tree(&mut runner).expect("a polygon").current());
        for p in turnings(&a) {
            for q in turnings(&b) {
                let start = Rational::from(&p.point()[0] + &q.point()[0]);
                // No vertex, nor a sum of two, has such an abscissa.
                let x = start + Rational::from((random.below(3 * 97) as i64 * 2 + 1, 2 * 97));
                let own = Ordinates::new(&p, &q, &x);
                let rows = own.rows([p.concave, q.concave]);
                let others = own.exchanged().rows([q.concave, p.concave]);
                for (index, row) in rows.into_iter().enumerate().chain(others.into_iter().enumerate()) {
                    let Some((lower, upper)) = row else { continue };
                    assert!(lower <= upper, "row {index} at {x}: {a:?} {b:?}");
                    met[index][usize::from(lower < upper)] += 1;
                }
            }
        }
    }
    assert!(met.iter().all(|[_, strictly]| *strictly > 0), "{met:?}");
}
