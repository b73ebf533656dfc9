//! A static index of boxes, so that only neighbours are ever compared. Boxes contain what they stand for, queries are
//! closed: nothing that touches is missed.

use static_aabb2d_index::{Control, StaticAABB2DIndex, StaticAABB2DIndexBuilder};

use crate::error::OracleError;
use crate::number::Number;
use crate::point::Place;

/// A closed box of doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Lower abscissa, lower ordinate, upper abscissa, upper ordinate.
    pub ends: [f64; 4],
}

impl Extent {
    /// The box around some places; `None` for none.
    pub fn around<'a, Q: Number>(places: impl IntoIterator<Item = &'a Place<Q>>) -> Option<Self> {
        let mut places = places.into_iter();
        let single = |p: &Place<Q>| [p.x.lo(), p.y.lo(), p.x.hi(), p.y.hi()];
        let first = single(places.next()?);
        let join = |a: [f64; 4], b: [f64; 4]| [a[0].min(b[0]), a[1].min(b[1]), a[2].max(b[2]), a[3].max(b[3])];
        Some(Self { ends: places.fold(first, |ends, p| join(ends, single(p))) })
    }

    /// Whether the boxes have a point in common.
    #[must_use]
    pub fn meets(&self, other: &Self) -> bool {
        let (a, b) = (&self.ends, &other.ends);
        a[0] <= b[2] && b[0] <= a[2] && a[1] <= b[3] && b[1] <= a[3]
    }
}

/// The index.
pub struct Boxes {
    index: StaticAABB2DIndex<f64>,
}

impl Boxes {
    /// Indexes the boxes by their position in the list.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] if the boxes are too large for doubles.
    pub fn new(extents: &[Extent]) -> Result<Self, OracleError> {
        let mut builder = StaticAABB2DIndexBuilder::new(extents.len());
        for Extent { ends: [x0, y0, x1, y1] } in extents {
            builder.add(*x0, *y0, *x1, *y1);
        }
        let too_large = |_| OracleError::BadNumber { ring: 0, vertex: 0, reason: "coordinates too large to index" };
        Ok(Self { index: builder.build().map_err(too_large)? })
    }

    /// Calls `visit` with every box that meets the query box.
    pub fn visit(&self, query: &Extent, mut visit: impl FnMut(usize)) {
        let [x0, y0, x1, y1] = query.ends;
        self.index.visit_query(x0, y0, x1, y1, &mut |i: usize| visit(i));
    }

    /// Calls `visit` with every box by increasing distance from (x, y), the distance rounded down a little, until it
    /// answers false.
    pub fn visit_nearest(&self, x: f64, y: f64, mut visit: impl FnMut(usize, f64) -> bool) {
        // Three roundings of 2^-53 each and the root: 2^-48 covers them.
        const SHRINK: f64 = 1.0 - 3.6e-15;
        const UNDERFLOW: f64 = 1e-150;
        self.index.visit_neighbors(x, y, &mut |i: usize, squared: f64| {
            if visit(i, squared.sqrt() * SHRINK - UNDERFLOW) { Control::Continue } else { Control::Break(()) }
        });
    }
}
