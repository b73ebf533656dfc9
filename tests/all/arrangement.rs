//! The arrangement: always a consistent planar map, for honest and lying modules alike, and the right one for integers.

use arcsum::arrangement::cross::FloatModule;
use arcsum::arrangement::{Arrangement, arrange, arrange_with};
use arcsum_fuzz::liar::Liar;
use arcsum_fuzz::{assert_consistent, tangle as of_loops};
use arcsum_tests::cases;
use arcsum_tests::tangle;
use glam::DVec2;
use proptest::prelude::*;

/// A point well inside each trapezoid has the winding number of its face.
fn assert_windings(map: &Arrangement, loops: &[Vec<DVec2>], least: f64) -> Result<(), TestCaseError> {
    for t in &map.trapezoids {
        // Off the middle, where cancelled edges may lie.
        let x = t.from + 0.414 * (t.to - t.from);
        let (bottom, top) = (&map.graph.curves[t.bottom as usize], &map.graph.curves[t.top as usize]);
        let (low, high) = (bottom.y_at(x), top.y_at(x));
        if t.to - t.from > least && high - low > least {
            let p = DVec2::new(x, low + 0.618 * (high - low));
            prop_assert_eq!(map.graph.windings[t.face as usize][0], tangle::winding(loops, p), "at {}", p);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(20000))]

    #[test]
    fn grids_give_the_exact_map(loops in (1..6).prop_flat_map(tangle::on_grid)) {
        let map = arrange(&of_loops(&loops));
        assert_consistent(&map);
        assert_windings(&map, &loops, 1e-9)?;
    }

    #[test]
    fn random_loops_give_the_right_windings(loops in tangle::in_box()) {
        let map = arrange(&of_loops(&loops));
        assert_consistent(&map);
        assert_windings(&map, &loops, 1e-9)?;
        prop_assert_eq!(map.audit.late, 0);
        prop_assert_eq!(map.audit.gather, 0);
    }

    #[test]
    fn a_lying_module_cannot_break_the_map(
        loops in prop_oneof![tangle::in_box(), tangle::on_grid(4)],
        seed in any::<u64>(),
        exponent in 3..12_i32,
    ) {
        let module = Liar { honest: FloatModule::new(1.0), size: 10.0_f64.powi(-exponent), seed };
        let map = arrange_with(&of_loops(&loops), &module);
        assert_consistent(&map);
    }
}
