//! Faces under construction: one a gap of the status, merged where gaps turn out to be the same cell (memo C3).

/// A disjoint-set forest of faces with their winding numbers. Face 0 is the one far away.
#[derive(Clone, Debug)]
pub struct Faces {
    parent: Vec<u32>,
    windings: Vec<[i32; 2]>,
    conflicts: usize,
}

impl Faces {
    /// The face far away, with its winding numbers.
    #[must_use]
    pub fn new(base: [i32; 2]) -> Self {
        Self { parent: vec![0], windings: vec![base], conflicts: 0 }
    }

    /// A new face.
    pub fn add(&mut self, winding: [i32; 2]) -> u32 {
        self.parent.push(self.parent.len() as u32);
        self.windings.push(winding);
        (self.parent.len() - 1) as u32
    }

    /// Winding numbers of a face.
    #[must_use]
    pub fn winding(&self, face: u32) -> [i32; 2] {
        self.windings[face as usize]
    }

    /// Asserts that a gap with these winding numbers belongs to a face. A conflict means that the pieces were not closed;
    /// it is counted, not thrown.
    pub fn expect(&mut self, face: u32, winding: [i32; 2]) {
        self.conflicts += usize::from(self.winding(face) != winding);
    }

    /// Joins two faces, which must agree in their winding numbers.
    pub fn join(&mut self, f: u32, g: u32) {
        self.expect(f, self.winding(g));
        let (f, g) = (self.root(f), self.root(g));
        // The least face leads, so that the one far away keeps its number.
        self.parent[f.max(g) as usize] = f.min(g);
    }

    fn root(&mut self, mut face: u32) -> u32 {
        while self.parent[face as usize] != face {
            let up = self.parent[face as usize];
            self.parent[face as usize] = self.parent[up as usize];
            face = up;
        }
        face
    }

    /// Numbers the faces without gaps. Returns the new number of every old face, the winding numbers by new number, and how
    /// many assertions failed.
    #[must_use]
    pub fn finish(mut self) -> (Vec<u32>, Vec<[i32; 2]>, usize) {
        let mut number = vec![u32::MAX; self.parent.len()];
        let mut windings = Vec::new();
        for face in 0..self.parent.len() {
            let root = self.root(face as u32) as usize;
            if number[root] == u32::MAX {
                number[root] = windings.len() as u32;
                windings.push(self.windings[root]);
            }
            number[face] = number[root];
        }
        (number, windings, self.conflicts)
    }
}
