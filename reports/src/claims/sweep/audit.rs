//! What an arrangement is against what its crossing module says and what the curves are (memo C4): the counters of the
//! claims, and the perturbation by the oracle.

use arcsum::arrangement::Arrangement;
use arcsum::arrangement::cross::{CrossingModule, Crossings};
use arcsum::arrangement::curve::{Curve, compare};
use arcsum::arrangement::moment::Moment;
use arcsum::piece::Pieces;
use arcsum_oracle::perturbation::{Gap, Greatest, of_order, of_vertices};
use arcsum_oracle::strand::Strand;

/// The most that a sweep over n curves does for a vertex, in questions to the module and events: a search through a tree whose
/// expected depth is 2 ln n, with three questions a level where curves are too close to tell, and a handful of neighbours
/// looked at, whose crossings are queued. From the algorithm (memo C2), not from measurements.
pub(in crate::claims) fn steps(curves: f64) -> f64 {
    6.0 * libm::log(curves) + 8.0
}

/// What the module says about all pairs of curves of a set.
pub(super) struct Told {
    curves: Vec<Curve>,
    /// By pairs: the answers for those whose parts of the sweep overlap.
    answers: Vec<Option<Crossings>>,
}

impl Told {
    /// Asks about all pairs.
    pub(super) fn new<M: CrossingModule>(pieces: &Pieces, module: &M) -> Self {
        let curves = curves(pieces);
        let n = curves.len();
        let mut answers = vec![None; n * n];
        for j in 0..n {
            for i in 0..j {
                let (f, g) = (&curves[i], &curves[j]);
                if compare(f.start, g.end).is_lt() && compare(g.start, f.end).is_lt() {
                    answers[i * n + j] = Some(module.cross(f, g));
                }
            }
        }
        Self { curves, answers }
    }

    /// The number of curves, n of the claims.
    pub(super) fn curves(&self) -> usize {
        self.curves.len()
    }

    /// The crossings, N of the claims.
    pub(super) fn crossings(&self) -> usize {
        self.answers.iter().flatten().map(|answer| answer.points().len()).sum()
    }

    /// The triples of curves in cyclic order for some part of the sweep, k of the claims: over some abscissas, or over some
    /// ordinates of one, which the sweep passes upwards.
    pub(super) fn cyclic(&self) -> usize {
        let n = self.curves.len();
        let mut cyclic = 0;
        for j in 0..n {
            for i in 0..j {
                if self.answers[i * n + j].is_some() {
                    cyclic += (0..i).filter(|&h| self.is_cyclic([h, i, j])).count();
                }
            }
        }
        cyclic
    }

    fn is_cyclic(&self, triple: [usize; 3]) -> bool {
        let n = self.curves.len();
        let [h, i, j] = triple;
        let [Some(hi), Some(ij), Some(hj)] = [(h, i), (i, j), (h, j)].map(|(f, g)| self.answers[f * n + g]) else {
            return false;
        };
        let [from, to] = self.common(triple);
        let during = |moment: &Moment| from.compare(moment).is_lt() && moment.compare(&to).is_lt();
        let changes = [&hi, &ij, &hj].into_iter().flat_map(|answer| answer.points()).copied();
        let mut moments: Vec<Moment> = changes.filter(during).chain([from, to]).collect();
        moments.sort_by(Moment::compare);
        // Between neighbours there may be no double: what has happened up to the first holds until the second.
        moments.windows(2).any(|ends| {
            let passed = |crossing: &&Moment| crossing.compare(&ends[0]).is_le();
            let below = |answer: &Crossings| answer.below ^ (answer.points().iter().filter(passed).count() == 1);
            ends[0].compare(&ends[1]).is_lt() && below(&hi) == below(&ij) && below(&hi) != below(&hj)
        })
    }

    /// When three curves begin to be all there, and when they end to be.
    fn common(&self, triple: [usize; 3]) -> [Moment; 2] {
        let curves = triple.map(|curve| &self.curves[curve]);
        let [starts, ends] = [curves.map(|curve| curve.start), curves.map(|curve| curve.end)];
        [
            starts.map(Moment::from).into_iter().reduce(Moment::max),
            ends.map(Moment::from).into_iter().reduce(Moment::min),
        ]
        .map(|moment| moment.expect("three curves"))
    }
}

/// The curves of some pieces, equal ends one vertex.
fn curves(pieces: &Pieces) -> Vec<Curve> {
    let mut points = pieces.points.clone();
    points.sort_by(|p, q| compare(*p, *q));
    points.dedup();
    let end = |v: u32| {
        let p = pieces.points[v as usize];
        (points.partition_point(|q| compare(*q, p).is_lt()) as u32, p)
    };
    let curve = |(index, piece): (usize, &arcsum::piece::Piece)| {
        let whole = piece.whole.map(|v| pieces.points[v as usize]);
        Curve::new(index as u32, piece, end(piece.tail), end(piece.head), whole)
    };
    pieces.pieces.iter().enumerate().filter_map(curve).collect()
}

/// The perturbation of the order of an arrangement, the first `clear` of each curve left out.
pub(super) fn order(map: &Arrangement, clear: f64) -> Greatest {
    let gap = |t: &arcsum::arrangement::trapezoid::Trapezoid| Gap {
        from: t.from,
        to: t.to,
        bottom: t.bottom as usize,
        top: t.top as usize,
    };
    let gaps: Vec<Gap> = map.trapezoids.iter().map(gap).collect();
    of_order(&strands(map), &gaps, clear)
}

/// The distance of its vertices from their curves.
pub(super) fn vertices(map: &Arrangement) -> Greatest {
    let graph = &map.graph;
    let places = graph
        .edges
        .iter()
        .flat_map(|edge| [edge.from, edge.to].map(|v| (edge.curve as usize, graph.points[v as usize].to_array())));
    of_vertices(&strands(map), places)
}

/// The greater of both.
pub(in crate::claims) fn perturbation(map: &Arrangement) -> Greatest {
    order(map, 0.0).or(vertices(map))
}

fn strands(map: &Arrangement) -> Vec<Strand> {
    let curve = |c: &Curve| Strand::new(c.left.to_array(), c.right.to_array(), c.delta);
    map.graph.curves.iter().map(curve).collect()
}

#[cfg(test)]
mod tests {
    use super::super::liar::{Liar, Lie};
    use super::*;
    use arcsum::angle::Ang;
    use arcsum::arrangement::arrange_with;
    use arcsum::arrangement::cross::{EPS, FloatModule};
    use arcsum::piece::{Piece, Source};
    use glam::DVec2;

    fn lines(ends: &[[f64; 4]]) -> Pieces {
        let mut pieces = Pieces::default();
        for &[x0, y0, x1, y1] in ends {
            let tail = pieces.points.len() as u32;
            let (from, to) = (DVec2::new(x0, y0), DVec2::new(x1, y1));
            pieces.points.extend([from, to]);
            let normal = Ang::of_line(from, to).unwrap();
            pieces.pieces.push(Piece::line(tail, tail + 1, normal, Source::default()));
        }
        pieces
    }

    #[test]
    fn honest_crossings_are_counted_and_nothing_is_cyclic() {
        let pieces = lines(&[[0.0, 0.0, 1.0, 1.0], [0.0, 1.0, 1.0, 0.0], [0.0, 0.25, 1.0, 0.25], [2.0, 0.0, 3.0, 0.0]]);
        let told = Told::new(&pieces, &FloatModule::new(1.0));
        assert_eq!((told.curves(), told.crossings(), told.cyclic()), (4, 3, 0));
        let off = perturbation(&arrange_with(&pieces, &FloatModule::new(1.0)));
        assert!(off.hi <= EPS, "{off:?}");
    }

    /// Stairs down, each line said to be above the one before: three of them are a cycle, and so are no other three of four.
    #[test]
    fn stairs_are_cyclic_and_out_of_order() {
        let step = 16.0 * EPS;
        let stair = |i: f64| [1e-3 * i, 0.1 - i * 0.9 * step, 1.0, 0.1 - i * 0.9 * step];
        let three = lines(&[stair(0.0), stair(1.0), stair(2.0)]);
        let module = Liar::new(Lie::Stairs, 1.0, step, 0);
        assert_eq!(Told::new(&three, &module).cyclic(), 1);
        let off = perturbation(&arrange_with(&three, &module));
        assert!(off.lo >= 0.45 * step, "{off:?}");
        let four = lines(&[stair(0.0), stair(1.0), stair(2.0), stair(3.0)]);
        assert_eq!(Told::new(&four, &module).cyclic(), 2);
    }
    /// Of lines 0, 1 and 2 each is below the next, and 2 below 0 until the sweep has passed (0, 3).
    struct Upright;

    impl CrossingModule for Upright {
        fn cross(&self, f: &Curve, g: &Curve) -> Crossings {
            let (low, high) = (f.piece.min(g.piece), f.piece.max(g.piece));
            if (low, high) == (0, 2) {
                Crossings::at(f.piece > g.piece, &[Moment::from(DVec2::new(0.0, 3.0))])
            } else {
                Crossings::none(f.piece < g.piece)
            }
        }

        fn above(&self, p: DVec2, curve: &Curve) -> f64 {
            p.y - curve.y_at(p.x)
        }

        fn tolerance(&self) -> f64 {
            EPS
        }
    }

    /// All of it happens at one abscissa.
    #[test]
    fn a_triple_may_be_cyclic_while_the_sweep_goes_up() {
        let pieces = lines(&[[0.0, 0.0, 1.0, 0.0], [0.0, 1.0, 1.0, 1.0], [0.0, 2.0, 1.0, 2.0]]);
        assert_eq!(Told::new(&pieces, &Upright).cyclic(), 1);
        let later = lines(&[[0.0, 0.0, 1.0, 0.0], [0.0, 1.0, 1.0, 1.0], [0.5, 2.0, 1.0, 2.0]]);
        assert_eq!(Told::new(&later, &Upright).cyclic(), 0);
    }
}
