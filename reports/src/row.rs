//! One measured case: a row of `results.csv`, and the record from which its picture is drawn.
//!
//! A report is made from these two alone. Columns that were not measured are empty, never zero.

pub(crate) mod number;

use arcsum::region::Region;
use serde::{Deserialize, Serialize};

/// What became of an engine on a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// An answer, measured and certified.
    Ok,
    /// The engine panicked, aborted or ran out of memory.
    Crashed,
    /// The engine did not answer in its time.
    Timeout,
    /// The engine answered something that is no region, or refused the case.
    Invalid,
    /// An answer whose error has no certificate, or none tight enough to call.
    Undecided,
    /// An answer too large for the reference, certified at samples only.
    Sampled,
}

/// A row of `results.csv`. Lengths are in unit-box lengths, times in milliseconds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The case, unique within a run together with the engine.
    pub case: String,
    /// The family or folder the case belongs to.
    pub family: String,
    /// The engine under test.
    pub engine: String,
    /// Its version.
    pub engine_version: String,
    /// What became of it.
    pub status: Status,
    /// The seed the case was made from; empty for cases from files.
    pub seed: Option<u64>,
    /// Certified lower bound of the region Hausdorff distance to the exact sum.
    #[serde(default, with = "number")]
    pub mu_lo: Option<f64>,
    /// Certified upper bound of it.
    #[serde(default, with = "number")]
    pub mu_hi: Option<f64>,
    /// -log2(mu_hi); `inf` when the result is exact.
    #[serde(default, with = "number")]
    pub bits: Option<f64>,
    /// Which way `mu_lo` is attained: `result` (a point of the result far from the sum) or `sum`.
    pub direction: Option<String>,
    /// Abscissa of the point that attains `mu_lo`, in input units.
    pub worst_x: Option<f64>,
    /// Ordinate of it.
    pub worst_y: Option<f64>,
    /// `mu` against the sum of the realizations: lower bound.
    pub mu_realized_lo: Option<f64>,
    /// Upper bound.
    pub mu_realized_hi: Option<f64>,
    /// Greatest inradius of the overlap at tested points that should be free: certified lower bound.
    #[serde(default, with = "number")]
    pub rho_lo: Option<f64>,
    /// Certified upper bound of it.
    #[serde(default, with = "number")]
    pub rho_hi: Option<f64>,
    /// Greatest penetration depth at the same points: certified lower bound.
    #[serde(default, with = "number")]
    pub pd_lo: Option<f64>,
    /// Certified upper bound of it.
    #[serde(default, with = "number")]
    pub pd_hi: Option<f64>,
    /// Milenkovic and Sacks' trapezoid number, the greatest at the deepest of these points; a float.
    #[serde(default, with = "number")]
    pub trap: Option<f64>,
    /// Tested points that should be free.
    pub tested: Option<u64>,
    /// Trapezoids of cells, vertices and middles that were left out, because there are many.
    pub left_out: Option<u64>,
    /// Of the tested points, blocked ones with rho > mu,
    pub falsely_free: Option<u64>,
    /// ones that are blocked with pd <= mu or that near to the sum,
    pub innocent: Option<u64>,
    /// and ones that may be blocked, with neither shown.
    pub open: Option<u64>,
    /// Tested points inside blocked cells that are free.
    pub falsely_blocked: Option<u64>,
    /// Least distance of two chains of A, or two of B, that are not incident: certified lower bound; `inf` without such.
    #[serde(default, with = "number")]
    pub separation_lo: Option<f64>,
    /// Certified upper bound of it.
    #[serde(default, with = "number")]
    pub separation_hi: Option<f64>,
    /// Places and points at which a result was looked at whose exact sum is too large.
    #[serde(default)]
    pub samples: Option<u64>,
    /// Of these, places without a certificate of 2^-45, and places and points that prove an error above that.
    #[serde(default)]
    pub samples_failed: Option<u64>,
    /// Greatest certified distance of the boundaries of result and sum among the samples.
    #[serde(default, with = "number")]
    pub sampled_mu: Option<f64>,
    /// Greatest lower bound of mu that a sample proves.
    #[serde(default, with = "number")]
    pub sampled_lo: Option<f64>,
    /// Segments of A.
    pub n: u64,
    /// Segments of B.
    pub m: u64,
    /// Segments of the convolution.
    pub sums: Option<u64>,
    /// Vertices of the arrangement.
    #[serde(rename = "V")]
    pub vertices: Option<u64>,
    /// Crossings the module reports over all pairs (audit only).
    #[serde(rename = "N")]
    pub crossings: Option<u64>,
    /// Cyclic triples (audit only).
    pub k: Option<u64>,
    /// Late swaps.
    pub late: Option<u64>,
    /// Gather swaps.
    pub gather: Option<u64>,
    /// Swaps refused because the convolution order is known to be right, each pair once.
    pub cancelled: Option<u64>,
    /// Gather swaps against a known convolution order; MS 7.2 has none in regions that are 2 mu separated.
    #[serde(default)]
    pub order_conflict: Option<u64>,
    /// Cells of the arrangement.
    pub cells: Option<u64>,
    /// Free cells all of whose tested points are blocked, with pd > mu.
    pub bubbles: Option<u64>,
    /// Free cells some but not all of whose tested points inside are.
    pub cracks: Option<u64>,
    /// Segments of the result.
    pub result_segments: Option<u64>,
    /// Loops of the result.
    pub result_loops: Option<u64>,
    /// Loops of the reference.
    pub exact_loops: Option<u64>,
    /// The most bits the reference needed; none for exact references.
    #[serde(default)]
    pub exact_bits: Option<u32>,
    /// Failed checks by name, separated by spaces; `none` when all held.
    pub failed_checks: Option<String>,
    /// Time of the convolution.
    pub t_convolution: Option<f64>,
    /// Time of the arrangement.
    pub t_arrangement: Option<f64>,
    /// Time of the extraction.
    pub t_extraction: Option<f64>,
    /// One sentence: why the status is not ok, or why the bits fall short.
    pub note: String,
}

/// What a picture needs: the file `cases/<number>.json` of an output folder, one a row.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// The row.
    pub row: Row,
    /// First operand, in input units.
    pub a: Region,
    /// Second operand.
    pub b: Region,
    /// What the engine answered.
    pub result: Option<Region>,
    /// The convolution as `[x0, y0, x1, y1, bulge]` in input units, empty where the engine has none to show.
    pub convolution: Vec<[f64; 5]>,
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// An undecided row with nothing measured.
    pub(crate) fn row() -> Row {
        let empty =
            r#"{"case":"c","family":"f","engine":"e","engine_version":"1","status":"undecided","n":1,"m":2,"note":""}"#;
        serde_json::from_str(empty).unwrap()
    }

    #[test]
    fn bits_survive_csv_and_json() {
        for bits in [None, Some(51.25), Some(51.0), Some(-3.0), Some(f64::INFINITY)] {
            let row = Row { bits, mu_hi: bits.map(|b| -b), ..row() };
            let json = serde_json::to_string(&row).unwrap();
            assert_eq!(serde_json::from_str::<Row>(&json).unwrap(), row);
            let mut writer = csv::Writer::from_writer(Vec::new());
            writer.serialize(&row).unwrap();
            let bytes = writer.into_inner().unwrap();
            let back: Row = csv::Reader::from_reader(&bytes[..]).deserialize().next().unwrap().unwrap();
            assert_eq!(back, row);
        }
    }
}
