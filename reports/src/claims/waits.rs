//! Claims that wait for packing, and for the decompositions and unions of the second paper.

use super::{Claim, Test};

const PACKING: &str = "waits for the packing algorithms";
const UNIONS: &str = "waits for the decompositions and unions of FH";

/// Number, place, what it says, what it waits for.
const WAITING: [[&str; 4]; 25] = [
    ["M36", "MS 8.1", "The packing algorithms find a placement if there is one.", PACKING],
    ["M37", "MS 8.2", "A threshold of 1e-13 suffices to remove falsely free cells.", PACKING],
    ["M38", "MS 8.3", "The monotonic convolution takes 42% less time in packing, 2% to 70%.", PACKING],
    ["M39", "MS 8.3", "It takes longer to convolve and much less to arrange.", PACKING],
    ["M40", "MS 8.3", "Robustness costs 2% of the time on average.", PACKING],
    ["M41", "MS 8.3", "Packings are accurate to 43 to 50 bits.", PACKING],
    ["M42", "MS 8.3", "A second measure of accuracy tells against the kinetic convolution for parts 3 and 4.", PACKING],
    ["M43", "MS 8.3", "Wrong answers of the binary search come after at least 50 steps.", PACKING],
    ["M44", "MS 8.3", "The kinetic convolution has more cells.", PACKING],
    ["M45", "MS 8.3", "The kinetic convolution has bubbles in packings, the monotonic one has none.", PACKING],
    ["M46", "MS 8.3", "Iterated sums and intersections keep nearly machine accuracy.", PACKING],
    ["M47", "MS 8.3", "The arrangement takes most of the time.", PACKING],
    ["M48", "MS 1", "Exact predicates of sums of arcs have degree 16, of iterated sums 256.", "needs computer algebra"],
    ["F2", "FH 2", "Degenerate holes, segments and points, are found.", UNIONS],
    ["F5", "FH 2", "The sum does not depend on the decomposition.", UNIONS],
    ["F6", "FH 2", "Sums of convex pieces take linear time.", UNIONS],
    ["F7", "FH 2", "The arrangement algorithm takes O(I + k log k) expected time.", UNIONS],
    ["F8", "FH 3", "The incremental union is the fastest on most inputs.", UNIONS],
    ["F9", "FH 3", "Divide and conquer is close to the better of the others, and worst on combs.", UNIONS],
    ["F10", "FH 3", "The arrangement algorithm is the fastest on forks.", UNIONS],
    ["F11", "FH 3", "On covered forks an order by fatness makes the incremental union output-sensitive.", UNIONS],
    ["F12", "FH 3", "On fat grids an order by fatness is about twice as slow.", UNIONS],
    ["F13", "FH 1", "The least separating translation leads to the nearest point of the boundary.", UNIONS],
    ["F14", "FH 1", "A robot passes a tight passage through a degenerate feature.", UNIONS],
    ["F15", "FH 3", "The choice of the decomposition matters much for the time.", UNIONS],
];

/// The claims that wait.
#[must_use]
pub fn claims() -> Vec<Claim> {
    let claim =
        |[id, place, says, why]: [&'static str; 4]| Claim { id, place, says, erratum: "", test: Test::Waits(why) };
    WAITING.into_iter().map(claim).collect()
}
