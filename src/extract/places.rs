//! Places: the vertices of a planar map told apart by their coordinates, as what is extracted from it will be.

use crate::arrangement::curve::compare;
use glam::DVec2;

/// The place of each vertex.
pub struct Places {
    of: Vec<u32>,
}

impl Places {
    /// Those of some vertices. They come nearly in order, so sorting them takes little more than looking at them.
    pub fn new(points: &[DVec2]) -> Self {
        let mut order: Vec<u32> = (0..points.len() as u32).collect();
        order.sort_by(|i, j| compare(points[*i as usize], points[*j as usize]));
        let mut of = vec![0; points.len()];
        for same in order.chunk_by(|i, j| compare(points[*i as usize], points[*j as usize]).is_eq()) {
            same.iter().for_each(|vertex| of[*vertex as usize] = same[0]);
        }
        Self { of }
    }

    /// The place of a vertex: the first vertex with its coordinates.
    pub fn of(&self, vertex: u32) -> u32 {
        self.of[vertex as usize]
    }

    /// How many vertices there are, a bound for places.
    pub fn count(&self) -> usize {
        self.of.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_coordinates_share_a_place() {
        let points = [(1.0, 0.0), (1.0, 2.0), (1.0, 1.0), (1.0, 2.0), (0.0, 0.0), (1.0, 0.0)];
        let places = Places::new(&points.map(DVec2::from));
        assert_eq!(places.of, [0, 1, 2, 1, 4, 0]);
        assert_eq!(places.count(), 6);
    }
}
