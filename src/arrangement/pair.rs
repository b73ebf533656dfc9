//! Two curves over their common part of the sweep: closed forms in doubles, made consistent with point tests at the ends and
//! between crossings (memo C1). Returns their order and crossings.

use super::cross::Crossings;
use super::curve::{Curve, compare, is_steep, order_at_end, order_at_start};
use super::meet::meet;
use super::moment::Moment;
use crate::twofold::two_sum;
use glam::DVec2;
use std::cmp::Ordering;

/// Two curves and the part of the sweep that they share.
pub(super) struct Pair<'a> {
    pub(super) f: &'a Curve,
    pub(super) g: &'a Curve,
    pub(super) tolerance: f64,
}

impl Pair<'_> {
    pub(super) fn crossings(&self) -> Crossings {
        let (joined, meeting) = self.shared();
        if self.cannot_cross(joined, meeting) {
            return Crossings::none(self.order_at_shared(joined));
        }
        let lines = self.f.is_line() && self.g.is_line();
        if lines && (self.f.is_steep_line() || self.g.is_steep_line()) {
            return self.steep_lines();
        }
        let (start, end) = (self.sign_at_start(), self.sign_at_end());
        if lines && start * end > 0 {
            return Crossings::none(start < 0);
        }
        let (candidates, count) = self.candidates(joined, meeting);
        let candidates = &candidates[..count];
        if count == 0 && start * end < 0 {
            return Crossings::at(start < 0, &[self.moment(self.bisect(start))]);
        }
        self.changes(self.signs(candidates, start, end), candidates)
    }

    /// Whether the curves share their starts and their ends.
    pub(super) fn shared(&self) -> (bool, bool) {
        (self.f.first == self.g.first, self.f.last == self.g.last)
    }

    /// Whether the shared ends leave no crossing.
    pub(super) fn cannot_cross(&self, joined: bool, meeting: bool) -> bool {
        (joined || meeting) && self.f.is_line() && self.g.is_line() || joined && meeting
    }

    /// Lines of which one is steep. Their difference in y is linear, and known at both ends of the common part to a few eps,
    /// so the fraction at which it vanishes and the abscissa there, in twofold precision, make it a few eps at most.
    fn steep_lines(&self) -> Crossings {
        let (p, q) = (self.gap_at_start(), self.gap_at_end());
        let (start, end) = (self.sign(p), self.sign(q));
        if start * end < 0 {
            return Crossings::at(start < 0, &[self.interpolated(p / (p - q))]);
        }
        Crossings::none(if start == 0 { end <= 0 } else { start < 0 })
    }

    /// The moment at this fraction of the common part, the ordinate by the flatter line.
    fn interpolated(&self, fraction: f64) -> Moment {
        let (from, to) = (self.start().x, self.end().x);
        let (x, low) = two_sum(from, fraction * (to - from));
        let (f, g) = (self.f.chord(), self.g.chord());
        let flat = if (f.y * g.x).abs() <= (g.y * f.x).abs() { self.f } else { self.g };
        let (first, last) = (flat.y_at(from), flat.y_at(to));
        let (f, g) = (self.f.y_range(), self.g.y_range());
        let lowest = f.0.max(g.0);
        let y = (first + fraction * (last - first)).clamp(lowest, f.1.min(g.1).max(lowest));
        Moment { at: DVec2::new(x, y), low }
    }

    /// When curves of which one at least is an arc, or lines neither of which is steep, cross at a place. On a steep curve the
    /// abscissa says it, with its error. A steep line has the last word, then the steeper arc: an arc is much steeper than
    /// a line only near its end, where it soon turns away.
    fn moment(&self, at: DVec2) -> Moment {
        if self.f.is_line() && self.g.is_line() {
            return Moment::from(at);
        }
        let Some(steep) = self.steep_at(at) else { return Moment::from(at) };
        let (x, low) = steep.twofold_x_at(at.y);
        Moment { at: DVec2::new(x, at.y), low }
    }

    /// The curve whose abscissa tells when the two cross at a place, unless it is vertical or neither is steep there.
    fn steep_at(&self, at: DVec2) -> Option<&Curve> {
        if let Some(line) = [self.f, self.g].into_iter().find(|curve| curve.is_steep_line()) {
            return (!line.is_vertical()).then_some(line);
        }
        // The direction is the normal turned by a right angle.
        let [f, g] = [self.f, self.g].map(|curve| curve.gradient(at).perp());
        let (steeper, direction) = if (f.y * g.x).abs() > (g.y * f.x).abs() { (self.f, f) } else { (self.g, g) };
        is_steep(direction).then_some(steeper)
    }

    /// Order of curves that share an end and cannot cross: by direction there. Equal directions fall back on the index.
    pub(super) fn order_at_shared(&self, joined: bool) -> bool {
        let order = if joined { order_at_start(self.f, self.g) } else { order_at_end(self.f, self.g) };
        order != Ordering::Greater
    }

    /// The sign of f above g, -1, 0 or 1, on the intervals into which the candidates cut the common part. An interval that
    /// begins or ends the part has the sign there, unless that is 0.
    fn signs(&self, candidates: &[DVec2], start: i8, end: i8) -> [i8; 3] {
        let bound = |i: usize| match i.checked_sub(1) {
            None => self.on_f(self.start()),
            Some(i) => candidates.get(i).copied().unwrap_or_else(|| self.on_f(self.end())),
        };
        let sign = |i: usize| match i {
            0 if start != 0 => start,
            _ if i == candidates.len() && end != 0 => end,
            _ if i > candidates.len() => 0,
            _ => self.sign_between(bound(i), bound(i + 1)),
        };
        [0, 1, 2].map(sign)
    }

    /// Keeps the candidates at which the sign changes. A sign of 0 counts as that of the interval before.
    fn changes(&self, signs: [i8; 3], candidates: &[DVec2]) -> Crossings {
        let Some(first) = signs.into_iter().find(|s| *s != 0) else {
            return Crossings::none(true);
        };
        let (mut sign, mut answer) = (first, Crossings::none(first < 0));
        for (place, next) in candidates.iter().zip(&signs[1..]) {
            if *next == -sign {
                sign = *next;
                answer.push(self.moment(*place));
            }
        }
        answer
    }

    fn start(&self) -> DVec2 {
        if compare(self.f.start, self.g.start).is_ge() { self.f.start } else { self.g.start }
    }

    fn end(&self) -> DVec2 {
        if compare(self.f.end, self.g.end).is_le() { self.f.end } else { self.g.end }
    }

    fn sign(&self, distance: f64) -> i8 {
        if distance > self.tolerance {
            1
        } else if distance < -self.tolerance {
            -1
        } else {
            0
        }
    }

    fn sign_at_start(&self) -> i8 {
        if self.f.first == self.g.first {
            return order_at_start(self.f, self.g) as i8;
        }
        self.sign(self.gap_at_start())
    }

    /// How far f is above g, vertically, at the start of the common part.
    pub(super) fn gap_at_start(&self) -> f64 {
        if compare(self.f.start, self.g.start).is_ge() {
            self.g.above(self.f.start)
        } else {
            -self.f.above(self.g.start)
        }
    }

    fn sign_at_end(&self) -> i8 {
        if self.f.last == self.g.last {
            return order_at_end(self.f, self.g) as i8;
        }
        self.sign(self.gap_at_end())
    }

    /// How far f is above g, vertically, at the end of the common part.
    fn gap_at_end(&self) -> f64 {
        if compare(self.f.end, self.g.end).is_le() { self.g.above(self.f.end) } else { -self.f.above(self.g.end) }
    }

    /// The sign half way between two points of f in the common part. A vertical has no half way: it crosses at most once.
    fn sign_between(&self, p: DVec2, q: DVec2) -> i8 {
        if self.f.is_vertical() || self.g.is_vertical() {
            return 0;
        }
        let m = self.point_between(p, q, 0.5);
        self.sign(self.g.side(m))
    }

    /// A point of f at this fraction between two of its points, parametrised by the longer side of its chord.
    fn point_between(&self, p: DVec2, q: DVec2, fraction: f64) -> DVec2 {
        let chord = self.f.chord();
        if chord.y.abs() > chord.x && !self.f.is_vertical() {
            let y = p.y + (q.y - p.y) * fraction;
            DVec2::new(self.f.x_at(y), y)
        } else {
            let x = p.x + (q.x - p.x) * fraction;
            DVec2::new(x, self.f.y_at(x))
        }
    }

    /// A place where the sign changes though no closed form found one: bisection along f.
    fn bisect(&self, first: i8) -> DVec2 {
        let (start, end) = (self.on_f(self.start()), self.on_f(self.end()));
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let side = self.g.side(self.point_between(start, end, middle));
            if (side > 0.0) == (first > 0) {
                low = middle;
            } else {
                high = middle;
            }
        }
        self.point_between(start, end, high)
    }

    fn on_f(&self, p: DVec2) -> DVec2 {
        if self.f.is_vertical() { p } else { DVec2::new(p.x, self.f.y_at(p.x)) }
    }

    /// Intersections of the two lines or circles that lie in the common part, sorted. At a shared end the curves meet but
    /// do not cross, so the root nearest to it is left out.
    // Inlined as if it had one caller: each pair of curves comes through here.
    #[inline(always)]
    pub(super) fn candidates(&self, joined: bool, meeting: bool) -> ([DVec2; 2], usize) {
        let (mut roots, mut count) = meet(self.f, self.g);
        let shared = match (joined, meeting) {
            (true, _) => Some(self.start()),
            (_, true) => Some(self.end()),
            _ => None,
        };
        if let (Some(p), 2) = (shared, count) {
            let far = usize::from(roots[0].distance_squared(p) < roots[1].distance_squared(p));
            (roots[0], count) = (roots[far], 1);
        } else if shared.is_some() {
            count = 0;
        }
        let mut kept = 0;
        for i in 0..count {
            if let Some(p) = self.in_common_part(roots[i]) {
                roots[kept] = p;
                kept += 1;
            }
        }
        if kept == 2 && compare(roots[0], roots[1]).is_gt() {
            roots.swap(0, 1);
        }
        (roots, kept)
    }

    /// The candidate moved into the box of the common part, unless it lies clearly outside.
    #[inline(always)]
    fn in_common_part(&self, p: DVec2) -> Option<DVec2> {
        let (f, g) = (self.f.y_range(), self.g.y_range());
        let low = DVec2::new(self.start().x, f.0.max(g.0));
        let high = DVec2::new(self.end().x, f.1.min(g.1)).max(low);
        let q = p.clamp(low, high);
        (p.is_finite() && (p - q).abs().max_element() <= self.tolerance).then_some(q)
    }
}
