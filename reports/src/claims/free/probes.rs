//! How deep the operands overlap at points that an engine takes for free (memo F): certified inradii over mu.

use super::mu::Mu;
use crate::bridge::{plain, unit};
use crate::cases::Case;
use crate::claims::finding::Measured;
use crate::engine::cells::{Cell, cells};
use crate::judge::places::{Place, of_cell};
use arcsum::sum::{Options, Sum, sum};
use arcsum_oracle::certified::depth::{Depths, Summed};
use arcsum_oracle::certified::membership::State;
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::error::{Budget, OracleError};
use arcsum_oracle::polygon;

/// The greatest inradius of the overlap over mu, at points strictly inside of an engine's free cells; at the corners of cells
/// too thin for doubles inside, which are forgiven their rounding. None if the engine has no sum, or the reference no answer.
pub(super) fn deepest(case: &Case, options: &Options, mu: Mu) -> Option<Measured> {
    let answer = sum(&case.a, &case.b, options).ok()?;
    let summed = summed(case).ok()??;
    let depths = Depths::new(&summed).ok()?;
    Some(Probes { depths: &depths, mu: mu.whole() }.over(case, &answer))
}

/// The operands with the boundary of their exact sum; none where it is undecided.
pub(super) fn summed(case: &Case) -> Result<Option<Summed>, OracleError> {
    let (a, b, unit) = (plain(&case.a), plain(&case.b), unit(&case.a, &case.b));
    if case.is_polygonal() {
        return Summed::of_polygons([&a, &b], &polygon::sum(&a, &b)?, unit).map(Some);
    }
    let reference = Reference::new(&a, &b, unit, Budget::default())?;
    Ok((reference.undecided() == 0).then(|| reference.summed().clone()))
}

/// Tests of points against the exact overlap.
pub(super) struct Probes<'d> {
    /// The operands.
    pub(super) depths: &'d Depths<'d>,
    /// What an overlap is measured in.
    pub(super) mu: f64,
}

impl Probes<'_> {
    fn over(&self, case: &Case, answer: &Sum) -> Measured {
        let cells = cells(answer);
        let free = cells.cells.iter().filter(|cell| cell.free);
        let places = |cell: &Cell| {
            let places = of_cell(&cells, cell);
            let thin = cell.inside.is_empty();
            let (places, spots) = if thin { (places.corners, &cell.corners) } else { (places.inside, &cell.inside) };
            places.into_iter().zip(spots.clone()).collect::<Vec<_>>()
        };
        let side = unit(&case.a, &case.b);
        let mut greatest = Measured::exactly(0.0);
        for (place, spot) in free.flat_map(places) {
            let (lo, hi) = self.inradius(&place, greatest.lo);
            let at = [0, 1].map(|i| side * (spot[i] + cells.origin[0][i] + cells.origin[1][i]));
            if lo > greatest.lo {
                greatest.spot = Some(at);
            }
            (greatest.lo, greatest.hi) = (greatest.lo.max(lo), greatest.hi.max(hi));
        }
        greatest
    }

    /// The inradius of the overlap at a place over mu, a bracket; a rough one where it is certainly less than `known`.
    pub(super) fn inradius(&self, place: &Place, known: f64) -> (f64, f64) {
        if self.depths.rough_state(&place.spot) == State::Free {
            return (0.0, 0.0);
        }
        let mu = self.mu + place.off;
        let pd = self.depths.pd(&place.spot);
        // A disc inside both must be moved by its diameter to leave itself.
        let most = 0.5 * pd.hi() / mu;
        if most <= known.max(0.5) {
            return (0.0, most);
        }
        match self.depths.state(&place.spot) {
            State::Free => (0.0, 0.0),
            State::Undecided => (0.0, most),
            State::Blocked => match self.depths.overlap(&place.spot, pd) {
                Ok(overlap) => (overlap.rho.lo() / mu, overlap.rho.hi() / mu),
                Err(_) => (0.0, most),
            },
        }
    }
}
