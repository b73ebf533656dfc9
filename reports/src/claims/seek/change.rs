//! Changes of an input: by units in the last place, to parallel, upright and equal, and by structure.

use super::super::input::{Input, Numbers};
use crate::cases::Case;
use crate::cases::place::{quarter_turned, turned};
use crate::cases::rng::Rng;
use arcsum::region::{Curve, Node};
use arcsum::validate::validate;

/// The input with one change; none if that gave no input.
pub(super) fn changed(input: &Input, rng: &mut Rng) -> Option<Input> {
    match input {
        Input::Numbers(numbers) => {
            Some(Input::Numbers(Numbers { values: values(numbers.values.clone(), rng), ..numbers.clone() }))
        }
        Input::Pair(case) => pair(case, rng).map(Input::pair),
    }
}

/// One or two numbers changed.
fn values(mut values: Vec<f64>, rng: &mut Rng) -> Vec<f64> {
    for _ in 0..=rng.below(2) {
        let (i, other) = (rng.below(values.len()), *rng.pick(&values));
        values[i] = match rng.below(8) {
            0..=2 => rng.jitter(values[i], 3),
            3..=4 => rng.jitter(values[i], 1000),
            5 => values[i] * (1.0 + rng.between(-1.0, 1.0) * rng.decade(-14.0, -1.0)),
            6 => values[i] * rng.between(0.5, 2.0),
            _ => other * rng.sign(),
        };
    }
    values
}

/// A pair with up to three changes, still valid.
fn pair(case: &Case, rng: &mut Rng) -> Option<Case> {
    let mut changed = case.clone();
    for _ in 0..=rng.below(3) {
        change(&mut changed, rng);
    }
    (changed != *case && validate(&changed.a).is_ok() && validate(&changed.b).is_ok()).then_some(changed)
}

fn change(case: &mut Case, rng: &mut Rng) {
    let in_a = rng.below(2) == 0;
    if rng.below(12) == 0 {
        return whole(case, in_a, rng);
    }
    let others: Vec<Node> =
        [&case.a, &case.b].into_iter().flat_map(|region| region.loops.iter().flatten()).copied().collect();
    let region = if in_a { &mut case.a } else { &mut case.b };
    if region.loops.is_empty() {
        return;
    }
    let of_loop = rng.below(region.loops.len());
    let nodes = &mut region.loops[of_loop];
    if nodes.is_empty() {
        return;
    }
    let i = rng.below(nodes.len());
    match rng.below(13) {
        0..=5 => moved(&mut nodes[i], rng),
        6 => level(nodes, i, rng),
        7 => parallel(nodes, i, &others, rng),
        8 => nodes[i].curve = bent(nodes, i, &others, rng),
        9 => bend_more(&mut nodes[i].curve, rng),
        10 if nodes.len() > 3 => drop(nodes.remove(i)),
        11 => split(nodes, i, rng),
        _ => moved(&mut nodes[i], rng),
    }
}

/// A whole region turned, or made from the other one.
fn whole(case: &mut Case, in_a: bool, rng: &mut Rng) {
    let (region, other) = if in_a { (&mut case.a, &case.b) } else { (&mut case.b, &case.a) };
    *region = match rng.below(6) {
        0 => quarter_turned(region),
        1 => turned(region, rng.sign() * rng.decade(-17.0, -1.0)),
        2 => turned(region, rng.angle()),
        3 => other.clone(),
        4 => other.negated(),
        _ => region.negated(),
    };
}

/// A coordinate moved by some units in the last place, by those of 1, or by a little of itself.
fn moved(node: &mut Node, rng: &mut Rng) {
    let x = if rng.below(2) == 0 { &mut node.x } else { &mut node.y };
    *x = match rng.below(6) {
        0..=1 => rng.jitter(*x, 2),
        2 => rng.jitter(*x, 64),
        3 => *x + (rng.below(9) as f64 - 4.0) * 0.5 * f64::EPSILON,
        4 => *x + rng.between(-1.0, 1.0) * rng.decade(-16.0, -1.0),
        _ => *x + rng.between(-0.5, 0.5),
    };
}

/// A vertex in line with a neighbour or another one along an axis.
fn level(nodes: &mut [Node], i: usize, rng: &mut Rng) {
    let other = nodes[if rng.below(2) == 0 { (i + 1) % nodes.len() } else { rng.below(nodes.len()) }];
    if rng.below(2) == 0 {
        nodes[i].x = other.x;
    } else {
        nodes[i].y = other.y;
    }
}

/// The edge from a vertex as a multiple of a difference of two other vertices, up to rounding.
fn parallel(nodes: &mut [Node], i: usize, others: &[Node], rng: &mut Rng) {
    let from = rng.below(others.len());
    let (p, q) = (others[from], others[(from + 1) % others.len()]);
    let next = (i + 1) % nodes.len();
    let factor = if rng.below(2) == 0 { rng.sign() } else { rng.between(-1.5, 1.5) };
    nodes[next].x = nodes[i].x + factor * (q.x - p.x);
    nodes[next].y = nodes[i].y + factor * (q.y - p.y);
}

/// The curve of another vertex: the same, of opposite radius, or nearly that.
fn bent(nodes: &[Node], i: usize, others: &[Node], rng: &mut Rng) -> Curve {
    let next = nodes[(i + 1) % nodes.len()];
    let chord = libm::hypot(next.x - nodes[i].x, next.y - nodes[i].y);
    match (rng.pick(others).curve, rng.below(3)) {
        (curve, 0) => curve,
        (Curve::Radius(r), 1) => Curve::Radius(rng.jitter(-r, 3)),
        (Curve::Bulge(b), 1) => Curve::Bulge(rng.jitter(-b, 3)),
        (Curve::Radius(r), _) if r.abs() >= 0.5 * chord => Curve::Radius(rng.jitter(r, 64)),
        _ => Curve::Line,
    }
}

fn bend_more(curve: &mut Curve, rng: &mut Rng) {
    *curve = match *curve {
        Curve::Line => Curve::Bulge(rng.sign() * rng.decade(-16.0, 0.0)),
        Curve::Radius(r) if rng.below(2) == 0 => Curve::Radius(rng.jitter(r, 8)),
        Curve::Radius(r) => Curve::Radius(r * (1.0 + rng.unit() * rng.decade(-15.0, 0.0))),
        Curve::Bulge(b) if rng.below(2) == 0 => Curve::Bulge(rng.jitter(b, 8)),
        Curve::Bulge(b) => Curve::Bulge(b * (1.0 + rng.between(-0.5, 0.5) * rng.decade(-15.0, 0.0))),
    };
}

/// A vertex more, on or near the chord of a line.
fn split(nodes: &mut Vec<Node>, i: usize, rng: &mut Rng) {
    let (p, q) = (nodes[i], nodes[(i + 1) % nodes.len()]);
    let (t, off) = (rng.unit(), rng.between(-1.0, 1.0) * rng.decade(-17.0, -1.0));
    let [dx, dy] = [q.x - p.x, q.y - p.y];
    nodes.insert(i + 1, Node::line(p.x + t * dx - off * dy, p.y + t * dy + off * dx));
}

#[cfg(test)]
mod tests {
    use super::super::super::draw;
    use super::*;

    #[test]
    fn changed_pairs_are_valid_and_different() {
        let mut rng = Rng::new(1, "change");
        let (mut input, mut done) = (draw::pair(&mut rng, 0), 0);
        for _ in 0..400 {
            if let Some(next) = changed(&input, &mut rng) {
                assert_ne!(next, input);
                assert!(next.as_pair().is_some_and(|case| validate(&case.a).is_ok() && validate(&case.b).is_ok()));
                (input, done) = (next, done + 1);
            }
        }
        assert!(done > 100, "{done}");
    }

    #[test]
    fn changed_regions_keep_their_kind() {
        let mut rng = Rng::new(2, "change");
        let Input::Pair(case) = draw::polygons(&mut rng, 0) else { panic!("a pair") };
        let unbounded = |region: &arcsum::region::Region| region.unbounded;
        for _ in 0..100 {
            let Some(next) = pair(&case, &mut rng) else { continue };
            assert_eq!((unbounded(&next.a), next.name.as_str()), (unbounded(&case.a), case.name.as_str()));
        }
    }
}
