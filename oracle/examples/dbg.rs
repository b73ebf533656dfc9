//! d
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::error::Budget;
use arcsum_oracle::plain::*;
use std::time::Instant;
fn disc(x: f64, r: f64) -> PlainRegion {
    let c = |x| Corner { x, y: 0., bend: Bend::Bulge(1.) };
    PlainRegion { loops: vec![vec![c(x - r), c(x + r)]], unbounded: false }
}
fn gear(n: usize, s: u64) -> PlainRegion {
    let mut z = s;
    let mut rnd = || {
        z = z.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (z >> 11) as f64 / (1u64 << 53) as f64
    };
    let v = (0..n)
        .map(|i| {
            let t = i as f64 / n as f64 * std::f64::consts::TAU;
            let r = 0.15 + 0.3 * rnd();
            Corner { x: r * t.cos(), y: r * t.sin(), bend: Bend::Bulge((rnd() - 0.5) * 0.4) }
        })
        .collect();
    PlainRegion { loops: vec![v], unbounded: false }
}
fn main() {
    let r = Reference::new(&disc(0., 0.5), &disc(0.25, 0.125), 1., Budget::default()).unwrap();
    println!("{} {:?}", r.sum().curves.len(), r.measure(&disc(0.25, 0.625)));
    println!("{:?}", r.measure(&disc(0.25, 0.625 + 1e-16)));
    for n in [10, 30, 60, 100] {
        for s in 1..3 {
            let t = Instant::now();
            let r = Reference::new(&gear(n, s), &gear(n, s + 77), 1., Budget::default()).unwrap();
            let t1 = t.elapsed();
            println!("{n} edges {} undecided {} {:?}", r.sum().curves.len(), r.undecided(), t1);
        }
    }
}
