//! The names of the statuses, in the order in which the page counts them.

use crate::row::Status;

/// All statuses, good first.
pub const ALL: [Status; 6] =
    [Status::Ok, Status::Sampled, Status::Undecided, Status::Invalid, Status::Timeout, Status::Crashed];

/// The name as `results.csv` has it; also the class that colours it.
pub fn name(status: Status) -> &'static str {
    match status {
        Status::Ok => "ok",
        Status::Sampled => "sampled",
        Status::Undecided => "undecided",
        Status::Invalid => "invalid",
        Status::Timeout => "timeout",
        Status::Crashed => "crashed",
    }
}

/// The name on its colour, as HTML.
pub fn badge(status: Status) -> String {
    let name = name(status);
    format!("<span class=\"badge {name}\">{name}</span>")
}
