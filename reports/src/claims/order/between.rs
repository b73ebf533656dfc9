//! M31: Lemma 3, functions pushed out of each other (MS 7.2; memo A9): what is claimed of the construction, in rationals.

use crate::cases::rng::Rng;
use crate::claims::control::Control;
use crate::claims::finding::Measured;
use crate::claims::input::Input;
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::kept;
use rug::Rational;

/// What the numbers are: the ends of both domains, the abscissa of p, then as many ordinates of f1 as of f2, at equal steps.
const FUNCTIONS: &str = "l1, r1, l2, r2, p_x, ordinates of f1, of f2";

/// Where the ordinates begin.
const ORDINATES: usize = 5;

/// Parts of each line of a function at whose ends distances are taken.
const ON_A_LINE: i64 = 8;

/// A point.
type Point = [Rational; 2];

/// A piecewise linear function, or a curve made of lines, from left to right.
type Path = Vec<Point>;

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "greatest distance of the old functions from the new ones over |p|",
        unit: "1",
        rule: Rule::AtMost(1.0),
        draws: [400, 40_000],
        draw,
        measure: |input| measured(input, Way::There),
        kept: kept!("M31_printed"),
        control: Control::Itself,
    };
    let printed = Claim {
        id: "M31 printed",
        place: "MS 7.2, Lemma 3",
        says: "If f1 moved by p = p2 - p1 is not above f2, there are functions in order that are |p| close to f1 and f2, by \
               the construction of the proof.",
        erratum: "The new functions are |p| close to the old ones, but not the other way round: a spike at an end that is \
                  narrower than the abscissa of p is dropped.",
        test: Test::Sup(sup.clone()),
    };
    let corrected = Claim {
        id: "M31 corrected",
        place: "MS 7.2, Lemma 3",
        says: "The new functions of the construction are in order, and no point of them is farther than |p| from the old ones.",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "greatest distance of the new functions from the old ones over |p|, infinite if they are not in order",
            measure: |input| measured(input, Way::Back),
            kept: kept!("M31_corrected"),
            control: Control::Claim("M31 printed"),
            ..sup
        }),
    };
    [printed, corrected]
}

/// Which distance.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    /// From the old functions to the new ones.
    There,
    /// From the new ones to the old ones.
    Back,
}

/// Domains that overlap, and ordinates, often with a spike at an end.
fn draw(rng: &mut Rng, number: usize) -> Input {
    let lines = 2 + rng.below(5);
    let mut numbers = vec![0.0, 1.0, rng.between(-0.4, 0.4), 1.0 + rng.between(-0.4, 0.4)];
    numbers.push(0.3 * rng.unit() * rng.unit());
    let mut ordinates: Vec<f64> = (0..2 * (lines + 1)).map(|_| rng.between(-1.0, 1.0)).collect();
    if number.is_multiple_of(2) {
        let place = [0, lines, lines + 1, 2 * lines + 1][rng.below(4)];
        ordinates[place] = rng.between(-10.0, 10.0);
    }
    numbers.append(&mut ordinates);
    Input::numbers(FUNCTIONS, numbers)
}

fn measured(input: &Input, way: Way) -> Option<Measured> {
    let numbers = input.as_numbers(FUNCTIONS).filter(|n| n.len() > 8 && n.len() % 2 == 1)?;
    let exact: Option<Vec<Rational>> = numbers.iter().map(|x| Rational::from_f64(*x)).collect();
    let exact = exact.filter(|n| n[0] < n[1] && n[2] < n[3] && n[4] >= 0)?;
    let count = (exact.len() - ORDINATES) / 2;
    let (first, second) = exact[ORDINATES..].split_at(count);
    let path = |ends: &[Rational], ordinates: &[Rational]| -> Path {
        let step = Rational::from(&ends[1] - &ends[0]) / (count as i64 - 1);
        let point = |(i, y): (usize, &Rational)| [Rational::from(&step * i as i64) + &ends[0], y.clone()];
        ordinates.iter().enumerate().map(point).collect()
    };
    let old = [path(&exact[..2], first), path(&exact[2..4], second)];
    let [p1, p2] = contact(&old, &exact[4])?;
    let p = [0, 1].map(|i| Rational::from(&p2[i] - &p1[i]));
    let square = Rational::from(&p[0] * &p[0]) + Rational::from(&p[1] * &p[1]);
    let new = pushed(&old, &p1, &p2, &p);
    if square == 0 {
        return None;
    }
    if way == Way::Back && !in_order(&new) {
        return Some(Measured::exactly(f64::INFINITY));
    }
    let far = |(old, new): (&Path, &Path)| if way == Way::There { farthest(old, new) } else { farthest(new, old) };
    let [lo, hi] = old.iter().zip(&new).map(far).reduce(|p, q| [0, 1].map(|i| (&p[i]).max(&q[i]).clone()))?;
    // Rounding must not say that a distance is |p| when it is more.
    let ratio = |of: Rational| {
        let is_more = of > square;
        let ratio = (of / &square).to_f64().sqrt();
        if is_more { ratio.max(1.0_f64.next_up()) } else { ratio.min(1.0) }
    };
    Some(Measured::between(ratio(lo), ratio(hi)))
}

/// Points of f1 and of f2 such that f1 moved from the one to the other touches f2 from below (Fig. 14): it is moved to the
/// right by as much as is given, and down as far as it takes. None if it need not go down.
fn contact([f1, f2]: &[Path; 2], right: &Rational) -> Option<[Point; 2]> {
    let shifted: Path = f1.iter().map(|v| [Rational::from(&v[0] + right), v[1].clone()]).collect();
    let abscissas = shifted.iter().chain(f2).map(|v| v[0].clone());
    let over = abscissas.filter_map(|x| Some((value(&shifted, &x)? - value(f2, &x)?, x)));
    let (_, x) = over.max().filter(|(down, _)| *down > 0)?;
    let own = Rational::from(&x - right);
    Some([[own.clone(), value(f1, &own)?], [x.clone(), value(f2, &x)?]])
}

/// The functions of the proof of Lemma 3, where p points to the right.
fn pushed([f1, f2]: &[Path; 2], p1: &Point, p2: &Point, p: &Point) -> [Path; 2] {
    let moved = |path: &Path, sign: i64| -> Path {
        path.iter().map(|v| [0, 1].map(|i| &v[i] + Rational::from(&p[i] * sign))).collect()
    };
    let end = |path: &Path| path[path.len() - 1][0].clone();
    let joined = |left: &Path, from: &Rational, right: &Path, to: &Rational| {
        let mut path = part(left, [from, &p1[0]]);
        path.extend([p1.clone(), p2.clone()]);
        path.extend(part(right, [&p2[0], to]));
        path
    };
    let first = joined(f1, &f1[0][0], &moved(f1, 1), &end(f1));
    let second = joined(&moved(f2, -1), &f2[0][0], f2, &end(f2));
    [first, second]
}

/// The part of a path strictly between two abscissas, its ends there included.
fn part(path: &Path, [from, to]: [&Rational; 2]) -> Path {
    if from >= to {
        return Path::new();
    }
    let at = |x: &Rational| value(path, x).map(|y| [x.clone(), y]);
    let inner = path.iter().filter(|v| v[0] > *from && v[0] < *to).cloned();
    at(from).into_iter().chain(inner).chain(at(to)).collect()
}

/// The ordinate of a function.
fn value(path: &Path, x: &Rational) -> Option<Rational> {
    let line = path.windows(2).find(|line| line[0][0] <= *x && *x <= line[1][0] && line[0][0] < line[1][0])?;
    let along = Rational::from(x - &line[0][0]) / Rational::from(&line[1][0] - &line[0][0]);
    Some(along * Rational::from(&line[1][1] - &line[0][1]) + &line[0][1])
}

/// Whether the first path is nowhere above the second: lines, so their vertices tell.
fn in_order([first, second]: &[Path; 2]) -> bool {
    let abscissas = first.iter().chain(second).map(|v| &v[0]);
    abscissas.filter_map(|x| Some(value(first, x)? <= value(second, x)?)).all(|held| held)
}

/// A bracket of the square of the greatest distance of points of one path from another. The lower bound is over points on the
/// lines. The distance from a line is convex, so that of all points between two neighbouring ones from it is no more than
/// that of these two.
fn farthest(from: &Path, to: &Path) -> [Rational; 2] {
    let mut bracket = [Rational::new(), Rational::new()];
    for line in from.windows(2) {
        let spot = |k: i64| {
            let along = Rational::from((k, ON_A_LINE));
            [0, 1].map(|i| Rational::from(&line[1][i] - &line[0][i]) * &along + &line[0][i])
        };
        let off: Vec<Vec<Rational>> = (0..=ON_A_LINE).map(|k| distances(&spot(k), to)).collect();
        let lo = off.iter().filter_map(|of| of.iter().min()).max();
        let ends = |pair: &[Vec<Rational>]| pair[0].iter().zip(&pair[1]).map(|(p, q)| p.max(q).clone()).min();
        let hi = off.windows(2).filter_map(ends).max();
        bracket[0] = lo.max(Some(&bracket[0])).cloned().unwrap_or_default();
        bracket[1] = hi.max(Some(bracket[1].clone())).unwrap_or_default();
    }
    bracket
}

/// The squares of the distances of a point from the lines of a path.
fn distances(p: &Point, path: &Path) -> Vec<Rational> {
    let way = |q: &Point, r: &Point| [0, 1].map(|i| Rational::from(&r[i] - &q[i]));
    let dot = |u: &Point, v: &Point| Rational::from(&u[0] * &v[0]) + Rational::from(&u[1] * &v[1]);
    let to_line = |line: &[Point]| {
        let (chord, from) = (way(&line[0], &line[1]), way(&line[0], p));
        let square = dot(&chord, &chord);
        let along = if square == 0 { Rational::new() } else { (dot(&chord, &from) / square).clamp(&0, &1) };
        let off = [0, 1].map(|i| &from[i] - Rational::from(&chord[i] * &along));
        dot(&off, &off)
    };
    path.windows(2).map(to_line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The memo's example: f1 = 0, f2 a spike of height 10 on [0, 0.1], then -0.05.
    #[test]
    fn a_spike_is_dropped() {
        let mut numbers = vec![0.0, 1.0, 0.0, 1.0, 0.1];
        numbers.extend([0.0; 11]);
        numbers.push(10.0);
        numbers.extend([-0.05; 10]);
        let input = Input::numbers(FUNCTIONS, numbers);
        assert!(measured(&input, Way::There).unwrap().lo > 50.0);
        assert!(measured(&input, Way::Back).unwrap().hi <= 1.0);
    }
}
