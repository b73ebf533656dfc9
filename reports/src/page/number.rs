//! Numbers as a person reads them: few digits, and bounds rounded to the side on which they stay true.

/// Which way a shortened number may move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Toward {
    /// Never above the value: lower bounds, bits.
    Down,
    /// Never below the value: upper bounds.
    Up,
    /// To the nearest: everything that is no bound.
    Nearest,
}

/// `value` with three significant digits as `1.23e-16`, moved only `toward` the given side.
pub fn short(value: f64, toward: Toward) -> String {
    if !value.is_finite() || value == 0.0 {
        return plain(value);
    }
    let nearest = format!("{value:.2e}");
    let read: f64 = nearest.parse().unwrap_or(value);
    match toward {
        Toward::Up if read < value => next_digit(value, 1),
        Toward::Down if read > value => next_digit(value, -1),
        _ => nearest,
    }
}

/// Bits with one decimal, rounded down.
pub fn bits(value: f64) -> String {
    if value.is_finite() { format!("{:.1}", (value * 10.0).floor() / 10.0) } else { plain(value) }
}

/// `count` with commas between the thousands.
pub fn count(count: usize) -> String {
    let digits = count.to_string();
    let groups: Vec<&str> = digits.as_bytes().rchunks(3).rev().filter_map(|g| std::str::from_utf8(g).ok()).collect();
    groups.join(",")
}

/// `count` and the noun in its number: `1 loop`, `2 loops`.
pub fn counted(n: usize, noun: &str) -> String {
    format!("{} {noun}{}", count(n), if n == 1 { "" } else { "s" })
}

fn plain(value: f64) -> String {
    if value.is_nan() { "NaN".to_owned() } else { value.to_string() }
}

/// The three digits nearest to `value`, moved by one unit in the last place in direction `step`.
fn next_digit(value: f64, step: i64) -> String {
    let nearest = format!("{value:.2e}");
    let (mantissa, exponent) = nearest.split_once('e').unwrap_or((&nearest, "0"));
    let hundredths = mantissa.replace('.', "").parse::<i64>().unwrap_or(0) + step;
    let exponent: i32 = exponent.parse().unwrap_or(0);
    match hundredths.abs() {
        1000 => format!("{}e{}", if hundredths > 0 { "1.00" } else { "-1.00" }, exponent + 1),
        // Below 1.00 the next three-digit number is 9.99 of the decade below, which is nearer still.
        99 => format!("{}e{}", if hundredths > 0 { "9.99" } else { "-9.99" }, exponent - 1),
        h => format!("{}{}.{:02}e{exponent}", if hundredths < 0 { "-" } else { "" }, h / 100, h % 100),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn known_values() {
        assert_eq!(short(1.2345e-16, Toward::Up), "1.24e-16");
        assert_eq!(short(1.2345e-16, Toward::Down), "1.23e-16");
        assert_eq!(short(9.991e-3, Toward::Up), "1.00e-2");
        assert_eq!(short(9.996e-3, Toward::Down), "9.99e-3");
        assert_eq!(short(0.0, Toward::Up), "0");
        assert_eq!(short(f64::INFINITY, Toward::Up), "inf");
        assert_eq!(short(f64::NAN, Toward::Up), "NaN");
        assert_eq!(bits(52.99), "52.9");
        assert_eq!(bits(-0.01), "-0.1");
        assert_eq!(bits(f64::INFINITY), "inf");
        assert_eq!(count(1_234_567), "1,234,567");
        assert_eq!(counted(1, "loop"), "1 loop");
        assert_eq!(counted(0, "loop"), "0 loops");
    }

    proptest! {
        #[test]
        fn bounds_stay_bounds(value in proptest::num::f64::NORMAL) {
            let up: f64 = short(value, Toward::Up).parse().unwrap();
            let down: f64 = short(value, Toward::Down).parse().unwrap();
            prop_assert!(down <= value && value <= up);
            prop_assert!(!up.is_finite() || (up - down) <= 0.0101 * value.abs());
        }

        #[test]
        fn bits_are_rounded_down(value in -100.0..100.0_f64) {
            let read: f64 = bits(value).parse().unwrap();
            prop_assert!(read <= value + 1e-12 && value - read < 0.1 + 1e-9);
        }
    }
}
