//! The JSON format of regions (design of the file formats):
//!
//! ```json
//! {"name": "...", "loops": [[{"x": 0, "y": 0, "bulge": 0}]], "unbounded": false}
//! ```
//!
//! with `radius` in place of `bulge` where the curve is given by its signed radius, and neither for a line. Unknown keys
//! are ignored, repeated ones refused. Numbers are written as the shortest decimal that reads back to the same double.

use super::FormatError;
use crate::region::{Curve, Node, Region};
use crate::validate::MAX_VERTICES;
use serde_json::error::Category;
use std::fmt::Write;

/// Reads a region. Needs no more stack for deeply nested text: ignored values are skipped without recursion.
pub fn read(text: &str) -> Result<Region, FormatError> {
    let region: Region = serde_json::from_str(text).map_err(|e| locate(&e))?;
    match region.segments() {
        vertices if vertices > MAX_VERTICES => Err(FormatError::TooLarge { vertices }),
        _ => Ok(region),
    }
}

/// Writes a region, one vertex a line. A number that is not finite, which JSON cannot express, comes out as 1e999: still
/// JSON, and refused by every reader of doubles.
#[must_use]
pub fn write(region: &Region) -> String {
    let mut out = String::from("{");
    if let Some(name) = &region.name {
        // Through a value, because only that cannot fail.
        write_to(&mut out, format_args!("\"name\": {}, ", serde_json::Value::from(name.as_str())));
    }
    out.push_str("\"loops\": [");
    for (i, nodes) in region.loops.iter().enumerate() {
        out.push_str(if i == 0 { "\n[" } else { ",\n[" });
        for (j, node) in nodes.iter().enumerate() {
            out.push_str(if j == 0 { "" } else { ",\n " });
            write_node(&mut out, node);
        }
        out.push(']');
    }
    write_to(&mut out, format_args!("], \"unbounded\": {}}}\n", region.unbounded));
    out
}

fn write_node(out: &mut String, node: &Node) {
    write_to(out, format_args!("{{\"x\": {}, \"y\": {}", number(node.x), number(node.y)));
    match node.curve {
        Curve::Line => {}
        Curve::Bulge(bulge) => write_to(out, format_args!(", \"bulge\": {}", number(bulge))),
        Curve::Radius(radius) => write_to(out, format_args!(", \"radius\": {}", number(radius))),
    }
    out.push('}');
}

fn write_to(out: &mut String, text: std::fmt::Arguments<'_>) {
    out.write_fmt(text).expect("a String takes everything");
}

/// The shortest decimal that reads back to the same double, with an exponent where plain digits would be mostly zeros.
#[must_use]
pub fn number(value: f64) -> String {
    if !value.is_finite() {
        return "1e999".into();
    }
    match value.abs() {
        0.0 | 1e-5..1e17 => value.to_string(),
        _ => format!("{value:e}"),
    }
}

/// Our error for an error of the JSON crate, which appends the place to its message.
fn locate(error: &serde_json::Error) -> FormatError {
    let (line, column) = (error.line(), error.column());
    let text = error.to_string();
    let reason = text.strip_suffix(&format!(" at line {line} column {column}")).unwrap_or(&text).to_owned();
    match error.classify() {
        // The crate has no code for this error; a test pins its wording.
        Category::Syntax if reason == "number out of range" => FormatError::NotFinite { line, column },
        Category::Data => FormatError::Content { line, column, reason },
        Category::Syntax | Category::Eof | Category::Io => FormatError::Syntax { line, column, reason },
    }
}
