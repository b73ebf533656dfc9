//! How two lines meet, exactly.

use super::Contact;
use crate::exact::orientation;
use glam::DVec2;
use std::cmp::Ordering::{Equal, Greater, Less};

/// A line segment: tail and head.
pub type Line = (DVec2, DVec2);

/// How two lines of positive length meet, and a common point: exact for a touch and an overlap, rounded for a crossing.
pub fn meet((a, b): Line, (c, d): Line) -> Option<(Contact, DVec2)> {
    let (side_c, side_d) = (orientation(a, b, c), orientation(a, b, d));
    if side_c == side_d && side_c != Equal {
        return None;
    }
    let sides = [side_c, side_d, orientation(c, d, a), orientation(c, d, b)];
    if sides == [Equal; 4] {
        return meet_collinear((a, b), (c, d));
    }
    let (apart_cd, apart_ab) = (opposite(sides[0], sides[1]), opposite(sides[2], sides[3]));
    if apart_cd && apart_ab {
        return Some((Contact::Cross, crossing((a, b), (c, d))));
    }
    let ends = [(c, sides[0], apart_ab), (d, sides[1], apart_ab), (a, sides[2], apart_cd), (b, sides[3], apart_cd)];
    // An end on the other line touches the other segment if that segment's ends lie on either side or at the end itself.
    let touch = |&(end, side, apart): &(DVec2, _, bool)| {
        side == Equal && (apart || [(a, b), (c, d)].iter().all(|&(p, q)| p == end || q == end))
    };
    ends.iter().find(|e| touch(e)).map(|&(end, ..)| (Contact::Touch, end))
}

fn opposite(one: std::cmp::Ordering, other: std::cmp::Ordering) -> bool {
    matches!((one, other), (Greater, Less) | (Less, Greater))
}

fn meet_collinear(one: Line, other: Line) -> Option<(Contact, DVec2)> {
    let key = |p: &DVec2, q: &DVec2| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y));
    let sorted = |(p, q): Line| if key(&p, &q).is_le() { (p, q) } else { (q, p) };
    let ((a, b), (c, d)) = (sorted(one), sorted(other));
    let start = if key(&a, &c).is_ge() { a } else { c };
    let end = if key(&b, &d).is_le() { b } else { d };
    match key(&start, &end) {
        Less => Some((Contact::Overlap, start)),
        Equal => Some((Contact::Touch, start)),
        Greater => None,
    }
}

fn crossing((a, b): Line, (c, d): Line) -> DVec2 {
    let share = (c - a).perp_dot(d - c) / (b - a).perp_dot(d - c);
    // The divisor may cancel to nothing when the lines are all but parallel; then any point of both will do.
    if share.is_finite() { a + (b - a) * share.clamp(0.0, 1.0) } else { c }
}
