//! The record of a job: what the engine and the reference said, put into the columns of a row.

use super::plan::Plan;
use crate::cases::Case;
use crate::engine::Answer;
use crate::engine::registry::Facts;
use crate::judge::Judgement;
use crate::row::{Record, Row, Status};
use crate::worker::Outcome;
use std::time::Duration;

/// A record keeps no more segments of the convolution: a picture of more shows nothing, and files stay small.
const MOST_CONVOLUTION: usize = 20_000;
/// A record keeps no larger result.
const MOST_RESULT: usize = 100_000;

/// The record of the job with this index.
#[must_use]
pub fn assemble(plan: &Plan, job: usize, outcome: Outcome) -> Record {
    let (case, engine) = (&plan.cases[plan.jobs[job].case], &plan.engines[plan.jobs[job].engine]);
    let mut row = blank(case, engine);
    if let Some(answer) = &outcome.answer {
        enter_answer(&mut row, answer);
    }
    if let Some(judgement) = &outcome.judgement {
        enter_judgement(&mut row, judgement);
    }
    if let Some((status, note)) = outcome.failure {
        (row.status, row.note) = (status, note);
    }
    let answer = outcome.answer.unwrap_or_default();
    let kept = row.result_segments.is_some_and(|n| n <= MOST_RESULT as u64);
    let drawn = answer.convolution.len() <= MOST_CONVOLUTION;
    Record {
        row,
        a: case.a.clone(),
        b: case.b.clone(),
        result: kept.then_some(answer.region),
        convolution: if drawn { answer.convolution } else { Vec::new() },
    }
}

fn enter_answer(row: &mut Row, answer: &Answer) {
    let milliseconds = |t: Option<Duration>| t.map(|t| t.as_secs_f64() * 1e3);
    let c = &answer.counters;
    row.sums = c.sums;
    row.vertices = c.vertices;
    row.crossings = c.crossings;
    row.k = c.k;
    row.late = c.late;
    row.gather = c.gather;
    row.cancelled = c.cancelled;
    row.order_conflict = c.order_conflict;
    row.cells = c.cells;
    row.result_segments = Some(answer.region.segments() as u64);
    row.result_loops = Some(answer.region.loops.len() as u64);
    row.failed_checks = answer.failed_checks.as_deref().map(words);
    row.t_convolution = milliseconds(answer.times.convolution);
    row.t_arrangement = milliseconds(answer.times.arrangement);
    row.t_extraction = milliseconds(answer.times.extraction);
}

fn enter_judgement(row: &mut Row, judgement: &Judgement) {
    row.status = judgement.status;
    (row.mu_lo, row.mu_hi) = (judgement.mu_lo, judgement.mu_hi);
    let [lo, hi] = judgement.mu_realized.map_or([None; 2], |[lo, hi]| [Some(lo), Some(hi)]);
    (row.mu_realized_lo, row.mu_realized_hi) = (lo, hi);
    row.bits = row.mu_hi.map(|mu| -mu.log2());
    row.direction = judgement.direction.clone();
    row.worst_x = judgement.witness.map(|w| w[0]);
    row.worst_y = judgement.witness.map(|w| w[1]);
    row.exact_loops = judgement.exact_loops;
    row.exact_bits = judgement.exact_bits;
    if let Some(free) = &judgement.free {
        (row.rho_lo, row.rho_hi) = (free.rho.lo, free.rho.hi);
        (row.pd_lo, row.pd_hi, row.trap) = (free.pd.lo, free.pd.hi, free.trap);
        (row.tested, row.left_out) = (Some(free.tested), Some(free.left_out));
        (row.falsely_free, row.innocent, row.open) = (Some(free.falsely_free), Some(free.innocent), Some(free.open));
        row.falsely_blocked = free.falsely_blocked;
        (row.bubbles, row.cracks) = (free.bubbles, free.cracks);
    }
    let separation = judgement.separation.unwrap_or_default();
    (row.separation_lo, row.separation_hi) = (separation.lo, separation.hi);
    if let Some(sampled) = &judgement.sampled {
        (row.samples, row.samples_failed) = (Some(sampled.samples), Some(sampled.failed));
        (row.sampled_mu, row.sampled_lo) = (Some(sampled.near), sampled.far);
    }
    row.note = judgement.note.clone();
    let engines = row.failed_checks.take().filter(|w| w != "none");
    let own = engines.as_deref().unwrap_or_default().split_whitespace().map(str::to_owned);
    let all: Vec<String> = own.chain(judgement.failed_checks.iter().cloned()).collect();
    row.failed_checks = Some(words(&all));
}

/// Names separated by spaces, `none` for none.
fn words(names: &[String]) -> String {
    if names.is_empty() { "none".into() } else { names.join(" ") }
}

/// The row of a case before anything is known about it.
fn blank(case: &Case, engine: &Facts) -> Row {
    Row {
        case: case.name.clone(),
        family: case.family.clone(),
        engine: engine.name.clone(),
        engine_version: engine.version.clone(),
        status: Status::Undecided,
        seed: case.seed,
        mu_lo: None,
        mu_hi: None,
        bits: None,
        direction: None,
        worst_x: None,
        worst_y: None,
        mu_realized_lo: None,
        mu_realized_hi: None,
        rho_lo: None,
        rho_hi: None,
        pd_lo: None,
        pd_hi: None,
        trap: None,
        tested: None,
        left_out: None,
        falsely_free: None,
        innocent: None,
        open: None,
        falsely_blocked: None,
        separation_lo: None,
        separation_hi: None,
        samples: None,
        samples_failed: None,
        sampled_mu: None,
        sampled_lo: None,
        n: case.a.segments() as u64,
        m: case.b.segments() as u64,
        sums: None,
        vertices: None,
        crossings: None,
        k: None,
        late: None,
        gather: None,
        cancelled: None,
        order_conflict: None,
        cells: None,
        bubbles: None,
        cracks: None,
        result_segments: None,
        result_loops: None,
        exact_loops: None,
        exact_bits: None,
        failed_checks: None,
        t_convolution: None,
        t_arrangement: None,
        t_extraction: None,
        note: String::new(),
    }
}
