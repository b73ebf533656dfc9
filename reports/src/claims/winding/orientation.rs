//! M5: which way sum segments run and which way they bend (MS 3, Fig. 2; memo B1, fact 5).

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::draw;
use super::pieces::{Convolved, Parent};
use super::probes::points;
use crate::kept;
use arcsum::piece::Piece;

/// Pieces looked at from both sides, and other points.
const PIECES: usize = 12;
const PROBES: usize = 12;

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "winding number of t less the certified Euler characteristic of A and t-B together",
        unit: "1",
        rule: Rule::AtMost(0.0),
        draws: [1500, 100_000],
        draw: draw::arcs,
        measure: |input| off(input, bent_as_printed),
        kept: kept!("M5_printed"),
        control: Control::Itself,
    };
    let printed = Claim {
        id: "M5 printed",
        place: "MS 3",
        says: "The sum of circle segments runs as in the four cases of Fig. 2 and has the sum of their signed radii as its \
               signed radius.",
        erratum: "Where the sum runs against its larger summand (a large convex with a small concave segment, or two \
                  concave ones) the signed radius is the negative of that sum.",
        test: Test::Sup(sup.clone()),
    };
    let corrected = Claim {
        id: "M5 corrected",
        place: "MS 3",
        says: "Sum segments that run as in the four cases of Fig. 2, and like cases with lines and turns, with the sum of \
               the signed radii, negated if they run backward: these have the right winding numbers.",
        erratum: "",
        test: Test::Sup(Sup {
            measure: |input| off(input, |_, _| ()),
            kept: kept!("M5_corrected"),
            control: Control::Measure {
                plants: "a large convex and a small concave segment run as the convex one does",
                measure: |input| off(input, against_the_third_case),
            },
            ..sup
        }),
    };
    [printed, corrected]
}

/// The sum of the signed radii decides on which side of the chord the arc is.
fn bent_as_printed(piece: &mut Piece, [a, b]: [Parent; 2]) {
    if piece.delta != 0.0 {
        piece.delta = piece.delta.abs().copysign(a.radius + b.radius);
    }
}

fn against_the_third_case(piece: &mut Piece, parents: [Parent; 2]) {
    if case_of(parents) == Some(Case::LargeConvex) {
        piece.weight = -piece.weight;
    }
}

/// The cases of Fig. 2 and what the memo adds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Case {
    LineConvex,
    LineConcave,
    Convex,
    SmallConvex,
    LargeConvex,
    Concave,
}

fn case_of([a, b]: [Parent; 2]) -> Option<Case> {
    Some(match (a.sign, b.sign) {
        (0, 0) => return None,
        (0, sign) | (sign, 0) => {
            if sign > 0 {
                Case::LineConvex
            } else {
                Case::LineConcave
            }
        }
        (1, 1) => Case::Convex,
        (-1, -1) => Case::Concave,
        _ if a.radius + b.radius < 0.0 => Case::SmallConvex,
        _ => Case::LargeConvex,
    })
}

fn off(input: &Input, change: fn(&mut Piece, [Parent; 2])) -> Option<Measured> {
    let case = input.as_pair()?;
    let mut convolved = Convolved::new(case)?;
    let mut places = convolved.beside(PIECES);
    places.extend(points(case, PROBES).into_iter().map(|p| convolved.framed(p)));
    let mut changed = convolved.pieces.pieces.clone();
    changed.iter_mut().for_each(|piece| change(piece, convolved.parents(piece)));
    convolved.pieces.pieces = changed;
    let (off, spot) = convolved.off(case, places)?;
    let measured = Measured::exactly(f64::from(off));
    Some(spot.map_or_else(|| measured.clone(), |spot| measured.clone().at(spot)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::rng::Rng;
    use std::collections::BTreeSet;

    #[test]
    fn every_case_occurs_with_arcs_and_with_turns() {
        let mut rng = Rng::new(1, "cases");
        let mut met = BTreeSet::new();
        for number in 0..60 {
            let input = draw::arcs(&mut rng, number);
            let convolved = Convolved::new(input.as_pair().unwrap()).unwrap();
            for piece in &convolved.pieces.pieces {
                let parents = convolved.parents(piece);
                let round = parents.iter().all(|parent| parent.radius != 0.0);
                met.extend(case_of(parents).map(|case| (case, round)));
            }
        }
        let lines = met.iter().filter(|(case, _)| *case <= Case::LineConcave).count();
        assert!(lines >= 2 && met.len() - lines == 8, "{met:?}");
    }
}
