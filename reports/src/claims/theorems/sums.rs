//! M16: Theorem 2, the error of the float sum against the sum of the realizations; M16b: against the sum of the input
//! (MS 4.3).
//!
//! The bound mu is computed for each input from what is known of its run:
//!
//! * how far the realizations have moved, certified ([`arcsum_oracle::certified::realize`]), with the rounding of the ends
//!   of sum segments: Lemma 1;
//! * the arrangement's error as MS 4.3 bound it, 4 eps (1 + k m) for m sum segments of which k were found out of order,
//!   with the constant of the memo (M14); or as it is, certified ([`arcsum_oracle::perturbation`]);
//! * for the monotonic convolution, the error of the sweeps that merge envelopes (MS 6, 6.1), another 4 eps;
//! * the rounding of the result to doubles in input units, and of the half sweeps and bulges of its arcs.

use super::super::control::Control;
use super::super::draw::{self, input};
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::sweep::audit::perturbation;
use super::super::{Claim, Test};
use super::{BUDGET, EPS, families};
use crate::bridge::{plain, stored, unit};
use crate::cases::Case;
use crate::cases::radial::noise;
use crate::cases::rng::Rng;
use crate::cases::shape;
use crate::kept;
use arcsum::region::{Curve, Node, Region};
use arcsum::sum::{Convolution, Options, Sum, sum};
use arcsum_oracle::certified::realize::realize;
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::measure::{Bracket, hausdorff};
use arcsum_oracle::polygon;

/// The error of a sweep over eps, without inconsistencies (memo M14).
const SWEEP: f64 = 4.0;

pub(super) fn claims() -> [Claim; 4] {
    let [realized, printed, corrected] = theorem();
    [realized, printed, corrected, given()]
}

fn theorem() -> [Claim; 3] {
    let sup = Sup {
        quantity: "Hausdorff distance / mu",
        unit: "1",
        rule: Rule::AtMost(1.0),
        draws: [80, 4_000],
        draw: draw::pair,
        measure: |input| against_realizations(input, 0.0),
        kept: kept!("M16"),
        control: Control::Measure {
            plants: "the result shifted by 1e-12",
            measure: |input| against_realizations(input, 1e-12),
        },
    };
    let realized = Claim {
        id: "M16",
        place: "MS 4.3",
        says: "Theorem 2: the float sum is mu-close to the sum of the realizations, mu the error of the arrangement, 4 eps \
               (1 + k m), and of the realizations together.",
        erratum: "",
        test: Test::Sup(sup.clone()),
    };
    let printed = Claim {
        id: "M16 audited printed",
        says: "For the kinetic convolution it is so with mu from the error that the arrangement turns out to have, the \
               least perturbation that makes it exact.",
        erratum: "The float sum of the proof is bounded by perturbed sum segments; the one that is delivered, by sum \
                  segments, which are as far from these once more.",
        test: Test::Sup(Sup {
            draws: [300, 3_000],
            measure: |input| audited(input, 0.0, 1.0),
            kept: kept!("M16_audited_printed"),
            control: Control::Itself,
            ..sup.clone()
        }),
        ..realized.clone()
    };
    let corrected = Claim {
        id: "M16 audited corrected",
        says: "It is so if mu takes the error of the arrangement twice.",
        erratum: "",
        test: Test::Sup(Sup {
            draws: [150, 3_000],
            measure: |input| audited(input, 0.0, 2.0),
            kept: kept!("M16_audited_corrected"),
            control: Control::Measure {
                plants: "the result shifted by 1e-12",
                measure: |input| audited(input, 1e-12, 2.0),
            },
            ..sup
        }),
        ..realized.clone()
    };
    [realized, printed, corrected]
}

fn given() -> Claim {
    Claim {
        id: "M16b",
        place: "MS 4.3",
        says: "The float sum is O(n eps) close to the sum of the regions as they are given.",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "Hausdorff distance / (n eps), over n",
            unit: "1",
            rule: Rule::Flat,
            draws: [families::ALL * 12, families::ALL * 400],
            draw: draw_growing,
            measure: |input| against_input(input, |_| 0.0),
            kept: kept!("M16b"),
            control: Control::Measure {
                plants: "the result shifted by n^2 eps",
                measure: |input| against_input(input, |n| (n * n) as f64 * EPS),
            },
        }),
    }
}

fn sum_by(convolution: Convolution, case: &Case) -> Option<Sum> {
    sum(&case.a, &case.b, &Options { convolution, ..Options::default() }).ok()
}

/// The greater distance over mu of both sums, shifted by a length in the unit box.
fn against_realizations(input: &Input, shift: f64) -> Option<Measured> {
    let realized = Realized::new(input.as_pair()?)?;
    let mut found = Vec::new();
    for (convolution, envelopes) in [(Convolution::Monotonic, SWEEP * EPS), (Convolution::Kinetic, 0.0)] {
        found.push(realized.ratio(convolution, shift, |sum| [bounded(sum) + envelopes; 2])?);
    }
    let hi = found.iter().map(|m| m.hi).fold(0.0, f64::max);
    let worst = found.into_iter().max_by(|m, n| m.lo.total_cmp(&n.lo))?;
    Some(Measured { hi, ..worst })
}

/// The distance over mu of the sum by the kinetic convolution, which mu takes so many times the error of its arrangement for.
fn audited(input: &Input, shift: f64, times: f64) -> Option<Measured> {
    let error = |sum: &Sum| {
        let off = perturbation(&sum.arrangement);
        [times * off.lo, times * off.hi]
    };
    Realized::new(input.as_pair()?)?.ratio(Convolution::Kinetic, shift, error)
}

/// A pair and the sum of its realizations.
struct Realized<'a> {
    case: &'a Case,
    unit: f64,
    /// How far the realizations are from the operands.
    moved: f64,
    reference: Reference,
}

impl<'a> Realized<'a> {
    fn new(case: &'a Case) -> Option<Self> {
        let [a, b] = stored(&case.a, &case.b).ok()?.map(|region| realize(&region).ok());
        let (a, b) = (a?, b?);
        let unit = unit(&case.a, &case.b);
        let reference = Reference::of_shapes(&a.shape, &b.shape, unit, BUDGET).ok()?;
        Some(Self { case, unit, moved: a.moved.greatest() + b.moved.greatest(), reference })
    }

    /// The distance over mu of a float sum, shifted by a length in the unit box, with this error of its arrangement.
    fn ratio(&self, by: Convolution, shift: f64, arranged: impl Fn(&Sum) -> [f64; 2]) -> Option<Measured> {
        let sum = sum_by(by, self.case)?;
        let mu = arranged(&sum).map(|error| error + self.moved + roundings(&sum, self.unit));
        let result = plain(&shifted(&sum.region, shift * self.unit));
        Some(ratio(self.reference.measure(&result).ok()??, mu))
    }
}

/// Roundings in the half sweep of an arc of the result: the sine of the whole piece, two lengths, their quotient, the product,
/// the arc sine, and the sum of up to three parts, with one unit in the last place for a function of the library.
const HALF_SWEEP: f64 = 9.0;
/// Roundings in the tangent that makes its bulge.
const TANGENT: f64 = 2.0;

/// The rounding of the ends of sum segments and of the result, in the unit box.
fn roundings(sum: &Sum, unit: f64) -> f64 {
    let last_place = |size: f64| size.next_up() - size;
    let ends = sum.convolution.points.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    let result = sum.region.loops.iter().flatten().map(|n| n.x.abs().max(n.y.abs())).fold(0.0, f64::max);
    // Half a unit in the last place of each coordinate.
    0.5 * std::f64::consts::SQRT_2 * (last_place(ends) + last_place(result) / unit) + bent(&sum.region) / unit
}

/// How far the roundings of a half sweep d and of the bulge b = tan(d / 2) move the middle of an arc over a chord c, which is
/// b c / 2 off the chord: the most for any arc of a result.
fn bent(result: &Region) -> f64 {
    let arc = |(from, to): (&Node, &Node)| {
        let Curve::Bulge(b) = from.curve else { return 0.0 };
        let relative = TANGENT * b.abs() + 0.5 * (1.0 + b * b) * HALF_SWEEP * 2.0 * libm::atan(b.abs());
        0.5 * libm::hypot(to.x - from.x, to.y - from.y) * EPS * relative
    };
    let sides = |nodes: &Vec<Node>| nodes.iter().zip(nodes.iter().cycle().skip(1)).map(arc).fold(0.0, f64::max);
    result.loops.iter().map(sides).fold(0.0, f64::max)
}

/// The error of the arrangement as MS bound it, in the unit box.
fn bounded(sum: &Sum) -> f64 {
    let audit = &sum.arrangement.audit;
    let (k, m) = ((audit.late + audit.gather) as f64, sum.convolution.pieces.len() as f64);
    SWEEP * EPS * (1.0 + k * m)
}

/// A distance over a bracket.
fn ratio(found: Bracket, [least, most]: [f64; 2]) -> Measured {
    let measured = Measured::between((found.lo / most).next_down().max(0.0), (found.hi / least).next_up());
    let (x, y) = found.witness;
    if x.is_finite() && y.is_finite() { measured.at([x, y]) } else { measured }
}

fn shifted(region: &Region, by: f64) -> Region {
    let mut shifted = region.clone();
    shifted.loops.iter_mut().flatten().for_each(|node| node.x += by);
    shifted
}

/// The distance over n eps of the monotonic sum, shifted by a length in the unit box.
fn against_input(input: &Input, shift: fn(usize) -> f64) -> Option<Measured> {
    let case = input.as_pair()?;
    let (unit, n) = (unit(&case.a, &case.b), case.segments());
    let sum = sum_by(Convolution::Monotonic, case)?;
    let result = plain(&shifted(&sum.region, shift(n) * unit));
    let (a, b) = (plain(&case.a), plain(&case.b));
    let found = if case.is_polygonal() {
        hausdorff(&result, &polygon::sum_within(&a, &b, BUDGET).ok()?, unit).ok()?
    } else {
        Reference::new(&a, &b, unit, BUDGET).ok()?.measure(&result).ok()??
    };
    Some(ratio(found, [n as f64 * EPS; 2]).of_size(n))
}

fn draw_growing(rng: &mut Rng, number: usize) -> Input {
    // Certified references of many circle segments take long.
    let most = if number % families::ALL < families::POLYGONS { 128 } else { 32 };
    let (kind, a) = families::region(number, families::ALL, most, rng);
    input(kind, a, shape::polygon(&noise(6, rng)))
}
