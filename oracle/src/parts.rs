//! Connected components of a region and the holes of one that matter to another (memo A8).

use crate::error::OracleError;
use crate::locate::{Location, Locator};
use crate::number::Number;
use crate::point::{Place, Point};
use crate::region::{ExactRegion, ring_area};

/// A closed ring of places.
pub type Ring<Q> = Vec<Place<Q>>;

/// A component: one outer loop, or none if it is unbounded, and the holes in it.
pub struct Part<Q> {
    /// The outer loop, counter-clockwise.
    pub outer: Option<Ring<Q>>,
    /// The holes, clockwise.
    pub holes: Vec<Ring<Q>>,
}

impl<Q: Number> Part<Q> {
    /// Whether the component is unbounded.
    #[must_use]
    pub fn unbounded(&self) -> bool {
        self.outer.is_none()
    }

    /// The loops left after filling every hole that `other` cannot lie in: a hole stays if its bounding box is at least
    /// as wide and as high as that of `other`. With these loops the winding number of the convolution is positive on
    /// the sum and 0 elsewhere.
    pub fn rings_against<'a>(&'a self, other: &'a Self) -> impl Iterator<Item = &'a Ring<Q>> {
        let size = other.outer.as_ref().map(|ring| box_size(ring));
        let stays = move |hole: &&Ring<Q>| {
            let hole = box_size(hole);
            size.as_ref().is_some_and(|size| hole.x >= size.x && hole.y >= size.y)
        };
        self.outer.iter().chain(self.holes.iter().filter(stays))
    }
}

/// Width and height of the bounding box of a ring.
fn box_size<Q: Number>(ring: &Ring<Q>) -> Point<Q> {
    let span = |coordinate: fn(&Point<Q>) -> &Q| {
        let values = || ring.iter().map(|p| coordinate(&p.exact));
        match (values().max(), values().min()) {
            (Some(max), Some(min)) => max.minus(min),
            _ => Q::from_i64(0),
        }
    };
    Point { x: span(|p| &p.x), y: span(|p| &p.y) }
}

/// The components of a region, an unbounded one first. Loops that only touch count as separate components, which
/// changes no sum.
///
/// # Errors
/// [`OracleError::Inconsistent`] for a hole in no component.
pub fn parts<Q: Number>(region: &ExactRegion<Q>) -> Result<Vec<Part<Q>>, OracleError> {
    let (outers, holes): (Vec<_>, Vec<_>) =
        region.loops().iter().zip(region.places()).partition(|(ring, _)| ring_area(ring).sign().is_gt());
    let mut hosts = Vec::new();
    let mut parts = Vec::new();
    if region.unbounded() {
        parts.push(Part { outer: None, holes: Vec::new() });
    }
    for (ring, places) in outers {
        hosts.push((ring_area(ring), Locator::of_rings(vec![places.clone()], false)?, parts.len()));
        parts.push(Part { outer: Some(places), holes: Vec::new() });
    }
    // Loops around the same point are nested: the host is the smallest of them.
    hosts.sort_by(|a, b| a.0.cmp(&b.0));
    for (ring, places) in holes {
        let host = hosts.iter().find(|(_, locator, _)| surrounds(locator, &ring[0], &ring[1])).map(|host| host.2);
        let host = host.or(region.unbounded().then_some(0));
        parts[host.ok_or(OracleError::Inconsistent("a hole lies in no component"))?].holes.push(places);
    }
    Ok(parts)
}

/// Whether the edge ab of another loop runs inside the ring. They share points at most, so some point of the edge is
/// not on the ring.
fn surrounds<Q: Number>(ring: &Locator<Q>, a: &Point<Q>, b: &Point<Q>) -> bool {
    let mut parameters = (2..).map(|k| Q::from_i64(1).over(&Q::from_i64(k)));
    let location = parameters.find_map(|t| {
        let location = ring.locate(&Place::from(a.toward(b, &t)));
        (location != Location::Boundary).then_some(location)
    });
    location == Some(Location::Inside)
}
