//! The fuzz targets on random bytes: a short run of each, with a fixed seed.

use arcsum_reports::cases::rng::Rng;

fn bytes(random: &mut Rng, most: usize) -> Vec<u8> {
    (0..random.below(most)).map(|_| random.below(256) as u8).collect()
}

#[test]
fn arrangements_are_consistent() {
    let mut random = Rng::new(1, "tests");
    let vertices: usize = (0..60_000).map(|_| arcsum_fuzz::arrangement(&bytes(&mut random, 160))).sum();
    assert!(vertices > 60_000);
}

#[test]
fn sums_are_finite_and_consistent() {
    let mut random = Rng::new(2, "tests");
    let summed = (0..60_000).filter(|_| arcsum_fuzz::sum_of_bytes(&bytes(&mut random, 200)).is_some()).count();
    assert!(summed > 5000, "{summed}");
}
