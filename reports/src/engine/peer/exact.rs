//! The peers that are built in against the exact sum.

use super::tests::{letter, square};
use super::*;
use crate::cases::Case;
use crate::cases::shape::{backwards, lines, rectangle, region};
use crate::judge::{Judgement, judge};
use proptest::prelude::*;

fn judged(peer: &mut Peer, a: &Region, b: &Region) -> Judgement {
    let case =
        Case { name: "case".into(), family: "test".into(), a: a.clone(), b: b.clone(), seed: None, golden: None };
    let answer = peer.sum(a, b).unwrap();
    judge(&case, peer.name(), &answer)
}

/// Whether nothing at all is wrong.
fn exact(judgement: &Judgement) -> bool {
    judgement.mu_hi == Some(0.0) && judgement.failed_checks.is_empty()
}

/// The engines that unite on a grid, and shipped sums that hold what they promise.
fn truthful() -> impl Iterator<Item = Peer> {
    let on_a_grid = |peer: &Peer| !matches!(peer.way, Way::Curves(_) | Way::Offset { .. });
    PEERS.iter().copied().filter(on_a_grid).filter(|peer| peer.name != "clipper2:minkowski")
}

#[test]
fn sums_on_the_grid_are_exact() {
    let frame = region(vec![lines(&rectangle([0.0, 0.0], [9.0, 9.0])), backwards(&rectangle([2.0, 2.0], [7.0, 7.0]))]);
    for (a, b) in [(square(2.0), square(3.0)), (letter(6.0, 2.0), square(1.0)), (frame, letter(3.0, 1.0))] {
        for mut peer in truthful() {
            let judgement = judged(&mut peer, &a, &b);
            assert!(exact(&judgement), "{}: {judgement:?}", peer.name);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    // All corners and crossings lie on the grid, so there is nothing to round.
    #[test]
    fn letters_sum_exactly(long in 2..40_u8, wide in 1..40_u8, other in 2..40_u8, thin in 1..40_u8) {
        let of = |long: u8, wide: u8| letter(f64::from(long), f64::from(wide.min(long - 1)));
        for mut peer in truthful() {
            let judgement = judged(&mut peer, &of(long, wide), &of(other, thin).negated());
            prop_assert!(exact(&judgement), "{}: {judgement:?}", peer.name);
        }
    }
}

#[test]
#[cfg(feature = "clipper2")]
fn a_sum_of_boundaries_is_found_out() {
    let mut peer = Peer::named("clipper2:minkowski").unwrap();
    assert!(exact(&judged(&mut peer, &letter(6.0, 2.0), &square(3.0))));
    let judgement = judged(&mut peer, &square(6.0), &square(1.0));
    assert!(judgement.mu_lo > Some(0.1) && judgement.failed_checks.contains(&"loops".to_owned()), "{judgement:?}");
}

#[test]
fn versions_are_those_that_are_pinned() {
    let manifest = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../Cargo.toml")).unwrap();
    for peer in PEERS {
        let (name, version) = (peer.name.split(':').next().unwrap(), peer.version.split(' ').next().unwrap());
        let crate_name = FEATURES.iter().find(|feature| feature.starts_with(name)).unwrap();
        let line = manifest.lines().find(|line| line.starts_with(&format!("{crate_name} = "))).unwrap();
        assert!(line.contains(&format!("\"={version}\"")), "{line}");
    }
}
