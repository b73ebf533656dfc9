//! The built-in families by name (memo G, J5), their sizes, and the cases they consist of.

use super::combs::{comb_and_polygon, combs};
use super::fig8::fig8;
use super::orthogonal::{Corners, Style, cells};
use super::partner::partners;
use super::passage::{self, Fit};
use super::place::turned;
use super::radial::{self, Bending, bulging};
use super::rng::Rng;
use super::shape::disc;
use super::{Case, fork, gear, many, parts, twoopt};
use arcsum::region::Region;

/// A pair of operands with the end of the case's name (empty when a size has but one).
type Pair = (String, Region, Region);

/// A family of cases of growing size.
pub struct Family {
    /// The name on the command line.
    pub name: &'static str,
    /// What it is for, in a line.
    pub about: &'static str,
    /// The sizes of the quick run; other sizes can be asked for by `name_size`.
    pub sizes: &'static [u32],
    /// How many cases are drawn for a size; 1 where nothing is random.
    pub draws: u32,
    pairs: fn(u32, &mut Rng) -> Vec<Pair>,
}

/// All families, in the order of a run.
pub const FAMILIES: &[Family] = &[
    Family {
        name: "parts",
        about: "the nine parts 1a to 5, axis-aligned and turned, with their negatives and discs",
        sizes: &[1, 2, 3, 4, 5, 6, 7, 8, 9],
        draws: 1,
        pairs: |size, rng| part_pairs(size, rng),
    },
    Family {
        name: "fork",
        about: "coarse and fine teeth whose sum has (p^2-1)^2 grid holes",
        sizes: &[1, 2, 3, 4, 6, 8],
        draws: 1,
        pairs: |p, _| one(fork::fork(p)),
    },
    Family {
        name: "covered",
        about: "forks with thin triangles whose sum covers the grid",
        sizes: &[2, 4],
        draws: 1,
        pairs: |p, _| one(fork::covered(p)),
    },
    Family {
        name: "combs",
        about: "two combs at right angles",
        sizes: &[2, 5, 10, 40],
        draws: 1,
        pairs: |n, _| one(combs(n)),
    },
    Family {
        name: "comb_polygon",
        about: "a comb of alternating teeth against an octagon and a 32-gon",
        sizes: &[5, 20, 100],
        draws: 1,
        pairs: |n, _| {
            [8, 32]
                .map(|k| comb_and_polygon(n, k))
                .into_iter()
                .zip(["8", "32"])
                .map(|((a, b), k)| (k.to_owned(), a, b))
                .collect()
        },
    },
    Family {
        name: "star",
        about: "two stars with jitter",
        sizes: &[5, 10, 20, 30],
        draws: 2,
        pairs: |n, rng| one(radial::stars(n, rng)),
    },
    Family {
        name: "radial",
        about: "two polygons with noisy radii",
        sizes: &[10, 20, 40, 100],
        draws: 2,
        pairs: |n, rng| one(radial::noisy(n, rng)),
    },
    Family {
        name: "twoopt",
        about: "two random simple polygons, untangled by 2-opt",
        sizes: &[5, 10, 20, 40, 100, 200],
        draws: 3,
        pairs: |n, rng| one((twoopt::simple(n, rng), twoopt::simple(n, rng))),
    },
    Family {
        name: "twoopt_small",
        about: "a random simple polygon of n vertices and one of 5",
        sizes: &[50, 100, 200],
        draws: 2,
        pairs: |n, rng| one((twoopt::simple(n, rng), twoopt::simple(5, rng))),
    },
    Family {
        name: "orthogonal",
        about: "random orthogonal polygons of n cells on small grids",
        sizes: &[6, 20, 40, 150],
        draws: 3,
        pairs: |n, rng| one(cell_pair(n, Corners::Sharp, false, rng)),
    },
    Family {
        name: "holed",
        about: "cells with holes and vertices between collinear edges",
        sizes: &[12, 24, 40, 100],
        draws: 3,
        pairs: |n, rng| one(cell_pair(n, Corners::Sharp, true, rng)),
    },
    Family {
        name: "chamfered",
        about: "cells with 45-degree corners, with and without holes",
        sizes: &[6, 20, 30, 80],
        draws: 3,
        pairs: |n, rng| {
            let holes = rng.below(2) == 0;
            one(cell_pair(n, Corners::Chamfered, holes, rng))
        },
    },
    Family {
        name: "fat_grid",
        about: "upright and level bars whose sums cross",
        sizes: &[1, 2, 3, 6],
        draws: 1,
        pairs: |p, _| one(many::fat_grid(p)),
    },
    Family {
        name: "robot",
        about: "a star-shaped robot among convex obstacles",
        sizes: &[2, 3, 4, 6],
        draws: 2,
        pairs: |p, rng| one(many::robot(p, rng)),
    },
    Family {
        name: "islands",
        about: "islands with lakes: several components with holes",
        sizes: &[1, 2, 3],
        draws: 2,
        pairs: |p, rng| one(many::islands(p, rng)),
    },
    Family {
        name: "passage",
        about: "a corridor as wide as the robot, or 2^-k more or less",
        sizes: &[0, 20, 40, 50],
        draws: 1,
        pairs: |k, _| passages(k),
    },
    Family {
        name: "container",
        about: "the plane without a box, and a part that fits exactly, loosely or not (size in percent)",
        sizes: &[80, 100, 150],
        draws: 3,
        pairs: |percent, rng| one(passage::container(f64::from(percent) / 100.0, rng)),
    },
    Family {
        name: "fig8",
        about: "a convex part in a convex container of as many corners",
        sizes: &[8, 16, 32, 64, 128, 256],
        draws: 1,
        pairs: |n, _| one(fig8(n)),
    },
    Family {
        name: "far",
        about: "one operand 2^k from the origin",
        sizes: &[0, 10, 20, 30, 40],
        draws: 1,
        pairs: |k, rng| one(passage::far(k, rng)),
    },
    Family {
        name: "nearly",
        about: "a 24-gon against its mirror image turned by 2^-k",
        sizes: &[10, 26, 40, 50],
        draws: 1,
        pairs: |k, _| one(passage::nearly(k)),
    },
    Family {
        name: "tiny",
        about: "a polygon against one 2^-k its size",
        sizes: &[5, 20, 40],
        draws: 1,
        pairs: |k, rng| one(passage::tiny(k, rng)),
    },
    Family {
        name: "arcs",
        about: "circle segments that bulge out and in by turns",
        sizes: &[8, 32],
        draws: 1,
        pairs: |n, rng| one((bulging(n, Bending::InTurn, rng), bulging(n, Bending::InTurn, rng))),
    },
    Family {
        name: "bulges",
        about: "circle segments that all bulge out",
        sizes: &[8, 32],
        draws: 1,
        pairs: |n, rng| one((bulging(n, Bending::Out, rng), bulging(n, Bending::Out, rng))),
    },
    Family {
        name: "gear",
        about: "two gears with rounded teeth, n/4 of them",
        sizes: &[12, 32],
        draws: 1,
        pairs: |n, rng| one((gear::gear(n, rng), gear::gear(n, rng))),
    },
    Family {
        name: "offset",
        about: "a polygon, arcs, and arcs with a hole, of n segments, and a disc",
        sizes: &[16, 32],
        draws: 1,
        pairs: |n, rng| gear::to_offset(n, rng).into_iter().map(|(end, a)| (end.into(), a, disc(0.1))).collect(),
    },
    Family {
        name: "mixed",
        about: "lines and circle segments at random, with their negatives and discs",
        sizes: &[5, 12, 24],
        draws: 1,
        pairs: |n, rng| with_partners("", &bulging(n, Bending::AtRandom, rng)),
    },
    Family {
        name: "rounded",
        about: "cells with quarter circles for corners: tangent arcs on a grid",
        sizes: &[4, 10],
        draws: 2,
        pairs: |n, rng| {
            let one = rounded(n, rng);
            let mut pairs = with_partners("", &one);
            pairs.push(("other".into(), one, rounded(n / 2 + 1, rng)));
            pairs
        },
    },
];

impl Family {
    /// The family of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<&'static Self> {
        FAMILIES.iter().find(|f| f.name == name)
    }

    /// The cases of the quick run.
    #[must_use]
    pub fn cases(&self, seed: u64) -> Vec<Case> {
        self.sizes.iter().flat_map(|&size| self.cases_of_size(size, seed)).collect()
    }

    /// The cases of one size: `name_size`, then the draw, then what the pair is.
    #[must_use]
    pub fn cases_of_size(&self, size: u32, seed: u64) -> Vec<Case> {
        (0..self.draws).flat_map(|draw| self.draw(size, draw, seed)).collect()
    }

    /// The cases of the first draw of a size.
    #[must_use]
    pub fn first_of_size(&self, size: u32, seed: u64) -> Vec<Case> {
        self.draw(size, 0, seed)
    }

    fn draw(&self, size: u32, draw: u32, seed: u64) -> Vec<Case> {
        let base = if self.draws == 1 {
            format!("{}_{size}", self.name)
        } else {
            format!("{}_{size}_{}", self.name, draw + 1)
        };
        let mut rng = Rng::new(seed, &base);
        let case = |(end, a, b): Pair| Case {
            name: if end.is_empty() { base.clone() } else { format!("{base}_{end}") },
            family: self.name.to_owned(),
            a,
            b,
            seed: Some(seed),
            golden: None,
        };
        (self.pairs)(size, &mut rng).into_iter().map(case).collect()
    }
}

fn one((a, b): (Region, Region)) -> Vec<Pair> {
    vec![(String::new(), a, b)]
}

/// The region with each of its partners, labelled with what it is.
fn with_partners(label: &str, region: &Region) -> Vec<Pair> {
    let pair = |(end, partner): (&str, Region)| {
        let name = if label.is_empty() { end.to_owned() } else { format!("{label}_{end}") };
        (name, region.clone(), partner)
    };
    partners(region).into_iter().map(pair).collect()
}

/// Part `size` (1 to 9), axis-aligned and turned by a random angle.
fn part_pairs(size: u32, rng: &mut Rng) -> Vec<Pair> {
    let Some(name) = parts::NAMES.get((size as usize).wrapping_sub(1)) else { return Vec::new() };
    let Some(part) = parts::part(name) else { return Vec::new() };
    let other = turned(&part, rng.angle());
    let mut pairs = with_partners(&format!("{name}_axis"), &part);
    pairs.extend(with_partners(&format!("{name}_turned"), &other));
    pairs
}

/// Two cell regions: one of n cells on a grid about two thirds full, one of half as many.
fn cell_pair(n: u32, corners: Corners, holes: bool, rng: &mut Rng) -> (Region, Region) {
    let style = |cells: usize| {
        let side = libm::ceil(libm::sqrt(1.5 * cells as f64)) as i32;
        Style { side, cells, holes, collinear: holes, corners }
    };
    let a = cells(style(n as usize), rng);
    (a, cells(style(n as usize / 2 + 1), rng))
}

fn rounded(n: u32, rng: &mut Rng) -> Region {
    cell_pair(n, Corners::Rounded, false, rng).0
}

fn passages(k: u32) -> Vec<Pair> {
    let pair = |name: &str, fit| {
        let (a, b) = passage::passage(fit);
        (name.to_owned(), a, b)
    };
    if k == 0 {
        return vec![pair("exact", Fit::Exact)];
    }
    vec![pair("wider", Fit::Wider(k)), pair("narrower", Fit::Narrower(k))]
}
