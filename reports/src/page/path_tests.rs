//! Paths held against geometry that shares nothing with their making: arcs by the bulge's centre and angles on one side,
//! by the SVG standard's centre parametrisation (SVG 2, B.2.4) on the other.

use super::*;
use crate::page::sample;
use crate::page::view::Frame;
use arcsum::region::{Curve, Node};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// Bows and vertices that are left out, and the rounding of both ends.
const TOLERANCE: f64 = 2.0 * INVISIBLE + 0.02;

/// Subpaths of path data as dense polylines, ordinate up again.
fn polylines(data: &str, height: f64) -> Vec<Vec<Point>> {
    let spaced: String =
        data.chars().map(|c| if "MLAZ".contains(c) { format!(" {c} ") } else { c.to_string() }).collect();
    let mut tokens = spaced.split_whitespace();
    let mut lines: Vec<Vec<Point>> = Vec::new();
    while let Some(command) = tokens.next() {
        let mut number = || tokens.next().unwrap().parse::<f64>().unwrap();
        match command {
            "M" => lines.push(vec![[number(), number()]]),
            "L" => lines.last_mut().unwrap().push([number(), number()]),
            "A" => {
                let from = *lines.last().unwrap().last().unwrap();
                let [radius, ry, _rotation, large, sweep, x, y] = std::array::from_fn(|_| number());
                assert_eq!(radius, ry);
                lines.last_mut().unwrap().extend(svg_arc(from, [x, y], radius, large == 1.0, sweep == 1.0));
            }
            "Z" => {
                let first = lines.last().unwrap()[0];
                lines.last_mut().unwrap().push(first);
            }
            other => panic!("unknown command {other}"),
        }
    }
    lines.iter().map(|l| l.iter().map(|p| [p[0], height - p[1]]).collect()).collect()
}

/// Points of an SVG arc after its start, by the standard's conversion to centre parameters for a circle.
fn svg_arc(from: Point, to: Point, radius: f64, large: bool, sweep: bool) -> Vec<Point> {
    let half = [(from[0] - to[0]) / 2.0, (from[1] - to[1]) / 2.0];
    let length2 = half[0] * half[0] + half[1] * half[1];
    let radius = radius.max(length2.sqrt());
    let root = ((radius * radius - length2) / length2).max(0.0).sqrt() * if large == sweep { -1.0 } else { 1.0 };
    let centre = [root * half[1] + (from[0] + to[0]) / 2.0, -root * half[0] + (from[1] + to[1]) / 2.0];
    let angle = |p: Point| (p[1] - centre[1]).atan2(p[0] - centre[0]);
    let (start, mut turn) = (angle(from), angle(to) - angle(from));
    if sweep && turn < 0.0 {
        turn += TAU;
    } else if !sweep && turn > 0.0 {
        turn -= TAU;
    }
    let at = |t: f64| [centre[0] + radius * (start + t * turn).cos(), centre[1] + radius * (start + t * turn).sin()];
    (1..=64).map(|i| at(f64::from(i) / 64.0)).collect()
}

/// Points of the edge from the definition of the bulge: sweep 4 atan(bulge) around the centre on the chord's bisector.
fn bulge_arc(tail: Point, head: Point, bulge: f64) -> Vec<Point> {
    let [dx, dy] = [head[0] - tail[0], head[1] - tail[1]];
    let off = (1.0 - bulge * bulge) / (4.0 * bulge);
    let centre = [(tail[0] + head[0]) / 2.0 - off * dy, (tail[1] + head[1]) / 2.0 + off * dx];
    let start = (tail[1] - centre[1]).atan2(tail[0] - centre[0]);
    let radius = distance(tail, centre);
    let at = |t: f64| start + t * 4.0 * bulge.atan();
    (0..=400)
        .map(|i| at(f64::from(i) / 400.0))
        .map(|w| [centre[0] + radius * w.cos(), centre[1] + radius * w.sin()])
        .collect()
}

/// Greatest distance of a point from a polyline.
fn off_line(points: &[Point], line: &[Point]) -> f64 {
    let to_part = |p: Point, q: &[Point]| {
        let d = [q[1][0] - q[0][0], q[1][1] - q[0][1]];
        let length2 = (d[0] * d[0] + d[1] * d[1]).max(1e-300);
        let t = (((p[0] - q[0][0]) * d[0] + (p[1] - q[0][1]) * d[1]) / length2).clamp(0.0, 1.0);
        distance(p, [q[0][0] + t * d[0], q[0][1] + t * d[1]])
    };
    let to_line = |p: &Point| line.windows(2).map(|q| to_part(*p, q)).fold(f64::INFINITY, f64::min);
    points.iter().map(to_line).fold(0.0, f64::max)
}

/// Both distances between the drawn segment and the true one.
fn deviation(data: &str, height: f64, truth: &[Point]) -> f64 {
    let drawn = polylines(data, height).concat();
    off_line(truth, &drawn).max(off_line(&drawn, truth))
}

fn square_view(side: f64) -> View {
    View { frame: Frame { low: [0.0; 2], high: [side; 2] }, scale: 1.0 }
}

/// The winding number of closed polylines around a point, by the crossings of a ray to the right.
fn winding(lines: &[Vec<Point>], p: Point) -> i32 {
    let crossing = |q: &[Point]| {
        let side = (q[1][0] - q[0][0]) * (p[1] - q[0][1]) - (q[1][1] - q[0][1]) * (p[0] - q[0][0]);
        match (q[0][1] <= p[1], q[1][1] <= p[1]) {
            (true, false) if side > 0.0 => 1,
            (false, true) if side < 0.0 => -1,
            _ => 0,
        }
    };
    lines.iter().flat_map(|l| l.windows(2)).map(crossing).sum()
}

#[test]
fn quarter_circle_runs_counter_clockwise() {
    let quarter = (PI / 8.0).tan();
    let drawing = convolution(&[[100.0, 0.0, 0.0, 100.0, quarter]], &square_view(100.0), 10);
    assert_eq!(drawing.data, "M100 100A100 100 0 0 0 0 0");
    let drawing = convolution(&[[100.0, 0.0, 0.0, 100.0, -quarter]], &square_view(100.0), 10);
    assert_eq!(drawing.data, "M100 100A100 100 0 0 1 0 0");
}

#[test]
fn square_is_closed_and_unbounded_square_is_framed() {
    let square = sample::region(vec![sample::rectangle(10.0, 10.0, 50.0, 50.0)]);
    assert_eq!(region(&square, &square_view(100.0), 100).data, "M10 90L60 90L60 40L10 40L10 90Z");
    let data = region(&square.complement(), &square_view(100.0), 100).data;
    assert!(data.starts_with("M-4 104L104 104L104 -4L-4 -4Z"));
    assert_eq!(winding(&polylines(&data, 100.0), [30.0, 30.0]), 0);
    assert_eq!(winding(&polylines(&data, 100.0), [80.0, 80.0]), 1);
}

#[test]
fn small_loops_are_left_out_first_and_counted() {
    let loops = (1..=10).map(|i| sample::rectangle(0.0, 0.0, f64::from(i), f64::from(i))).collect();
    let drawing = region(&sample::region(loops), &square_view(100.0), 9);
    assert_eq!((drawing.shown, drawing.of), (3, 10));
    assert!(drawing.data.starts_with("M0 100L10 100"));
}

#[test]
fn cap_on_segments_picks_evenly() {
    let segments: Vec<[f64; 5]> = (0..100).map(|i| [0.0, f64::from(i), 50.0, f64::from(i), 0.0]).collect();
    let drawing = convolution(&segments, &square_view(100.0), 10);
    assert_eq!((drawing.shown, drawing.of), (10, 100));
    assert_eq!(drawing.data.matches('M').count(), 10);
    assert!(drawing.data.contains("M0 100L") && drawing.data.contains("M0 10L"));
}

#[test]
fn joined_segments_lift_no_pen_and_broken_ones_are_skipped() {
    let segments = [[0.0, 0.0, 9.0, 0.0, 0.0], [9.0, 0.0, 9.0, 9.0, 0.0], [0.0, f64::NAN, 1.0, 1.0, 0.0]];
    assert_eq!(convolution(&segments, &square_view(10.0), 10).data, "M0 10L9 10L9 1");
}

#[test]
fn decimals_are_short() {
    assert_eq!([decimal(1.0), decimal(-0.001), decimal(2.346), decimal(100.0)], ["1", "0", "2.35", "100"]);
}

fn an_arc() -> impl Strategy<Value = (Point, Point, f64)> {
    // Sweeps up to 359.9 degrees on circles of 1 to 100 pixels inside a view of 600.
    (1.0..100.0_f64, 0.0..TAU, 0.05..6.281_f64, any::<bool>()).prop_map(|(radius, start, sweep, left)| {
        let at = |w: f64| [300.0 + radius * w.cos(), 300.0 + radius * w.sin()];
        let bulge = (sweep / 4.0).tan();
        if left { (at(start), at(start + sweep), bulge) } else { (at(start + sweep), at(start), -bulge) }
    })
}

proptest! {
    #[test]
    fn drawn_arcs_are_the_true_arcs((tail, head, bulge) in an_arc()) {
        let data = convolution(&[[tail[0], tail[1], head[0], head[1], bulge]], &square_view(600.0), 1).data;
        let off = deviation(&data, 600.0, &bulge_arc(tail, head, bulge));
        prop_assert!(off < TOLERANCE, "{off} pixels off: {data}");
    }

    /// The check above sees a wrong flag whenever the eye would.
    #[test]
    fn flipped_flags_are_seen((tail, head, bulge) in an_arc()) {
        let data = convolution(&[[tail[0], tail[1], head[0], head[1], bulge]], &square_view(600.0), 1).data;
        prop_assume!(data.contains('A'));
        let flipped = data.replace(" 0 0 0 ", " 0 0 * ").replace(" 0 0 1 ", " 0 0 0 ").replace(" 0 0 * ", " 0 0 1 ");
        prop_assert!(deviation(&flipped, 600.0, &bulge_arc(tail, head, bulge)) > INVISIBLE);
        let large = data.replace(" 0 0 0 ", " 0 1 0 ").replace(" 0 0 1 ", " 0 1 1 ");
        prop_assert!(deviation(&large, 600.0, &bulge_arc(tail, head, bulge)) > INVISIBLE);
    }

    /// However little of a ring a view shows, and however far it zooms, the fill inside it is right.
    #[test]
    fn insets_are_filled_right(
        centre in prop::array::uniform2(-130.0..130.0_f64), side in -4.0..2.5_f64, unbounded in any::<bool>(),
        probe in prop::array::uniform2(0.0..1.0_f64),
    ) {
        let side = 10.0_f64.powf(side);
        let mut ring = sample::region(vec![sample::circle(0.0, 0.0, 100.0, 1.0), sample::circle(0.0, 0.0, 60.0, -1.0)]);
        if unbounded {
            ring = ring.complement();
        }
        let view = View { frame: Frame::around(centre, side), scale: 280.0 / side };
        let p = [0, 1].map(|i| view.frame.low[i] + probe[i] * side);
        let away = p[0].hypot(p[1]);
        prop_assume!((away - 100.0).abs().min((away - 60.0).abs()) * view.scale > 1.0);
        let inside = (60.0..100.0).contains(&away) != unbounded;
        let data = region(&ring, &view, 1000).data;
        prop_assert_eq!(winding(&polylines(&data, 280.0), view.point(p)), i32::from(inside));
        prop_assert!(data.len() < 1500, "{} bytes", data.len());
    }

    /// A radius is drawn as the minor arc on the side of its sign.
    #[test]
    fn radii_are_drawn_as_minor_arcs(sign in prop_oneof![Just(1.0), Just(-1.0)], half in 0.05..1.55_f64) {
        let (radius, chord) = (100.0, 200.0 * half.sin());
        let tail = Node { x: 200.0, y: 300.0, curve: Curve::Radius(sign * radius) };
        let shape = sample::region(vec![vec![tail, Node::line(200.0 + chord, 300.0)]]);
        let data = region(&shape, &square_view(600.0), 10).data;
        let lowest = polylines(&data, 600.0).concat().iter().map(|p| (p[1] - 300.0) * -sign).fold(0.0, f64::max);
        prop_assert!((lowest - radius * (1.0 - half.cos())).abs() < TOLERANCE);
    }
}
