//! M26: the four rules of the convolution order (MS 7.1; memo E6), on ordinates of polygons in rationals.

use super::exact::{between, excess, pair};
use crate::bridge::plain;
use crate::claims::control::Control;
use crate::claims::finding::Measured;
use crate::claims::input::Input;
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::kept;
use arcsum_oracle::chains::{Chain, Point, chains, convolved, extreme, rings};
use rug::Rational;

/// An interval of abscissas.
type Range = [Rational; 2];

/// A pair of chains of one region, the first below the second.
type Below<'c> = [&'c Chain; 2];

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "greatest height of the lower one above the upper one",
        unit: "input units",
        rule: Rule::AtMost(0.0),
        draws: [120, 12_000],
        draw: pair,
        measure: |input| measured(input, false),
        kept: kept!("M26_printed"),
        control: Control::Itself,
    };
    let printed = Claim {
        id: "M26 printed",
        place: "MS 7.1",
        says: "The order of chains carries over to their sums by four rules, each wherever both segments are: translation, \
               lower crusts below moved lower chains, moved upper chains below upper crusts, lower crusts below upper crusts.",
        erratum: "Rule 4 holds only where a point of both chains of one operand and a point of both of the other have the \
                  abscissa for sum, which its proof needs: as far as the shorter chains reach.",
        test: Test::Sup(sup.clone()),
    };
    let corrected = Claim {
        id: "M26 corrected",
        place: "MS 7.1",
        says: "The four rules hold, the fourth as far as the shorter chain of each pair reaches.",
        erratum: "",
        test: Test::Sup(Sup {
            measure: |input| measured(input, true),
            kept: kept!("M26_corrected"),
            control: Control::Claim("M26 printed"),
            ..sup
        }),
    };
    [printed, corrected]
}

/// How far any rule is broken at the tried abscissas, the fourth within its reach or wherever both crusts are.
fn measured(input: &Input, within_reach: bool) -> Option<Measured> {
    let case = input.as_pair().filter(|case| case.is_polygonal())?;
    let [a, b] = [&case.a, &case.b].map(|region| chains(&rings(&plain(region))[0]));
    let (below_a, below_b) = (ordered(&a), ordered(&b));
    let mut greatest = f64::NEG_INFINITY;
    let mut enter = |ordinates: Option<[Rational; 2]>| {
        greatest = ordinates.iter().map(excess).fold(greatest, f64::max);
    };
    for (p, q) in below_a.iter().flat_map(|p| below_b.iter().map(move |q| (p, q))) {
        fourth(*p, *q, within_reach).into_iter().for_each(|found| enter(Some(found)));
    }
    for (of, by, pairs) in [(&a, &b, &below_a), (&b, &a, &below_b)] {
        first(pairs, by).into_iter().chain(second_and_third(of, by)).for_each(|found| enter(Some(found)));
    }
    Some(Measured::exactly(greatest)).filter(|_| greatest > f64::NEG_INFINITY)
}

/// The abscissas of a chain.
fn domain(chain: &Chain) -> Range {
    let xs = || chain.path.iter().map(|p| &p[0]);
    [xs().min().expect("vertices").clone(), xs().max().expect("vertices").clone()]
}

/// What two intervals have in common, if that is an interval.
fn common(a: &Range, b: &Range) -> Option<Range> {
    let both = [(&a[0]).max(&b[0]).clone(), (&a[1]).min(&b[1]).clone()];
    (both[0] < both[1]).then_some(both)
}

fn plus(a: &Range, b: &Range) -> Range {
    [0, 1].map(|i| Rational::from(&a[i] + &b[i]))
}

/// The pairs of chains with a common abscissa, by their order: they do not cross, so one abscissa tells.
fn ordered(chains: &[Chain]) -> Vec<Below<'_>> {
    let mut found = Vec::new();
    for (i, f) in chains.iter().enumerate() {
        for g in &chains[i + 1..] {
            let Some(range) = common(&domain(f), &domain(g)) else { continue };
            let x = Rational::from(&range[0] + &range[1]) / 2;
            let [y, z] = [f, g].map(|chain| extreme(&chain.path, &x, chain.upper).expect("in the domain"));
            if y != z {
                found.push(if y < z { [f, g] } else { [g, f] });
            }
        }
    }
    found
}

/// Rule 1 at a vertex of the other region: V+p <= W+p.
fn first(pairs: &[Below], by: &[Chain]) -> Vec<[Rational; 2]> {
    let mut found = Vec::new();
    for [v, w] in pairs {
        let Some(range) = common(&domain(v), &domain(w)) else { continue };
        for x in between([&range[0], &range[1]]) {
            let p = &by[0].path[0];
            let moved = |chain: &Chain| Some(extreme(&chain.path, &x, chain.upper)? + &p[1]);
            found.extend(moved(v).zip(moved(w)).map(|(v, w)| [v, w]));
        }
    }
    found
}

/// Rules 2 and 3 at the vertices p of a region above a lower chain of it, or below an upper one.
fn second_and_third(of: &[Chain], by: &[Chain]) -> Vec<[Rational; 2]> {
    let mut found = Vec::new();
    for partner in by {
        for p in by.iter().flat_map(|chain| &chain.path) {
            let Some(y) = extreme(&partner.path, &p[0], partner.upper) else { continue };
            let is_beyond = if partner.upper { p[1] <= y } else { p[1] >= y };
            if is_beyond {
                of.iter().filter(|own| own.upper == partner.upper).for_each(|own| moved(own, partner, p, &mut found));
            }
        }
    }
    found
}

/// The crust of two chains and the first one moved by a point, lower one first.
fn moved(own: &Chain, partner: &Chain, p: &Point, found: &mut Vec<[Rational; 2]>) {
    let [from, to] = domain(own);
    for u in between([&from, &to]) {
        let x = Rational::from(&u + &p[0]);
        let crust = convolved(&own.path, &partner.path, &x, own.upper);
        let chain = extreme(&own.path, &u, own.upper).map(|y| y + &p[1]);
        found.extend(crust.zip(chain).map(|(crust, chain)| if own.upper { [chain, crust] } else { [crust, chain] }));
    }
}

/// Rule 4: L1+L2 <= U1+U2.
fn fourth([l1, u1]: Below, [l2, u2]: Below, within_reach: bool) -> Vec<[Rational; 2]> {
    if l1.upper || l2.upper || !u1.upper || !u2.upper {
        return Vec::new();
    }
    let range = if within_reach {
        common(&domain(l1), &domain(u1)).zip(common(&domain(l2), &domain(u2))).map(|(p, q)| plus(&p, &q))
    } else {
        common(&plus(&domain(l1), &domain(l2)), &plus(&domain(u1), &domain(u2)))
    };
    let ordinates = |x: Rational| {
        let crust = |f: &Chain, g: &Chain| convolved(&f.path, &g.path, &x, f.upper);
        Some([crust(l1, l2)?, crust(u1, u2)?])
    };
    let xs = range.map_or_else(Vec::new, |[from, to]| between([&from, &to]));
    xs.into_iter().filter_map(ordinates).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::polygon;
    use crate::claims::draw;

    /// At 13/2 the lower crust is at 17/4 and the upper one at 15/4: beyond 6, where the shorter chains end.
    #[test]
    fn the_fourth_rule_ends_with_the_shorter_chains() {
        let a = polygon(&[[2.0, 3.0], [3.0, 1.0], [1.0, 0.0], [4.0, 0.0]]);
        let b = polygon(&[[2.0, 1.0], [4.0, 4.0], [0.0, 3.0], [3.0, 3.0]]);
        let input = draw::input("hand", a, b);
        assert!(measured(&input, false).unwrap().lo > 0.0);
        assert_eq!(measured(&input, true).unwrap().hi, 0.0);
    }
}
