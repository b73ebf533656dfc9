//! Time that this thread has run: unlike time on the wall it does not pass while others use the processor.

use rustix::time::{ClockId, clock_gettime};

/// Seconds of processor time that the work takes, and what it returns.
pub(super) fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let now = || {
        let time = clock_gettime(ClockId::ThreadCPUTime);
        time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
    };
    let start = now();
    let done = work();
    (now() - start, done)
}
