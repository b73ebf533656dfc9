//! Gears with rounded teeth, and what is offset by a disc: regions of a given number of segments.

use super::radial::{Bending, bulging, noise};
use super::rng::Rng;
use super::shape::{polar, polygon, region};
use arcsum::region::{Curve, Node, Region};
use std::f64::consts::TAU;

/// A gear of n/4 teeth, three at least, around the origin: a round tip, a flank, a round root and a flank each. Tips are
/// on the unit circle before they bulge.
///
/// Simple by construction: tips bulge out of the unit circle and roots into the inner one, by less than half circles whose
/// diameters are a fifth of a pitch; and the ends of a flank are so near in angle that it stays outside of the chords of
/// the roots.
pub fn gear(n: u32, rng: &mut Rng) -> Region {
    let teeth = (n / 4).max(3);
    let pitch = TAU / f64::from(teeth);
    let inner = 1.0 - (0.8 * pitch).min(0.4);
    let phase = rng.angle();
    let mut nodes = Vec::new();
    for tooth in 0..teeth {
        let at = phase + pitch * f64::from(tooth);
        let mut corner = |radius: f64, part: f64, bend: f64| {
            let [x, y] = polar(radius, at + pitch * (part + rng.between(-0.02, 0.02)));
            let curve = if bend == 0.0 { Curve::Line } else { Curve::Bulge(bend * rng.between(0.3, 0.9)) };
            nodes.push(Node { x, y, curve });
        };
        corner(1.0, 0.0, 1.0);
        corner(1.0, 0.2, 0.0);
        corner(inner, 0.5, -1.0);
        corner(inner, 0.7, 0.0);
    }
    region(vec![nodes])
}

/// Regions of n segments to be offset, with what they are: a polygon with noisy radii, arcs that bulge out and in by turns,
/// and arcs around a hole of arcs (n is 16 at least there).
pub fn to_offset(n: u32, rng: &mut Rng) -> [(&'static str, Region); 3] {
    let n = n.max(16);
    let mut holed = bulging(n - n / 2, Bending::InTurn, rng);
    let mut hole = bulging(n / 2, Bending::Out, rng);
    for node in hole.loops.iter_mut().flatten() {
        (node.x, node.y) = (0.4 * node.x, 0.4 * node.y);
    }
    holed.loops.extend(hole.complement().loops);
    [("polygon", polygon(&noise(n, rng))), ("arcs", bulging(n, Bending::InTurn, rng)), ("holed", holed)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use arcsum::validate::validate;

    #[test]
    fn all_are_regions_of_so_many_segments() {
        for n in [12, 16, 32, 96, 1000] {
            for seed in 0..20 {
                let gear = gear(n, &mut Rng::new(seed, "gear"));
                assert_eq!(gear.segments(), n as usize);
                validate(&gear).unwrap();
                for (what, region) in to_offset(n, &mut Rng::new(seed, "offset")) {
                    assert_eq!(region.segments(), n.max(16) as usize);
                    validate(&region).unwrap_or_else(|e| panic!("{what} {n}: {e}"));
                }
            }
        }
    }
}
