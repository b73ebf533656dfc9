//! The errors of the engine's formulas against MPFR (memo A2 to A5), the worst inputs known, and printed formulas that must fail.

use arcsum_reports::claims::formulas::angle::{ANGLES, REALIZED_IN_RADIANS};
use arcsum_reports::claims::formulas::arc::{ARCS, PRINTED};
use arcsum_reports::claims::formulas::formula::Formula;
use arcsum_reports::claims::formulas::modification::SECANT;
use arcsum_tests::worst::{Search, Worst};

const DRAWS: usize = 4_000;

#[test]
fn formulas_keep_their_bounds() {
    ANGLES.into_iter().chain(ARCS).chain([SECANT]).for_each(|formula| Search(formula).check(DRAWS));
}

#[test]
fn printed_formulas_fail() {
    for formula in PRINTED.into_iter().chain([REALIZED_IN_RADIANS]) {
        let worst = Search(formula).search(DRAWS, &[]).remove(0);
        println!("{:28} worst {:12.4e} eps at {:?}", formula.name, worst.error, worst.input);
        assert!(worst.error > 1e6, "the check must show that this formula fails: {worst:?}");
    }
}

/// The search itself finds what is wrong with the arc sine.
#[test]
#[should_panic(expected = "exceeds 1.3 eps")]
fn arc_sine_exceeds_the_bound() {
    Search(Formula { bound: 1.3, ..PRINTED[0] }).check(DRAWS);
}

#[test]
#[should_panic(expected = "rose to")]
fn worse_than_kept_is_told() {
    let kept = Worst { error: 0.1, input: vec![0.1, 0.2, 0.3, 0.5, 1.0] };
    let _ = Search(ARCS[0]).again(vec![kept]);
}
