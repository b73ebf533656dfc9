//! Making a worst input small: fewer vertices, and rounder numbers.

use super::super::finding::Worst;
use super::super::input::{Input, Numbers};
use super::super::sup::{Rule, Sup};
use crate::attack::shrink::shrink;
use crate::cases::Case;
use arcsum::region::Node;
use arcsum::validate::validate;

/// What may be lost for the sake of a smaller input: a tenth.
const LOST: f64 = 0.1;

/// Digits after the binary point that a coordinate is rounded to, if it can be.
const DIGITS: [i32; 5] = [0, 2, 5, 10, 20];

/// The input made smaller. It does not cease to refute what it refutes.
pub(super) fn shrunk(worst: Worst, sup: &Sup) -> Worst {
    let least = worst.lo - LOST * worst.lo.abs();
    let least = match sup.rule {
        Rule::AtMost(bound) if worst.lo > bound => least.max(bound.next_up()),
        _ => least,
    };
    let measured = |input: Input| {
        let found = (sup.measure)(&input)?;
        (found.lo >= least).then(|| Worst::new(input, &found))
    };
    match worst.input.clone() {
        Input::Numbers(numbers) => rounder_numbers(worst, numbers, measured),
        Input::Pair(case) => {
            let same = |case: &Case| measured(Input::pair(case.clone()));
            let (case, worst) = shrink(*case, worst, same);
            rounder_case(worst, case, same)
        }
    }
}

fn rounder_numbers(mut worst: Worst, mut numbers: Numbers, measured: impl Fn(Input) -> Option<Worst>) -> Worst {
    for i in 0..numbers.values.len() {
        let kept = numbers.values[i];
        for digits in DIGITS {
            numbers.values[i] = rounded(kept, digits);
            if let Some(found) = measured(Input::Numbers(numbers.clone())) {
                worst = found;
                break;
            }
            numbers.values[i] = kept;
        }
    }
    worst
}

fn rounder_case(mut worst: Worst, mut case: Case, same: impl Fn(&Case) -> Option<Worst>) -> Worst {
    for place in 0..2 * case.segments() {
        for digits in DIGITS {
            let mut rounder = case.clone();
            let Some(coordinate) = coordinate(&mut rounder, place) else { break };
            let before = *coordinate;
            *coordinate = rounded(before, digits);
            if *coordinate == before {
                break;
            }
            let valid = validate(&rounder.a).is_ok() && validate(&rounder.b).is_ok();
            if let Some(found) = same(&rounder).filter(|_| valid) {
                (worst, case) = (found, rounder);
                break;
            }
        }
    }
    worst
}

fn coordinate(case: &mut Case, place: usize) -> Option<&mut f64> {
    let mut nodes = [&mut case.a, &mut case.b].into_iter().flat_map(|region| region.loops.iter_mut().flatten());
    let node: &mut Node = nodes.nth(place / 2)?;
    Some(if place.is_multiple_of(2) { &mut node.x } else { &mut node.y })
}

fn rounded(x: f64, digits: i32) -> f64 {
    libm::scalbn(libm::round(libm::scalbn(x, digits)), -digits)
}

#[cfg(test)]
mod tests {
    use super::super::super::control::Control;
    use super::super::super::finding::Measured;
    use super::*;
    use crate::cases::shape::{polygon, regular};

    #[test]
    fn what_does_not_matter_goes() {
        fn measure(input: &Input) -> Option<Measured> {
            let case = input.as_pair()?;
            Some(Measured::exactly(case.a.loops[0].iter().map(|node| node.x).fold(0.0, f64::max)))
        }
        let rule = Rule::AtMost(0.95);
        let draw = |_: &mut crate::cases::rng::Rng, _: usize| Input::numbers("", []);
        let control = Control::Itself;
        let sup = Sup { quantity: "q", unit: "1", rule, draws: [1, 1], draw, measure, kept: "", control };
        let region = polygon(&regular(9, 1.0, 0.0));
        let case =
            Case { name: "c".into(), family: "f".into(), a: region.clone(), b: region, seed: None, golden: None };
        let worst = Worst::new(Input::pair(case), &Measured::exactly(1.0));
        let small = shrunk(worst, &sup);
        assert!(small.lo > 0.95);
        assert!(small.input.size() < 12, "{small:?}");
    }
}
