use super::*;
use crate::cases::shape::{polygon, rectangle};
use crate::engine::registry::engine;
use crate::engine::{Abilities, Answer, EngineError};

/// The rows of a chain of polygons, which needs no worker.
fn rows(engine: &mut dyn Engine, limit: Duration) -> Vec<Row> {
    let square = polygon(&rectangle([0.0, 0.0], [1.0, 1.0]));
    let (a, b) = (square.clone(), square);
    let case = Case { name: "c".into(), family: "f".into(), a, b, seed: None, golden: None };
    let mut worker = Worker::new("none".into(), limit);
    let mut rows = Vec::new();
    chain(&case, engine, &mut worker, (4, limit), &AtomicBool::new(false), &mut |row| rows.push(row)).unwrap();
    rows
}

/// An engine that is off by 2^-20 to the right.
struct Drifting(Box<dyn Engine>);

impl Engine for Drifting {
    fn name(&self) -> &str {
        "drifting"
    }

    fn version(&self) -> String {
        self.0.version()
    }

    fn abilities(&self) -> Abilities {
        self.0.abilities()
    }

    fn sum(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        let answer = self.0.sum(a, b)?;
        let region = crate::cases::place::moved(&answer.region, [libm::scalbn(1.0, -20), 0.0]);
        Ok(Answer { region, ..answer })
    }
}

#[test]
fn exact_sums_of_squares_are_exact() {
    let rows = rows(engine("monotonic").unwrap().as_mut(), Duration::from_secs(60));
    assert_eq!(rows.iter().map(|row| row.depth).collect::<Vec<_>>(), [1, 2, 3, 4]);
    for row in rows {
        assert_eq!((row.status, row.mu_hi, row.reference), (Status::Ok, Some(0.0), "chain"), "{row:?}");
        assert_eq!((row.segments, row.exact_segments), (Some(4), Some(4)));
    }
}

#[test]
fn a_drift_adds_up() {
    let rows = rows(&mut Drifting(engine("monotonic").unwrap()), Duration::from_secs(60));
    // The unit boxes have sides 1, 2, 4, 4.
    let drift = [1.0, 2.0 / 2.0, 3.0 / 4.0, 4.0 / 4.0].map(|steps| steps * libm::scalbn(1.0, -20));
    for (row, drift) in rows.iter().zip(drift) {
        let [lo, hi] = [row.mu_lo.unwrap(), row.mu_hi.unwrap()];
        assert!(lo <= drift && drift <= hi && hi < 1.001 * drift, "{row:?}");
    }
}

#[test]
fn after_the_limit_all_is_undecided() {
    let rows = rows(engine("monotonic").unwrap().as_mut(), Duration::from_nanos(1));
    assert_eq!(rows[0].status, Status::Ok);
    assert!(rows[1..].iter().all(|row| row.status == Status::Undecided && row.note.contains("too costly")), "{rows:?}");
}
