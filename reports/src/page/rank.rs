//! What is worse: the order of measured errors, and the cases that fall short.

use super::folder::Entry;
use crate::row::Status;
use std::cmp::Ordering;

/// Bits below which a case falls short: 45 of the 53 that a double has.
pub const ENOUGH_BITS: f64 = 45.0;

/// The upper bound of an entry's error as an order: NaN certifies nothing and is worse than infinity.
pub fn error(entry: &Entry) -> Option<f64> {
    entry.row.mu_hi.map(|mu| if mu.is_nan() { f64::NAN } else { mu })
}

/// Compares by error, least first; entries without one come before all.
pub fn by_error(a: &Entry, b: &Entry) -> Ordering {
    let key = |e: &Entry| error(e).unwrap_or(f64::NEG_INFINITY);
    key(a).total_cmp(&key(b))
}

/// The entry of the greatest error, the first of equals. `None` when nothing was measured.
pub fn worst<'a>(entries: impl IntoIterator<Item = &'a Entry>) -> Option<&'a Entry> {
    let measured = entries.into_iter().filter(|e| e.row.mu_hi.is_some());
    measured.reduce(|worst, e| if by_error(worst, e) == Ordering::Less { e } else { worst })
}

/// The bits of an entry that answered with a certificate; `None` for all others, NaN included.
pub fn bits(entry: &Entry) -> Option<f64> {
    entry.row.bits.filter(|bits| !bits.is_nan())
}

/// Whether an entry has no certified answer, or too few bits.
pub fn falls_short(entry: &Entry) -> bool {
    entry.row.status != Status::Ok || bits(entry).is_none_or(|bits| bits < ENOUGH_BITS)
}

/// Values in the order of their first appearance.
pub fn distinct<'a>(values: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let mut seen = std::collections::BTreeSet::new();
    values.into_iter().filter(|v| seen.insert(*v)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::sample;

    #[test]
    fn nan_is_worse_than_infinity_is_worse_than_large() {
        let entries = sample::entries(&[Some(1.0), None, Some(f64::INFINITY), Some(1e300)]);
        assert_eq!(worst(&entries).unwrap().number, 3);
        let entries = sample::entries(&[Some(f64::INFINITY), Some(-f64::NAN), Some(1.0)]);
        assert_eq!(worst(&entries).unwrap().number, 2);
        assert!(worst(&sample::entries(&[None])).is_none());
    }

    #[test]
    fn the_first_of_equals_is_kept() {
        assert_eq!(worst(&sample::entries(&[Some(1.0), Some(2.0), Some(2.0)])).unwrap().number, 2);
    }

    #[test]
    fn only_ok_with_enough_bits_does_not_fall_short() {
        let mut entries = sample::entries(&[Some(2.0_f64.powi(-45)), Some(2.0_f64.powi(-44)), None, Some(f64::NAN)]);
        let short: Vec<bool> = entries.iter().map(falls_short).collect();
        assert_eq!(short, [false, true, true, true]);
        entries[0].row.status = Status::Undecided;
        assert!(falls_short(&entries[0]));
    }
}
