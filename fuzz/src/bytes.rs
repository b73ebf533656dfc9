//! Numbers and shapes out of a fuzzer's bytes. Short input gives zeros, so every input means something.

use arcsum::region::{Curve, Node, Region};
use glam::DVec2;

/// A cursor over the bytes of an input.
pub struct Bytes<'a> {
    data: &'a [u8],
}

/// How coordinates are made.
#[derive(Clone, Copy, Debug)]
enum Scale {
    /// Small integers: full of coincidences.
    Grid,
    /// Small integers moved by units in the last place.
    Nudged,
    /// Anywhere in the unit box.
    Fine,
    /// Any finite double.
    Wild,
}

impl<'a> Bytes<'a> {
    /// A cursor at the start.
    #[must_use]
    pub fn new(data: &'a [u8]) -> Self {
        Self { data }
    }

    /// The next byte.
    pub fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.data.split_first() else { return 0 };
        self.data = rest;
        first
    }

    fn word(&mut self) -> u16 {
        u16::from_le_bytes([self.byte(), self.byte()])
    }

    /// Eight bytes as a number.
    pub fn number(&mut self) -> u64 {
        (0..8).fold(0, |n, i| n | u64::from(self.byte()) << (8 * i))
    }

    fn scale(&mut self) -> Scale {
        match self.byte() % 8 {
            0..=2 => Scale::Grid,
            3 | 4 => Scale::Nudged,
            5 | 6 => Scale::Fine,
            _ => Scale::Wild,
        }
    }

    fn coordinate(&mut self, scale: Scale) -> f64 {
        match scale {
            Scale::Grid => f64::from(self.byte() % 16) - 8.0,
            Scale::Nudged => {
                let byte = self.byte();
                let x = f64::from(byte % 8) - 3.5;
                x + f64::from(byte / 32) * (x.abs().next_up() - x.abs())
            }
            Scale::Fine => f64::from(self.word()) / 65536.0 - 0.5,
            Scale::Wild => Some(f64::from_bits(self.number())).filter(|x| x.is_finite()).unwrap_or(0.0),
        }
    }

    /// Up to four closed loops of up to ten points each.
    pub fn loops(&mut self) -> Vec<Vec<DVec2>> {
        let scale = match self.scale() {
            Scale::Wild => Scale::Fine,
            tame => tame,
        };
        let point = |bytes: &mut Self| DVec2::new(bytes.coordinate(scale), bytes.coordinate(scale));
        let count = 1 + self.byte() % 4;
        (0..count).map(|_| (0..3 + self.byte() % 8).map(|_| point(self)).collect()).collect()
    }

    /// A region of up to three loops, valid or not.
    pub fn region(&mut self) -> Region {
        let scale = self.scale();
        let header = self.byte();
        let mut loops: Vec<Vec<Node>> =
            (0..header % 4).map(|_| (0..2 + self.byte() % 8).map(|_| self.node(scale)).collect()).collect();
        if header & 64 != 0 {
            loops.iter_mut().for_each(|l| sort_around(l));
        }
        Region { name: None, loops, unbounded: header & 128 != 0 }
    }

    fn node(&mut self, scale: Scale) -> Node {
        let (x, y) = (self.coordinate(scale), self.coordinate(scale));
        let curve = match self.byte() {
            kind @ 0..=127 if kind < 96 => Curve::Line,
            96..=111 => {
                Curve::Bulge([1.0, -1.0, 0.414_213_562_373_095, -0.414_213_562_373_095][usize::from(self.byte() % 4)])
            }
            112..=175 => Curve::Bulge((f64::from(self.byte()) - 127.5) / 64.0),
            176..=223 => Curve::Radius(self.coordinate(scale)),
            _ => Curve::Bulge(self.coordinate(Scale::Wild)),
        };
        Node { x, y, curve }
    }
}

/// Sorts vertices by their direction from their mean, which makes most loops simple.
fn sort_around(nodes: &mut [Node]) {
    let n = nodes.len() as f64;
    let mean = nodes.iter().fold(DVec2::ZERO, |sum, node| sum + DVec2::new(node.x, node.y) / n);
    nodes.sort_by(|p, q| f64::total_cmp(&(p.y - mean.y).atan2(p.x - mean.x), &(q.y - mean.y).atan2(q.x - mean.x)));
}
