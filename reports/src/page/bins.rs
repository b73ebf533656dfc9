//! Bits counted in bins of one bit, with places for no bits and for exact results: every row is in one bin.

use super::folder::Entry;
use super::rank;

/// Counts by whole bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bins {
    /// The first bin counts bits in [low, low + 1), and everything below.
    pub low: i32,
    /// One count a bit. The last one counts everything finite above it too.
    pub counts: Vec<usize>,
    /// Rows without bits.
    pub none: usize,
    /// Rows with infinitely many.
    pub exact: usize,
}

impl Bins {
    /// The whole bits that hold all finite ones, but never more than 0 to 64, nor less than 40 to 54.
    pub fn range(entries: &[Entry]) -> (i32, i32) {
        let finite = entries.iter().filter_map(rank::bits).filter(|b| b.is_finite());
        let (low, high) = finite.fold((40.0_f64, 54.0_f64), |(low, high), b| (low.min(b), high.max(b)));
        (low.floor().max(0.0) as i32, high.ceil().min(64.0) as i32)
    }

    /// Counts the entries in bins over a range.
    pub fn of<'a>(entries: impl IntoIterator<Item = &'a Entry>, (low, high): (i32, i32)) -> Self {
        let mut bins = Self { low, counts: vec![0; (high - low).max(1) as usize], none: 0, exact: 0 };
        for entry in entries {
            match rank::bits(entry) {
                None => bins.none += 1,
                Some(f64::INFINITY) => bins.exact += 1,
                Some(bits) => {
                    let last = bins.counts.len() - 1;
                    let index = (bits.floor() - f64::from(low)).clamp(0.0, last as f64);
                    bins.counts[index as usize] += 1;
                }
            }
        }
        bins
    }

    /// The largest count of all.
    pub fn highest(&self) -> usize {
        self.counts.iter().copied().chain([self.none, self.exact]).max().unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::sample;
    use proptest::prelude::*;

    fn total(bins: &Bins) -> usize {
        bins.counts.iter().sum::<usize>() + bins.none + bins.exact
    }

    #[test]
    fn ends_and_special_values_have_their_places() {
        let powers = [70, 52, 45, -3].map(|bits| Some(2.0_f64.powi(-bits)));
        let mut entries = sample::entries(&powers);
        entries.extend(sample::entries(&[None, Some(0.0), Some(f64::NAN)]));
        let range = Bins::range(&entries);
        assert_eq!(range, (0, 64));
        let bins = Bins::of(&entries, range);
        assert_eq!((bins.none, bins.exact, total(&bins)), (2, 1, 7));
        assert_eq!((bins.counts[0], bins.counts[45], bins.counts[52], bins.counts[63]), (1, 1, 1, 1));
    }

    proptest! {
        #[test]
        fn every_row_is_in_one_bin(bits in prop::collection::vec(prop::option::of(any::<f64>()), 0..40)) {
            let mut entries = sample::entries(&vec![None; bits.len()]);
            for (entry, bits) in entries.iter_mut().zip(&bits) {
                entry.row.bits = *bits;
            }
            prop_assert_eq!(total(&Bins::of(&entries, Bins::range(&entries))), bits.len());
        }
    }
}
