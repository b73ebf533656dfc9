//! The chains of a smoothed region as functions, and which of them is below which (MS 7.1), in doubles: regions that are 2 mu
//! separated leave no doubt.

use arcsum::arrangement::curve::Curve;
use arcsum::chain::{Chain, Chains};
use arcsum::piece::{Piece, Source};
use arcsum::smooth::{Kind, Smooth};

/// Abscissas at which two chains are compared.
const SAMPLES: usize = 9;

/// A chain as a function.
pub(super) struct Graph {
    curves: Vec<Curve>,
    /// Its least and its greatest abscissa.
    pub(super) range: [f64; 2],
}

/// The chains of a region and their order.
pub(super) struct Ordered {
    /// The chains as functions.
    pub(super) graphs: Vec<Graph>,
    /// Pairs of chains with a common abscissa, the lower one first.
    pub(super) below: Vec<[usize; 2]>,
}

impl Ordered {
    /// The order of some chains of a region.
    pub(super) fn new(region: &Smooth, chains: &Chains) -> Self {
        let graphs: Vec<Graph> = chains.chains.iter().map(|chain| Graph::new(region, chain)).collect();
        let pairs = (0..graphs.len()).flat_map(|i| (i + 1..graphs.len()).map(move |j| [i, j]));
        let below = pairs.filter_map(|[i, j]| {
            let height = graphs[i].least_doubtful_height_over(&graphs[j])?;
            Some(if height < 0.0 { [i, j] } else { [j, i] })
        });
        let below = below.collect();
        Self { graphs, below }
    }
}

impl Graph {
    fn new(region: &Smooth, chain: &Chain) -> Self {
        let links = chain.links.iter().filter(|link| link.seg.kind != Kind::Turn);
        let curves: Vec<Curve> = links
            .filter_map(|link| {
                let seg = &link.seg;
                let mut piece = Piece::line(seg.tail, seg.head, seg.a, Source::default());
                (piece.b, piece.delta, piece.r) = (seg.b, seg.delta, seg.r);
                let end = |vertex: u32| (vertex, region.points[vertex as usize]);
                let [tail, head] = [end(seg.tail), end(seg.head)];
                Curve::new(0, &piece, tail, head, [tail.1, head.1])
            })
            .collect();
        let least = curves.iter().map(|curve| curve.left.x).fold(f64::INFINITY, f64::min);
        let greatest = curves.iter().map(|curve| curve.right.x).fold(f64::NEG_INFINITY, f64::max);
        Self { curves, range: [least, greatest] }
    }

    /// The ordinate at an abscissa strictly between its ends.
    fn at(&self, x: f64) -> Option<f64> {
        let curve = self.curves.iter().find(|curve| curve.left.x <= x && x <= curve.right.x && !curve.is_vertical())?;
        Some(curve.y_at(x))
    }

    /// How far this chain is above another at that common abscissa where it is farthest from it; none if there is none.
    fn least_doubtful_height_over(&self, other: &Self) -> Option<f64> {
        let (from, to) = (self.range[0].max(other.range[0]), self.range[1].min(other.range[1]));
        let step = (to - from) / (SAMPLES + 1) as f64;
        if step <= 0.0 {
            return None;
        }
        let heights = (1..=SAMPLES).filter_map(|i| {
            let x = from + step * i as f64;
            Some(self.at(x)? - other.at(x)?)
        });
        heights.max_by(|h, k| h.abs().total_cmp(&k.abs()))
    }
}
