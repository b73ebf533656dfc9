//! A pool of workers, one thread for each, that share a list of jobs.

use super::plan::Plan;
use crate::worker::parent::{Worker, WorkerError};
use crate::worker::{Ask, Outcome, Task};
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Sender};
use std::time::Duration;

/// What stops a pool.
#[derive(Debug, thiserror::Error)]
pub enum PoolError {
    /// Somebody asked for it.
    #[error("interrupted")]
    Stopped,
    /// A worker cannot be started or talked to.
    #[error(transparent)]
    Worker(#[from] WorkerError),
}

/// How jobs are carried out.
#[derive(Clone, Copy, Debug)]
pub struct Pool<'a> {
    /// The program whose command `worker` serves.
    pub program: &'a Path,
    /// Workers at a time.
    pub threads: usize,
    /// Time for the engine, and again for the reference, on a case.
    pub limit: Duration,
}

impl Pool<'_> {
    /// Carries out the jobs in this order as workers get free, and hands each outcome to `take` in the order they come.
    ///
    /// # Errors
    /// When stopped, when no worker starts, or with the first error of `take`; running jobs are then given up.
    pub fn measure<E: From<PoolError>>(
        &self,
        plan: &Plan,
        jobs: &[usize],
        stop: &AtomicBool,
        mut take: impl FnMut(usize, Outcome) -> Result<(), E>,
    ) -> Result<(), E> {
        let next = AtomicUsize::new(0);
        let given_up = AtomicBool::new(false);
        let (sender, outcomes) = mpsc::channel();
        std::thread::scope(|scope| {
            for _ in 0..self.threads.clamp(1, jobs.len().max(1)) {
                let (next, given_up, sender) = (&next, &given_up, sender.clone());
                scope.spawn(move || self.work(plan, jobs, next, [stop, given_up], &sender));
            }
            drop(sender);
            let mut result = Ok(());
            // After the first error the channel is only emptied.
            for (job, outcome) in outcomes {
                if result.is_ok() {
                    result = outcome.map_err(|e| E::from(e)).and_then(|o| take(job, o));
                    given_up.store(result.is_err(), Ordering::Relaxed);
                }
            }
            result
        })
    }

    fn work(
        &self,
        plan: &Plan,
        jobs: &[usize],
        next: &AtomicUsize,
        [stop, given_up]: [&AtomicBool; 2],
        sender: &Sender<(usize, Result<Outcome, PoolError>)>,
    ) {
        let mut worker = Worker::new(self.program.to_path_buf(), self.limit);
        while !given_up.load(Ordering::Relaxed) {
            let Some(&job) = jobs.get(next.fetch_add(1, Ordering::Relaxed)) else { return };
            let facts = &plan.engines[plan.jobs[job].engine];
            let case = plan.cases[plan.jobs[job].case].clone();
            let task = Task { case, engine: facts.name.clone(), claim: None, sampling: plan.sampling, ask: Ask::All };
            let outcome = worker.measure(&task, stop).map_err(|e| match e {
                WorkerError::Stopped => PoolError::Stopped,
                other => PoolError::Worker(other),
            });
            let failed = outcome.is_err();
            if sender.send((job, outcome)).is_err() || failed {
                return;
            }
        }
    }
}
