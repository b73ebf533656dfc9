//! Falsely free points: how deep the regions overlap where an engine says that they do not (memo F, MS 7, 8.3).
//!
//! Tested are the vertices of the result and the middles of its segments, which is MS's choice, and, of engines that show
//! their cells, the points of [`crate::engine::cells`]. Nothing here is decided by a time, so the same case gives the same
//! numbers.
//!
//! Points on a boundary are blocked by a rounding as often as not, and so are points inside cells as thin as that. So a
//! blocked point is *falsely free* only if rho > mu: no perturbation by mu frees it. It is *innocent* if pd <= mu: a
//! translation frees it. What is neither stays open by these tests. A *bubble* is a free cell all of whose points inside
//! (all corners, if it is too thin for points inside) are blocked, as far as can be told, and not innocent, a *crack* a free cell with some such
//! points inside but not all. The other way round there is nothing to forgive: *falsely blocked* is every point inside a
//! blocked cell that is free; mu bounds how far from the sum it is.
//!
//! mu is the upper bound of the error of the result, to which is added how far a rounding may have moved the point.

use super::places::{Place, of_cell, of_result};
use crate::engine::Answer;
use crate::engine::cells::{Cell, Cells};
use crate::row::number;
use arcsum_oracle::certified::depth::Depths;
use arcsum_oracle::certified::membership::State;
use arcsum_oracle::certified::spot::Spot;
use arcsum_oracle::error::OracleError;
use arcsum_oracle::interval::Interval;
use serde::{Deserialize, Serialize};

/// Points nearer to the boundary of the sum than this are taken for contacts without asking further.
const CONTACT: f64 = 1.0 / (1u128 << 80) as f64;

/// Deepest points of which the overlap is measured even if they are innocent, for the sake of their trapezoid number.
const DEEPEST: usize = 4;

/// Overlaps measured in a case, times the segments of both operands.
const EFFORT: usize = 20_000;

/// No more overlaps are measured than this, and no fewer than [`DEEPEST`].
const MOST_OVERLAPS: usize = 200;

/// A certified bracket of the greatest of some lengths, in unit-box lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Greatest {
    /// The lower bound.
    #[serde(default, with = "number")]
    pub lo: Option<f64>,
    /// The upper bound.
    #[serde(default, with = "number")]
    pub hi: Option<f64>,
}

/// What was found at the tested points.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Findings {
    /// The greatest inradius of the overlap; 0 if no tested point is blocked.
    pub rho: Greatest,
    /// The greatest penetration depth.
    pub pd: Greatest,
    /// The greatest trapezoid number among the overlaps that were measured, in unit-box lengths.
    #[serde(default, with = "number")]
    pub trap: Option<f64>,
    /// Points that should be free.
    pub tested: u64,
    /// Of these, blocked ones with rho > mu,
    pub falsely_free: u64,
    /// ones that are blocked with pd <= mu or that near to the sum,
    pub innocent: u64,
    /// and ones that may be blocked, with neither shown.
    pub open: u64,
    /// Bubbles; none if the engine does not show its cells.
    pub bubbles: Option<u64>,
    /// Cracks, likewise.
    pub cracks: Option<u64>,
    /// Points inside blocked cells that are free, likewise.
    pub falsely_blocked: Option<u64>,
    /// Trapezoids of cells, vertices and middles that were left out, because there are many.
    pub left_out: u64,
}

/// A point that should be free and may be blocked.
struct Suspect {
    spot: Spot,
    pd: Interval,
    /// A depth that is forgiven: mu and the rounding of the point.
    mu: f64,
    /// Whether it certainly is, or certainly is not, as far as anybody asked.
    blocked: Option<bool>,
}

/// The tests of one answer.
struct Tests<'a> {
    depths: &'a Depths<'a>,
    mu: f64,
    suspects: Vec<Suspect>,
    tested: u64,
    /// The depth of contacts at most.
    contact: f64,
}

/// Tests an answer of error at most `mu`, given the side of the unit box and the segments of both operands.
pub(super) fn test(
    depths: &Depths<'_>,
    answer: &Answer,
    mu: f64,
    unit: f64,
    segments: usize,
) -> Result<Findings, OracleError> {
    let mut tests = Tests { depths, mu, suspects: Vec::new(), tested: 0, contact: 0.0 };
    let mut findings = Findings::default();
    if let Some(cells) = &answer.cells {
        tests.cells(cells, &mut findings);
    }
    let (places, mut left_out) = of_result(&answer.region, unit);
    for place in places {
        tests.is_guilty(place);
    }
    left_out += answer.cells.as_ref().map_or(0, |cells| cells.left_out);
    findings.left_out = left_out;
    tests.measure(&mut findings, segments)?;
    Ok(findings)
}

impl Tests<'_> {
    fn cells(&mut self, cells: &Cells, findings: &mut Findings) {
        let [mut bubbles, mut cracks, mut falsely_blocked] = [0, 0, 0];
        for cell in &cells.cells {
            if cell.free {
                let (guilty, all) = self.free_cell(cells, cell);
                bubbles += u64::from(all > 0 && guilty == all);
                cracks += u64::from(guilty > 0 && guilty < all);
            } else {
                let free = |place: &Place| self.depths.state(&place.spot) == State::Free;
                falsely_blocked += of_cell(cells, cell).inside.iter().filter(|place| free(place)).count() as u64;
            }
        }
        findings.bubbles = Some(bubbles);
        findings.cracks = Some(cracks);
        findings.falsely_blocked = Some(falsely_blocked);
    }

    /// How many of the points that stand for a free cell are blocked and not innocent, and how many there are.
    fn free_cell(&mut self, cells: &Cells, cell: &Cell) -> (usize, usize) {
        let places = of_cell(cells, cell);
        let [inside, corners] = [places.inside, places.corners]
            .map(|places| places.into_iter().filter(|p| self.is_guilty(p.clone())).count());
        if cell.inside.is_empty() { (corners, cell.corners.len()) } else { (inside, cell.inside.len()) }
    }

    /// Whether a point that should be free is blocked and not innocent. What may be blocked becomes a suspect.
    fn is_guilty(&mut self, place: Place) -> bool {
        self.tested += 1;
        let rough = self.depths.rough_state(&place.spot);
        if rough == State::Free {
            return false;
        }
        let pd = self.depths.pd(&place.spot);
        if pd.hi() < CONTACT {
            self.contact = self.contact.max(pd.hi());
            return false;
        }
        let mu = (self.mu + place.off).next_up();
        let mut suspect = Suspect { spot: place.spot, pd, mu, blocked: (rough == State::Blocked).then_some(true) };
        // Of what is innocent if it is blocked, few matter: the others need not be told from free points.
        let guilty = pd.hi() > mu && suspect.is_blocked(self.depths) != Some(false);
        if suspect.blocked != Some(false) {
            self.suspects.push(suspect);
        }
        guilty
    }

    /// Measures the suspects, the deepest first: as 2 rho <= pd, the others soon do not matter.
    fn measure(mut self, findings: &mut Findings, segments: usize) -> Result<(), OracleError> {
        self.suspects.sort_by(|a, b| b.pd.hi().total_cmp(&a.pd.hi()));
        let most = (EFFORT / segments.max(1)).clamp(DEEPEST, MOST_OVERLAPS);
        let (mut rho, mut pd, mut trap) = ((0.0_f64, half(self.contact)), (0.0_f64, self.contact), 0.0_f64);
        let mut measured = 0;
        for mut suspect in self.suspects {
            let deepest = half(suspect.pd.hi());
            let matters = measured < DEEPEST || deepest > suspect.mu;
            let mut known = Interval::new(0.0, deepest);
            if (matters || suspect.pd.hi() > pd.0) && suspect.is_blocked(self.depths) == Some(true) {
                pd.0 = pd.0.max(suspect.pd.lo());
                if matters && measured < most {
                    let overlap = self.depths.overlap(&suspect.spot, suspect.pd)?;
                    (known, trap) = (overlap.rho, trap.max(overlap.trap));
                    measured += 1;
                }
            }
            if suspect.blocked != Some(false) {
                pd.1 = pd.1.max(suspect.pd.hi());
                rho = (rho.0.max(known.lo()), rho.1.max(known.hi()));
                *suspect.verdict(known, findings) += 1;
            }
        }
        findings.tested = self.tested;
        (findings.rho, findings.pd, findings.trap) = (Greatest::from(rho), Greatest::from(pd), Some(trap));
        Ok(())
    }
}

impl Suspect {
    /// Whether the point certainly is blocked, or certainly free.
    fn is_blocked(&mut self, depths: &Depths<'_>) -> Option<bool> {
        if self.blocked.is_none() {
            self.blocked = match depths.state(&self.spot) {
                State::Blocked => Some(true),
                State::Free => Some(false),
                State::Undecided => None,
            };
        }
        self.blocked
    }

    /// The count that a point of this inradius belongs to.
    fn verdict<'a>(&self, rho: Interval, findings: &'a mut Findings) -> &'a mut u64 {
        if rho.lo() > self.mu {
            &mut findings.falsely_free
        } else if self.pd.hi() <= self.mu {
            &mut findings.innocent
        } else {
            &mut findings.open
        }
    }
}

impl From<(f64, f64)> for Greatest {
    fn from((lo, hi): (f64, f64)) -> Self {
        Self { lo: Some(lo), hi: Some(hi) }
    }
}

/// What half of a depth is at most.
fn half(depth: f64) -> f64 {
    if depth == 0.0 { 0.0 } else { (0.5 * depth).next_up() }
}

#[cfg(test)]
#[path = "free_tests.rs"]
mod tests;
