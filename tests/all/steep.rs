//! Crossings of steep lines, judged vertically in rational arithmetic (memo C1). A rounding of x is far in y there, so being
//! near both lines, which the contract in `crossing` asks for, is not enough: the lines must be near each other at the
//! moment itself.
//!
//! The bound, for ordinates in [-1, 1], to first order in eps; abscissas only come in by their differences.
//!
//! * `y_at` is an end plus x cy / cx: three differences, a product and a quotient make 5 eps of at most half the height, 1,
//!   and the sum 1 eps more: 6 eps.
//! * The gap D at an end of the common part is an ordinate minus that: 6 eps and one of the gap, 8 eps in all.
//! * At the fraction p/(p-q) of computed gaps p and q of opposite signs, D is a mean of their errors, 6 eps and
//!   2|pq|/(|p|+|q|) <= 2 eps. The moment is from + p/(p-q) (to-from), with four roundings before a sum without any: 4 eps
//!   of the fraction times |p-q|, which is |p| <= 2. At the moment, so, D is at most 6 + 2 + 8 = 16 eps.
//! * An end where the computed gap is at most the tolerance, 4 eps of the side 2, counts as touching: D is at most 8 + 8 =
//!   16 eps there. D is linear in between, so the order is nowhere wrong by more.
//! * The place's ordinate runs between two of `y_at` on one line, 6 eps, with three roundings of at most 2, 2 and 1 eps; the
//!   moment has two that the fraction does not share, 2 eps of the line's height, 4 eps: 15 eps from that line. It is moved
//!   into both ranges of ordinates, which brings it no farther than 16 eps, and is 15 + 16 eps from the other line.

use super::crossing::curve;
use arcsum::arrangement::cross::{CrossingModule, Crossings, EPS, FloatModule};
use arcsum::arrangement::curve::Curve;
use arcsum::arrangement::moment::Moment;
use arcsum_tests::cases;
use glam::DVec2;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use rug::Rational;
use std::cell::Cell;

/// Bounds on the order and on the residuals of the place, with 1 eps for the terms of higher order.
const ORDER: f64 = 17.0;
const PLACE: f64 = 32.0;

fn exact(x: f64) -> Rational {
    Rational::from_f64(x).expect("finite")
}

/// The abscissa of a moment.
fn time(moment: &Moment) -> Rational {
    exact(moment.at.x) + exact(moment.low)
}

/// The ordinate of a line, extended where need be.
fn ordinate(line: &Curve, x: &Rational) -> Rational {
    let (left, right) = (line.left.to_array().map(exact), line.right.to_array().map(exact));
    let slope = (right[1].clone() - &left[1]) / (right[0].clone() - &left[0]);
    slope * (x.clone() - &left[0]) + &left[1]
}

/// How far f is above g at an abscissa, in eps.
fn gap(f: &Curve, g: &Curve, x: &Rational) -> f64 {
    ((ordinate(f, x) - ordinate(g, x)) / exact(EPS)).to_f64()
}

/// The first and last abscissa that two lines share.
fn common(f: &Curve, g: &Curve) -> (f64, f64) {
    (f.left.x.max(g.left.x), f.right.x.min(g.right.x))
}

/// By how much, in eps, the order is wrong at the worst: the gap is linear, so at an end of the common part or a crossing.
fn order_excess(f: &Curve, g: &Curve, answer: &Crossings) -> f64 {
    let (from, to) = common(f, g);
    let crossings = answer.points().iter().map(time);
    let times: Vec<Rational> = [exact(from)].into_iter().chain(crossings).chain([exact(to)]).collect();
    let mut below = answer.below;
    let mut worst = 0.0_f64;
    for part in times.windows(2) {
        for x in part {
            let above = gap(f, g, x);
            worst = worst.max(if below { above } else { -above });
        }
        below = !below;
    }
    worst
}

/// The greater vertical distance of a crossing's place from the two lines at its moment, in eps.
fn residual(f: &Curve, g: &Curve, crossing: &Moment) -> f64 {
    let x = time(crossing);
    let off = |line| ((exact(crossing.at.y) - ordinate(line, &x)) / exact(EPS)).to_f64().abs();
    off(f).max(off(g))
}

fn line(index: u32, p: DVec2, q: DVec2) -> Option<Curve> {
    curve(index, [(2 * index, p), (2 * index + 1, q)], 0.0)
}

/// Ordinates of a second line: free, or those of the first up to 1e-16 to 1e-3.
fn ordinates(close: bool, (p, q): (f64, f64), (r, s): (f64, f64), exponent: f64) -> (f64, f64) {
    let size = 10.0_f64.powf(exponent);
    let near = |y: f64, d: f64| (y + d * size).clamp(-1.0, 1.0);
    if close { (near(p, r), near(q, s)) } else { (r, s) }
}

/// Lines of which the first is steep, one to 2^50 units in the last place of x wide; the second is about as wide and close by,
/// or as wide as the box.
fn pair() -> impl Strategy<Value = (Curve, Curve)> {
    let y = || (-1.0..1.0, -1.0..1.0);
    let width = prop_oneof![(1..4_u64).prop_map(|w| w as f64), (0.0..50.0).prop_map(f64::exp2)];
    let one = (-1.0..1.0_f64, width, y());
    let other = (any::<bool>(), (-1.5..1.0_f64, 0.0..2.5_f64), any::<bool>(), y(), -16.0..-3.0);
    (one, other).prop_filter_map("not steep or apart", |((x, width, p), (wide, (a, b), close, r, exponent))| {
        // Bounded below, or a failing pair would shrink to where widths underflow.
        let size = x.abs().max(1e-6);
        let width = width * (size.next_up() - size);
        let f = line(0, DVec2::new(x, p.0), DVec2::new(x + width, p.1))?;
        let r = ordinates(close, p, r, exponent);
        let (left, right) = if wide { (a.min(x), b.max(x + width)) } else { (x + a * width, x + b * width) };
        let g = line(1, DVec2::new(left, r.0), DVec2::new(right, r.1))?;
        let (from, to) = common(&f, &g);
        let steep = f.chord().y.abs() > 8.0 * f.chord().x;
        (steep && !f.is_vertical() && !g.is_vertical() && from < to).then_some((f, g))
    })
}

#[test]
fn steep_lines_are_near_each_other_when_they_cross() {
    let runs = cases(20_000);
    let (order, place, crossings, total) = (Cell::new(0.0_f64), Cell::new(0.0_f64), Cell::new(0_u32), runs.cases);
    let result = TestRunner::new(runs).run(&pair(), |(f, g)| {
        let answer = FloatModule::new(2.0).cross(&f, &g);
        let excess = order_excess(&f, &g, &answer);
        order.set(order.get().max(excess));
        prop_assert!(excess <= ORDER, "order wrong by {excess} eps, {answer:?}");
        for crossing in answer.points() {
            prop_assert_eq!(crossing.at.x + crossing.low, crossing.at.x);
            let off = residual(&f, &g, crossing);
            place.set(place.get().max(off));
            prop_assert!(off <= PLACE, "place off by {off} eps, {answer:?}");
            crossings.set(crossings.get() + 1);
        }
        Ok(())
    });
    println!("worst order {:.2} eps, worst place {:.2} eps, {} crossings", order.get(), place.get(), crossings.get());
    if let Err(e) = result {
        panic!("{e}");
    }
    assert!(crossings.get() >= total / 8, "only {} crossings", crossings.get());
}

/// Without what rounding takes from the abscissa no time serves: both lines end there.
#[test]
fn a_rounded_moment_would_be_noticed() {
    let x = 0.5_f64;
    let f = line(0, DVec2::new(x, -1.0), DVec2::new(x.next_up(), 1.0)).expect("a line");
    let g = line(1, DVec2::new(x, 0.9), DVec2::new(x.next_up(), -0.7)).expect("a line");
    let answer = FloatModule::new(2.0).cross(&f, &g);
    assert!(order_excess(&f, &g, &answer) <= ORDER && residual(&f, &g, &answer.points()[0]) <= PLACE);
    let rounded = Moment { low: 0.0, ..answer.points()[0] };
    let planted = Crossings::at(answer.below, &[rounded]);
    assert!(order_excess(&f, &g, &planted) > 1e15 && residual(&f, &g, &rounded) > 1e15);
}
