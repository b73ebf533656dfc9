//! The command `arcsum`.

fn main() {}
