//! Planar regions as they come and go: loops of lines and circle segments (MS 2, design of the file formats).
//!
//! A [`Region`] is plain data. It says nothing about validity: [`crate::validate`] does.

use serde::de::value::MapAccessDeserializer;
use serde::de::{Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;

/// How the boundary runs from one vertex to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// A straight line.
    Line,
    /// A circle segment of at most 180 degrees with this signed radius in input units: positive when the
    /// centre lies to the left (convex), negative when it lies to the right (concave).
    Radius(f64),
    /// A circle segment with this bulge, tan(sweep/4): positive counter-clockwise, 1 a half circle.
    Bulge(f64),
}

/// A vertex, in input units, and the curve that leaves it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(into = "NodeRepr")]
pub struct Node {
    /// Abscissa.
    pub x: f64,
    /// Ordinate.
    pub y: f64,
    /// The curve to the next vertex of the loop.
    pub curve: Curve,
}

/// A closed set bounded by loops with the interior on the left: outer loops counter-clockwise, holes clockwise.
///
/// The last vertex of a loop is joined to the first. With `unbounded` the set also contains everything far away,
/// as complements do.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(remote = "Self")]
pub struct Region {
    /// A name for people; not part of the shape.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// The boundary, in any order.
    pub loops: Vec<Vec<Node>>,
    /// Whether the region contains all points far away.
    #[serde(default)]
    pub unbounded: bool,
}

impl Node {
    /// A vertex followed by a line.
    #[must_use]
    pub fn line(x: f64, y: f64) -> Self {
        Self { x, y, curve: Curve::Line }
    }
}

impl Curve {
    /// The same curve traversed from head to tail.
    #[must_use]
    pub fn reversed(self) -> Self {
        match self {
            Self::Line => Self::Line,
            Self::Radius(r) => Self::Radius(-r),
            Self::Bulge(b) => Self::Bulge(-b),
        }
    }
}

impl Region {
    /// The whole plane.
    #[must_use]
    pub fn plane() -> Self {
        Self { unbounded: true, ..Self::default() }
    }

    /// The region mirrored in the origin, -A. Exact: coordinates are negated, the order of the vertices is kept
    /// because a rotation by 180 degrees preserves orientation.
    #[must_use]
    pub fn negated(&self) -> Self {
        let flip = |n: &Node| Node { x: -n.x, y: -n.y, curve: n.curve };
        Self {
            name: self.name.as_ref().map(|n| format!("-{n}")),
            loops: self.loops.iter().map(|l| l.iter().map(flip).collect()).collect(),
            unbounded: self.unbounded,
        }
    }

    /// The closure of the complement: every loop reversed, `unbounded` flipped. Exact.
    #[must_use]
    pub fn complement(&self) -> Self {
        Self { name: None, loops: self.loops.iter().map(|l| reversed(l)).collect(), unbounded: !self.unbounded }
    }

    /// The number of lines and circle segments.
    #[must_use]
    pub fn segments(&self) -> usize {
        self.loops.iter().map(Vec::len).sum()
    }

    /// Whether every curve is a line.
    #[must_use]
    pub fn is_polygonal(&self) -> bool {
        self.loops.iter().flatten().all(|n| n.curve == Curve::Line)
    }
}

fn reversed(nodes: &[Node]) -> Vec<Node> {
    let n = nodes.len();
    // Walking backwards, the curve that leaves vertex i is the one that entered it.
    (0..n).rev().map(|i| Node { curve: nodes[(i + n - 1) % n].curve.reversed(), ..nodes[i] }).collect()
}

/// A vertex as the JSON format has it: `bulge` or `radius`, or neither for a line.
#[derive(Serialize, Deserialize)]
struct NodeRepr {
    x: f64,
    y: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    bulge: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    radius: Option<f64>,
}

// What serde derives takes a list for a struct, so that a point [x, y, z] would come out as a vertex whose bulge is z.
// These visitors take a map alone.
struct NodeVisitor;

impl<'de> Visitor<'de> for NodeVisitor {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(r#"a vertex, {"x": ..., "y": ...}"#)
    }

    fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<Node, M::Error> {
        let repr = NodeRepr::deserialize(MapAccessDeserializer::new(map))?;
        Node::try_from(repr).map_err(M::Error::custom)
    }
}

impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(NodeVisitor)
    }
}

struct RegionVisitor;

impl<'de> Visitor<'de> for RegionVisitor {
    type Value = Region;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(r#"a region, {"loops": ...}"#)
    }

    fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<Region, M::Error> {
        // The derived function, which `remote` keeps apart from the trait's.
        Region::deserialize(MapAccessDeserializer::new(map))
    }
}

impl<'de> Deserialize<'de> for Region {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(RegionVisitor)
    }
}

impl Serialize for Region {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Region::serialize(self, serializer)
    }
}

impl TryFrom<NodeRepr> for Node {
    type Error = &'static str;

    fn try_from(repr: NodeRepr) -> Result<Self, Self::Error> {
        let curve = match (repr.bulge, repr.radius) {
            (Some(_), Some(_)) => return Err("a vertex has both a bulge and a radius"),
            (Some(bulge), None) if bulge != 0.0 => Curve::Bulge(bulge),
            (None, Some(radius)) if radius != 0.0 => Curve::Radius(radius),
            _ => Curve::Line,
        };
        Ok(Self { x: repr.x, y: repr.y, curve })
    }
}

impl From<Node> for NodeRepr {
    fn from(node: Node) -> Self {
        let (bulge, radius) = match node.curve {
            Curve::Line => (None, None),
            Curve::Radius(r) => (None, Some(r)),
            Curve::Bulge(b) => (Some(b), None),
        };
        Self { x: node.x, y: node.y, bulge, radius }
    }
}
