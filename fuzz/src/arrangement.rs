//! Target `arrangement`: a consistent planar map comes out of any closed loops, whatever the crossing module says.

use crate::bytes::Bytes;
use crate::liar::Liar;
use crate::tangle::tangle;
use arcsum::arrangement::cross::FloatModule;
use arcsum::arrangement::{Arrangement, arrange, arrange_with};

/// Arranges the loops that the bytes describe, honestly or with lies of up to 1e-3. Returns the number of vertices.
///
/// # Panics
/// If the map is not consistent: that is the find.
pub fn arrangement(data: &[u8]) -> usize {
    let mut bytes = Bytes::new(data);
    let (header, seed) = (bytes.byte(), bytes.number());
    let pieces = tangle(&bytes.loops());
    let map = match header % 16 {
        0..=3 => arrange(&pieces),
        n => {
            let size = 10_f64.powi(-i32::from(n));
            arrange_with(&pieces, &Liar { honest: FloatModule::new(1.0), size: size.max(1e-16), seed })
        }
    };
    assert_consistent(&map);
    map.graph.points.len()
}

/// # Panics
/// Unless Euler's formula and all winding numbers hold.
pub fn assert_consistent(map: &Arrangement) {
    let euler = map.graph.euler();
    assert!(euler.holds(), "{euler:?}");
    assert_eq!(map.graph.winding_conflicts, 0);
    assert!(map.graph.edges.iter().all(|e| e.to != u32::MAX));
}
