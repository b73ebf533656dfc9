//! The predicates of the references: orientation of points, where intervals decide and where rational numbers must, and
//! membership of random points in a sum. What whole references cost is the bench `certified` of
//! the oracle.
#![allow(missing_docs, reason = "the macros of criterion make public items")]

use arcsum_oracle::certified::membership::{Membership, State};
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::spot::Spot;
use arcsum_oracle::number::Number;
use arcsum_oracle::plain::PlainRegion;
use arcsum_oracle::point::{Place, Point, area_exact, orient};
use arcsum_reports::bridge::plain;
use arcsum_reports::cases::family::Family;
use arcsum_reports::cases::rng::Rng;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use num_rational::BigRational;
use rug::Rational;
use std::cmp::Ordering;
use std::hint::black_box;

/// Questions of one iteration.
const MANY: usize = 1000;

/// Triples of points in the unit square, or on one line through it.
fn triples<Q: Number>(collinear: bool) -> Vec<[Place<Q>; 3]> {
    let mut rng = Rng::new(1, "triples");
    let mut point = || {
        let x = rng.unit();
        let y = if collinear { 0.5 * x } else { rng.unit() };
        Point::from_f64(x, y).expect("finite").into()
    };
    (0..MANY).map(|_| [point(), point(), point()]).collect()
}

fn orientation<Q: Number>(criterion: &mut Criterion, backend: &str) {
    let mut group = criterion.benchmark_group("orientation");
    group.throughput(Throughput::Elements(MANY as u64));
    for (name, collinear) in [("random", false), ("collinear", true)] {
        let triples = triples::<Q>(collinear);
        let left = || triples.iter().filter(|[a, b, c]| orient(a, b, c) == Ordering::Greater).count();
        assert_eq!(left() == 0, collinear);
        group.bench_function(BenchmarkId::new(name, backend), |bencher| bencher.iter(left));
    }
    let triples = triples::<Q>(false);
    group.bench_function(BenchmarkId::new("without intervals", backend), |bencher| {
        bencher.iter(|| {
            triples.iter().for_each(|[a, b, c]| drop(black_box(area_exact(&a.exact, &b.exact, &c.exact))));
        });
    });
    group.finish();
}

fn orientations(criterion: &mut Criterion) {
    orientation::<Rational>(criterion, "rug");
    orientation::<BigRational>(criterion, "num");
}

fn memberships(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("membership");
    group.sample_size(10);
    for (name, size) in [("star", 15), ("arcs", 32)] {
        let case = Family::named(name).expect("a family").cases_of_size(size, 1).remove(0);
        let shape = |region: &PlainRegion| Shape::new(region).expect("a valid region");
        let [a, b] = [&case.a, &case.b].map(|region| shape(&plain(region)));
        let membership = Membership::new(&a, &b);
        let mut rng = Rng::new(1, "spots");
        let away: Vec<Spot> =
            (0..MANY / 10).map(|_| Spot::exact(rng.between(-2.0, 2.0), rng.between(-2.0, 2.0))).collect();
        group.throughput(Throughput::Elements(away.len() as u64));
        group.bench_function(BenchmarkId::new("random", &case.name), |bencher| {
            bencher.iter(|| away.iter().filter(|spot| membership.state(spot) == State::Blocked).count());
        });
    }
    group.finish();
}

criterion_group!(benches, orientations, memberships);
criterion_main!(benches);
