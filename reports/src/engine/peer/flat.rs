//! Regions with chords in place of arcs.

use super::EngineError;
use arcsum::arc::Arc;
use arcsum::frame::Frame;
use arcsum::region::{Curve, Node, Region};
use glam::DVec2;
use std::f64::consts::FRAC_PI_2;

/// Both operands with every arc replaced by chords that are at most `sagitta` away from it, in unit-box lengths. No chord
/// spans more than a quarter of a circle, so that a tiny disc stays a region. Corners are those of the arcs, rounded.
///
/// # Errors
/// [`EngineError::Invalid`] when there is no such arc.
pub fn flattened(a: &Region, b: &Region, sagitta: f64) -> Result<[Region; 2], EngineError> {
    let most = Frame::pair(a, b).0.length_to_input(sagitta);
    Ok([flat(a, most)?, flat(b, most)?])
}

/// The same for one region, the sagitta in its units.
fn flat(region: &Region, most: f64) -> Result<Region, EngineError> {
    let mut loops = Vec::with_capacity(region.loops.len());
    for nodes in &region.loops {
        let mut ring = Vec::new();
        for (i, node) in nodes.iter().enumerate() {
            chords(node, &nodes[(i + 1) % nodes.len()], most, &mut ring)?;
        }
        loops.push(ring);
    }
    Ok(Region { loops, ..region.clone() })
}

/// Adds the first corner of each chord.
fn chords(from: &Node, to: &Node, most: f64, ring: &mut Vec<Node>) -> Result<(), EngineError> {
    let (tail, head) = (DVec2::new(from.x, from.y), DVec2::new(to.x, to.y));
    ring.push(Node::line(tail.x, tail.y));
    let arc = match from.curve {
        Curve::Line => return Ok(()),
        Curve::Radius(r) => Arc::with_radius(tail, head, r),
        Curve::Bulge(bulge) => Arc::with_bulge(tail, head, bulge),
    };
    let arc = arc.map_err(|error| EngineError::Invalid(error.to_string()))?;
    let count = count(&arc, most);
    ring.extend((1..count).map(|k| {
        let (end, way) = arc.offset(arc.a().plus(2.0 * arc.delta() * f64::from(k) / f64::from(count)));
        Node::line(end.x + way.x, end.y + way.y)
    }));
    Ok(())
}

/// How many chords an arc takes: a chord of half sweep t is r (1 - cos t) = 2 r sin^2(t/2) away from it.
fn count(arc: &Arc, most: f64) -> u32 {
    let half_sweep = arc.delta().abs();
    let radius = arc.head().distance(arc.tail()) / (2.0 * libm::sin(half_sweep).abs());
    let half_chord = 2.0 * libm::asin(libm::sqrt((most / (2.0 * radius)).min(0.5)));
    // The quarter is exact in floats; half a circle becomes two chords, not three.
    libm::ceil((half_sweep / half_chord).max(2.0 * half_sweep / FRAC_PI_2)) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bridge::plain;
    use crate::cases::radial::{Bending, bulging};
    use crate::cases::rng::Rng;
    use crate::cases::shape::disc;
    use arcsum_oracle::certified::shape::Shape;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        // From first principles: every corner lies on its arc, and the middle of every chord is within the sagitta.
        #[test]
        fn chords_keep_their_sagitta(seed: u64, power in 4..30_i32, bulge in -3.0_f64..3.0) {
            let most = libm::ldexp(1.0, -power);
            let mut rng = Rng::new(seed, "chords");
            let mut point = || DVec2::new(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0));
            let (tail, head) = (point(), point());
            prop_assume!(tail.distance(head) > 0.01 && bulge.abs() > 1e-3);
            let (from, to) = (Node { x: tail.x, y: tail.y, curve: Curve::Bulge(bulge) }, Node::line(head.x, head.y));
            let mut ring = Vec::new();
            chords(&from, &to, most, &mut ring).unwrap();
            ring.push(to);
            let chord = head - tail;
            let centre = tail + 0.5 * chord + (1.0 - bulge * bulge) / (4.0 * bulge) * chord.perp();
            let radius = chord.length() * (1.0 + bulge * bulge) / (4.0 * bulge.abs());
            let corners: Vec<DVec2> = ring.iter().map(|n| DVec2::new(n.x, n.y)).collect();
            for pair in corners.windows(2) {
                prop_assert!((pair[0].distance(centre) - radius).abs() < 1e-12 * radius);
                let sagitta = radius - (0.5 * (pair[0] + pair[1])).distance(centre);
                prop_assert!(sagitta <= most + 1e-12 * radius, "{sagitta:e} of {most:e}");
            }
            // And no more chords than that takes, but for the quarters.
            let widest = corners.windows(2).map(|p| radius - (0.5 * (p[0] + p[1])).distance(centre)).fold(0.0, f64::max);
            prop_assert!(widest > 0.2 * most || corners.len() <= 6, "{widest:e} of {most:e}, {}", corners.len());
        }
    }

    #[test]
    fn what_is_flat_is_a_region() {
        let arcs = bulging(12, Bending::InTurn, &mut Rng::new(1, "flat"));
        for (region, most) in [(&arcs, 1e-3), (&disc(1.0), 1e-6), (&disc(1e-9), 1.0)] {
            let flat = flat(region, most).unwrap();
            assert!(flat.is_polygonal() && flat.segments() >= 4);
            Shape::new(&plain(&flat)).unwrap();
        }
    }
}
