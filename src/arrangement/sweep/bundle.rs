//! Bundles: lines that coincide from a vertex on, merged with their net weight, and the remainders of lines cut there
//! (memo C2).

use super::{Sweep, add};
use crate::arrangement::cross::CrossingModule;
use crate::arrangement::curve::{Curve, compare};

impl<M: CrossingModule> Sweep<'_, M> {
    /// Cuts the lines that go on beyond the vertex; their remainders start there.
    pub(super) fn cut(&mut self, ending: &[u32], vertex: u32, starting: &mut Vec<u32>) {
        for &curve in ending {
            if self.curves[curve as usize].last != vertex {
                let rest = self.curves[curve as usize].from_vertex(vertex, self.now);
                let pieces = self.pieces_of(curve);
                starting.push(self.add_curve(rest));
                self.stand_for(starting[starting.len() - 1], pieces);
                self.vertices.register_end(starting[starting.len() - 1], &rest);
                self.audit.cut += 1;
            }
        }
    }

    fn add_curve(&mut self, curve: Curve) -> u32 {
        self.curve_of[curve.piece as usize] = self.curves.len() as u32;
        self.curves.push(curve);
        self.edge_of.push(u32::MAX);
        self.is_ending.push(false);
        (self.curves.len() - 1) as u32
    }

    /// Merges neighbours among the starting curves that coincide into one of net weight. What cancels disappears.
    pub(super) fn merge(&mut self, starting: &mut Vec<u32>) {
        if !starting.windows(2).any(|pair| self.coincide(pair[0], pair[1])) {
            return;
        }
        let mut kept: Vec<u32> = Vec::with_capacity(starting.len());
        let mut rest = starting.as_slice();
        while let Some(&first) = rest.first() {
            let bundled = 1 + rest.windows(2).take_while(|pair| self.coincide(pair[0], pair[1])).count();
            let (bundle, others) = rest.split_at(bundled);
            rest = others;
            kept.extend(if bundled == 1 { Some(first) } else { self.merge_bundle(bundle) });
        }
        *starting = kept;
    }

    fn coincide(&self, f: u32, g: u32) -> bool {
        let (f, g) = (&self.curves[f as usize], &self.curves[g as usize]);
        if f.last == g.last {
            return f.delta == g.delta && (f.is_line() || (f.left, f.right) == (g.left, g.right));
        }
        let (short, long) = if compare(f.end, g.end).is_lt() { (f, g) } else { (g, f) };
        short.is_line() && long.is_line() && short.is_vertical() == long.is_vertical() && long.side(short.end) == 0.0
    }

    /// Makes a chain of curves that coincide from the current vertex on: one piece from each of their ends to the next, with
    /// the weight of all that reach that far. Returns the first piece; the others start later. So a vertex never has to
    /// merge more than one curve for all that have been merged before.
    fn merge_bundle(&mut self, bundle: &[u32]) -> Option<u32> {
        let mut chain = bundle.to_vec();
        chain.sort_unstable_by(|f, g| compare(self.curves[*f as usize].end, self.curves[*g as usize].end));
        let mut weight = chain.iter().fold([0; 2], |sum, c| add(sum, self.curves[*c as usize].weight));
        let (mut vertex, mut start) = (self.curves[bundle[0] as usize].first, self.now);
        let mut first = None;
        let pieces: Vec<Vec<u32>> = chain.iter().map(|curve| self.pieces_of(*curve)).collect();
        for (index, curve) in chain.into_iter().enumerate() {
            let Curve { last, end, weight: own, .. } = self.curves[curve as usize];
            self.audit.merged += 1;
            if last != vertex && weight != [0; 2] {
                let mut piece = self.curves[curve as usize].from_vertex(vertex, start);
                piece.weight = weight;
                self.curves[curve as usize] = piece;
                self.stand_for(curve, pieces[index..].concat());
                if start == self.now {
                    first = Some(curve);
                } else {
                    self.vertices.register_start(curve, &piece);
                }
            }
            weight = [weight[0] - own[0], weight[1] - own[1]];
            (vertex, start) = (last, end);
        }
        first
    }
}
