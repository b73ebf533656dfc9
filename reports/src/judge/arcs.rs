//! Regions with circle segments: the sums of polygons inside and around the operands enclose the exact sum (memo I6 in the
//! form of certified bounds). They tell how wrong a result is at least, and whether its area can be right.
//!
//! The upper bound contains what the polygons leave open, so it says more about them than about the engine: it goes to
//! the note, and the status is undecided.

use super::Judgement;
use super::why::WANTED_BITS;
use crate::bridge::{plain, unit};
use crate::cases::Case;
use crate::engine::Answer;
use arcsum::region::{Curve, Region};
use arcsum_oracle::enclose::{Enclosure, enclose};
use arcsum_oracle::error::{Budget, OracleError};
use arcsum_oracle::interval::Interval;
use arcsum_oracle::measure::Direction;
use arcsum_oracle::probe::bracket;
use rug::Rational;

/// Chords or tangents for a circle segment, the most that is affordable.
const PIECES: [usize; 5] = [32, 16, 8, 4, 2];

/// The product of the vertices of both operands' polygons that is affordable: a few seconds.
const AFFORDABLE: usize = 40_000;

/// Judges the answer to a case with circle segments.
pub(super) fn judge(case: &Case, answer: &Answer) -> Judgement {
    measured(case, answer).unwrap_or_else(|e| Judgement::undecided(e.to_string()))
}

fn measured(case: &Case, answer: &Answer) -> Result<Judgement, OracleError> {
    let pieces = pieces(&case.a, &case.b);
    let operand = |region: &Region| enclose::<Rational>(&plain(region), pieces);
    let sum = operand(&case.a)?.sum(&operand(&case.b)?, Budget::default())?;
    let result = operand(&answer.region)?;
    let bounds = bracket(&result, &sum, unit(&case.a, &case.b))?;
    let (x, y) = bounds.witness;
    let within = if bounds.hi.is_finite() { format!(", at most {:.1e}", bounds.hi) } else { String::new() };
    Ok(Judgement {
        mu_lo: Some(bounds.lo + 0.0),
        direction: Some(if bounds.direction == Direction::FromResult { "result" } else { "sum" }.to_owned()),
        witness: (x.is_finite() && y.is_finite()).then_some([x, y]),
        exact_loops: agreed_loops(&sum),
        failed_checks: failed(answer, bounds.lo, &result, &sum),
        ..Judgement::undecided(format!(
            "bounds by polygons of {pieces} sides an arc: mu at least {:.1e}{within}",
            bounds.lo
        ))
    })
}

fn pieces(a: &Region, b: &Region) -> usize {
    let vertices = |region: &Region, pieces: usize| {
        let arcs = region.loops.iter().flatten().filter(|n| n.curve != Curve::Line).count();
        region.segments() + arcs * (pieces - 1)
    };
    let fits = |&&p: &&usize| vertices(a, p) * vertices(b, p) <= AFFORDABLE;
    *PIECES.iter().find(fits).unwrap_or(&PIECES[PIECES.len() - 1])
}

/// The loops of the sum if the polygons inside and around it have as many: no proof, but no coincidence either.
fn agreed_loops(sum: &Enclosure<Rational>) -> Option<u64> {
    let (inner, outer) = (sum.inner.loops().len(), sum.outer.loops().len());
    (inner == outer).then_some(inner as u64)
}

/// Whether a boundary as long as this is plausible between the polygons inside and around the sum. Length is not monotone:
/// a tenth is left for what flattening arcs adds.
fn plausible_length(length: f64, sum: &Enclosure<Rational>) -> bool {
    let (inner, outer) = (sum.inner.perimeter(), sum.outer.perimeter());
    length >= 0.9 * inner.lo().min(outer.lo()) && length <= 1.1 * inner.hi().max(outer.hi())
}

/// Areas that cannot be equal, implausible perimeters, loops other than agreed on, and errors that leave fewer bits than wanted.
fn failed(answer: &Answer, mu: f64, result: &Enclosure<Rational>, sum: &Enclosure<Rational>) -> Vec<String> {
    let apart = |p: Interval, q: Interval| p.hi() < q.lo() || q.hi() < p.lo();
    let loops = agreed_loops(sum).is_some_and(|n| n != answer.region.loops.len() as u64);
    let short = -mu.log2() < WANTED_BITS;
    let checks = [
        ("bits", short),
        ("area", apart(result.area(), sum.area())),
        ("perimeter", !plausible_length(answer.region.perimeter(), sum)),
        ("loops", loops),
    ];
    checks.into_iter().filter(|(_, failed)| *failed).map(|(name, _)| name.to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{disc, polygon, rectangle};

    fn judged(answer: Region) -> Judgement {
        let case = Case { name: "c".into(), family: "f".into(), a: disc(1.0), b: disc(0.5), seed: None, golden: None };
        judge(&case, &Answer { region: answer, ..Answer::default() })
    }

    #[test]
    fn the_right_disc_passes_and_wrong_ones_do_not() {
        let right = judged(disc(1.5));
        assert!(right.failed_checks.is_empty() && right.mu_lo.is_some_and(|mu| mu < 1e-15), "{right:?}");
        // The unit box has side 2: off by 1/4 of an input unit is 1/8.
        let small = judged(disc(1.25));
        assert_eq!(small.failed_checks, ["bits", "area", "perimeter"]);
        assert!(small.mu_lo.is_some_and(|mu| mu > 0.12 && mu <= 0.125), "{small:?}");
        assert_eq!(small.direction.as_deref(), Some("sum"));
    }

    #[test]
    fn a_square_of_the_right_area_is_told_by_its_distance() {
        let side = 1.5 * std::f64::consts::PI.sqrt();
        let square = judged(polygon(&rectangle([-0.5 * side, -0.5 * side], [0.5 * side, 0.5 * side])));
        assert_eq!(square.failed_checks, ["bits", "perimeter"]);
        assert_eq!(square.direction.as_deref(), Some("result"));
    }

    #[test]
    fn pieces_shrink_as_regions_grow() {
        let many = |n: u32| {
            crate::cases::radial::bulging(
                n,
                crate::cases::radial::Bending::Out,
                &mut crate::cases::rng::Rng::new(1, "pieces"),
            )
        };
        assert_eq!(pieces(&disc(1.0), &disc(1.0)), 32);
        assert_eq!(pieces(&many(40), &many(40)), 4);
        assert_eq!(pieces(&many(4000), &many(4000)), 2);
    }
}
