//! What a curve stands for: the pieces that coincide in it, about each of which something may be known (MS 7.1).
//!
//! Merged curves go on under the name of one of them. What the order of a convolution says of the others holds for it, too;
//! without that, a crossing that is refused for one of two coinciding pieces happens because of the other, and leaves a cell
//! that is falsely free.

use super::Sweep;
use crate::arrangement::cross::CrossingModule;
use crate::arrangement::curve::Curve;
use crate::arrangement::known::Known;
use rustc_hash::FxHashMap as HashMap;

/// The pieces of merged curves; what is not merged has no entry.
#[derive(Debug, Default)]
pub(super) struct Guises {
    /// For a merged curve, all pieces that it stands for.
    pieces: HashMap<u32, Vec<u32>>,
    /// For a piece, the curves that stand for it besides its own.
    curves: HashMap<u32, Vec<u32>>,
    /// Whether a curve stands for more than one piece; later curves do not.
    is_merged: Vec<bool>,
}

impl Guises {
    /// Whether nothing has been merged so far.
    pub(super) fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// The curve stands for these pieces from now on, of which one is its own.
    fn stand(&mut self, curve: u32, own: u32, pieces: Vec<u32>) {
        for piece in pieces.iter().filter(|piece| **piece != own) {
            self.curves.entry(*piece).or_default().push(curve);
        }
        self.pieces.insert(curve, pieces);
        if self.is_merged.len() <= curve as usize {
            self.is_merged.resize(curve as usize + 1, false);
        }
        self.is_merged[curve as usize] = true;
    }

    /// Whether a curve is one piece.
    fn is_one(&self, curve: u32) -> bool {
        !self.is_merged.get(curve as usize).is_some_and(|is_merged| *is_merged)
    }
}

impl<M: CrossingModule> Sweep<'_, M> {
    /// The pieces that a curve stands for.
    pub(super) fn pieces_of(&self, curve: u32) -> Vec<u32> {
        self.guises.pieces.get(&curve).cloned().unwrap_or_else(|| vec![self.curves[curve as usize].piece])
    }

    /// Adds the pieces about whose order with what a curve stands for something may be known at the current abscissa.
    pub(super) fn related_pieces(&self, curve: u32, found: &mut Vec<u32>) {
        let own = [self.curves[curve as usize].piece];
        let all = self.guises.pieces.get(&curve).map_or(&own[..], Vec::as_slice);
        all.iter().for_each(|piece| self.module.related(*piece, self.now.x, found));
    }

    /// A curve stands for these pieces, too.
    pub(super) fn stand_for(&mut self, curve: u32, pieces: Vec<u32>) {
        if pieces.len() > 1 {
            self.guises.stand(curve, self.curves[curve as usize].piece, pieces);
        }
    }

    /// The curves that may be active for a piece: that which it is or was last, and those it was merged into.
    pub(super) fn curves_of(&self, piece: u32) -> impl Iterator<Item = u32> {
        let merged = self.guises.curves.get(&piece).into_iter().flatten().copied();
        std::iter::once(self.curve_of[piece as usize]).chain(merged)
    }

    /// A curve as each of the pieces that it stands for.
    fn guises_of(&self, curve: u32) -> impl Iterator<Item = Curve> {
        let (itself, others) = (self.curves[curve as usize], self.guises.pieces.get(&curve));
        let others = others.into_iter().flatten().filter(move |piece| **piece != itself.piece);
        std::iter::once(itself).chain(others.map(move |&piece| itself.named(piece)))
    }

    fn in_guises(&self, f: u32, g: u32) -> impl Iterator<Item = [Curve; 2]> {
        self.guises_of(f).flat_map(move |f| self.guises_of(g).map(move |g| [f, g]))
    }

    /// Two curves of which each is one piece, as most are.
    fn as_they_are(&self, f: u32, g: u32) -> Option<[&Curve; 2]> {
        let are_one = self.guises.is_one(f) && self.guises.is_one(g);
        are_one.then(|| [&self.curves[f as usize], &self.curves[g as usize]])
    }

    /// [`CrossingModule::agrees`] of all that two curves stand for.
    pub(super) fn all_agree(&self, below: bool, f: u32, g: u32) -> bool {
        match self.as_they_are(f, g) {
            Some([f, g]) => self.module.agrees(below, f, g),
            None => self.in_guises(f, g).all(|[f, g]| self.module.agrees(below, &f, &g)),
        }
    }

    /// [`CrossingModule::known`] of all that two curves stand for.
    pub(super) fn all_known(&self, f: u32, g: u32, x: f64) -> Known {
        match self.as_they_are(f, g) {
            Some([f, g]) => self.module.known(f, g, x),
            None => {
                let all = self.in_guises(f, g).map(|[f, g]| self.module.known(&f, &g, x));
                all.fold(Known::NOTHING, Known::and)
            }
        }
    }

    /// [`CrossingModule::placed`] of the first of what two curves stand for about which it says something.
    pub(super) fn any_placed(&self, f: u32, g: u32) -> Option<bool> {
        match self.as_they_are(f, g) {
            Some([f, g]) => self.module.placed(f, g, self.now.x),
            None => self.in_guises(f, g).find_map(|[f, g]| self.module.placed(&f, &g, self.now.x)),
        }
    }
}
