//! A formula of the engine, or of the papers, with inputs that are hard on it and its error against MPFR.

use super::super::finding::Measured;
use super::super::input::Input;
use crate::cases::rng::Rng;
use arcsum::angle::Ang;
use arcsum_oracle::precise;
use glam::DVec2;
use rug::Float;

/// A formula.
#[derive(Clone, Copy)]
pub struct Formula {
    /// Its name.
    pub name: &'static str,
    /// What its error may be at most by its derivation, in eps; infinite for a formula known to fail.
    pub bound: f64,
    /// Draws an input.
    pub draw: fn(&mut Rng) -> Vec<f64>,
    /// The error in eps = 2^-53 of what it counts against; none if the formula is not for this input.
    pub error: fn(&[f64]) -> Option<f64>,
}

/// The error of the formula that the input names, if it is one of these.
pub(super) fn measure(formulas: &[Formula], input: &Input) -> Option<Measured> {
    let found = formulas.iter().find_map(|formula| Some((formula, input.as_numbers(formula.name)?)));
    found.and_then(|(formula, values)| (formula.error)(values)).map(Measured::exactly)
}

/// An input of one of these formulas, by turns.
pub(super) fn draw(formulas: &[Formula], rng: &mut Rng, number: usize) -> Input {
    let formula = formulas[number % formulas.len()];
    Input::numbers(formula.name, (formula.draw)(rng))
}

/// The angle as the engine stores it, taken literally: axis times pi/2 plus offset.
#[must_use]
pub fn value(angle: Ang) -> Float {
    precise::angle(angle.axis(), angle.offset())
}

/// Tail and head.
#[must_use]
pub fn ends(input: &[f64]) -> (DVec2, DVec2) {
    (DVec2::new(input[0], input[1]), DVec2::new(input[2], input[3]))
}
