//! M51: the sum with a small disc makes regions separated that are not (MS 8.3).

use crate::bridge::{plain, unit};
use crate::cases::rng::Rng;
use crate::cases::shape::{Point, disc, polygon, regular};
use crate::claims::control::Control;
use crate::claims::draw;
use crate::claims::finding::Measured;
use crate::claims::input::Input;
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::kept;
use arcsum::region::Region;
use arcsum::sum::{Options, sum};
use arcsum_oracle::certified::separation::separation;

/// The radius of the disc; the drawn regions are about 1 large.
const RADIUS: f64 = 0.01;

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "radius of the disc over the separation of the sum",
        unit: "1",
        rule: Rule::AtMost(1.0),
        draws: [150, 15_000],
        draw: |rng, _| draw::input("comb", comb(rng, any_width, |rng, _| rng.between(0.6, 1.0)), disc(RADIUS)),
        measure: |input| measured(input, true),
        kept: kept!("M51_printed"),
        control: Control::Itself,
    };
    let printed = Claim {
        id: "M51 printed",
        place: "MS 8.3",
        says: "The sum of a region that is not separated with a small disc is a separated one.",
        erratum: "A gap a little wider than the disc becomes one a little wider than nothing. And an arc that should end where \
                  it is vertical ends a rounding beyond: a chain as short as that comes between two others, which are not \
                  incident then and touch nearly.",
        test: Test::Sup(sup.clone()),
    };
    let corrected = Claim {
        id: "M51 corrected",
        place: "MS 8.3",
        says: "If the gaps of a polygon are a few roundings wide, or at least four times the radius, and what is beside them \
               ends as far apart, its sum with a regular \
               polygon for a disc is separated by the radius.",
        erratum: "",
        test: Test::Sup(Sup {
            draw: |rng, _| draw::input("comb", comb(rng, clear_width, clear_reach), polygon(&regular(13, RADIUS, 0.1))),
            kept: kept!("M51_corrected"),
            control: Control::Measure {
                plants: "the region without the disc",
                measure: |input| measured(input, false),
            },
            ..sup
        }),
    };
    [printed, corrected]
}

/// A few roundings, or far more than the disc.
fn clear_width(rng: &mut Rng) -> f64 {
    match rng.below(2) {
        0 => rng.between(1.0, 16.0) * f64::EPSILON,
        _ => rng.between(5.0, 20.0) * RADIUS,
    }
}

/// The same, or close to the diameter of the disc.
fn any_width(rng: &mut Rng) -> f64 {
    match rng.below(3) {
        0 => (2.0 + rng.between(0.0, 0.2)) * RADIUS,
        _ => clear_width(rng),
    }
}

/// Teeth of lengths that differ by far more than the disc.
fn clear_reach(rng: &mut Rng, tooth: usize) -> f64 {
    0.6 + 0.1 * (3 * tooth % 5) as f64 + rng.between(0.0, 0.04)
}

/// A comb with gaps of such widths, and teeth that reach so far.
fn comb(rng: &mut Rng, width: fn(&mut Rng) -> f64, reach: fn(&mut Rng, usize) -> f64) -> Region {
    let (tilt, mut y, mut points) = (rng.between(-0.3, 0.3), 0.0, Vec::<Point>::new());
    let at = |x: f64, y: f64| [x, y + tilt * x];
    let teeth = 2 + rng.below(3);
    for tooth in 0..teeth {
        let (reach, height) = (reach(rng, tooth), rng.between(0.1, 0.3));
        points.extend([at(reach, y), at(reach, y + height)]);
        y += height;
        if tooth + 1 < teeth {
            let gap = width(rng);
            points.extend([at(0.25, y), at(0.25, y + gap)]);
            y += gap;
        }
    }
    points.extend([at(0.0, y), at(0.0, 0.0)]);
    polygon(&points)
}

/// The radius of B over the separation of the sum, or over that of A; none if A is separated by the radius.
fn measured(input: &Input, summed: bool) -> Option<Measured> {
    let case = input.as_pair()?;
    let corner = case.b.loops.first()?.first()?;
    let radius = libm::hypot(corner.x, corner.y);
    let side = unit(&case.a, &case.b);
    let apart = |region: &Region| separation(&plain(region), side).ok();
    let before = apart(&case.a).filter(|before| before.hi() * side < radius)?;
    let after = if summed { apart(&sum(&case.a, &case.b, &Options::default()).ok()?.region)? } else { before };
    Some(Measured::between(radius / (after.hi() * side), radius / (after.lo() * side)))
}
