//! The separation of regions, against points sampled on their chains, and with slits of known width.

use std::f64::consts::FRAC_PI_2;
use std::time::{Duration, Instant};

use arcsum_oracle::certified::separation::separation;
use arcsum_oracle::interval::Interval;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use proptest::prelude::*;

/// Samples a segment.
const SAMPLES: usize = 60;

fn region(loops: &[&[(f64, f64, f64)]]) -> PlainRegion {
    let corner = |&(x, y, bulge): &(f64, f64, f64)| Corner {
        x,
        y,
        bend: if bulge == 0.0 { Bend::Line } else { Bend::Bulge(bulge) },
    };
    PlainRegion { loops: loops.iter().map(|l| l.iter().map(corner).collect()).collect(), unbounded: false }
}

fn polygon(corners: &[(f64, f64)]) -> PlainRegion {
    let corners: Vec<_> = corners.iter().map(|&(x, y)| (x, y, 0.0)).collect();
    region(&[&corners])
}

/// Points of a segment from its start to before its end, among them those where its tangent is along an axis.
fn sampled(from: (f64, f64), bulge: f64, to: (f64, f64)) -> Vec<(f64, f64)> {
    let part = |k: usize| k as f64 / SAMPLES as f64;
    let chord = (to.0 - from.0, to.1 - from.1);
    if bulge == 0.0 {
        return (0..SAMPLES).map(|k| (from.0 + part(k) * chord.0, from.1 + part(k) * chord.1)).collect();
    }
    let rise = (1.0 - bulge * bulge) / (4.0 * bulge);
    let centre = (from.0 + 0.5 * chord.0 - rise * chord.1, from.1 + 0.5 * chord.1 + rise * chord.0);
    let arm = (from.0 - centre.0, from.1 - centre.1);
    let (radius, start, sweep) = (arm.0.hypot(arm.1), arm.1.atan2(arm.0), 4.0 * bulge.atan());
    let axes = (-12..=12).map(|k| f64::from(k) * FRAC_PI_2).map(|angle| (angle - start) / sweep);
    let mut parts: Vec<f64> = (0..SAMPLES).map(part).chain(axes.filter(|t| *t > 1e-6 && *t < 1.0 - 1e-6)).collect();
    parts.sort_by(f64::total_cmp);
    parts.dedup_by(|s, t| (*s - *t).abs() < 1e-9);
    let at = |t: f64| (centre.0 + radius * (start + t * sweep).cos(), centre.1 + radius * (start + t * sweep).sin());
    std::iter::once(from).chain(parts.into_iter().skip(1).map(at)).collect()
}

/// The points of a loop, chain by chain: runs that go left or right.
fn runs(corners: &[Corner]) -> Vec<Vec<(f64, f64)>> {
    let n = corners.len();
    let segment = |i: usize| {
        let (p, q) = (corners[i], corners[(i + 1) % n]);
        let bulge = if let Bend::Bulge(bulge) = p.bend { bulge } else { 0.0 };
        sampled((p.x, p.y), bulge, (q.x, q.y))
    };
    let points: Vec<(f64, f64)> = (0..n).flat_map(segment).collect();
    let n = points.len();
    let left = |i: usize| points[(i + 1) % n].0 < points[i % n].0;
    let Some(start) = (0..n).find(|&i| left(i) != left(i + n - 1)) else { return vec![points] };
    let mut runs: Vec<Vec<(f64, f64)>> = Vec::new();
    for i in start..start + n {
        if i == start || left(i) != left(i - 1) {
            runs.push(vec![points[i % n]]);
        }
        let last = runs.len() - 1;
        runs[last].push(points[(i + 1) % n]);
    }
    runs
}

/// The least distance of samples of chains `skip` or more apart on their loop, or of different loops, and the longest step.
fn brute(region: &PlainRegion, skip: usize) -> (f64, f64) {
    let all: Vec<_> = region.loops.iter().map(|corners| runs(corners)).collect();
    let (mut least, mut step) = (f64::INFINITY, 0.0_f64);
    let apart = |p: (f64, f64), q: (f64, f64)| (p.0 - q.0).hypot(p.1 - q.1);
    let places: Vec<(usize, usize)> = (0..all.len()).flat_map(|l| (0..all[l].len()).map(move |c| (l, c))).collect();
    for &(l, c) in &places {
        step = all[l][c].windows(2).map(|pair| apart(pair[0], pair[1])).fold(step, f64::max);
        for &(m, d) in places.iter().filter(|other| **other > (l, c)) {
            let between = (d.abs_diff(c)).min(all[l].len() - d.abs_diff(c).min(all[l].len()));
            if l == m && between < skip {
                continue;
            }
            let pairs = all[l][c].iter().flat_map(|p| all[m][d].iter().map(move |q| apart(*p, *q)));
            least = pairs.fold(least, f64::min);
        }
    }
    (least, step)
}

/// What the roundings of samples do to their distances.
const ROUNDING: f64 = 1e-14;

/// Whether a bracket and a sampled distance are compatible: samples miss a distance by a step at most.
fn agrees(found: Interval, (least, step): (f64, f64)) -> bool {
    if least.is_infinite() {
        found.lo().is_infinite()
    } else {
        found.lo() <= least + ROUNDING && least <= found.hi() + step + ROUNDING
    }
}

/// Loops around the origin, mostly simple, and a small one beside or inside of them.
fn shape() -> impl Strategy<Value = PlainRegion> {
    let corner = (0.15..1.0f64, 0.1..0.9f64, prop_oneof![Just(0.0), -0.6..0.6f64]);
    let ring = prop::collection::vec(corner, 3..10);
    let hole = prop::option::of((-1.5..1.5f64, -1.5..1.5f64, 0.01..0.3f64));
    (ring, hole).prop_map(|(ring, hole)| {
        let n = ring.len() as f64;
        let at = |(i, (radius, shift, bulge)): (usize, &(f64, f64, f64))| {
            let angle = 4.0 * FRAC_PI_2 * (i as f64 + shift) / n;
            (radius * angle.cos(), radius * angle.sin(), *bulge)
        };
        let outer: Vec<_> = ring.iter().enumerate().map(at).collect();
        let hole = hole.map(|(x, y, r)| [(x - r, y, -1.0), (x + r, y, -1.0)]);
        hole.map_or_else(|| region(&[&outer]), |hole| region(&[&outer, &hole]))
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn chains_are_as_far_apart_as_their_points(region in shape()) {
        let found = separation(&region, 1.0).expect("sound");
        prop_assert!(agrees(found, brute(&region, 2)), "{found:?}, sampled {:?}", brute(&region, 2));
        prop_assert!(found.hi().is_infinite() || found.hi() - found.lo() < 1e-15);
    }

    /// Turned by half a turn or seen in a unit of another size, a region has the same separation.
    #[test]
    fn it_moves_with_the_region(region in shape()) {
        let found = separation(&region, 1.0).expect("sound");
        let mut turned = region.clone();
        for corner in turned.loops.iter_mut().flatten() {
            (corner.x, corner.y) = (-corner.x, -corner.y);
        }
        let other = separation(&turned, 1.0).expect("sound");
        prop_assert!(other.lo() <= found.hi() && found.lo() <= other.hi());
        let half = separation(&region, 2.0).expect("sound");
        prop_assert!(2.0 * half.lo() <= found.hi() && found.lo() <= 2.0 * half.hi());
    }
}

/// A C, open to the right, with a slit of this width.
fn slit(width: f64) -> PlainRegion {
    polygon(&[
        (0.0, 0.0),
        (4.0, 0.0),
        (4.0, 1.0),
        (1.0, 1.0),
        (1.0, 1.0 + width),
        (4.0, 1.0 + width),
        (4.0, 3.0),
        (0.0, 3.0),
    ])
}

/// The same with a hook in the lower wall: two more chains, so that the walls are not incident, and its tip is 1/4 below
/// the wall.
fn wound(width: f64) -> PlainRegion {
    let w = 1.0 + width;
    polygon(&[
        (0.0, 0.0),
        (6.0, 0.0),
        (6.0, 1.0),
        (2.0, 1.0),
        (4.0, 0.75),
        (1.0, 0.5),
        (1.0, 2.0),
        (3.0, w),
        (6.0, w),
        (6.0, 4.0),
        (0.0, 4.0),
    ])
}

/// A V whose walls come near each other half way, and only there.
#[test]
fn incident_chains_may_come_near_each_other() {
    let waist =
        |w: f64| polygon(&[(0.0, 0.0), (9.0, 1.0), (5.0, 4.0 - w), (1.0, 4.0), (5.0, 4.0), (9.0, 7.0), (0.0, 8.0)]);
    let found = separation(&waist(1e-9), 1.0).expect("sound");
    assert!(found.lo() == 1.0 && agrees(found, brute(&waist(1e-9), 2)), "{found:?}");
    assert!(brute(&waist(1e-9), 1).0 < 0.1);
}

/// Widths down to a last place of the numbers.
#[test]
fn slits_have_the_width_they_are_given() {
    for width in (1..53).map(|k| f64::from(-k).exp2()) {
        let w = (1.0 + width) - 1.0;
        // The walls are incident, but where one ends a chain begins that is not incident with the other.
        assert_eq!(separation(&slit(width), 1.0), Ok(Interval::point(w)));
        let found = separation(&wound(width), 1.0).expect("sound");
        let expected = w.min(0.25);
        assert!(found.lo() <= expected && expected <= found.hi(), "{found:?} for {w:e}");
        assert!(found.hi() - found.lo() <= 1e-15 * expected);
    }
}

/// The walls of a vertical notch belong to one chain.
#[test]
fn a_vertical_notch_is_no_gap_between_chains() {
    let notch =
        polygon(&[(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (1.5, 2.0), (1.5, 1.0), (1.25, 1.0), (1.25, 2.0), (0.0, 2.0)]);
    assert_eq!(separation(&notch, 1.0), Ok(Interval::point(f64::INFINITY)));
}

/// Round walls: a disc in a round hole, and a hole that touches the outside.
#[test]
fn rings_are_as_wide_as_the_gap_between_circles() {
    let circle = |x: f64, r: f64, s: f64| [(x + s * r, 0.0, s), (x - s * r, 0.0, s)];
    for (x, width) in [(0.0, 0.5), (0.25, 0.25), (0.5, 0.0), (0.5 - f64::EPSILON, f64::EPSILON)] {
        let ring = region(&[&circle(0.0, 1.0, 1.0), &circle(x, 0.5, -1.0)]);
        let found = separation(&ring, 1.0).expect("sound");
        assert!(found.lo() <= width && width <= found.hi() && found.hi() - found.lo() < 1e-16, "{found:?} for {width}");
    }
}

/// The check above fails where a slit is of another width, and where incident chains count.
#[test]
fn the_check_tells_other_chains() {
    let (found, sampled) = (separation(&wound(0.2), 1.0).expect("sound"), brute(&wound(0.2), 2));
    assert!(agrees(found, sampled));
    assert!(!agrees(separation(&wound(0.05), 1.0).expect("sound"), sampled));
    assert!(!agrees(found, brute(&wound(0.2), 1)));
    // A chain and the next but one: the hook in the wall and what is behind it.
    let hook = separation(&wound(0.5), 1.0).expect("sound");
    assert!(agrees(hook, brute(&wound(0.5), 2)) && !agrees(hook, brute(&wound(0.5), 3)));
}

/// A thousand segments take well under a second.
#[test]
fn large_regions_are_quick() {
    let n = 500;
    let tooth =
        |i: usize| [(2.0 * i as f64, 0.0), (2.0 * i as f64 + 1.0, if i.is_multiple_of(2) { 50.0 } else { -0.01 })];
    let below: Vec<_> = (0..n).flat_map(tooth).map(|(x, y)| (y, x)).collect();
    let comb = polygon(&[below.as_slice(), &[(-9.0, 2.0 * n as f64), (-9.0, 0.0)]].concat());
    let start = Instant::now();
    let found = separation(&comb, 1024.0).expect("sound");
    assert!(start.elapsed() < Duration::from_secs(2), "{:?}", start.elapsed());
    assert!(found.lo() > 0.0 && found.hi() < 4.0 / 1024.0, "{found:?}");
}
