//! The parts of the engine, one by one, on the same pairs: a grid (`fork`), what tangles (`star`) and circle segments (`arcs`).
//!
//! Measured through public functions alone. Envelopes are private: the monotonic convolution, whose crusts they are, stands
//! for them (`convolution/monotonic`), and so does `arrange` for the sweep.
#![allow(missing_docs, reason = "the macros of criterion make public items")]

use arcsum::angle::Ang;
use arcsum::arc::Arc;
use arcsum::arrangement::cross::{CrossingModule, FloatModule};
use arcsum::arrangement::curve::Curve;
use arcsum::arrangement::{Arrangement, arrange};
use arcsum::convolution::{kinetic, monotonic, ordered};
use arcsum::extract::outline;
use arcsum::frame::Frame;
use arcsum::piece::{Piece, Pieces, Source};
use arcsum::robustness::Robustness;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_reports::cases::family::Family;
use arcsum_reports::cases::rng::Rng;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use glam::DVec2;
use std::hint::black_box;

/// The families and sizes of the pairs.
const PAIRS: [(&str, u32); 3] = [("fork", 8), ("star", 15), ("arcs", 32)];

/// Angles, points and pairs of curves that one iteration takes.
const MANY: usize = 1000;

/// A pair of operands as the engine takes them.
struct Pair {
    name: String,
    a: Smooth,
    b: Smooth,
}

fn pairs() -> Vec<Pair> {
    let pair = |(name, size): (&str, u32)| {
        let case = Family::named(name).expect("a family").cases_of_size(size, 1).remove(0);
        let frames = Frame::pair(&case.a, &case.b);
        let smooth = |region, frame| Smooth::new(region, frame).expect("a valid region");
        Pair { name: case.name, a: smooth(&case.a, &frames.0), b: smooth(&case.b, &frames.1) }
    };
    PAIRS.map(pair).into()
}

fn points(count: usize, name: &str) -> Vec<DVec2> {
    let mut rng = Rng::new(1, name);
    (0..count).map(|_| DVec2::new(rng.unit(), rng.unit())).collect()
}

fn angles(criterion: &mut Criterion) {
    let normals: Vec<Ang> =
        points(MANY, "angles").iter().filter_map(|p| Ang::of_normal(p.x - 0.5, p.y - 0.5)).collect();
    let directions = points(MANY, "directions");
    let mut group = criterion.benchmark_group("angle");
    group.throughput(Throughput::Elements(MANY as u64));
    group.bench_function("of_normal", |bencher| {
        bencher.iter(|| directions.iter().filter_map(|p| black_box(Ang::of_normal(p.x, p.y))).count());
    });
    group.bench_function("turn_to", |bencher| {
        bencher.iter(|| normals.windows(2).map(|w| w[0].turn_to(w[1])).sum::<f64>());
    });
    group.bench_function("sin_cos", |bencher| {
        bencher.iter(|| normals.iter().map(|angle| angle.sin_cos().0).sum::<f64>());
    });
    group.finish();
}

fn sums_of_points(criterion: &mut Criterion) {
    let [t, q] = ["tails", "others"].map(|name| points(MANY, name));
    let arc = Arc::with_bulge(DVec2::new(0.25, 0.5), DVec2::new(0.5, 0.25), 0.2).expect("an arc");
    let angle = arc.a().half_sum(arc.b());
    let mut group = criterion.benchmark_group("point");
    group.throughput(Throughput::Elements(MANY as u64));
    for rounding in [Rounding::Correct, Rounding::Plain] {
        group.bench_function(BenchmarkId::new("sum", format!("{rounding:?}")), |bencher| {
            let sum = || t.iter().zip(&q).map(|(t, q)| rounding.sum_points(*t, DVec2::splat(1e-9), *q)).sum::<DVec2>();
            bencher.iter(sum);
        });
    }
    group.bench_function("on_an_arc", |bencher| {
        bencher.iter(|| q.iter().map(|q| arc.point_plus(angle, *q, Rounding::Correct)).sum::<DVec2>());
    });
    group.finish();
}

/// Curves from left to right between random points, every other one bent.
fn curves() -> Vec<Curve> {
    let points = points(2 * MANY, "curves");
    let curve = |i: usize| {
        let ends = [2 * i as u32, 2 * i as u32 + 1];
        let at = ends.map(|end| points[end as usize]);
        let mut piece = Piece::between(&points, ends[0], ends[1], Source::default());
        if i.is_multiple_of(2) {
            piece.delta = 0.3;
        }
        Curve::new(i as u32, &piece, (ends[0], at[0]), (ends[1], at[1]), at)
    };
    (0..MANY).filter_map(curve).collect()
}

fn crossings(criterion: &mut Criterion) {
    let curves = curves();
    let module = FloatModule::new(1.0);
    // The module is asked about curves whose parts overlap in the sweep.
    let overlap = |f: &Curve, g: &Curve| f.start.x < g.end.x && g.start.x < f.end.x;
    let met: Vec<[&Curve; 2]> = curves.windows(2).filter(|w| overlap(&w[0], &w[1])).map(|w| [&w[0], &w[1]]).collect();
    let mut group = criterion.benchmark_group("crossing");
    group.throughput(Throughput::Elements(met.len() as u64));
    group.bench_function("cross", |bencher| {
        bencher.iter(|| met.iter().map(|[f, g]| module.cross(f, g).points().len()).sum::<usize>());
    });
    group.bench_function("above", |bencher| {
        bencher.iter(|| met.iter().map(|[f, g]| module.above(f.start, g)).sum::<f64>());
    });
    group.finish();
}

fn convolutions(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("convolution");
    for Pair { name, a, b } in &pairs() {
        let sums = kinetic(a, b, Rounding::Correct).expect("a convolution").pieces.len();
        group.throughput(Throughput::Elements(sums as u64));
        group.bench_function(BenchmarkId::new("kinetic", name), |bencher| {
            bencher.iter(|| kinetic(a, b, Rounding::Correct));
        });
        group.bench_function(BenchmarkId::new("monotonic", name), |bencher| {
            bencher.iter(|| monotonic(a, b, Rounding::Correct));
        });
    }
    group.finish();
}

fn sweeps(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("arrangement");
    group.sample_size(20);
    for Pair { name, a, b } in &pairs() {
        let pieces = kinetic(a, b, Rounding::Correct).expect("a convolution");
        group.throughput(Throughput::Elements(arrange(&pieces).audit.vertices as u64));
        group.bench_function(BenchmarkId::new("kinetic", name), |bencher| bencher.iter(|| arrange(&pieces)));
        let (pieces, order) = monotonic(a, b, Rounding::Correct).expect("a convolution");
        let ordered = || ordered::arrange(&pieces, &order, Robustness::ALL);
        group.throughput(Throughput::Elements(ordered().audit.vertices as u64));
        group.bench_function(BenchmarkId::new("monotonic", name), |bencher| bencher.iter(ordered));
    }
    group.finish();
}

fn extractions(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("extraction");
    let arranged = |a: &Smooth, b: &Smooth| -> (Pieces, Arrangement) {
        let pieces = kinetic(a, b, Rounding::Correct).expect("a convolution");
        let arrangement = arrange(&pieces);
        (pieces, arrangement)
    };
    for Pair { name, a, b } in &pairs() {
        let (pieces, arrangement) = arranged(a, b);
        group.throughput(Throughput::Elements(arrangement.audit.vertices as u64));
        group.bench_function(BenchmarkId::from_parameter(name), |bencher| {
            bencher.iter(|| outline(&arrangement, &pieces, |winding| winding[0] != 0));
        });
    }
    group.finish();
}

criterion_group!(benches, angles, sums_of_points, crossings, convolutions, sweeps, extractions);
criterion_main!(benches);
