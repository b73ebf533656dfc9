//! Target `sum`: two regions, valid or not, give a finite region or an error, and their arrangement is consistent.

use crate::arrangement::assert_consistent;
use crate::bytes::Bytes;
use arcsum::boolean::{Operation, combine};
use arcsum::region::{Curve, Region};
use arcsum::sum::{Convolution, Options, sum};

/// Sums and combines the regions that the bytes describe. Returns the number of loops of the
/// sums by both convolutions.
///
/// # Panics
/// If a result is not finite or an arrangement not consistent: that is the find.
pub fn sum_of_bytes(data: &[u8]) -> Option<usize> {
    let mut bytes = Bytes::new(data);
    let (a, b) = (bytes.region(), bytes.region());
    for operation in [Operation::Union, Operation::Intersection, Operation::Difference, Operation::SymmetricDifference]
    {
        if let Ok(region) = combine(operation, &a, &b) {
            assert_finite(&region);
        }
    }
    let mut loops = 0;
    for convolution in [Convolution::Kinetic, Convolution::Monotonic] {
        let sum = sum(&a, &b, &Options { convolution, ..Options::default() }).ok()?;
        assert_consistent(&sum.arrangement);
        assert_finite(&sum.region);
        loops += sum.region.loops.len();
    }
    Some(loops)
}

fn assert_finite(region: &Region) {
    for node in region.loops.iter().flatten() {
        let curve = match node.curve {
            Curve::Line => 0.0,
            Curve::Bulge(x) | Curve::Radius(x) => x,
        };
        assert!(node.x.is_finite() && node.y.is_finite() && curve.is_finite(), "{node:?}");
    }
}
