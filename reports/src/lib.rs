//! The harness of arcsum: cases, engines under test, measurements, and the pages and tables they end in.

pub mod page;
pub mod row;
