//! Whether A meets t - B, asked for many t: the definition of the sum, as a test (MS 3).
//!
//! Boundaries that cross mean that the regions meet; where none do, each loop lies wholly inside or outside the other
//! region. Curves are sorted by their left ends, which stay sorted when B moves, so a question takes O(n log n) time for n
//! curves, and time for the pairs that run over the same abscissas. All of it is plain doubles: within a few eps of contact the
//! answer may be wrong.

use crate::arrangement::cross::{CrossingModule, FloatModule};
use crate::arrangement::curve::{Curve, compare};
use crate::piece::{Piece, Source};
use crate::smooth::{Kind, Seg, Smooth};
use glam::DVec2;

/// The boundary of a region.
#[derive(Clone, Debug)]
struct Side {
    /// Its curves, by their left ends.
    curves: Vec<Curve>,
    /// The width of the widest.
    widest: f64,
    /// A vertex of each loop.
    vertices: Vec<DVec2>,
    unbounded: bool,
}

/// Two regions, ready for the question.
#[derive(Clone, Debug)]
pub struct Overlap {
    a: Side,
    /// The second region mirrored in the origin.
    b: Side,
    module: FloatModule,
}

impl Overlap {
    /// Makes ready for the sum of two regions in frames of one scale.
    #[must_use]
    pub fn new(a: &Smooth, b: &Smooth) -> Self {
        let first = a.points.len() as u32;
        let (a, b) = (Side::new(a, false, 0), Side::new(b, true, first));
        Self { a, b, module: FloatModule::new(1.0) }
    }

    /// Whether the regions meet however far apart they are.
    #[must_use]
    pub fn is_unbounded(&self) -> bool {
        self.a.unbounded || self.b.unbounded
    }

    /// Whether A meets t - B, for t in units of the frame from the origins of both.
    #[must_use]
    pub fn at(&self, t: DVec2) -> bool {
        let b = self.b.moved(t);
        let inside = |vertices: &[DVec2], side: &Side| vertices.iter().any(|p| side.contains(*p));
        self.cross(&b) || inside(&self.a.vertices, &b) || inside(&b.vertices, &self.a)
    }

    /// Whether a curve of A crosses one of the other side.
    fn cross(&self, other: &Side) -> bool {
        self.a.curves.iter().any(|f| {
            let from = other.curves.partition_point(|g| g.start.x < f.start.x - other.widest);
            let near = other.curves[from..].iter().take_while(|g| g.start.x <= f.end.x);
            near.filter(|g| compare(f.start, g.end).is_lt() && compare(g.start, f.end).is_lt())
                .any(|g| !self.module.cross(f, g).points().is_empty())
        })
    }
}

impl Side {
    /// The boundary of a region, mirrored or not, with vertices that are numbered from `first` on.
    fn new(region: &Smooth, mirrored: bool, first: u32) -> Self {
        let segs = || region.loops.iter().flat_map(|l| &l.segs).filter(|seg| seg.kind != Kind::Turn);
        let place = |v: u32| if mirrored { -region.points[v as usize] } else { region.points[v as usize] };
        let curve = |(index, seg): (usize, &Seg)| {
            let [tail, head] = [seg.tail, seg.head].map(|v| (first + v, place(v)));
            Curve::new(index as u32, &piece(seg, mirrored), tail, head, [tail.1, head.1])
        };
        let mut curves: Vec<Curve> = segs().enumerate().filter_map(curve).collect();
        curves.sort_by(|f, g| compare(f.start, g.start));
        let widest = curves.iter().map(|f| f.end.x - f.start.x).fold(0.0, f64::max);
        let vertices = region.loops.iter().filter_map(|l| l.segs.first()).map(|seg| place(seg.tail)).collect();
        let unbounded = region.components.iter().any(|component| component.outer.is_none());
        Self { curves, widest, vertices, unbounded }
    }

    fn moved(&self, by: DVec2) -> Self {
        Self {
            curves: self.curves.iter().map(|curve| curve.moved(by)).collect(),
            // With room for the rounding of both ends.
            widest: self.widest + 8.0 * f64::EPSILON,
            vertices: self.vertices.iter().map(|p| *p + by).collect(),
            unbounded: self.unbounded,
        }
    }

    /// Whether the region holds a point: it lies above an odd number of curves, or an even one if all far points are in it.
    fn contains(&self, p: DVec2) -> bool {
        let from = self.curves.partition_point(|f| f.start.x < p.x - self.widest);
        let near = self.curves[from..].iter().take_while(|f| f.start.x <= p.x);
        let below = near.filter(|f| p.x < f.end.x && f.above(p) > 0.0).count();
        self.unbounded != (below % 2 == 1)
    }
}

/// The segment as a piece. Mirroring turns its normals by half a turn and leaves its sweep.
fn piece(seg: &Seg, mirrored: bool) -> Piece {
    let [a, b] = [seg.a, seg.b].map(|angle| if mirrored { angle.opposite() } else { angle });
    let (tail, head, source) = (seg.tail, seg.head, Source::default());
    Piece { tail, head, a, b, whole: [tail, head], delta: seg.delta, r: seg.r, source, operand: 0, weight: 1 }
}
