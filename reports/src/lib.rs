//! The harness of arcsum: cases, engines under test, measurements, and the pages and tables they end in.

pub mod attack;
pub mod bench;
pub mod bridge;
pub mod cases;
pub mod claims;
pub mod command;
pub mod engine;
pub mod environment;
pub mod iterate;
pub mod judge;
pub mod lines;
pub mod memory;
pub mod page;
pub mod row;
pub mod run;
pub mod winding;
pub mod worker;
