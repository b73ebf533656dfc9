//! Pairs of polygons that are hard on exact algorithms: small integers, collinear and coincident edges, tiny scales,
//! structured families.

use super::super::draw::{cells, input, integers, polygons};
use super::super::input::Input;
use crate::cases::passage::{Fit, passage};
use crate::cases::place::scaled;
use crate::cases::rng::Rng;
use crate::cases::{combs, fork, many, twoopt};
use arcsum::validate::validate;
use libm::scalbn;

/// A valid pair of bounded polygonal regions.
pub(super) fn pair(rng: &mut Rng, number: usize) -> Input {
    loop {
        let (kind, a, b) = match number % 8 {
            0 => ("cells", cells(4, true, rng), cells(3, true, rng)),
            1 => {
                let a = cells(3, true, rng);
                ("copies", a.clone(), if rng.below(2) == 0 { a } else { a.negated() })
            }
            2 => ("integers", integers(rng), integers(rng)),
            3 => {
                // About 1e-300, and 2^-200 beside 1.
                let [p, q] = [[-997, -997], [0, -200]][rng.below(2)];
                ("scales", scaled(&twoopt::simple(5, rng), scalbn(1.0, p)), scaled(&integers(rng), scalbn(1.0, q)))
            }
            4 => ("simple", twoopt::simple(4 + rng.below(6) as u32, rng), twoopt::simple(4 + rng.below(5) as u32, rng)),
            5 => {
                let (a, b) = match rng.below(3) {
                    0 => combs::combs(2),
                    1 => fork::fork(1),
                    _ => many::islands(1, rng),
                };
                ("families", a, b)
            }
            6 => {
                let (a, b) = passage([Fit::Exact, Fit::Wider(50), Fit::Narrower(40)][rng.below(3)]);
                ("passage", a, b)
            }
            _ => return polygons(rng, number),
        };
        if [&a, &b].iter().all(|region| validate(region).is_ok()) {
            return input(kind, a, b);
        }
    }
}
