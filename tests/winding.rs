//! Convolutions, and winding numbers of points in them.

use arcsum::convolution::{kinetic, monotonic};
use arcsum::frame::Frame;
use arcsum::piece::Pieces;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_reports::cases::Case;
use arcsum_reports::cases::rng::Rng;
pub use arcsum_reports::winding::winding;
use glam::DVec2;

/// Both convolutions of a bounded pair, the kinetic one first.
#[must_use]
pub fn convolutions(case: &Case) -> [Pieces; 2] {
    let frames = Frame::pair(&case.a, &case.b);
    let [a, b] = [(&case.a, &frames.0), (&case.b, &frames.1)].map(|(r, frame)| Smooth::new(r, frame).expect("valid"));
    let monotonic = monotonic(&a, &b, Rounding::Correct).expect("bounded").0;
    [kinetic(&a, &b, Rounding::Correct).expect("bounded"), monotonic]
}

/// Pairs of winding numbers of random points near some of the vertices, in a whole and in what is left of it.
#[must_use]
pub fn before_and_after(whole: &Pieces, left: &Pieces, seed: u64) -> Vec<[i32; 2]> {
    let mut random = Rng::new(seed, "tests");
    let mut pair = || {
        let p = *random.pick(&whole.points) + 0.05 * DVec2::new(random.unit() - 0.5, random.unit() - 0.5);
        Some([winding(whole, p)?, winding(left, p)?])
    };
    (0..400).filter_map(|_| pair()).collect()
}
