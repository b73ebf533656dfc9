//! The claims of the papers as experiments: every numbered statement of memo H with what is measured, the bound, the rule of
//! the verdict, and a control that must come out refuted.
//!
//! [`registry::claims`] lists them, [`run`] carries them out, [`seek`] searches for the worst input of one. An experiment is
//! mostly a [`sup::Sup`]: a quantity on single inputs that must stay below a bound on all of them. What does not have that
//! form, because times or counts are compared over many inputs, is a function that ends in a [`finding::Finding`].

pub mod bench;
pub mod control;
mod convolutions;
pub mod draw;
pub mod errata;
mod exact;
pub mod finding;
pub mod formulas;
mod free;
pub mod input;
pub mod kept;
mod models;
mod order;
pub mod picture;
pub mod plot;
pub mod record;
pub mod registry;
pub mod run;
pub mod seek;
pub mod sup;
mod sweep;
mod theorems;
pub mod trend;
mod waits;
mod winding;
pub mod witness;

use bench::Bench;
use control::Control;
use finding::Finding;
use sup::Sup;

/// A statement of a paper, as printed or as corrected.
#[derive(Clone)]
pub struct Claim {
    /// Number in memo H, and which reading it is if there are two: `M9 printed`, `M9 corrected`.
    pub id: &'static str,
    /// Where the paper says it: `MS 4.1`.
    pub place: &'static str,
    /// What it says, in our words.
    pub says: &'static str,
    /// What is wrong with the print, if anything (memo A9); else empty.
    pub erratum: &'static str,
    /// How it is tested.
    pub test: Test,
}

/// How a claim is tested.
#[derive(Clone)]
pub enum Test {
    /// Not yet; why.
    Waits(&'static str),
    /// By a quantity on single inputs.
    Sup(Sup),
    /// By a measurement over many inputs together.
    Whole(Whole),
}

/// A measurement that has its own form.
#[derive(Clone)]
pub struct Whole {
    /// What is measured.
    pub quantity: &'static str,
    /// Its unit, 1 for a pure number.
    pub unit: &'static str,
    /// Measures.
    pub run: fn(&Bench) -> Finding,
    /// What must come out refuted.
    pub control: Control,
}

impl Claim {
    /// The number in memo H: `M9` of `M9 printed`.
    #[must_use]
    pub fn number(&self) -> &'static str {
        self.id.split(' ').next().unwrap_or(self.id)
    }

    /// The name of its files.
    #[must_use]
    pub fn stem(&self) -> String {
        self.id.replace(' ', "_")
    }

    /// What is measured, and its unit.
    #[must_use]
    pub fn quantity(&self) -> [&'static str; 2] {
        match &self.test {
            Test::Waits(_) => ["", ""],
            Test::Sup(sup) => [sup.quantity, sup.unit],
            Test::Whole(whole) => [whole.quantity, whole.unit],
        }
    }
}
