//! M27: among segments that share no end, the sweep keeps rules 1 and 4 by accuracy alone, if the regions are 2 mu separated
//! (MS 7.1).

use super::chains::Ordered;
use super::swept::{Member, Swept};
use crate::cases::rng::Rng;
use crate::cases::shape::{Point, disc, polygon};
use crate::claims::control::Control;
use crate::claims::draw;
use crate::claims::finding::Measured;
use crate::claims::free::mu::Mu;
use crate::claims::input::Input;
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::kept;
use arcsum::robustness::Robustness;
use libm::exp2;

pub(super) fn claims() -> [Claim; 1] {
    let sup = Sup {
        quantity: "pairs of curves that the sweep has in the wrong order, over all slabs",
        unit: "1",
        rule: Rule::AtMost(0.0),
        draws: [120, 12_000],
        draw: walls,
        measure: |input| inversions(input, <[u32]>::to_vec),
        kept: kept!("M27"),
        control: Control::Measure {
            plants: "neighbours of each slab exchanged",
            measure: |input| inversions(input, exchanged),
        },
    };
    [Claim {
        id: "M27",
        place: "MS 7.1",
        says: "The sweep enforces rules 1 and 4 between chains that are not incident by its accuracy, if these are 2 mu apart.",
        erratum: "",
        test: Test::Sup(sup),
    }]
}

/// Neighbours exchanged two by two.
fn exchanged(status: &[u32]) -> Vec<u32> {
    status.chunks(2).flat_map(|pair| pair.iter().rev().copied()).collect()
}

/// A comb with gaps from a tenth of mu to thirty of it and its negative or a disc, or any pair.
fn walls(rng: &mut Rng, number: usize) -> Input {
    if number.is_multiple_of(3) {
        return draw::pair(rng, number);
    }
    let gap = 1e-15 * exp2(rng.between(-3.4, 5.0));
    let tilt = if rng.below(2) == 0 { 0.0 } else { rng.between(-0.4, 0.4) };
    let (teeth, mut y, mut points) = (2 + rng.below(2), 0.0, Vec::<Point>::new());
    let at = |x: f64, y: f64| [x, y + tilt * x];
    for tooth in 0..teeth {
        let (reach, height) = (rng.between(0.5, 1.0), rng.between(0.1, 0.4));
        points.extend([at(reach, y), at(reach, y + height)]);
        y += height;
        if tooth + 1 < teeth {
            points.extend([at(0.25, y), at(0.25, y + gap)]);
            y += gap;
        }
    }
    points.extend([at(0.0, y), at(0.0, 0.0)]);
    let comb = polygon(&points);
    let partner = if rng.below(2) == 0 { comb.negated() } else { disc(rng.between(0.05, 0.5)) };
    draw::input("walls", comb, partner)
}

/// Inversions among curves that share no end, in the order that `order` makes of that of each slab; none if the operands may
/// not be 2 mu separated.
fn inversions(input: &Input, order: fn(&[u32]) -> Vec<u32>) -> Option<Measured> {
    let case = input.as_pair()?;
    Mu::of(case).filter(|mu| mu.separates(case))?;
    let swept = Swept::new(case, Robustness::ALL)?;
    let chains = [0, 1].map(|operand| Ordered::new(&swept.regions[operand], &swept.chains[operand]));
    let mut found = 0;
    let mut last = f64::NEG_INFINITY;
    for (trapezoid, middle, status, _) in swept.middles() {
        // Trapezoids of one slab have the same curves.
        if trapezoid.from == last {
            continue;
        }
        last = trapezoid.from;
        let members: Vec<Member> = order(&status).iter().map(|curve| swept.member(*curve)).collect();
        let pairs = (0..members.len()).flat_map(|i| (i + 1..members.len()).map(move |j| [i, j]));
        found += pairs.filter(|[i, j]| is_below(&swept, &chains, members[*j], members[*i], middle.x)).count();
    }
    Some(Measured::count(found))
}

/// Whether rule 1 or 4, at chains that are not incident, says that the first is below the second.
fn is_below(swept: &Swept, chains: &[Ordered; 2], first: Member, second: Member, x: f64) -> bool {
    match (first, second) {
        (Member::Moved { operand, chain, turning, .. }, Member::Moved { operand: o, chain: other, turning: t, .. }) => {
            (operand, turning) == (o, t) && below(swept, chains, operand, [chain, other]) == Some(true)
        }
        (Member::Crust { upper: false, chains: lower }, Member::Crust { upper: true, chains: upper }) => {
            let pairs = [0, 1].map(|operand| below(swept, chains, operand, [lower[operand], upper[operand]]));
            // Chains that are incident are told by their related segments.
            pairs.iter().all(Option::is_some) && pairs.contains(&Some(true)) && reaches(chains, lower, upper, x)
        }
        _ => false,
    }
}

/// Whether one chain is below another: `Some(true)` if they are not incident, `Some(false)` if they are.
fn below(swept: &Swept, chains: &[Ordered; 2], operand: usize, [i, j]: [usize; 2]) -> Option<bool> {
    let ends = &swept.chains[operand].ends;
    let incident = ends[i].iter().any(|end| ends[j].contains(end));
    chains[operand].below.contains(&[i, j]).then_some(!incident)
}

/// Whether rule 4 reaches an abscissa (see M26).
fn reaches(chains: &[Ordered; 2], lower: [usize; 2], upper: [usize; 2], x: f64) -> bool {
    let common = [0, 1].map(|operand| {
        let [f, g] = [lower[operand], upper[operand]].map(|chain| chains[operand].graphs[chain].range);
        [f[0].max(g[0]), f[1].min(g[1])]
    });
    common[0][0] + common[1][0] < x && x < common[0][1] + common[1][1]
}
