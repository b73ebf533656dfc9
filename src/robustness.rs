//! The robustness steps of the engine, each of which can be left out (MS 8.3).
//!
//! Without all of them the same algorithms run in plain doubles, as if these were real numbers: the papers' baseline,
//! against which they measure the cost of robustness. It may answer with a wrong region or an inconsistent map; it still
//! ends, and does not panic.

use crate::sum3::Rounding;

/// A robustness step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Step {
    /// End points of sum segments are rounded once (memo A6); without it, twice.
    Rounding,
    /// Angles keep their offset from an axis (memo A2); without it they are radians in [0, 2 pi]. Their loss is what is
    /// left out: they are stored and compared alike, so the time stays.
    Angles,
    /// Angles at tangential joints are made equal (memo A1).
    Joints,
    /// The convolution takes for convexly compatible what runs forward (MS 6); without it, what has nonnegative curvature
    /// (MS 5.1).
    Forward,
    /// The crossing module checks closed forms by point tests (memo C1); without it, it believes them.
    Crossings,
    /// Neighbours that disagree with the crossing module are swapped at once (memo C2); without it they stay.
    LateSwaps,
    /// Curves that end at a vertex and are not neighbours are brought together (memo C2); without it, each is taken out
    /// where it is.
    Gather,
    /// Lines are cut at vertices on them; without it, they pass by.
    Cuts,
    /// Swaps against the convolution order are refused (MS 7.1).
    OrderedSwaps,
    /// Curves are inserted in convolution order (MS 7.1).
    OrderedInsertion,
}

impl Step {
    /// All steps with their names.
    pub const ALL: [(Self, &'static str); 10] = [
        (Self::Rounding, "rounding"),
        (Self::Angles, "angles"),
        (Self::Joints, "joints"),
        (Self::Forward, "forward"),
        (Self::Crossings, "crossings"),
        (Self::LateSwaps, "late-swaps"),
        (Self::Gather, "gather"),
        (Self::Cuts, "cuts"),
        (Self::OrderedSwaps, "ordered-swaps"),
        (Self::OrderedInsertion, "ordered-insertion"),
    ];
}

/// A set of robustness steps; by default all.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Robustness {
    left_out: u16,
}

impl Robustness {
    /// All steps.
    pub const ALL: Self = Self { left_out: 0 };
    /// No step: the naive engine.
    pub const NONE: Self = Self { left_out: u16::MAX };

    /// These steps but one.
    #[must_use]
    pub const fn without(self, step: Step) -> Self {
        Self { left_out: self.left_out | 1 << step as u8 }
    }

    /// Whether a step is taken.
    #[must_use]
    pub const fn takes(self, step: Step) -> bool {
        self.left_out & (1 << step as u8) == 0
    }

    /// How end points of sum segments are rounded.
    #[must_use]
    pub const fn rounding(self) -> Rounding {
        if self.takes(Step::Rounding) { Rounding::Correct } else { Rounding::Plain }
    }
}

impl Default for Robustness {
    fn default() -> Self {
        Self::ALL
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_step_can_be_left_out_alone() {
        for (step, _) in Step::ALL {
            let without = Robustness::ALL.without(step);
            let left: Vec<Step> = Step::ALL.map(|(s, _)| s).into_iter().filter(|s| !without.takes(*s)).collect();
            assert_eq!(left, [step]);
            assert!(Robustness::ALL.takes(step) && !Robustness::NONE.takes(step));
        }
    }
}
