//! Cycles of the convolution, and peers that fail.

use super::grid::Grid;
use super::*;
use crate::cases::fork::fork;
use crate::cases::shape::{disc, polygon, rectangle};

/// A polygon like the letter L: `long` both ways, its arms `wide`.
pub fn letter(long: f64, wide: f64) -> Region {
    polygon(&[[0.0, 0.0], [long, 0.0], [long, wide], [wide, wide], [wide, long], [0.0, long]])
}

pub fn square(side: f64) -> Region {
    polygon(&rectangle([0.0, 0.0], [side, side]))
}

fn planted(unite: fn(&[Ring]) -> Outcome) -> Peer {
    Peer { name: "planted", version: "0", abilities: UNITES, way: Way::Union { bits: 20, unite } }
}

#[test]
fn a_union_that_fails_is_an_error() {
    let (a, b) = (letter(6.0, 2.0), square(1.0));
    assert!(matches!(planted(|_| Ok(Vec::new())).sum(&a, &b), Err(EngineError::Invalid(_))));
    assert!(matches!(planted(|_| panic!("planted")).sum(&a, &b), Err(EngineError::Crashed(_))));
    assert!(matches!(planted(|_| Err(EngineError::Invalid("no".into()))).sum(&a, &b), Err(EngineError::Invalid(_))));
}

#[test]
fn what_no_union_takes_is_refused() {
    for bad in [&disc(1.0), &Region::plane()] {
        let mut peer = planted(|rings| Ok(rings.to_vec()));
        assert!(matches!(peer.sum(&square(1.0), bad), Err(EngineError::Invalid(_))));
    }
}

#[test]
fn cycles_are_the_whole_convolution() {
    let (a, b) = fork(3);
    let kinetic = arcsum::sum::Options { convolution: arcsum::sum::Convolution::Kinetic, ..Default::default() };
    let pieces = arcsum::sum::sum(&a, &b, &kinetic).unwrap().convolution.pieces.len();
    let grid = Grid::new(&a, &b, 40);
    let cycles = grid.cycles(&a, &b).unwrap();
    assert_eq!(cycles.iter().map(Vec::len).sum::<usize>(), pieces);
    let doubled = |[p, q]: [[i64; 2]; 2]| i128::from(p[0]) * i128::from(q[1]) - i128::from(p[1]) * i128::from(q[0]);
    let area = |ring: &Ring| (0..ring.len()).map(|i| doubled([ring[i], ring[(i + 1) % ring.len()]])).sum::<i128>();
    assert!(cycles.iter().map(area).sum::<i128>() > 0);
}
