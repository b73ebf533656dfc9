//! Certified cases per second and core (`elem/s`): the boundary of a sum, and the distance between two sums that differ in the last places,
//! for random regions of 10, 30 and 100 segments each, half of them arcs.
#![allow(missing_docs, reason = "the macros of criterion make public items")]

use std::hint::black_box;

use arcsum_oracle::certified::hausdorff::between;
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::error::Budget;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

const SIZES: [usize; 3] = [10, 30, 100];

/// Numbers in [0, 1) from a linear congruential generator (constants of Knuth's MMIX).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A region that is star-shaped but for its arcs, which are too flat to cross each other. Every coordinate is moved by up
/// to `shake`.
fn radial(n: usize, seed: u64, shake: f64) -> PlainRegion {
    let (mut numbers, mut shakes) = (Numbers(seed), Numbers(!seed));
    let mut corner = |k: usize| {
        let radius = 0.25 * (1.0 - 0.25 * numbers.next());
        let (sin, cos) = ((k as f64 + 0.3 * numbers.next()) / n as f64 * std::f64::consts::TAU).sin_cos();
        let bulge = 0.1 * numbers.next() - 0.05;
        let bend = if k.is_multiple_of(2) { Bend::Line } else { Bend::Bulge(bulge) };
        let [x, y] = [cos, sin].map(|c| radius * c + shake * (shakes.next() - 0.5));
        Corner { x, y, bend }
    };
    PlainRegion { loops: vec![(0..n).map(&mut corner).collect()], unbounded: false }
}

fn sum(n: usize, shake: f64) -> Reference {
    Reference::new(&radial(n, 1, shake), &radial(n, 2, 0.0), 1.0, Budget::NONE).expect("valid regions")
}

fn certified(criterion: &mut Criterion) {
    let mut boundary = criterion.benchmark_group("boundary");
    boundary.sample_size(10).throughput(Throughput::Elements(1));
    for n in SIZES {
        boundary.bench_function(BenchmarkId::from_parameter(n), |bencher| bencher.iter(|| black_box(sum(n, 0.0))));
    }
    boundary.finish();
    let mut measure = criterion.benchmark_group("measure");
    measure.sample_size(10).throughput(Throughput::Elements(1));
    for n in SIZES {
        let (truth, result) = (sum(n, 0.0), sum(n, f64::from(-50).exp2()));
        assert_eq!(truth.undecided() + result.undecided(), 0);
        measure.bench_function(BenchmarkId::from_parameter(n), |bencher| {
            bencher.iter(|| black_box(between(result.sum(), truth.sum()).expect("closed").expect("decided")));
        });
    }
    measure.finish();
}

criterion_group!(benches, certified);
criterion_main!(benches);
