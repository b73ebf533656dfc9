//! A monotonic convolution in the order of the sweep: what lies below what at an abscissa, and what chains each curve is made
//! of (MS 7.1, 7.2).

use crate::cases::Case;
use arcsum::arrangement::Arrangement;
use arcsum::arrangement::trapezoid::Trapezoid;
use arcsum::chain::{Chain, Chains};
use arcsum::convolution::fill::{PairSum, fill};
use arcsum::convolution::order::{Kind, Order};
use arcsum::convolution::{monotonic_by, ordered};
use arcsum::frame::Frame;
use arcsum::piece::Pieces;
use arcsum::robustness::Robustness;
use arcsum::smooth::Smooth;
use glam::DVec2;

/// What a curve of a monotonic convolution is part of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::claims) enum Member {
    /// The crust of two chains.
    Crust {
        /// Whether they are upper ones.
        upper: bool,
        /// Their places among those of A and of B.
        chains: [usize; 2],
    },
    /// A chain of one operand moved by a concave turning point of the other.
    Moved {
        /// Whether it is an upper one.
        upper: bool,
        /// The operand.
        operand: usize,
        /// The chain.
        chain: usize,
        /// The turning point.
        turning: usize,
    },
}

/// A convolution of two connected regions, arranged.
pub(in crate::claims) struct Swept {
    /// The operands in their frames.
    pub(in crate::claims) regions: [Smooth; 2],
    /// Their chains.
    pub(in crate::claims) chains: [Chains; 2],
    /// The convolution.
    pub(in crate::claims) pieces: Pieces,
    /// Its order.
    pub(in crate::claims) order: Order,
    /// Its arrangement.
    pub(in crate::claims) arrangement: Arrangement,
}

impl Swept {
    /// The convolution of a case with these robustness steps; none if an operand has several parts, or the sum is the plane.
    pub(in crate::claims) fn new(case: &Case, robustness: Robustness) -> Option<Self> {
        let frames = Frame::pair(&case.a, &case.b);
        let (a, b) = (Smooth::new(&case.a, &frames.0).ok()?, Smooth::new(&case.b, &frames.1).ok()?);
        let ([of_a], [of_b]) = (a.components.as_slice(), b.components.as_slice()) else { return None };
        let PairSum::Loops(filled) = fill(&a, of_a, &b, of_b) else { return None };
        let chains = [Chains::new(&a, &filled.a), Chains::new(&b, &filled.b)];
        let (pieces, order) = monotonic_by(&a, &b, robustness)?;
        let arrangement = ordered::arrange(&pieces, &order, robustness);
        Some(Self { regions: [a, b], chains, pieces, order, arrangement })
    }

    /// What a curve of the arrangement is part of.
    pub(in crate::claims) fn member(&self, curve: u32) -> Member {
        let role = self.order.roles(self.arrangement.graph.curves[curve as usize].piece)[0];
        let turnings = self.order.group_of(role).turnings;
        let chain = |operand: usize, upper: bool| {
            let turning = &self.chains[operand].turnings[turnings[operand]];
            if upper { turning.upper } else { turning.lower }
        };
        let crust = |upper: bool| Member::Crust { upper, chains: [chain(0, upper), chain(1, upper)] };
        let moved = |operand: usize, upper: bool| Member::Moved {
            upper,
            operand,
            chain: chain(operand, upper),
            turning: turnings[1 - operand],
        };
        match role.1 {
            Kind::LowerCrust => crust(false),
            Kind::UpperCrust => crust(true),
            Kind::LowerOfA => moved(0, false),
            Kind::UpperOfA => moved(0, true),
            Kind::LowerOfB => moved(1, false),
            Kind::UpperOfB => moved(1, true),
        }
    }

    /// The trapezoids with a point in the middle that is not on their curves, that point, the curves at its abscissa, and
    /// how many of them are below it.
    pub(in crate::claims) fn middles(&self) -> impl Iterator<Item = (&Trapezoid, DVec2, Vec<u32>, usize)> {
        self.arrangement.trapezoids.iter().filter_map(|trapezoid| {
            let middle = trapezoid.spot(&self.arrangement.graph.curves, [0.5; 2]);
            let curves = (trapezoid.from < middle.x && middle.x < trapezoid.to)
                .then(|| status(&self.arrangement.trapezoids, middle.x))?;
            let below = 1 + curves.iter().position(|curve| *curve == trapezoid.bottom)?;
            Some((trapezoid, middle, curves, below))
        })
    }

    /// How many crusts there are at an abscissa, those that have cancelled included.
    pub(in crate::claims) fn crusts_at(&self, x: f64) -> usize {
        let [a, b] = [0, 1].map(|operand| {
            let points = &self.regions[operand].points;
            let range = |chain: &Chain| {
                let [p, q] = [chain.tail(), chain.head()].map(|vertex| points[vertex as usize].x);
                (chain.upper, p.min(q), p.max(q))
            };
            self.chains[operand].chains.iter().map(range).collect::<Vec<_>>()
        });
        let pairs = a.iter().flat_map(|p| b.iter().filter(|q| q.0 == p.0).map(move |q| [p.1 + q.1, p.2 + q.2]));
        pairs.filter(|[from, to]| *from < x && x < *to).count()
    }

    /// Whether a face is taken for free.
    pub(in crate::claims) fn is_free(&self, face: u32) -> bool {
        self.arrangement.graph.windings[face as usize][0] == 0
    }
}

/// The curves of a decomposition at an abscissa at which there is no vertex, from bottom to top.
pub(in crate::claims) fn status(trapezoids: &[Trapezoid], x: f64) -> Vec<u32> {
    let here: Vec<&Trapezoid> = trapezoids.iter().filter(|t| t.from < x && x < t.to).collect();
    let lowest = here.iter().map(|t| t.bottom).find(|bottom| here.iter().all(|t| t.top != *bottom));
    let mut curves: Vec<u32> = lowest.into_iter().collect();
    while let Some(next) = curves.last().and_then(|last| here.iter().find(|t| t.bottom == *last)) {
        curves.push(next.top);
    }
    curves
}
