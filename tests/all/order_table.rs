//! The order table of memo E6 (MS 7.1) by definition: ordinates of crusts and moved chains of integer polygons, in rationals,
//! at abscissas between their vertices. Every row is met, and met with strict order, so that none could stand the other way
//! round.

use arcsum_oracle::turnings::{Ordinates, Turning, turnings};
use arcsum_reports::bridge::plain;
use arcsum_tests::random::Random;
use arcsum_tests::shapes::{Lattice, simple};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use rug::Rational;

#[test]
fn every_row_holds_and_is_met() {
    let (mut runner, mut random) = (TestRunner::deterministic(), Random::new(1));
    let polygons = simple(16, 0.0, Lattice::Integers(6));
    let mut met = [[0_usize; 2]; 10];
    for _ in 0..3000 {
        let [a, b] = [0, 1].map(|_| polygons.new_tree(&mut runner).expect("a polygon").current());
        let lefts =
            |region| turnings(&plain(region)).into_iter().filter(|turning| turning.left).collect::<Vec<Turning>>();
        let (lefts_a, lefts_b) = (lefts(&a), lefts(&b));
        for (p, q) in lefts_a.iter().flat_map(|p| lefts_b.iter().map(move |q| (p, q))) {
            let start = Rational::from(&p.point[0] + &q.point[0]);
            // No vertex, nor a sum of two, has such an abscissa.
            let x = start + Rational::from((random.below(3 * 97) as i64 * 2 + 1, 2 * 97));
            let own = Ordinates::new(p, q, &x);
            let rows = own.rows([p.concave, q.concave]);
            let others = own.exchanged().rows([q.concave, p.concave]);
            for (index, row) in rows.into_iter().enumerate().chain(others.into_iter().enumerate()) {
                let Some([lower, upper]) = row else { continue };
                assert!(lower <= upper, "row {index} at {x}: {a:?} {b:?}");
                met[index][usize::from(lower < upper)] += 1;
            }
        }
    }
    assert!(met.iter().all(|[_, strictly]| *strictly > 0), "{met:?}");
}
