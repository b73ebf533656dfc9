//! Iterated sums P + k Q: the error grows no worse than linearly in the depth k and leaves more than 40 bits at depth 10, and
//! the number of segments is that of the exact sum (MS 8.1; memo D, M46).
//!
//! Polygons are judged by the exact sum of exact sums. For arcs there is no such chain: each step is measured against the
//! certified sum of the two operands as stored, and the errors are added up, which bounds the error of the whole because
//! sums are 1-Lipschitz. What tidying moves is part of each step. With `--nocapture` the tests print what they measure.

use arcsum::arrangement::cross::EPS;
use arcsum::boolean::{Operation, combine};
use arcsum::iterate::partial_sums;
use arcsum::region::Region;
use arcsum::sum::{Convolution, Options, sum};
use arcsum::tidy::{MOVES, TOLERANCES};
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::convolve;
use arcsum_oracle::error::Budget;
use arcsum_oracle::measure::hausdorff;
use arcsum_oracle::region::ExactRegion;
use arcsum_reports::bridge::{plain, unit};
use arcsum_reports::cases::rng::Rng;
use arcsum_reports::cases::{combs, parts, place, radial, shape, twoopt};
use arcsum_tests::cases;
use arcsum_tests::shapes::{Lattice, any_region, holed, simple};
use proptest::prelude::*;
use rug::Rational;

/// The greatest depth.
const DEPTH: usize = 10;

/// What one step may be off by in units of eps and of the unit box of its operands: a sum by 20 (see [`crate::exact`]), and
/// what tidying moves in a box of up to twice that side.
const STEP: f64 = 20.0 + 2.0 * MOVES * TOLERANCES[0];

fn exact(region: &Region) -> ExactRegion<Rational> {
    ExactRegion::from_plain(&plain(region)).expect("polygonal and finite")
}

/// P + Q, P + 2 Q, ...
fn iterated(p: &Region, q: &Region, convolution: Convolution) -> Vec<Region> {
    let options = Options { convolution, ..Options::default() };
    partial_sums(p, std::iter::repeat_n(q, DEPTH), options).collect::<Result<_, _>>().expect("can be summed")
}

/// The exact sums, likewise.
fn truths(p: &Region, q: &Region) -> Vec<ExactRegion<Rational>> {
    let (mut truth, q) = (exact(p), exact(q));
    let mut next = || {
        truth = convolve::sum(&truth, &q, Budget::default()).expect("within budget");
        truth.clone()
    };
    std::iter::repeat_with(&mut next).take(DEPTH).collect()
}

/// The sides of the unit boxes of the steps: of the sum so far and Q.
fn units(p: &Region, q: &Region, sums: &[Region]) -> Vec<f64> {
    std::iter::once(p).chain(sums).take(sums.len()).map(|before| unit(before, q)).collect()
}

/// The upper bound of the distance of each from the truth, in units of the step.
fn errors(sums: &[Region], truths: &[ExactRegion<Rational>], units: &[f64]) -> Vec<f64> {
    let error =
        |((sum, truth), unit): ((&Region, _), &f64)| hausdorff(&plain(sum), truth, *unit).expect("measurable").hi;
    sums.iter().zip(truths).zip(units).map(error).collect()
}

/// Whether the errors, each in units of its step, add up to no more than a step's at each depth.
fn grows_linearly(errors: &[f64], units: &[f64]) -> bool {
    let allowed = units.iter().scan(0.0, |total, unit| {
        *total += STEP * EPS * unit;
        Some(*total / unit)
    });
    errors.iter().zip(allowed).all(|(error, allowed)| *error <= allowed)
}

fn print(name: &str, convolution: Convolution, sums: &[Region], errors: &[f64]) {
    let entry = |(sum, error): (&Region, &f64)| format!(" {:.1}/{}", -libm::log2(*error), sum.segments());
    println!("{name} {convolution:?}, bits/segments:{}", sums.iter().zip(errors).map(entry).collect::<String>());
}

/// Checks the errors, and that no vertices are lost or gained.
fn check(name: &str, p: &Region, q: &Region) -> Result<(), TestCaseError> {
    let truths = truths(p, q);
    for convolution in [Convolution::Kinetic, Convolution::Monotonic] {
        let sums = iterated(p, q, convolution);
        let units = units(p, q, &sums);
        let errors = errors(&sums, &truths, &units);
        print(name, convolution, &sums, &errors);
        prop_assert!(grows_linearly(&errors, &units), "{errors:?}");
        prop_assert!(errors.iter().all(|error| *error < 2_f64.powi(-40)), "{errors:?}");
        let vertices: Vec<usize> = truths.iter().map(ExactRegion::vertices).collect();
        prop_assert_eq!(sums.iter().map(Region::segments).collect::<Vec<_>>(), vertices);
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn random_polygons(p in holed(7, 0.0, Lattice::Fine), q in simple(7, 0.0, Lattice::Fine)) {
        check("random", &p, &q)?;
    }

    #[test]
    fn integer_polygons(p in holed(7, 0.0, Lattice::Integers(5)), q in simple(7, 0.0, Lattice::Integers(3))) {
        check("integers", &p, &q)?;
    }

    /// Erosions: the complement grows, and its holes shrink until they vanish.
    #[test]
    fn complements(p in simple(7, 0.0, Lattice::Fine), q in simple(7, 0.0, Lattice::Fine)) {
        check("complements", &place::scaled(&p, 8.0).complement(), &q)?;
    }

    /// Sums and set operations in turn, none refused.
    #[test]
    fn sums_and_set_operations(p in any_region(), q in any_region(), steps in prop::collection::vec(0..6_usize, 5)) {
        let operations = [Operation::Union, Operation::Intersection, Operation::Difference];
        let mut so_far = p.clone();
        for step in steps {
            let options = Options { convolution: [Convolution::Kinetic, Convolution::Monotonic][step % 2], ..Options::default() };
            so_far = match operations.get(step) {
                Some(operation) => combine(*operation, &so_far, &q).map_err(|e| TestCaseError::fail(e.to_string()))?,
                None => sum(&so_far, &p, &options).map_err(|e| TestCaseError::fail(e.to_string()))?.region,
            };
        }
    }
}

#[test]
fn families_of_polygons() {
    let mut rng = Rng::new(1, "iterated");
    let teeth: Vec<_> = parts::gear(8).iter().map(|n| [n.x, n.y]).collect();
    let gear = shape::polygon(&teeth);
    let named = [
        ("gear", (gear.clone(), gear)),
        ("radial", radial::stars(6, &mut rng)),
        ("combs", combs::combs(4)),
        ("comb and polygon", combs::comb_and_polygon(4, 8)),
        ("twoopt", (twoopt::simple(12, &mut rng), twoopt::simple(12, &mut rng))),
        ("regular", (shape::polygon(&shape::regular(5, 1.0, 0.1)), shape::polygon(&shape::regular(12, 1.0, 0.1)))),
    ];
    for (name, (p, q)) in named {
        check(name, &p, &q).unwrap_or_else(|e| panic!("{name}: {e}"));
    }
}

/// The bounds of the errors after each step, in units of the step.
fn certified(p: &Region, q: &Region, sums: &[Region], units: &[f64]) -> Vec<f64> {
    let mut total = 0.0;
    let mut step = |((before, sum), unit): ((&Region, &Region), &f64)| {
        let reference = Reference::new(&plain(before), &plain(q), *unit, Budget::default()).expect("within budget");
        total += unit * reference.measure(&plain(sum)).expect("measurable").expect("decided").hi;
        total / unit
    };
    std::iter::once(p).chain(sums).zip(sums).zip(units).map(&mut step).collect()
}

#[test]
fn parts_keep_their_arcs_and_their_bits() {
    for (name, depth) in [("1a", 3), ("1b", 1), ("2a", 10), ("2b", 5), ("3", 10), ("4", 4)] {
        let part = parts::part(name).expect("known");
        for convolution in [Convolution::Kinetic, Convolution::Monotonic] {
            let sums = iterated(&part, &part, convolution);
            let units = units(&part, &part, &sums);
            let errors = certified(&part, &part, &sums[..depth], &units);
            print(name, convolution, &sums, &errors);
            assert!(grows_linearly(&errors, &units), "{name}: {errors:?}");
            assert!(errors.iter().all(|error| *error < 2_f64.powi(-40)), "{name}: {errors:?}");
            assert!(!sums[DEPTH - 1].is_polygonal(), "{name}");
        }
    }
}

/// Planted: every step is 2^-42 of its unit box off to one side, as if some rounding were a little coarse.
#[test]
fn a_coarse_step_is_found() {
    let q = shape::polygon(&shape::regular(5, 1.0, 0.1));
    let mut sums = iterated(&q, &q, Convolution::Kinetic);
    let units = units(&q, &q, &sums);
    let mut off = 0.0;
    for (sum, unit) in sums.iter_mut().zip(&units) {
        off += unit * 2_f64.powi(-42);
        *sum = place::moved(sum, [off, 0.0]);
    }
    let errors = errors(&sums, &truths(&q, &q), &units);
    assert!(!grows_linearly(&errors, &units) && errors[DEPTH - 1] > 2_f64.powi(-40), "{errors:?}");
}

/// Without tidying, edges that are parallel or concentric but for rounding stay apart.
#[test]
fn raw_sums_grow() {
    let part = parts::part("2c").expect("known");
    let raw = |sum_so_far: Region, _| sum(&sum_so_far, &part, &Options::default()).expect("can be summed").region;
    let raw = (0..2).fold(part.clone(), raw);
    let tidied = &iterated(&part, &part, Convolution::Kinetic)[1];
    assert!(raw.segments() > 3 * tidied.segments() / 2, "{} {}", raw.segments(), tidied.segments());
}
