//! M30 and M33: the relation of the chains of A and of t - B that the order of the sweep at t makes has no cycle (MS 7.2,
//! Lemmas 2 and 5).

use super::chains::Ordered;
use super::exact;
use super::swept::{Member, Swept};
use crate::cases::rng::Rng;
use crate::claims::control::Control;
use crate::claims::draw;
use crate::claims::finding::Measured;
use crate::claims::free::mu::Mu;
use crate::claims::input::Input;
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::kept;
use arcsum::robustness::{Robustness, Step};

/// The engine without the convolution order.
const UNORDERED: Robustness = Robustness::ALL.without(Step::OrderedSwaps).without(Step::OrderedInsertion);

/// What tells about the order of chains of A and of t - B.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Told {
    /// The crusts below and above t.
    Crusts,
    /// The same, but that upper crusts above t are taken for ones below.
    CrustsReversed,
    /// Moved chains, too.
    All,
}

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "middles t of free trapezoids at which the relation has a cycle",
        unit: "1",
        rule: Rule::AtMost(0.0),
        draws: [150, 15_000],
        draw: pair,
        measure: |input| cyclic(input, Robustness::ALL, Told::Crusts),
        kept: kept!("M30"),
        control: Control::Measure {
            plants: "upper crusts above t taken for ones below",
            measure: |input| cyclic(input, Robustness::ALL, Told::CrustsReversed),
        },
    };
    let second = Claim {
        id: "M30",
        place: "MS 7.2, Lemma 2",
        says: "The orders of the chains of A and of t - B, with those between them that the crusts below and above t tell, have \
               no cycle, for free t and 2 mu separated regions.",
        erratum: "The proof rests on rule 4 also where that does not hold (see M26). No cycle came of it.",
        test: Test::Sup(sup.clone()),
    };
    let fifth = Claim {
        id: "M33",
        place: "MS 7.2, Lemma 5",
        says: "With what the moved chains around t tell about concave turning points inside the other region, the relation of \
               chains still has no cycle.",
        erratum: "",
        test: Test::Sup(Sup {
            draw: draw::pair,
            measure: |input| cyclic(input, Robustness::ALL, Told::All),
            kept: kept!("M33"),
            control: Control::Measure {
                plants: "a sweep that does not know the convolution order",
                measure: |input| cyclic(input, UNORDERED, Told::All),
            },
            ..sup
        }),
    };
    [second, fifth]
}

/// Small pairs of any kind, and polygons on a lattice, whose crusts go on beyond shorter chains.
fn pair(rng: &mut Rng, number: usize) -> Input {
    if number.is_multiple_of(4) { exact::pair(rng, number / 4) } else { draw::pair(rng, number) }
}

/// How many free t have a cycle; none for regions that may not be 2 mu separated.
fn cyclic(input: &Input, robustness: Robustness, told: Told) -> Option<Measured> {
    let case = input.as_pair()?;
    let swept = Swept::new(case, robustness)?;
    if !Mu::of(case)?.separates(case) {
        return None;
    }
    let relation = Relation::new(&swept);
    let free = swept.middles().filter(|(trapezoid, ..)| swept.is_free(trapezoid.face));
    let cyclic = free.filter(|(_, _, curves, below)| relation.has_cycle(curves, *below, told));
    let mut spots = cyclic.map(|(_, middle, ..)| middle.to_array());
    let first = spots.next();
    let count = spots.count() + usize::from(first.is_some());
    Some(first.into_iter().fold(Measured::count(count), Measured::at))
}

/// The chains of A, then those of t - B, and which are below which.
struct Relation<'s> {
    swept: &'s Swept,
    /// Chains of A.
    first: usize,
    /// What does not depend on t.
    fixed: Vec<[usize; 2]>,
    nodes: usize,
}

impl<'s> Relation<'s> {
    fn new(swept: &'s Swept) -> Self {
        let [a, b] = [0, 1].map(|operand| Ordered::new(&swept.regions[operand], &swept.chains[operand]));
        let first = a.graphs.len();
        let turned = b.below.iter().map(|[lower, upper]| [first + upper, first + lower]);
        let fixed = a.below.iter().copied().chain(turned).collect();
        Self { swept, first, fixed, nodes: first + b.graphs.len() }
    }

    fn has_cycle(&self, curves: &[u32], below: usize, told: Told) -> bool {
        let mut pairs = self.fixed.clone();
        let members: Vec<Member> = curves.iter().map(|curve| self.swept.member(*curve)).collect();
        for (place, member) in members.iter().enumerate() {
            if let Member::Crust { upper, chains: [i, j] } = *member {
                let (own, partner) = (i, self.first + j);
                match (upper, (place < below) != (upper && told == Told::CrustsReversed)) {
                    // t above U1+U2, or below L1+L2.
                    (true, true) => pairs.push([own, partner]),
                    (false, false) => pairs.push([partner, own]),
                    _ => {}
                }
            }
        }
        if told == Told::All {
            self.extend(&members, below, &mut pairs);
        }
        !is_acyclic(self.nodes, pairs)
    }

    /// Adds what is told by turning points inside the other region: the chains moved by one that are next to t, a lower one
    /// below and an upper one above.
    fn extend(&self, members: &[Member], below: usize, pairs: &mut Vec<[usize; 2]>) {
        let near = |member: &Member, of: usize, by: usize| match *member {
            Member::Moved { upper, operand, chain, turning } if (operand, turning) == (of, by) => Some((upper, chain)),
            _ => None,
        };
        for operand in 0..2 {
            let other = 1 - operand;
            for (index, turning) in self.swept.chains[other].turnings.iter().enumerate().filter(|(_, t)| t.concave) {
                let under = members[..below].iter().rev().find_map(|member| near(member, operand, index));
                let over = members[below..].iter().find_map(|member| near(member, operand, index));
                let (Some((false, lower)), Some((true, upper))) = (under, over) else { continue };
                // The turning point, turned by half a turn where it is one of B, has its upper chain below its lower one.
                if operand == 0 {
                    pairs.push([lower, self.first + turning.lower]);
                    pairs.push([self.first + turning.upper, upper]);
                } else {
                    pairs.push([self.first + upper, turning.lower]);
                    pairs.push([turning.upper, self.first + lower]);
                }
            }
        }
    }
}

/// Whether a relation on so many nodes has no cycle: whether all can be taken away, each after what is below it.
fn is_acyclic(nodes: usize, mut pairs: Vec<[usize; 2]>) -> bool {
    let mut left: Vec<usize> = (0..nodes).collect();
    loop {
        let (blocked, gone): (Vec<_>, Vec<_>) =
            left.iter().copied().partition(|node| pairs.iter().any(|[_, upper]| upper == node));
        if gone.is_empty() {
            return blocked.is_empty();
        }
        pairs.retain(|[lower, _]| !gone.contains(lower));
        left = blocked;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cycles_are_seen() {
        assert!(is_acyclic(3, vec![[0, 1], [1, 2], [0, 2]]));
        assert!(!is_acyclic(4, vec![[0, 1], [1, 2], [2, 1], [2, 3]]));
        assert!(is_acyclic(0, Vec::new()));
    }
}
