//! Bodies of the fuzz targets, as plain functions so that tests can run them too.

mod region_json;

pub use region_json::region_json;
