//! Things sorted into buckets by counting, in linear time.

/// Where each of so many buckets starts, and the things in the order of their buckets, those of one in the order given.
pub fn into_buckets<T: Copy>(count: usize, things: &[(usize, T)]) -> (Vec<u32>, Vec<T>) {
    let mut firsts = vec![0_u32; count + 1];
    things.iter().for_each(|(bucket, _)| firsts[bucket + 1] += 1);
    for bucket in 0..count {
        firsts[bucket + 1] += firsts[bucket];
    }
    let mut next = firsts.clone();
    let mut sorted: Vec<T> = things.iter().map(|(_, thing)| *thing).collect();
    for (bucket, thing) in things {
        sorted[next[*bucket] as usize] = *thing;
        next[*bucket] += 1;
    }
    (firsts, sorted)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn buckets_keep_the_order_given() {
        let (firsts, sorted) = into_buckets(4, &[(2, 'a'), (0, 'b'), (2, 'c'), (3, 'd'), (0, 'e')]);
        assert_eq!((firsts, sorted), (vec![0, 2, 2, 4, 5], vec!['b', 'e', 'a', 'c', 'd']));
    }
}
