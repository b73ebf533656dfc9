//! The integration tests, in one binary: they share what is generic over numbers, and run side by side.

mod angles;
mod arcs;
mod arrangement;
mod boolean_exact;
mod convolution;
mod crossing;
mod exact;
mod families;
mod frame;
mod fuzzing;
mod heuristic;
mod iterated;
mod metamorphic;
mod monotonic;
mod mutated_json;
mod naive;
mod order;
mod realize;
mod regions;
mod small_polygons;
mod smooth;
mod steep;
mod sum3;
mod tidy;
mod two_ways;
mod validate;
