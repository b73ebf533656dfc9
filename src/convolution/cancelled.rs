//! What cancels: the stretches of crusts that lie on moved boundaries, by what they are sums of (memo E4).

use super::sums::Summand;
use rustc_hash::FxHashMap as HashMap;

/// A part of a crust, from left to right.
#[derive(Clone, Copy, Debug)]
pub struct Stretch {
    /// Its ends, vertices.
    pub ends: [u32; 2],
    /// The next one to the right with the same summands.
    pub next: Option<u32>,
}

/// Stretches with the same summands are linked from left to right, as they are added.
#[derive(Clone, Debug, Default)]
pub struct Cancelled {
    /// All of them.
    pub stretches: Vec<Stretch>,
    /// The first and the last with each pair of summands.
    ends: HashMap<[Summand; 2], [u32; 2]>,
}

impl Cancelled {
    /// Adds a stretch to the right of all with the same summands.
    pub fn push(&mut self, summands: [Summand; 2], ends: [u32; 2]) {
        let index = self.stretches.len() as u32;
        self.stretches.push(Stretch { ends, next: None });
        let [_, last] = self.ends.entry(summands).or_insert([index; 2]);
        if *last != index {
            self.stretches[*last as usize].next = Some(index);
            *last = index;
        }
    }

    /// The first stretch with these summands.
    #[must_use]
    pub fn first(&self, summands: &[Summand; 2]) -> Option<u32> {
        self.ends.get(summands).map(|[first, _]| *first)
    }
}
