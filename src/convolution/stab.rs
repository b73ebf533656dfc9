//! Ranges of numbers in groups, and which ranges of a group hold a number: an implicit interval tree a group.

use super::buckets::into_buckets;

/// A closed range of numbers, and what it is the range of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Its lower end.
    pub from: f64,
    /// Its upper end.
    pub to: f64,
    /// What runs over it.
    pub item: u32,
}

/// Ranges, made ready for questions.
#[derive(Clone, Debug, Default)]
pub struct Ranges {
    /// Where those of each group start.
    firsts: Vec<u32>,
    /// By group, each group's by their lower ends.
    sorted: Vec<Range>,
    /// A slice of a group is a tree with its middle as root; at the root stands the greatest upper end of the slice.
    latest: Vec<f64>,
}

impl Ranges {
    /// Ranges with the groups that they belong to, of so many.
    pub fn new(groups: usize, ranges: &[(usize, Range)]) -> Self {
        let (firsts, mut sorted) = into_buckets(groups, ranges);
        let mut latest = vec![f64::NEG_INFINITY; sorted.len()];
        for own in firsts.windows(2) {
            let own = own[0] as usize..own[1] as usize;
            sorted[own.clone()].sort_unstable_by(|p, q| p.from.total_cmp(&q.from).then(p.item.cmp(&q.item)));
            plant(&sorted[own.clone()], &mut latest[own]);
        }
        Self { firsts, sorted, latest }
    }

    /// Adds the items of a group whose ranges hold a number, by their lower ends.
    pub fn holding(&self, group: usize, x: f64, found: &mut Vec<u32>) {
        let own = self.firsts[group] as usize..self.firsts[group + 1] as usize;
        stab(&self.sorted[own.clone()], &self.latest[own], x, found);
    }
}

/// Slices of so few ranges are looked through instead.
const FEW: usize = 12;

/// Fills in the greatest upper ends. Returns that of all.
fn plant(ranges: &[Range], latest: &mut [f64]) -> f64 {
    let root = ranges.len() / 2;
    let greatest = if ranges.len() <= FEW {
        ranges.iter().map(|range| range.to).fold(f64::NEG_INFINITY, f64::max)
    } else {
        let (below, above) = latest.split_at_mut(root);
        ranges[root].to.max(plant(&ranges[..root], below)).max(plant(&ranges[root + 1..], &mut above[1..]))
    };
    if let Some(latest) = latest.get_mut(root) {
        *latest = greatest;
    }
    greatest
}

fn stab(ranges: &[Range], latest: &[f64], x: f64, found: &mut Vec<u32>) {
    let root = ranges.len() / 2;
    if latest.get(root).is_none_or(|latest| *latest < x) {
        return;
    }
    if ranges.len() <= FEW {
        let begun = ranges.iter().take_while(|range| range.from <= x);
        found.extend(begun.filter(|range| x <= range.to).map(|range| range.item));
        return;
    }
    stab(&ranges[..root], &latest[..root], x, found);
    let middle = ranges[root];
    if middle.from <= x {
        if x <= middle.to {
            found.push(middle.item);
        }
        stab(&ranges[root + 1..], &latest[root + 1..], x, found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Looking at every range is the reference.
    #[test]
    fn finds_what_looking_at_all_finds() {
        let mut seed = 1_u64;
        let mut random = |n: u64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) % n
        };
        for count in 0..60 {
            let range = |item, random: &mut dyn FnMut(u64) -> u64| {
                let (from, length) = (random(20) as f64, random(8) as f64);
                (random(3) as usize, Range { from, to: from + length, item })
            };
            let all: Vec<(usize, Range)> = (0..count).map(|item| range(item, &mut random)).collect();
            let ranges = Ranges::new(3, &all);
            for (group, x) in (0..3).flat_map(|group| (-1..29).map(move |x| (group, f64::from(x)))) {
                let mut found = Vec::new();
                ranges.holding(group, x, &mut found);
                found.sort_unstable();
                let holds = |(of, range): &&(usize, Range)| *of == group && range.from <= x && x <= range.to;
                assert_eq!(found, all.iter().filter(holds).map(|(_, range)| range.item).collect::<Vec<_>>());
            }
        }
    }
}
