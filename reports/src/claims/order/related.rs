//! M28: how many segments a segment of the convolution is related to (MS 7.1; memo E6).

use super::exact::lattice;
use super::swept::Swept;
use crate::cases::combs::combs;
use crate::cases::rng::Rng;
use crate::claims::control::Control;
use crate::claims::draw;
use crate::claims::finding::Measured;
use crate::claims::input::Input;
use crate::claims::sup::{Rule, Sup};
use crate::claims::{Claim, Test};
use crate::kept;
use arcsum::convolution::order::Role;
use arcsum::robustness::Robustness;

pub(super) fn claims() -> [Claim; 2] {
    let sup = Sup {
        quantity: "most segments related to one at an abscissa",
        unit: "1",
        rule: Rule::AtMost(5.0),
        draws: [150, 15_000],
        draw: pair,
        measure: |input| most(input, by_any_end),
        kept: kept!("M28_printed"),
        control: Control::Itself,
    };
    let printed = Claim {
        id: "M28 printed",
        place: "MS 7.1",
        says: "An edge is related to at most five segments, so inserting it in convolution order costs no more than a constant.",
        erratum: "Five are the others at one end. A crust has two ends that are sums of turning points, with five others each.",
        test: Test::Sup(sup.clone()),
    };
    let corrected = Claim {
        id: "M28 corrected",
        place: "MS 7.1",
        says: "At each of its ends a segment is related to at most five others at an abscissa.",
        erratum: "",
        test: Test::Sup(Sup {
            measure: |input| most(input, by_one_end),
            kept: kept!("M28_corrected"),
            control: Control::Measure {
                plants: "related segments at any abscissa",
                measure: |input| most(input, by_one_end_anywhere),
            },
            ..sup
        }),
    };
    [printed, corrected]
}

/// Combs with many concave turning points, and small pairs of any kind.
fn pair(rng: &mut Rng, number: usize) -> Input {
    match number % 4 {
        0 => {
            let (a, b) = combs(2 + rng.below(4) as u32);
            draw::input("combs", a, b)
        }
        1 => draw::input("lattice", lattice(rng, 8, 8), lattice(rng, 8, 8)),
        _ => draw::pair(rng, number),
    }
}

/// The most related pieces over all pieces that are not vertical, each at the middle of its abscissas.
fn most(input: &Input, count: fn(&Swept, u32, f64) -> usize) -> Option<Measured> {
    let swept = Swept::new(input.as_pair()?, Robustness::ALL)?;
    let middle = |piece: u32| {
        let piece = &swept.pieces.pieces[piece as usize];
        let [from, to] = [piece.tail, piece.head].map(|v| swept.pieces.points[v as usize].x);
        let x = from.midpoint(to);
        (from.min(to) < x && x < from.max(to)).then_some(x)
    };
    let counts = (0..swept.pieces.pieces.len() as u32).filter_map(|piece| Some(count(&swept, piece, middle(piece)?)));
    counts.max().map(|most| Measured::count(most).of_size(input.size()))
}

/// Other pieces at an abscissa that share an end with one.
fn by_any_end(swept: &Swept, piece: u32, x: f64) -> usize {
    others(swept, piece, |other| is_at(swept, other, x), |_| true)
}

/// The same, at one of the ends.
fn by_one_end(swept: &Swept, piece: u32, x: f64) -> usize {
    let roles = swept.order.roles(piece).iter();
    let at = |end: &Role| others(swept, piece, |other| is_at(swept, other, x), |role| role.0 == end.0);
    roles.map(at).max().unwrap_or(0)
}

/// The same wherever the other pieces are.
fn by_one_end_anywhere(swept: &Swept, piece: u32, _: f64) -> usize {
    let roles = swept.order.roles(piece).iter();
    roles.map(|end| others(swept, piece, |_| true, |role| role.0 == end.0)).max().unwrap_or(0)
}

/// Other pieces of some kind that share an end of some kind with one.
fn others(swept: &Swept, piece: u32, counts: impl Fn(u32) -> bool, is_end: impl Fn(&Role) -> bool) -> usize {
    let own: Vec<u32> = swept.order.roles(piece).iter().filter(|role| is_end(role)).map(|role| role.0).collect();
    let shares = |other: &u32| swept.order.roles(*other).iter().any(|role| own.contains(&role.0));
    let all = 0..swept.pieces.pieces.len() as u32;
    all.filter(|other| *other != piece && shares(other) && counts(*other)).count()
}

/// Whether a piece has points strictly left and right of an abscissa.
fn is_at(swept: &Swept, piece: u32, x: f64) -> bool {
    let piece = &swept.pieces.pieces[piece as usize];
    let [from, to] = [piece.tail, piece.head].map(|v| swept.pieces.points[v as usize].x);
    from.min(to) < x && x < from.max(to)
}
