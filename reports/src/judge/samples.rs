//! Certified samples of a result whose exact sum is too large to be computed ([`arcsum_oracle::sampled`]).
//!
//! An equal number of samples each: places of the result's boundary by length, some at vertices; points at random in and around
//! the result; points beside its boundary at distances 2^-k; places of the sum's boundary between random points; and for
//! polygons vertices of the sum in random directions. What they certify holds at the samples, not between them, so this is
//! neither a bracket of `mu` nor an `ok`.

use crate::bridge::{plain, unit};
use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::engine::Answer;
use crate::row::{Status, number};
use arcsum_oracle::error::OracleError;
use arcsum_oracle::sampled::{Regions, Sample, Sampler};
use serde::{Deserialize, Serialize};

use super::Judgement;
use super::why::WANTED_BITS;

/// Samples unless told otherwise.
pub const DEFAULT: u32 = 200;

/// When results are sampled, and how often.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Sampling {
    /// Samples of each of the two directions.
    pub count: u32,
    /// Whether all cases are sampled, and not only those beyond the limits of the reference.
    pub all: bool,
}

/// What the samples of a result say, in unit-box lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Sampled {
    /// Places and points that were looked at.
    pub samples: u64,
    /// Of these, places without a certificate of 2^-45, and places and points that prove an error above that.
    pub failed: u64,
    /// Of these, points that could not be decided: contacts.
    pub undecided: u64,
    /// The boundaries of result and sum are within this at every place with a certificate.
    pub near: f64,
    /// Certified lower bound of the region Hausdorff distance, if an error is proved.
    #[serde(default, with = "number")]
    pub far: Option<f64>,
    /// Where that is attained, in input units.
    pub worst: Option<[f64; 2]>,
}

/// What a sample is expected to bring.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// A certificate, because it is on one of the boundaries.
    Place,
    /// Agreement only.
    Point,
}

/// Judges the answer to a case by samples.
pub(super) fn judge(case: &Case, answer: &Answer, count: u32) -> Judgement {
    match sampled(case, answer, count) {
        Err(error) => Judgement::undecided(error.to_string()),
        Ok(sampled) => {
            let failed = sampled.far.is_some_and(|far| far > allowed());
            Judgement {
                status: Status::Sampled,
                witness: sampled.worst,
                failed_checks: if failed { vec!["samples".into()] } else { Vec::new() },
                sampled: Some(sampled),
                ..Judgement::undecided(sentence(&sampled))
            }
        }
    }
}

/// An error above this counts as a failure: bits below that fall short elsewhere, too.
fn allowed() -> f64 {
    (-WANTED_BITS).exp2()
}

fn sentence(found: &Sampled) -> String {
    let Sampled { samples, failed, undecided, near, far, .. } = *found;
    let mut text = format!("{samples} samples within {near:.1e}");
    if undecided > 0 {
        text.push_str(&format!(", {undecided} undecided"));
    }
    if failed > 0 {
        text.push_str(&format!(", {failed} failed"));
    }
    if let Some(far) = far {
        text.push_str(&format!("; the error is at least {far:.1e}"));
    }
    text
}

/// Takes the samples of an answer.
///
/// # Errors
/// When a region is none, or its numbers do not fit the unit box.
pub fn sampled(case: &Case, answer: &Answer, count: u32) -> Result<Sampled, OracleError> {
    let operands = [plain(&case.a), plain(&case.b)];
    let regions = Regions::new([&operands[0], &operands[1]], &plain(&answer.region), unit(&case.a, &case.b))?;
    let sampler = Sampler::new(&regions)?;
    let mut rng = Rng::new(case.seed.unwrap_or(0), &format!("samples of {}", case.name));
    let mut found = Sampled::default();
    for index in 0..count {
        if regions.sides() > 0 {
            // Every fourth one is at a vertex.
            let share = if index % 4 == 0 { 0.0 } else { rng.between(0.01, 0.99) };
            let side = regions.side_at(rng.unit());
            found.enter(&sampler.boundary(side, share)?, Kind::Place);
            let (side, share) = (regions.side_at(rng.unit()), rng.between(0.01, 0.99));
            let exponent = -(3 + rng.below(44) as i32);
            found.enter(&sampler.beside(side, share, index % 2 == 0, exponent)?, Kind::Point);
        }
        let ends = [[rng.unit(), rng.unit()], [rng.unit(), rng.unit()]];
        found.enter(&sampler.point(ends[0])?, Kind::Point);
        if let Some(sample) = sampler.between(ends[0], ends[1])? {
            found.enter(&sample, Kind::Place);
        }
        let angle = rng.angle();
        if let Some(sample) = sampler.extreme([libm::cos(angle), libm::sin(angle)]) {
            found.enter(&sample, Kind::Place);
        }
    }
    Ok(found)
}

impl Sampled {
    fn enter(&mut self, sample: &Sample, kind: Kind) {
        let certified = kind == Kind::Point || sample.near.is_some_and(|near| near <= allowed());
        let fails = !certified || sample.far > allowed();
        self.samples += 1;
        self.failed += u64::from(fails);
        self.undecided += u64::from(sample.undecided && !fails);
        self.near = self.near.max(sample.near.unwrap_or(0.0));
        if sample.far > self.far.unwrap_or(0.0) {
            (self.far, self.worst) = (Some(sample.far), Some(sample.place));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::family;
    use crate::cases::shape::{disc, polygon, rectangle, region};
    use crate::engine::registry::engine;
    use arcsum::region::{Node, Region};

    fn case(a: Region, b: Region) -> Case {
        Case { name: "samples".into(), family: "test".into(), a, b, seed: Some(1), golden: None }
    }

    fn frame() -> Case {
        let hole: Vec<Node> = polygon(&rectangle([4.0, 4.0], [8.0, 8.0])).loops[0].iter().rev().copied().collect();
        let plate = region(vec![polygon(&rectangle([0.0, 0.0], [12.0, 12.0])).loops[0].clone(), hole]);
        case(plate, polygon(&rectangle([0.0, 0.0], [1.0, 2.0])))
    }

    fn answer(case: &Case) -> Answer {
        engine("monotonic").unwrap().sum(&case.a, &case.b).unwrap()
    }

    fn of(case: &Case, region: Region) -> Sampled {
        sampled(case, &Answer { region, ..Answer::default() }, 60).unwrap()
    }

    fn far(found: &Sampled) -> f64 {
        found.far.unwrap_or(0.0)
    }

    #[test]
    fn good_sums_are_certified_at_every_sample() {
        let stars = family::Family::named("star").unwrap().cases_of_size(6, 1).remove(0);
        for case in [frame(), case(polygon(&rectangle([0.0, 0.0], [3.0, 1.0])), disc(1.5)), stars] {
            let found = of(&case, answer(&case).region);
            assert!(found.samples > 180 && found.failed == 0, "{found:?}");
            assert!(found.near < 1e-15 && far(&found) < 1e-15, "{found:?}");
        }
    }

    /// Moved by 2^-30 of the unit box, which is 16.
    #[test]
    fn a_moved_vertex_is_found() {
        let case = frame();
        let by = libm::scalbn(1.0, -30);
        let mut proved = 0;
        for (ring, vertex, way) in [(0, 0, 1.0), (0, 0, -1.0), (0, 2, 1.0), (1, 1, -1.0)] {
            let mut region = answer(&case).region;
            region.loops[ring][vertex].x += way * 16.0 * by;
            let found = of(&case, region);
            assert!(found.failed > 0 && found.near > by / 16.0 && far(&found) <= by, "{found:?}");
            proved += usize::from(far(&found) > by / 16.0);
        }
        // At one of the vertices the result only grows near short edges, which few samples see.
        assert!(proved >= 2, "{proved}");
    }

    #[test]
    fn a_hole_that_is_missing_is_found() {
        let case = frame();
        let mut region = answer(&case).region;
        region.loops.retain(|ring| ring.iter().any(|node| node.x < 1.0));
        let found = sampled(&case, &Answer { region, ..Answer::default() }, 300).unwrap();
        // The hole of the sum is 3 by 2, so its middle is 1 of 16 off.
        assert!(found.failed > 0 && far(&found) > 0.01 && far(&found) <= 1.0 / 16.0, "{found:?}");
        assert!(found.near > 1.0 / 16.0, "{found:?}");
    }

    #[test]
    fn a_wrong_loop_is_found() {
        let case = frame();
        let square = |low, high| polygon(&rectangle(low, high)).loops[0].clone();
        let island = square([20.0, 5.0], [21.0, 6.0]);
        let hole = square([9.0, 9.5], [11.0, 11.0]).into_iter().rev().collect();
        for extra in [island, hole] {
            let mut region = answer(&case).region;
            region.loops.push(extra);
            let found = of(&case, region);
            assert!(found.failed > 0 && far(&found) > 0.001, "{found:?}");
        }
    }

    #[test]
    fn nothing_and_everything_are_no_sums() {
        let case = frame();
        let nothing = of(&case, Region::default());
        assert!(nothing.failed > 0 && nothing.far == Some(f64::INFINITY), "{nothing:?}");
        assert!(judge(&case, &answer(&case), 20).failed_checks.is_empty());
    }
}
