//! Bodies of the fuzz targets, as plain functions so that tests can run them too.

mod arrangement;
mod bytes;
pub mod liar;
mod region_json;
mod sum;
mod tangle;

pub use arrangement::{arrangement, assert_consistent};
pub use region_json::region_json;
pub use sum::sum_of_bytes;
pub use tangle::tangle;
