//! The reader and the validator of regions, on any bytes.

use arcsum::format::{FormatError, json};
use arcsum::region::{Curve, Region};
use arcsum::validate::validate;

/// Reads and validates, and returns the kind of the outcome: `valid`, the kind of an [`arcsum::validate::Invalid`], or
/// what the reader refused. Never panics unless a region that is read is not written and read back bit by bit.
pub fn region_json(data: &[u8]) -> &'static str {
    let Ok(text) = std::str::from_utf8(data) else { return "not text" };
    let region = match json::read(text) {
        Ok(region) => region,
        Err(error) => return refusal(&error),
    };
    let written = json::write(&region);
    let again = json::read(&written).expect("a region that was written is read");
    assert_eq!(bits(&region), bits(&again), "the region changed on the way through {written}");
    validate(&region).err().map_or("valid", |invalid| invalid.kind())
}

fn refusal(error: &FormatError) -> &'static str {
    match error {
        FormatError::Syntax { .. } => "syntax",
        FormatError::Content { .. } => "content",
        FormatError::NotFinite { .. } => "not finite",
        FormatError::TooLarge { .. } => "too large",
    }
}

/// All of a region, with numbers as their bits.
fn bits(region: &Region) -> (Option<&str>, bool, Vec<Vec<[u64; 4]>>) {
    let loops = region.loops.iter().map(|nodes| nodes.iter().map(|n| node_bits(n.x, n.y, n.curve)).collect());
    (region.name.as_deref(), region.unbounded, loops.collect())
}

fn node_bits(x: f64, y: f64, curve: Curve) -> [u64; 4] {
    let (kind, shape) = match curve {
        Curve::Line => (0, 0.0),
        Curve::Radius(radius) => (1, radius),
        Curve::Bulge(bulge) => (2, bulge),
    };
    [x.to_bits(), y.to_bits(), kind, shape.to_bits()]
}
