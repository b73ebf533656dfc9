//! M34: the monotonic convolution has no falsely free points (MS 7.2, Theorem 4).

use super::mu::Mu;
use super::probes::deepest;
use crate::cases::Case;
use crate::claims::control::Control;
use crate::claims::draw;
use crate::claims::finding::Measured;
use crate::claims::input::Input;
use crate::claims::order::swept::Swept;
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::kept;
use arcsum::piece::Piece;
use arcsum::robustness::Robustness;
use arcsum::sum::{Convolution, Options};

/// What is called steep: a piece that is not vertical and no wider than this, though it is taller. Sums in the unit box are
/// rounded to multiples of 2^-53 or 2^-52.
const NARROW: f64 = 64.0 * f64::EPSILON;

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "greatest inradius of the overlap at a free point of the monotonic sum over mu",
        unit: "mu",
        rule: Rule::AtMost(1.0),
        draws: [60, 6_000],
        draw: draw::pair,
        measure: |input| measured(input, &Options::default()),
        kept: kept!("M34_printed"),
        control: Control::Measure { plants: "the kinetic sum", measure: |input| measured(input, &kinetic()) },
    };
    let printed = Claim {
        id: "M34 printed",
        place: "MS 7.2, Theorem 4",
        says: "The approximate monotonic sum of 2 mu separated regions has no falsely free points: wherever it is free, \
               perturbations by mu make the parts free.",
        erratum: "The proof takes errors of mu to be vertical ones. A line a few roundings wide in x rises by much within \
                  them, and then no order of ordinates is right within mu.",
        test: Test::Sup(sup.clone()),
    };
    let corrected = Claim {
        id: "M34 corrected",
        place: "MS 7.2, Theorem 4",
        says: "There are no falsely free points if, besides, no segment of the convolution is a few roundings wide and taller.",
        erratum: "",
        test: Test::Sup(Sup {
            measure: |input| measured(input, &Options::default()).filter(|_| input.as_pair().is_some_and(is_plain)),
            kept: kept!("M34_corrected"),
            control: Control::Claim("M34 printed"),
            ..sup
        }),
    };
    [printed, corrected]
}

/// Whether no piece of the convolution of a case is steep.
fn is_plain(case: &Case) -> bool {
    let Some(swept) = Swept::new(case, Robustness::ALL) else { return false };
    let steep = |piece: &Piece| {
        let [p, q] = [piece.tail, piece.head].map(|v| swept.pieces.points[v as usize]);
        let size = (q - p).abs();
        0.0 < size.x && size.x <= NARROW && size.x < size.y
    };
    !swept.pieces.pieces.iter().any(steep)
}

fn kinetic() -> Options {
    Options { convolution: Convolution::Kinetic, ..Options::default() }
}

/// The greatest inradius over mu; none if the operands may not be 2 mu separated.
fn measured(input: &Input, options: &Options) -> Option<Measured> {
    let case: &Case = input.as_pair()?;
    let mu = Mu::by(case, options).filter(|mu| mu.separates(case))?;
    deepest(case, options, mu)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::kept;

    /// Each of the kept inputs has what the corrected claim leaves out.
    #[test]
    fn what_refutes_the_print_is_steep() {
        let all = kept::read(kept!("M34_printed"));
        assert!(!all.is_empty() && all.iter().all(|worst| !is_plain(worst.input.as_pair().unwrap())));
    }
}
