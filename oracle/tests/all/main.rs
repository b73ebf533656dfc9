//! The tests of the oracle, in one binary: they share what is generic over numbers, and run side by side.

mod agreement;
mod backward;
mod boolean;
mod boundary;
mod boundary_arcs;
mod certified_regions;
mod common;
mod depth;
mod enclose;
mod gap;
mod inside;
mod known;
mod laws;
mod measure;
mod meet;
mod membership;
mod overlap;
mod planted;
mod same_sum;
mod separation;
mod shortcuts;
