//! The peers that take arcs against the certified sum.

use super::tests::{letter, square};
use super::*;
use crate::cases::Case;
use crate::cases::gear::{gear, to_offset};
use crate::cases::rng::Rng;
use crate::cases::shape::disc;
use crate::judge::{Judgement, judge};
use arcsum::region::{Curve, Node};

fn judged(peer: &mut Peer, a: &Region, b: &Region) -> Judgement {
    let case =
        Case { name: "case".into(), family: "test".into(), a: a.clone(), b: b.clone(), seed: None, golden: None };
    let answer = peer.sum(a, b).unwrap_or_else(|e| panic!("{}: {e}", peer.name));
    judge(&case, peer.name(), &answer)
}

/// Those built in that take arcs.
fn curved() -> impl Iterator<Item = Peer> {
    PEERS.iter().copied().filter(|peer| peer.abilities.arcs)
}

/// What an engine promises its error to stay below, in unit-box lengths. Chords move each operand by their sagitta. The
/// offset takes places within 1e-5 and 1e-4 of each other for one where the box is 1024 wide. iCurve has a grid of 26 bits over
/// what is here less than 8 wide, and some roundings on it.
fn promise(peer: &Peer) -> f64 {
    match peer.way {
        Way::Flat { sagitta, .. } => 2.0 * sagitta,
        Way::Offset { bits, .. } => libm::ldexp(1e-5 + 1e-4, -bits),
        _ => libm::ldexp(1.0, 6 - 26),
    }
}

#[test]
fn sums_with_discs_keep_what_they_promise() {
    let mut operands = vec![letter(6.0, 2.0), disc(3.0), gear(12, &mut Rng::new(3, "gear"))];
    operands.extend(to_offset(16, &mut Rng::new(3, "offset")).map(|(_, region)| region));
    for a in operands {
        // iCurve is wrong on more than corners and discs: see the witnesses.
        let plain = a.segments() <= 6;
        for mut peer in curved().filter(|peer| plain || !matches!(peer.way, Way::Curves(_))) {
            for (a, b) in [(&a, &disc(0.25)), (&disc(0.25), &a)] {
                let judgement = judged(&mut peer, a, b);
                // The references' bracket is as wide as one part in 16.
                let most = promise(&peer) * 1.0625;
                assert!(judgement.mu_hi.is_some_and(|mu| mu <= most), "{}: {judgement:?}", peer.name);
                assert!(!judgement.failed_checks.contains(&"loops".to_owned()), "{}: {judgement:?}", peer.name);
            }
        }
    }
}

#[test]
fn chords_are_measured_as_wrong() {
    for (name, sagitta) in [("clipper2:flat-1e-3", 1e-3), ("clipper2:flat-1e-6", 1e-6)] {
        let Some(mut peer) = Peer::named(name) else { continue };
        let judgement = judged(&mut peer, &square(1.0), &disc(0.5));
        // Chords take the fewest that keep the sagitta, so the widest of them is not far below it.
        assert!(judgement.mu_lo > Some(0.2 * sagitta) && judgement.mu_hi < Some(1.0625 * sagitta), "{judgement:?}");
        assert!(judgement.direction.as_deref() == Some("sum"), "{judgement:?}");
    }
}

/// Adds an offset by too little, and one the wrong way.
#[test]
fn a_wrong_offset_is_measured_as_wrong() {
    let same: offset::By = |loops, _| Ok(Offset { loops: loops.clone(), time: std::time::Duration::ZERO });
    let abilities = Abilities { discs_only: true, ..Abilities::ALL };
    let mut lazy = Peer { name: "planted", version: "0", abilities, way: Way::Offset { bits: 3, offset: same } };
    // The corner of the square is as far from it as the radius; the unit box is 2 wide.
    let judgement = judged(&mut lazy, &square(2.0), &disc(0.5));
    let (lo, hi) = (judgement.mu_lo.unwrap(), judgement.mu_hi.unwrap());
    assert!(lo <= 0.25 && 0.25 <= hi && hi < 1.0625 * lo, "{judgement:?}");
}

#[test]
fn an_offset_is_for_discs_alone() {
    let able = Abilities { unbounded: false, discs_only: true, ..Abilities::ALL };
    let half = |x: f64, bulge| Node { x, y: 0.0, curve: Curve::Bulge(bulge) };
    let lens = Region { loops: vec![vec![half(1.0, 0.5), half(-1.0, 0.5)]], ..Region::default() };
    let [.., (_, holed)] = to_offset(16, &mut Rng::new(1, "offset"));
    for (a, covered) in
        [(&square(1.0), true), (&holed, true), (&disc(2.0), true), (&lens, true), (&Region::plane(), false)]
    {
        assert_eq!((able.cover(a, &disc(1.0)), able.cover(&disc(1.0), a)), (covered, covered));
        assert_eq!(able.cover(a, &lens), covered && *a == disc(2.0));
    }
    if let Some(mut cavalier) = Peer::named("cavalier") {
        assert_eq!(cavalier.abilities(), able);
        assert!(matches!(cavalier.sum(&square(1.0), &lens), Err(EngineError::Invalid(_))));
    }
}
