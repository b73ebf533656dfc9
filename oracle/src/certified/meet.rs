//! Contacts of two pieces: the boxes in which they come within the zone of each other (memo I4).
//!
//! A contact is a place of the carriers ([`super::carriers`]) that neither piece certainly misses. It is a certain
//! crossing if the carriers cross there once and the whole place lies between the ends of both pieces.

use std::cmp::Ordering;

use super::carriers::{Places, grown};
use super::piece::Piece;
use super::precision::Precision;
use super::real::Real;
use super::vector::Vector;

pub use super::carriers::{SAME, ZONE};

/// Contacts smaller than two to this power need not be known any better.
pub const FINE: i32 = -90;
/// The precision at which a contact is taken as it is, however large.
pub const LIMIT: Precision = Precision::LADDER[4];

/// A place where two pieces come within the zone of each other.
#[derive(Clone, Debug)]
pub struct Contact {
    /// A box around all points of both pieces that belong to the contact.
    pub place: Vector,
    /// For a certain crossing at inner points of both pieces and at an angle: `Greater` if the second piece goes from the
    /// right of the first to its left, `Less` the other way. Unknown for all other contacts.
    pub crossing: Option<Ordering>,
}

/// What is known about how two pieces meet.
#[derive(Clone, Debug)]
pub enum Meeting {
    /// They are certainly farther apart than the zone.
    Apart,
    /// Every point of one piece within the zone of the other is in one of these places, except for the common stretch of
    /// pieces with the same carrier.
    Contacts {
        /// Whether the carriers are the same to within two to the power of [`SAME`]. Then the contacts are the ends of
        /// each piece on the other.
        same: bool,
        /// The places, not empty.
        contacts: Vec<Contact>,
    },
    /// This precision cannot tell.
    Unclear,
}

/// How two pieces, known to this precision, meet. Doubles give only certain crossings; finer numbers also contacts with
/// boxes smaller than two to the power of [`FINE`], and [`LIMIT`] everything but carriers that are neither apart nor
/// the same.
#[must_use]
pub fn meet(first: &Piece, second: &Piece, precision: Precision) -> Meeting {
    if are_far(first, second) {
        return Meeting::Apart;
    }
    let (places, simple) = match Places::of(first, second, precision) {
        Places::Nowhere => return Meeting::Apart,
        Places::Unclear => return Meeting::Unclear,
        Places::Same => return overlap(first, second, precision),
        Places::Crossings(places) => (places, true),
        Places::Tangency(place) => (vec![place], false),
    };
    let mut contacts = Vec::with_capacity(places.len());
    for place in places {
        let on = [first, second].map(|piece| piece.spans(&place));
        if on.contains(&Some(false)) {
            continue;
        }
        let inner = simple && on == [Some(true); 2];
        let crossing = if inner { first.tangent(&place).turn(&second.tangent(&place)) } else { None };
        let crossing = crossing.filter(|order| order.is_ne());
        if crossing.is_none() && !is_fine(&place, precision) {
            return Meeting::Unclear;
        }
        contacts.push(Contact { place, crossing });
    }
    if contacts.is_empty() { Meeting::Apart } else { Meeting::Contacts { same: false, contacts } }
}

/// Whether boxes of doubles are apart by more than the zone.
fn are_far(first: &Piece, second: &Piece) -> bool {
    let (a, b) = (first.bounds(), second.bounds());
    let limit = f64::from(ZONE + 1).exp2();
    (0..2).any(|axis| b[axis] - a[axis + 2] > limit || a[axis] - b[axis + 2] > limit)
}

/// Whether a contact is known well enough to be one.
fn is_fine(place: &Vector, precision: Precision) -> bool {
    let small = || [&place.x, &place.y].into_iter().all(|c| spread(c).is_within(FINE));
    precision >= LIMIT || (precision > Precision::DOUBLE && small())
}

/// The differences of two numbers of an interval.
fn spread(interval: &Real) -> Real {
    let other = interval;
    interval - other
}

/// The ends of each piece on the other, for pieces with the same carrier.
fn overlap(first: &Piece, second: &Piece, precision: Precision) -> Meeting {
    let mut contacts = Vec::new();
    for (piece, other) in [(first, second), (second, first)] {
        for end in [&piece.from, &piece.to] {
            let place = grown(end, precision);
            match other.spans(&place) {
                Some(false) => continue,
                None if !is_fine(&place, precision) => return Meeting::Unclear,
                _ => contacts.push(Contact { place, crossing: None }),
            }
        }
    }
    if contacts.is_empty() { Meeting::Apart } else { Meeting::Contacts { same: true, contacts } }
}
