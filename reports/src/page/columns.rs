//! What the columns of `results.csv` mean, and to which side the page rounds them.

use super::number::Toward;

/// A column the page knows.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Its name in the file.
    pub name: &'static str,
    /// Its meaning in one line.
    pub meaning: &'static str,
    /// How it may be shortened, if it is a length.
    pub toward: Option<Toward>,
}

const fn column(name: &'static str, meaning: &'static str) -> Column {
    Column { name, meaning, toward: None }
}

const fn length(name: &'static str, toward: Toward, meaning: &'static str) -> Column {
    Column { name, meaning, toward: Some(toward) }
}

/// All columns of a row; lengths in unit-box lengths and times in milliseconds unless they say otherwise.
pub const COLUMNS: [Column; 54] = [
    column("case", "the pair of regions"),
    column("family", "the family or folder it belongs to"),
    column("engine", "the engine under test"),
    column("engine_version", "its version"),
    column("status", "ok, sampled, undecided, invalid, timeout or crashed"),
    column("seed", "what the case was made from; empty for cases from files"),
    length("mu_lo", Toward::Down, "certified lower bound of the error mu"),
    length("mu_hi", Toward::Up, "certified upper bound of the error mu"),
    column("bits", "-log2(mu_hi), rounded down; inf where the result is exact"),
    column(
        "direction",
        "mu_lo is attained at a point of the result far from the sum, or of the sum far from the result",
    ),
    column("worst_x", "where mu_lo is attained, in input units"),
    column("worst_y", "where mu_lo is attained, in input units"),
    length("mu_realized_lo", Toward::Down, "lower bound of mu against the sum of the realizations"),
    length("mu_realized_hi", Toward::Up, "upper bound of mu against the sum of the realizations"),
    length("rho_lo", Toward::Down, "lower bound of the greatest inradius of the overlap at tested points"),
    length("rho_hi", Toward::Up, "upper bound of it"),
    length("pd_lo", Toward::Down, "lower bound of the greatest penetration depth at tested points"),
    length("pd_hi", Toward::Up, "upper bound of it"),
    length("trap", Toward::Nearest, "Milenkovic and Sacks' trapezoid number at the deepest tested points"),
    column("tested", "points that the engine takes for free and that were tested"),
    column("left_out", "trapezoids, vertices and middles of segments that were not, because there are many"),
    column("falsely_free", "blocked ones among the tested points with rho > mu"),
    column("innocent", "ones among them that are blocked with pd <= mu or that near to the sum"),
    column("open", "ones among them that may be blocked, with neither shown"),
    column("falsely_blocked", "tested points inside blocked cells that are free"),
    length(
        "separation_lo",
        Toward::Down,
        "lower bound of the least distance of chains of A, or of B, that are not incident; inf without such",
    ),
    length("separation_hi", Toward::Up, "upper bound of it"),
    column("samples", "places and points at which a result was looked at whose exact sum is too large"),
    column("samples_failed", "of these, without a certificate of 2^-45, or proving an error above that"),
    length(
        "sampled_mu",
        Toward::Up,
        "greatest certified distance of the boundaries of result and sum among the samples",
    ),
    length("sampled_lo", Toward::Down, "greatest lower bound of mu that a sample proves"),
    column("n", "segments of A"),
    column("m", "segments of B"),
    column("sums", "segments of the convolution"),
    column("V", "vertices of the arrangement"),
    column("N", "crossings over all pairs (audit only)"),
    column("k", "cyclic triples (audit only)"),
    column("late", "late swaps"),
    column("gather", "gather swaps"),
    column("cancelled", "swaps refused because the convolution order is known, each pair once"),
    column("order_conflict", "gather swaps against a known convolution order"),
    column("cells", "cells of the arrangement"),
    column("bubbles", "free cells all of whose tested points are blocked with pd > mu"),
    column("cracks", "free cells some but not all of whose tested points are blocked with pd > mu"),
    column("result_segments", "segments of the result"),
    column("result_loops", "loops of the result"),
    column("exact_loops", "loops of the reference"),
    column(
        "exact_bits",
        "the most bits that a certified reference needed to tell how curves meet; empty for rational ones",
    ),
    column("failed_checks", "failed checks by name; none when all held"),
    column("t_convolution", "time of the convolution in ms"),
    column("t_arrangement", "time of the arrangement in ms"),
    column("t_extraction", "time of the extraction in ms"),
    column("note", "why the status is not ok, or why the bits fall short"),
    column("#", "number of the row, its record and its picture"),
];

/// The column of that name; a column the page does not know has no meaning to tell.
pub fn find(name: &str) -> Column {
    COLUMNS.into_iter().find(|c| c.name == name).unwrap_or(column("", ""))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::sample;

    #[test]
    fn every_column_of_a_row_is_known_and_no_other() {
        let headers = sample::headers();
        for name in headers.iter() {
            assert!(!find(name).meaning.is_empty(), "{name} has no meaning");
        }
        for known in COLUMNS.iter().filter(|c| c.name != "#") {
            assert!(headers.iter().any(|name| name == known.name), "{} is no column", known.name);
        }
    }
}
