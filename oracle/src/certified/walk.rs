//! One curve among the others: its contacts in order, gathered into clusters.
//!
//! Places on a curve are fractions of its chord (see [`super::stretch`]). Contacts whose fractions overlap are refined until
//! they separate or their cluster is shorter than two to the power of [`CLUSTER`]. Outside the clusters every other curve
//! is farther away than the zone, except curves with the same carrier.

use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use rug::Float;

use super::curve::Curve;
use super::meet::{LIMIT, Meeting, meet};
use super::piece::Piece;
use super::precision::Precision;
use super::real::Real;
use super::vector::Vector;
use crate::interval::Interval;

/// Clusters shorter than two to this power need not be known any better. A single contact that [`meet`] reports is.
pub const CLUSTER: i32 = -88;
/// Clusters longer than two to this power hide too much. Touching curves make clusters of about √(Z r) for the zone Z and
/// the radius r of their difference in curvature: that allows for r up to 2^160.
pub const OBSCURE: i32 = -66;

/// A contact of the curve with another one, or an end of the curve.
#[derive(Clone, Debug)]
struct Touch {
    /// Least and greatest fraction, from 0 to 1.
    extent: [Float; 2],
    /// The other curve; none for an end.
    other: Option<usize>,
    /// A box around it.
    place: Vector,
    /// As in [`super::meet::Contact`].
    crossing: Option<Ordering>,
    /// How finely it is known.
    precision: Precision,
}

/// A stretch of a curve that contains contacts or an end.
#[derive(Clone, Debug)]
pub struct Cluster {
    /// Where it begins, as a fraction of the chord.
    pub low: Float,
    /// Where it ends.
    pub high: Float,
    touches: Vec<Touch>,
}

/// A curve's clusters, in order from its start to its end.
#[derive(Debug)]
pub struct Walk<'a> {
    curves: &'a [Arc<Curve>],
    /// Index of the curve.
    pub index: usize,
    /// The clusters; the first contains the start, the last the end.
    pub clusters: Vec<Cluster>,
    /// The curves with the same carrier that overlap it or touch its ends.
    pub copies: BTreeSet<usize>,
    /// The finest precision that was needed.
    pub finest: Precision,
}

impl<'a> Walk<'a> {
    /// Along the curve of this index, among those others that may come near it.
    #[must_use]
    pub fn new(curves: &'a [Arc<Curve>], index: usize, others: &[usize]) -> Self {
        let mut walk = Self { curves, index, clusters: Vec::new(), copies: BTreeSet::new(), finest: Precision::DOUBLE };
        let mut touches = walk.ends();
        touches.extend(others.iter().flat_map(|&other| walk.touches(other, Precision::DOUBLE)));
        walk.clusters = gather(touches);
        walk.separate();
        walk
    }

    /// The curve.
    #[must_use]
    pub fn curve(&self) -> &'a Arc<Curve> {
        &self.curves[self.index]
    }

    /// Another curve.
    #[must_use]
    pub fn other(&self, index: usize) -> &'a Curve {
        &self.curves[index]
    }

    fn ends(&self) -> Vec<Touch> {
        let rough = self.curve().rough();
        let touch = |(fraction, place): (u32, &Vector)| Touch {
            extent: [Float::with_val(53, fraction), Float::with_val(53, fraction)],
            other: None,
            place: place.clone(),
            crossing: None,
            precision: LIMIT,
        };
        [(0, &rough.from), (1, &rough.to)].map(touch).to_vec()
    }

    /// The contacts with another curve, at the first precision from `start` on that tells.
    fn touches(&mut self, other: usize, start: Precision) -> Vec<Touch> {
        let (first, second) = (self.curve(), &self.curves[other]);
        for precision in LIMIT.up_to().filter(|&p| p >= start) {
            self.finest = self.finest.max(precision);
            let piece = first.at(precision);
            let touch = |place: Vector, crossing| Touch {
                extent: extent(piece, &place),
                other: Some(other),
                place,
                crossing,
                precision,
            };
            match meet(piece, second.at(precision), precision) {
                Meeting::Apart => return Vec::new(),
                Meeting::Contacts { same, contacts } => {
                    if same {
                        self.copies.insert(other);
                    }
                    return contacts.into_iter().map(|contact| touch(contact.place, contact.crossing)).collect();
                }
                Meeting::Unclear if precision == LIMIT => {
                    return vec![touch(common_box(first.rough(), second.rough()), None)];
                }
                Meeting::Unclear => {}
            }
        }
        Vec::new()
    }

    /// The length of a cluster, in input units.
    #[must_use]
    pub fn length(&self, cluster: &Cluster) -> f64 {
        // In doubles the chord of a tiny curve may be known to no digit.
        let chord = |p: Precision| self.curve().at(p).chord().length();
        let known = LIMIT.decide(|p| Some(chord(p)).filter(|length| length.hi() < 2.0 * length.lo()));
        cluster.size().to_f64() * known.unwrap_or_else(|| chord(LIMIT)).hi()
    }

    /// Whether a cluster is as short as it needs to be.
    fn is_small(&self, cluster: &Cluster) -> bool {
        self.length(cluster) < f64::from(CLUSTER).exp2()
    }

    /// Refines the contacts of clusters that are too large, and gathers them anew.
    fn separate(&mut self) {
        loop {
            let coarse: BTreeMap<usize, Precision> = self
                .clusters
                .iter()
                .filter(|cluster| cluster.touches.len() > 1 && !self.is_small(cluster))
                .flat_map(Cluster::coarse)
                .collect();
            if coarse.is_empty() {
                return;
            }
            let refined = |touch: &Touch| touch.other.is_some_and(|other| coarse.contains_key(&other));
            let mut touches: Vec<Touch> = self.clusters.drain(..).flat_map(|cluster| cluster.touches).collect();
            touches.retain(|touch| !refined(touch));
            for (other, precision) in coarse {
                touches.extend(self.touches(other, finer(precision)));
            }
            self.clusters = gather(touches);
        }
    }

    /// A cluster known so finely that it is small, if that can be had.
    #[must_use]
    pub fn refined(&mut self, cluster: &Cluster) -> Cluster {
        let mut cluster = cluster.clone();
        while !self.is_small(&cluster) {
            let coarse: Vec<_> = cluster.coarse().collect();
            let Some(&(other, precision)) = coarse.first() else { break };
            let finer = self.touches(other, finer(precision));
            let overlaps = |touch: &Touch| touch.extent[0] <= cluster.high && cluster.low <= touch.extent[1];
            let mut touches: Vec<Touch> = finer.into_iter().filter(overlaps).collect();
            touches.extend(cluster.touches.into_iter().filter(|touch| touch.other != Some(other)));
            match gather(touches).into_iter().next() {
                Some(next) => cluster = next,
                None => unreachable!("a contact at one precision is one at all finer ones"),
            }
        }
        cluster
    }
}

impl Cluster {
    /// Its length as a fraction of the chord.
    fn size(&self) -> Float {
        Float::with_val(53, &self.high - &self.low)
    }

    /// If all contacts are certain crossings of one kind: `Greater` if the curve leaves the left of the other ones, `Less`
    /// if it enters it.
    #[must_use]
    pub fn crossing(&self) -> Option<Ordering> {
        let first = self.touches[0].crossing;
        first.filter(|_| self.touches.iter().all(|touch| touch.crossing == first))
    }

    /// A fraction inside: an end of the curve if it contains one, else the middle.
    #[must_use]
    pub fn fraction(&self) -> Float {
        let end = self.touches.iter().find(|touch| touch.other.is_none());
        end.map_or_else(|| middle(&self.low, &self.high), |touch| touch.extent[0].clone())
    }

    /// A box around its contacts, or around the end if there are none.
    #[must_use]
    pub fn place(&self) -> Vector {
        let contacts = self.touches.iter().filter(|touch| touch.other.is_some());
        let hull = |a: Vector, b: Vector| Vector { x: a.x.hull(&b.x), y: a.y.hull(&b.y) };
        let place = contacts.map(|touch| touch.place.clone()).reduce(hull);
        place.unwrap_or_else(|| self.touches[0].place.clone())
    }

    /// The other curves whose contacts could be known better, with the precisions they are known to.
    fn coarse(&self) -> impl Iterator<Item = (usize, Precision)> {
        self.touches
            .iter()
            .filter(|touch| touch.precision < LIMIT)
            .filter_map(|touch| touch.other.map(|other| (other, touch.precision)))
    }
}

/// Halfway between two fractions, exactly or to far below the zone.
#[must_use]
pub fn middle(low: &Float, high: &Float) -> Float {
    Float::with_val(LIMIT.bits(), low + high) / 2u32
}

/// The next precision of the ladder.
fn finer(precision: Precision) -> Precision {
    Precision::LADDER[precision.rung() + 1]
}

/// The fractions of the chord that a box covers, cut at 0 and 1.
fn extent(piece: &Piece, place: &Vector) -> [Float; 2] {
    let fraction = piece.progress(place) / piece.chord().square();
    let ends = match fraction {
        Real::Double(interval) => [interval.lo(), interval.hi()].map(|end| Float::with_val(53, end)),
        Real::Long(bounds) => *bounds,
    };
    let [low, high] = ends;
    // What is not a number is unknown.
    let low = if low.is_nan() { Float::new(53) } else { low };
    let high = if high.is_nan() { Float::with_val(53, 1) } else { high };
    [low, high].map(|end| end.clamp(&0, &1))
}

/// The box that two pieces have in common.
fn common_box(first: &Piece, second: &Piece) -> Vector {
    let (a, b) = (first.bounds(), second.bounds());
    let side = |axis: usize| {
        let (low, high) = (a[axis].max(b[axis]), a[axis + 2].min(b[axis + 2]));
        Real::Double(Interval::new(low.min(high), high.max(low)))
    };
    Vector { x: side(0), y: side(1) }
}

/// The clusters of overlapping contacts, in order.
fn gather(mut touches: Vec<Touch>) -> Vec<Cluster> {
    touches.sort_by(|a, b| a.extent[0].partial_cmp(&b.extent[0]).expect("numbers"));
    let mut clusters: Vec<Cluster> = Vec::new();
    for touch in touches {
        match clusters.last_mut() {
            Some(cluster) if touch.extent[0] <= cluster.high => {
                if touch.extent[1] > cluster.high {
                    cluster.high.clone_from(&touch.extent[1]);
                }
                cluster.touches.push(touch);
            }
            _ => {
                let [low, high] = touch.extent.clone();
                clusters.push(Cluster { low, high, touches: vec![touch] });
            }
        }
    }
    clusters
}
