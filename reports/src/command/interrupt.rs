//! Ctrl-C: a flag that whoever runs for long looks at.

use super::Failure;
use std::sync::atomic::{AtomicBool, Ordering};

static STOP: AtomicBool = AtomicBool::new(false);

/// The flag, raised by an interrupt, a termination or a hang-up.
///
/// # Errors
/// When the system refuses the handler.
pub fn flag() -> Result<&'static AtomicBool, Failure> {
    match ctrlc::set_handler(|| STOP.store(true, Ordering::Relaxed)) {
        // Set before in this process: the flag is the same.
        Ok(()) | Err(ctrlc::Error::MultipleHandlers) => Ok(&STOP),
        Err(e) => Err(Failure::other(e)),
    }
}
