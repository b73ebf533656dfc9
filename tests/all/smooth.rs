//! Smoothed regions: structure, turning, geometry (memo A3, A4, A7), and what happens at joints, cusps and bad input.

use arcsum::angle::Ang;
use arcsum::arc::ArcError;
use arcsum::boundary::Boundary;
use arcsum::frame::Frame;
use arcsum::region::{Curve, Node, Region};
use arcsum::smooth::{Counts, Kind, Seg, Smooth, SmoothError};
use arcsum_oracle::precise::{Circular, big, in_eps};
use arcsum_reports::cases::rng::Rng;
use arcsum_tests::cases;
use arcsum_tests::shapes::any_region;
use glam::DVec2;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

const UNIT: Frame = Frame { exp: 0, shift: DVec2::ZERO };

fn node(x: f64, y: f64, curve: Curve) -> Node {
    Node { x, y, curve }
}

fn region(loops: Vec<Vec<Node>>) -> Region {
    Region { loops, ..Region::default() }
}

fn smooth(region: &Region) -> Result<Smooth, SmoothError> {
    Smooth::new(region, &Frame::pair(region, region).0)
}

fn segs(smooth: &Smooth) -> impl Iterator<Item = &Seg> {
    smooth.loops.iter().flat_map(|l| &l.segs)
}

/// What every smoothed region promises, valid or not.
fn check_structure(region: &Region, smooth: &Smooth) {
    assert_eq!(smooth.loops.len(), region.loops.len());
    for (of, nodes) in smooth.loops.iter().zip(&region.loops) {
        let mut edges: Vec<u32> = of.segs.iter().filter(|s| s.kind != Kind::Turn).map(|s| s.edge).collect();
        assert!(edges.is_sorted());
        edges.dedup();
        assert_eq!(edges.len(), nodes.len());
        for (i, seg) in of.segs.iter().enumerate() {
            let next = &of.segs[(i + 1) % of.segs.len()];
            assert_eq!((seg.head, seg.b), (next.tail, next.a), "{seg:?} {next:?}");
            check_segment(smooth, seg);
            let tail = smooth.points[seg.tail as usize];
            assert!(tail.cmpge(of.min).all() && tail.cmple(of.max).all());
        }
    }
    let mut seen: Vec<usize> = smooth.components.iter().flat_map(|c| c.outer.iter().chain(&c.holes).copied()).collect();
    seen.sort_unstable();
    assert_eq!(seen, (0..smooth.loops.len()).collect::<Vec<_>>());
}

fn check_segment(smooth: &Smooth, seg: &Seg) {
    let (tail, head) = (smooth.points[seg.tail as usize], smooth.points[seg.head as usize]);
    match seg.kind {
        Kind::Line => assert!(seg.a == seg.b && seg.delta == 0.0 && seg.r == 0.0 && tail != head),
        Kind::Turn => {
            assert!(seg.tail == seg.head && seg.a != seg.b && seg.r == 0.0);
            assert!(seg.delta != 0.0 && seg.delta.abs() <= FRAC_PI_2);
        }
        Kind::Arc => {
            assert!(tail != head && seg.a != seg.b && seg.delta.abs() <= FRAC_PI_4);
            assert_eq!(seg.delta > 0.0, seg.r > 0.0);
            assert!(seg.delta != 0.0 && smooth.arc(seg).cuts().is_empty());
            // The direction of travel is the rightward normal turned left.
            let travel = seg.a.plus(seg.delta).normal().perp();
            assert!(((head - tail) * travel).cmpge(DVec2::ZERO).all(), "{seg:?} {tail} {head}");
        }
    }
}

/// The total turning of a loop in whole turns, by adding up.
fn turns(segs: &[Seg]) -> f64 {
    segs.iter().map(|s| s.delta).sum::<f64>() / PI
}

/// Twice the signed area, roughly.
fn area(nodes: &[Node]) -> f64 {
    let lens = |b: f64, chord: DVec2| {
        let half = 2.0 * libm::atan(b);
        chord.length_squared() * (half - half.sin() * half.cos()) / (2.0 * half.sin() * half.sin())
    };
    let part = |(i, n): (usize, &Node)| {
        let next = &nodes[(i + 1) % nodes.len()];
        let (p, q) = (DVec2::new(n.x, n.y), DVec2::new(next.x, next.y));
        p.perp_dot(q) + if let Curve::Bulge(b) = n.curve { lens(b, q - p) } else { 0.0 }
    };
    nodes.iter().enumerate().map(part).sum()
}

/// Checks that all arcs lie on the circles of the input, and that no input vertex moved.
fn check_geometry(region: &Region, frame: &Frame, smooth: &Smooth) -> f64 {
    let nodes: Vec<(Node, Node)> =
        region.loops.iter().flat_map(|l| (0..l.len()).map(|i| (l[i], l[(i + 1) % l.len()]))).collect();
    let unit = |n: &Node| frame.to_unit(DVec2::new(n.x, n.y));
    nodes.iter().zip(&smooth.points).for_each(|((n, _), &p)| assert_eq!(unit(n), p));
    let mut worst = 0.0f64;
    for seg in segs(smooth).filter(|s| s.kind == Kind::Arc) {
        let (from, to) = &nodes[seg.edge as usize];
        let circle = match from.curve {
            Curve::Bulge(b) => Some(Circular::with_bulge(unit(from).into(), unit(to).into(), b)),
            Curve::Radius(r) => Circular::with_radius(unit(from).into(), unit(to).into(), frame.length_to_unit(r)),
            Curve::Line => None,
        };
        let arc = smooth.arc(seg);
        for step in 0..4 {
            let (end, way) = arc.offset(seg.a.plus(seg.delta * f64::from(step) * 0.5));
            if let Some(circle) = &circle {
                worst = worst.max(in_eps(&circle.off_circle((end + way).into()), &big(1.0)));
            }
        }
    }
    worst
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn valid_regions_are_smoothed(region in any_region()) {
        let frame = Frame::pair(&region, &region).0;
        let smooth = Smooth::new(&region, &frame).expect("a valid region");
        check_structure(&region, &smooth);
        let outer: Vec<usize> = smooth.components.iter().filter_map(|c| c.outer).collect();
        for (i, of) in smooth.loops.iter().enumerate() {
            let expected = if outer.contains(&i) { 1.0 } else { -1.0 };
            prop_assert!((turns(&of.segs) - expected).abs() < 1e-12);
            prop_assert_eq!(expected, area(&region.loops[i]).signum());
        }
        prop_assert_eq!(smooth.counts.modification2, 0);
        // A cut may be off by 11 eps (see the test of arcs), the piece from there on by 5 more.
        let worst = check_geometry(&region, &frame, &smooth);
        prop_assert!(worst <= 16.0, "{worst}");
        let boundary = Boundary::new(&region, &frame).expect("a valid region");
        prop_assert!(boundary.loops.iter().flatten().eq(segs(&smooth).filter(|s| s.kind != Kind::Turn)));
    }

    /// Any doubles at all: an error or a sound structure, never a panic.
    #[test]
    fn nothing_panics(numbers in wild_edges(), split in 0..12usize, unbounded: bool) {
        let make = |&(x, y, c, kind): &(f64, f64, f64, u8)| {
            node(x, y, [Curve::Line, Curve::Radius(c), Curve::Bulge(c)][usize::from(kind)])
        };
        let nodes: Vec<Node> = numbers.iter().map(make).collect();
        let (one, other) = nodes.split_at(split.min(nodes.len()));
        let loops = [one, other].into_iter().filter(|l| !l.is_empty()).map(<[Node]>::to_vec).collect();
        let region = Region { loops, unbounded, ..Region::default() };
        if let Ok(smooth) = smooth(&region) {
            check_structure(&region, &smooth);
        }
    }

    /// Mirroring in the origin, quarter turns and powers of two change nothing but what they must, to the last bit.
    #[test]
    fn symmetries_are_exact(region in any_region(), exponent in -400..400i32) {
        let plain = smooth(&region).expect("a valid region");
        let negated = smooth(&region.negated()).expect("a valid region");
        for (seg, other) in segs(&plain).zip(segs(&negated)) {
            prop_assert_eq!((seg.a.opposite(), seg.b.opposite(), seg.delta), (other.a, other.b, other.delta));
            prop_assert_eq!(-plain.points[seg.tail as usize], negated.points[other.tail as usize]);
        }
        let scaled = mapped(&region, |p| p * 2f64.powi(exponent), 2f64.powi(exponent));
        prop_assert!(segs(&plain).eq(segs(&smooth(&scaled).expect("a valid region"))));
        let turned = smooth(&mapped(&region, DVec2::perp, 1.0)).expect("a valid region");
        for (seg, other) in segs(&plain).zip(segs(&turned)) {
            let quarter = |angle: Ang| (angle.opposite().turn_to(angle), (angle.axis() + 1) % 4, angle.offset());
            let same = |angle: Ang| (PI, angle.axis() % 4, angle.offset());
            prop_assert_eq!((quarter(seg.a), quarter(seg.b)), (same(other.a), same(other.b)));
        }
    }

    /// The complement has the same loops backwards: every angle opposite, every turn and sweep negated.
    #[test]
    fn complements_mirror(region in any_region()) {
        let (plain, complement) = (smooth(&region).expect("valid"), smooth(&region.complement()).expect("valid"));
        prop_assert_eq!(complement.components[0].outer, None);
        prop_assert!(complement.components[0].holes.contains(&0));
        prop_assert_eq!(complement.components.len() + plain.components.len(), 1 + region.loops.len());
        for (of, back) in plain.loops.iter().zip(&complement.loops) {
            let mut there: Vec<(Ang, Ang)> = of.segs.iter().map(|s| (s.a, s.b)).collect();
            let mut back: Vec<(Ang, Ang)> = back.segs.iter().map(|s| (s.b.opposite(), s.a.opposite())).collect();
            there.sort();
            back.sort();
            prop_assert_eq!(there, back);
        }
    }
}

fn mapped(region: &Region, map: impl Fn(DVec2) -> DVec2, scale: f64) -> Region {
    let mut region = region.clone();
    for n in region.loops.iter_mut().flatten() {
        let p = map(DVec2::new(n.x, n.y));
        (n.x, n.y) = (p.x, p.y);
        if let Curve::Radius(r) = &mut n.curve {
            *r *= scale;
        }
    }
    region
}

/// Small integers as often as any doubles, so that loops close, touch and fold.
fn wild() -> impl Strategy<Value = f64> {
    let extreme = prop::sample::select(vec![f64::INFINITY, f64::NAN, f64::MAX, -f64::MAX, 5e-324]);
    let small = (-2..=2i32).prop_map(f64::from);
    prop_oneof![20 => any::<f64>(), 1 => extreme, 60 => small, 20 => -1.0..1.0f64]
}

/// The checks see one wrong angle, vertex, turn, component or cut.
#[test]
fn planted_faults_are_seen() {
    let region = rounded(0.9, 0.6, 0.1, 1.0);
    let sound = Smooth::new(&region, &UNIT).expect("valid");
    let faults: [fn(&mut Smooth); 5] = [
        |s| s.loops[0].segs[3].b = s.loops[0].segs[3].b.plus(1e-15),
        |s| s.loops[0].segs[3].head = s.loops[0].segs[0].tail,
        |s| s.loops[0].segs.truncate(8),
        |s| s.components[0].outer = None,
        |s| {
            let cut = s.points.len() - 1;
            s.points[cut] *= 1.0 - 64.0 * f64::EPSILON;
        },
    ];
    let sound_structure = |s: &Smooth| std::panic::catch_unwind(|| check_structure(&region, s)).is_ok();
    let passes = |s: &Smooth| sound_structure(s) && check_geometry(&region, &UNIT, s) <= 16.0;
    assert!(passes(&sound));
    for (i, plant) in faults.iter().enumerate() {
        let mut faulty = sound.clone();
        plant(&mut faulty);
        assert!(!passes(&faulty), "fault {i} went unseen");
    }
}

/// Vertices with a radius or a bulge, and which of them the edge has.
fn wild_edges() -> impl Strategy<Value = Vec<(f64, f64, f64, u8)>> {
    prop::collection::vec((wild(), wild(), wild(), 0..3u8), 0..12)
}

/// A rectangle with quarter circles for corners, turned by an angle.
fn rounded(width: f64, height: f64, r: f64, angle: f64) -> Region {
    let bulge = Curve::Bulge(libm::tan(PI / 8.0));
    let (x, y) = (width / 2.0, height / 2.0);
    let corners = [(x, -y + r), (x, y - r), (x - r, y), (r - x, y), (-x, y - r), (-x, r - y), (r - x, -y), (x - r, -y)];
    let turn = DVec2::from_angle(angle);
    let place = |(i, &(x, y)): (usize, &(f64, f64))| {
        let p = turn.rotate(DVec2::new(x, y));
        node(p.x, p.y, if i % 2 == 0 { Curve::Line } else { bulge })
    };
    region(vec![corners.iter().enumerate().map(place).collect()])
}

/// Tangential joints of rounded coordinates make no turns and no slivers, at any angle and for all fillets that are not
/// longer than the lines between them (the angle of a shorter line is less certain than an arc may adapt to).
#[test]
fn tangential_joints_make_no_turns() {
    let straight = smooth(&rounded(0.9, 0.6, 0.1, 0.0)).expect("valid");
    assert_eq!(segs(&straight).count(), 8);
    let mut random = Rng::new(3, "tests");
    let (mut least, mut joined, mut worst) = (1.0f64, 0, 0.0f64);
    for _ in 0..300 {
        let region = rounded(0.9, 0.8, 0.2 * random.decade(-6.0, 0.0), random.between(0.0, 2.0 * PI));
        let smooth = Smooth::new(&region, &UNIT).expect("valid");
        check_structure(&region, &smooth);
        joined += smooth.counts.snapped;
        let sliver = |s: &&Seg| s.kind == Kind::Turn && s.delta.abs() < 1e-6;
        assert_eq!(segs(&smooth).filter(sliver).count(), 0, "{region:?}");
        least = segs(&smooth).filter(|s| s.kind == Kind::Arc).map(|s| s.delta.abs()).fold(least, f64::min);
        worst = worst.max(check_geometry(&region, &UNIT, &smooth));
    }
    println!(
        "joints: {joined} of 2400 end angles moved, then {worst:.3} eps from the circles, least half sweep {least:e}"
    );
    assert!(joined > 1000 && least > 1e-6);
    // 4 eps for a point of a monotone piece, and the sagitta of two ends that swing by 4 eps: one eps each (see below).
    assert!(worst <= 6.0);
}

/// A crescent between two circles that touch from within, in one loop: the cusp turns left twice; its complement's
/// right.
#[test]
fn cusps_of_arcs_turn_to_the_inside() {
    let crescent = region(vec![vec![
        node(0.5, 0.0, Curve::Bulge(1.0)),
        node(-0.5, 0.0, Curve::Bulge(1.0)),
        node(0.5, 0.0, Curve::Bulge(-1.0)),
        node(0.0, 0.0, Curve::Bulge(-1.0)),
    ]]);
    for (region, sign) in [(crescent.clone(), 1.0), (crescent.complement(), -1.0)] {
        let smooth = smooth(&region).expect("valid");
        check_structure(&region, &smooth);
        assert_eq!(turns(&smooth.loops[0].segs), sign);
        let cusps: Vec<f64> = segs(&smooth).filter(|s| s.kind == Kind::Turn).map(|s| s.delta).collect();
        assert_eq!(cusps, [sign * FRAC_PI_2; 2]);
    }
}

/// Spikes and cracks thinner than angles can tell turn to the side that the coordinates tell.
#[test]
fn thin_spikes_turn_to_the_inside() {
    let thin = 2f64.powi(-70);
    for (y, sign) in [(thin, 1.0), (-thin, -1.0)] {
        let nodes = [(0.0, 0.0), (0.3, 0.4), (-0.3 * y, -0.4 * y + y)];
        let loops = vec![nodes.map(|(x, y)| Node::line(x, y)).to_vec()];
        let region = Region { loops, unbounded: sign < 0.0, ..Region::default() };
        let smooth = smooth(&region).expect("valid but thin");
        check_structure(&region, &smooth);
        assert!((turns(&smooth.loops[0].segs) - sign).abs() < 1e-12);
    }
}

#[test]
fn bad_regions_are_told() {
    let lines = |points: &[(f64, f64)]| points.iter().map(|&(x, y)| Node::line(x, y)).collect::<Vec<_>>();
    let error = |loops: Vec<Vec<Node>>| smooth(&region(loops)).expect_err("a bad region");
    let square = lines(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]);
    let spike = lines(&[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (1.0, 0.0), (1.0, 1.0)]);
    assert_eq!(error(vec![square.clone(), spike]), SmoothError::Fold { index: 1, edge: 1 });
    assert_eq!(error(vec![lines(&[(0.0, 0.0)])]), SmoothError::TooFewEdges { index: 0 });
    let repeated = lines(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
    assert_eq!(error(vec![repeated]), SmoothError::Edge { index: 0, edge: 1, reason: ArcError::ZeroChord });
    let eight = lines(&[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)]);
    assert_eq!(error(vec![eight]), SmoothError::Turning { index: 0, turns: 0 });
    let hole: Vec<Node> = square.iter().rev().map(|n| Node::line(n.x + 2.0, n.y)).collect();
    assert_eq!(error(vec![square.clone(), hole]), SmoothError::Orphan { index: 1 });
    let short = vec![node(0.0, 0.0, Curve::Radius(0.4)), Node::line(1.0, 0.0), Node::line(0.0, 1.0)];
    assert_eq!(error(vec![short]), SmoothError::Edge { index: 0, edge: 0, reason: ArcError::ChordTooLong });
    let infinite = lines(&[(0.0, 0.0), (1.0, 0.0), (0.0, f64::INFINITY)]);
    assert_eq!(error(vec![infinite]), SmoothError::Edge { index: 0, edge: 1, reason: ArcError::NotFinite });
}

/// A disc in the hole of a ring in the hole of a frame, and holes that touch their outer loops.
#[test]
fn holes_find_the_smallest_loop_around_them() {
    let square = |r: f64| [(r, -r), (r, r), (-r, r), (-r, -r)].map(|(x, y)| Node::line(x, y)).to_vec();
    let diamond = |r: f64| [(0.0, -r), (r, 0.0), (0.0, r), (-r, 0.0)].map(|(x, y)| Node::line(x, y)).to_vec();
    let circle = |r: f64| vec![node(r, 0.0, Curve::Bulge(1.0)), node(-r, 0.0, Curve::Bulge(1.0))];
    let hole = |nodes: Vec<Node>| region(vec![nodes]).complement().loops.remove(0);
    let nested = vec![circle(0.3), hole(circle(1.0)), square(1.0), hole(circle(0.4)), circle(0.9), hole(square(0.1))];
    let mut touching = nested.clone();
    touching[1] = hole(diamond(1.0));
    touching[4] = diamond(0.7);
    for loops in [nested, touching] {
        let smooth = smooth(&region(loops)).expect("valid");
        let parts: Vec<_> = smooth.components.iter().map(|c| (c.outer, c.holes.clone())).collect();
        assert_eq!(parts, [(Some(0), vec![5]), (Some(2), vec![1]), (Some(4), vec![3])]);
    }
    let outside = Region { unbounded: true, ..region(vec![hole(square(1.0)), circle(0.5)]) };
    let smooth = smooth(&outside).expect("valid");
    assert_eq!(smooth.components.iter().map(|c| c.outer).collect::<Vec<_>>(), [None, Some(1)]);
    assert_eq!(smooth.components[0].holes, [0]);
    assert_eq!(Smooth::new(&Region::plane(), &UNIT).expect("the plane").components.len(), 1);
    assert_eq!(Smooth::new(&Region::default(), &UNIT).expect("nothing").components.len(), 0);
}

/// Arcs of nearly 360 degrees by bulge, closed by a short line.
#[test]
fn nearly_full_circles_are_cut_four_times() {
    for exponent in 2..15 {
        let gap = 0.1f64.powi(exponent);
        for (x, y) in [(gap, 0.0), (0.0, gap), (-0.6 * gap, 0.8 * gap)] {
            // Radius 0.4: L (1 + b^2) / (4 b) is about L b / 4.
            let arc = region(vec![vec![node(0.0, 0.0, Curve::Bulge(1.6 / gap)), node(x, y, Curve::Line)]]);
            let smooth = Smooth::new(&arc, &UNIT).expect("valid");
            check_structure(&arc, &smooth);
            assert!(check_geometry(&arc, &UNIT, &smooth) <= 16.0);
            let size = smooth.loops[0].max - smooth.loops[0].min;
            assert!((size - DVec2::splat(0.8)).length() < 1e-3, "{size}");
            assert_eq!(smooth.counts, Counts { snapped: smooth.counts.snapped, ..Counts::default() });
        }
    }
}
