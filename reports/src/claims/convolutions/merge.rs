//! M22: the merge of two envelopes, watched from outside by the crossing module that it asks (MS 6; memo E2).
//!
//! An input is curves of which never more than two are over the same abscissa, so that they are two envelopes and one merge.

use super::super::control::Control;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use crate::cases::rng::Rng;
use crate::kept;
use arcsum::angle::Ang;
use arcsum::arrangement::cross::{CrossingModule, Crossings, FloatModule};
use arcsum::arrangement::curve::Curve;
use arcsum::convolution::envelope::envelope;
use arcsum::piece::{Piece, Pieces, Source};
use glam::DVec2;
use std::cell::RefCell;
use std::collections::HashMap;

/// What the numbers are.
const FORMAT: &str = "x0, y0, x1, y1, half sweep of each curve";

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "curves from the first to the last question about which a question falls",
        unit: "1",
        rule: Rule::AtMost(2.0),
        draws: [2_000, 200_000],
        draw: |rng, number| draw(rng, number, 2),
        measure: |input| asked(input).map(|asked| asked.measured(asked.most_active() as f64)),
        kept: kept!("M22_active"),
        control: Control::Inputs { plants: "six curves over an abscissa", draw: |rng, number| draw(rng, number, 6) },
    };
    let claim = |id, says, sup| Claim { id, place: "MS 6", says, erratum: "", test: Test::Sup(sup) };
    [
        claim("M22 active", "The merge of two envelopes has at most two segments active at all times.", sup.clone()),
        claim(
            "M22 linear",
            "The merge of two envelopes takes time linear in their segments, here: no more questions than segments.",
            Sup {
                quantity: "questions to the crossing module by segments",
                rule: Rule::AtMost(1.0),
                measure: |input| {
                    asked(input).map(|asked| asked.measured(asked.pairs.len() as f64 / asked.curves as f64))
                },
                kept: kept!("M22_linear"),
                ..sup
            },
        ),
    ]
}

/// The questions of a merge, by the ends of the two curves.
struct Asked {
    curves: usize,
    pairs: Vec<[[u64; 4]; 2]>,
}

impl Asked {
    /// The greatest number of curves under way at a question: between the first and the last one about them.
    fn most_active(&self) -> usize {
        let mut range: HashMap<[u64; 4], [usize; 2]> = HashMap::new();
        for (time, pair) in self.pairs.iter().enumerate() {
            for curve in pair {
                range.entry(*curve).or_insert([time, time])[1] = time;
            }
        }
        let active = |time: usize| range.values().filter(|[from, to]| (*from..=*to).contains(&time)).count();
        (0..self.pairs.len()).map(active).max().unwrap_or(0)
    }

    fn measured(&self, value: f64) -> Measured {
        Measured::exactly(value).of_size(self.curves)
    }
}

/// The honest module, with a list of what it was asked.
struct Listening {
    honest: FloatModule,
    pairs: RefCell<Vec<[[u64; 4]; 2]>>,
}

impl CrossingModule for Listening {
    fn cross(&self, f: &Curve, g: &Curve) -> Crossings {
        let ends = |c: &Curve| [c.left.x, c.left.y, c.right.x, c.right.y].map(f64::to_bits);
        self.pairs.borrow_mut().push([ends(f), ends(g)]);
        self.honest.cross(f, g)
    }

    fn above(&self, p: DVec2, curve: &Curve) -> f64 {
        self.honest.above(p, curve)
    }

    fn tolerance(&self) -> f64 {
        self.honest.tolerance()
    }
}

/// Makes the upper envelope of an input.
fn asked(input: &Input) -> Option<Asked> {
    let mut pieces = Pieces::default();
    for curve in input.as_numbers(FORMAT)?.chunks_exact(5) {
        let (left, right) = (DVec2::new(curve[0], curve[1]), DVec2::new(curve[2], curve[3]));
        let chord = Ang::of_line(left, right).filter(|_| left.x < right.x)?;
        let tail = pieces.points.len() as u32;
        pieces.points.extend([left, right]);
        let line = Piece::line(tail, tail + 1, chord, Source::default());
        let delta = curve[4];
        pieces.pieces.push(Piece { a: chord.plus(-delta), b: chord.plus(delta), delta, ..line });
    }
    let module = Listening { honest: FloatModule::new(2.0), pairs: RefCell::default() };
    let own: Vec<u32> = (0..pieces.pieces.len() as u32).collect();
    envelope(&mut pieces.points, &pieces.pieces, &own, true, &module);
    Some(Asked { curves: own.len(), pairs: module.pairs.into_inner() }).filter(|asked| asked.curves > 1)
}

/// So many rows of curves, each from left to right, near each other; every third time they nearly coincide.
fn draw(rng: &mut Rng, number: usize, rows: usize) -> Input {
    let near = if number.is_multiple_of(3) { 4.0 * f64::EPSILON } else { 0.2 };
    let mut values = Vec::new();
    for _ in 0..rows {
        let count = 2 + rng.below(20);
        let mut places: Vec<f64> = (0..=count).map(|_| rng.unit()).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut y = || 0.5 + near * rng.between(-1.0, 1.0);
        let heights: Vec<f64> = places.iter().map(|x| x * x * 0.3 + y()).collect();
        for (x, height) in places.windows(2).zip(heights.windows(2)) {
            let rise = libm::atan2((height[1] - height[0]).abs(), x[1] - x[0]);
            let half_sweep = [0.0, 0.5 * rise, -0.5 * rise][rng.below(3)];
            values.extend([x[0], height[0], x[1], height[1], half_sweep]);
        }
    }
    Input::numbers(FORMAT, values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_is_active_from_its_first_to_its_last_question() {
        let pair = |f: u64, g: u64| [[f; 4], [g; 4]];
        let most = |pairs: &[[u64; 2]]| {
            Asked { curves: 0, pairs: pairs.iter().map(|[f, g]| pair(*f, *g)).collect() }.most_active()
        };
        assert_eq!(most(&[]), 0);
        assert_eq!(most(&[[1, 2], [1, 3], [4, 3]]), 2);
        assert_eq!(most(&[[1, 2], [3, 4], [1, 4]]), 3);
    }
}
