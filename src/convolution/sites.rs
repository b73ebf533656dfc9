//! Sites: the places on the boundary of an operand at which sum segments end, by number.
//!
//! Vertices come first, as the region numbers them; places inside arcs follow as they are met. What a sum needs of an arc
//! there is computed once, however many vertices are added to it.

use super::Stop;
use super::sums::Placed;
use crate::angle::Ang;
use crate::arc::Arc;
use crate::smooth::{Kind, Smooth};
use glam::DVec2;
use rustc_hash::FxHashMap as HashMap;

/// A place on the boundary: a vertex, an index of [`Smooth::points`], or beyond those an index of the places inside arcs.
pub type Site = u32;

/// The places of one operand.
pub struct Sites<'a> {
    region: &'a Smooth,
    inside: Vec<Inside>,
    index: HashMap<(u32, u32, Ang), Site>,
}

/// A place inside an arc.
struct Inside {
    stop: Stop,
    arc: Arc,
    /// The place, as [`Arc::offset`] gives it.
    offset: (DVec2, DVec2),
}

/// The geometry of a site.
pub enum Place<'s> {
    /// A vertex.
    Point(DVec2),
    /// An arc and an end of it with the way from there.
    On(&'s Arc, (DVec2, DVec2)),
}

impl<'a> Sites<'a> {
    /// The vertices of a region.
    pub fn new(region: &'a Smooth) -> Self {
        Self { region, inside: Vec::new(), index: HashMap::default() }
    }

    /// The site of a segment at an angle.
    pub fn site(&mut self, placed: Placed, angle: Ang) -> Site {
        let seg = placed.seg;
        if seg.kind == Kind::Turn || angle == seg.a {
            seg.tail
        } else if angle == seg.b {
            seg.head
        } else {
            let next = (self.region.points.len() + self.inside.len()) as Site;
            let site = *self.index.entry((placed.of_loop, placed.index, angle)).or_insert(next);
            if site == next {
                self.inside.push(Inside::new(self.region, placed, angle));
            }
            site
        }
    }

    /// Where a site is.
    pub fn place(&self, site: Site) -> Place<'_> {
        let site = site as usize;
        match self.region.points.get(site) {
            Some(point) => Place::Point(*point),
            None => {
                let inside = &self.inside[site - self.region.points.len()];
                Place::On(&inside.arc, inside.offset)
            }
        }
    }

    /// The places inside arcs, in order.
    pub fn stops(&self) -> Vec<Stop> {
        let mut stops: Vec<Stop> = self.inside.iter().map(|inside| inside.stop).collect();
        stops.sort_unstable();
        stops
    }
}

impl Inside {
    fn new(region: &Smooth, placed: Placed, angle: Ang) -> Self {
        let seg = placed.seg;
        let [tail, head] = [seg.tail, seg.head].map(|v| region.points[v as usize]);
        let arc = Arc::minor(tail, head, seg.a, seg.b, seg.delta < 0.0);
        let stop = Stop { of_loop: placed.of_loop as usize, seg: placed.index as usize, angle };
        Self { stop, offset: arc.offset(angle), arc }
    }
}
