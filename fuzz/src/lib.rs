//! Bodies of the fuzz targets, as plain functions so that tests can run them too.
