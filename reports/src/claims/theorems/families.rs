//! Regions of growing size to fit exponents on: smooth and jagged ones, with circle segments and without, and ones with
//! nearly vertical lines.

use crate::cases::combs::combs;
use crate::cases::gear::gear;
use crate::cases::place::turned;
use crate::cases::radial::{Bending, bulging, noise, star};
use crate::cases::rng::Rng;
use crate::cases::shape::{polygon, regular};
use arcsum::region::Region;
use libm::scalbn;

/// A region of about n segments by the name of its kind.
type Maker = (&'static str, fn(u32, &mut Rng) -> Region);

/// Those without circle segments come first.
const KINDS: [Maker; 8] = [
    ("regular", |n, _| polygon(&regular(n, 1.0, 0.05))),
    ("noise", |n, rng| polygon(&noise(n, rng))),
    ("star", |n, rng| polygon(&star(n / 2, rng))),
    ("comb", |n, rng| turned(&combs(n / 4).0, rng.between(-1e-3, 1e-3))),
    ("steep", steep),
    ("gear", gear),
    ("spline", |n, rng| bulging(n, Bending::Out, rng)),
    ("waves", |n, rng| bulging(n, Bending::InTurn, rng)),
];

/// How many kinds there are, and how many of them have no circle segments.
pub const ALL: usize = KINDS.len();

/// See [`ALL`].
pub const POLYGONS: usize = 5;

/// The input of this number among so many kinds: once through the kinds with 8 segments, then with 16 and so on up to
/// `most`, and over again.
pub fn region(number: usize, kinds: usize, most: u32, rng: &mut Rng) -> (&'static str, Region) {
    let sizes = most.ilog2() as usize - 2;
    let (kind, make) = KINDS[number % kinds];
    (kind, make(8 << (number / kinds % sizes), rng))
}

/// Teeth with nearly vertical flanks that all lean the same way, a little more than 2^-k wide.
fn steep(n: u32, rng: &mut Rng) -> Region {
    let teeth = n / 4;
    let lean = scalbn(rng.between(0.5, 1.0), -(rng.below(40) as i32) - 12) / f64::from(teeth);
    let mut points = vec![[-0.5, -1.0], [f64::from(teeth) - 0.25, -1.0]];
    for i in (0..teeth).rev() {
        let (x, top) = (f64::from(i), rng.between(0.5, 1.0) * f64::from(teeth));
        points.extend([[x, 0.0], [x + lean, top], [x - 0.5, top], [x - 0.5 - lean, 0.0]]);
    }
    points.pop();
    polygon(&points)
}

#[cfg(test)]
mod tests {
    use super::*;
    use arcsum::validate::validate;

    #[test]
    fn all_are_regions_of_about_the_size() {
        for number in 0..ALL * 5 {
            let (kind, region) = region(number, ALL, 128, &mut Rng::new(number as u64, "families"));
            validate(&region).unwrap_or_else(|error| panic!("{kind}: {error}"));
            let n = 8 << (number / ALL);
            assert!((n - n / 4..=n + n / 2).contains(&region.segments()), "{kind}: {} of {n}", region.segments());
            assert_eq!(region.is_polygonal(), number % ALL < POLYGONS, "{kind}");
        }
    }
}
