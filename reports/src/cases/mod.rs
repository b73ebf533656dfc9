//! Cases: two regions to be summed, where they come from, and what they are called.
//!
//! A case comes from files, from a folder of files, or from a built-in family of the memo (G, J5). Built-in cases depend
//! on the seed and on nothing else.

pub mod combs;
pub mod family;
pub mod fig8;
pub mod files;
pub mod folder;
pub mod fork;
pub mod gear;
pub mod hard;
pub mod many;
pub mod orthogonal;
pub mod pairs;
pub mod partner;
pub mod parts;
pub mod passage;
pub mod place;
pub mod radial;
pub mod rng;
pub mod shape;
pub mod source;
pub mod twoopt;

use arcsum::region::Region;
use serde::{Deserialize, Serialize};

/// Two regions whose sum an engine is asked for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Case {
    /// Unique within a run.
    pub name: String,
    /// The built-in family, or the folder the regions were read from.
    pub family: String,
    /// First operand, in input units.
    pub a: Region,
    /// Second operand.
    pub b: Region,
    /// The seed of a built-in case; none for regions from files.
    pub seed: Option<u64>,
    /// What somebody else claims the outer boundary of the sum to be, up to a translation; mostly empty.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub golden: Option<Golden>,
}

/// Somebody else's no-fit polygon of the two parts A and -B of a case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Golden {
    /// The loops as printed, outer boundary and others.
    pub region: Region,
    /// The point of the moving part that traces the boundary, in input units: A + (-B) shifted by it is the claim.
    pub shift: [f64; 2],
}

impl Case {
    /// The segments of both operands.
    #[must_use]
    pub fn segments(&self) -> usize {
        self.a.segments() + self.b.segments()
    }

    /// Whether both operands are polygons.
    #[must_use]
    pub fn is_polygonal(&self) -> bool {
        self.a.is_polygonal() && self.b.is_polygonal()
    }
}
