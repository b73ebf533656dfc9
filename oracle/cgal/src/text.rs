//! Loops of exact points from and to the text they cross the C ABI in: `x y x y ...;` a loop, numbers as `p` or `p/q`.

use crate::error::CgalError;
use arcsum_oracle::point::Point;
use rug::Rational;
use std::fmt::Write;

/// Closed loops of exact points.
pub type Loops = Vec<Vec<Point<Rational>>>;

/// The text of loops.
pub fn write(loops: &[Vec<Point<Rational>>]) -> String {
    let mut text = String::new();
    for ring in loops {
        for p in ring {
            // Writing to a string does not fail.
            let _ = write!(text, "{} {} ", p.x, p.y);
        }
        text.push(';');
    }
    text
}

/// The loops of a text.
pub fn read(text: &str) -> Result<Loops, CgalError> {
    text.split_terminator(';').map(ring).collect()
}

fn ring(text: &str) -> Result<Vec<Point<Rational>>, CgalError> {
    let numbers = text.split_whitespace().map(number).collect::<Result<Vec<_>, _>>()?;
    if numbers.len() % 2 == 1 {
        return Err(nonsense("a vertex without an ordinate"));
    }
    Ok(numbers.chunks_exact(2).map(|pair| Point { x: pair[0].clone(), y: pair[1].clone() }).collect())
}

/// The rational number of a word.
pub fn number(word: &str) -> Result<Rational, CgalError> {
    word.parse().map_err(|_| nonsense(word))
}

/// The error for text like this.
pub fn nonsense(what: &str) -> CgalError {
    CgalError::Nonsense(what.chars().take(60).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn loops_read_back(rings in prop::collection::vec(prop::collection::vec(any::<[(i32, u8); 2]>(), 0..5), 0..4)) {
            let number = |(p, q): (i32, u8)| Rational::from((p, u32::from(q) + 1));
            let point = |[x, y]: [(i32, u8); 2]| Point { x: number(x), y: number(y) };
            let loops: Loops = rings.into_iter().map(|ring| ring.into_iter().map(point).collect()).collect();
            prop_assert_eq!(read(&write(&loops)), Ok(loops));
        }
    }

    #[test]
    fn what_is_no_loop_is_refused() {
        for text in ["1 2 3;", "1 x;", "1 2/0;", "nan 1;"] {
            assert!(matches!(read(text), Err(CgalError::Nonsense(_))), "{text}");
        }
    }
}
