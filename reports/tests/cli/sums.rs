//! Sums of files.

use super::{Place, code, errors, run, square};
use arcsum::format::json;

#[test]
fn three_regions_are_summed_in_turn() {
    let place = Place::new();
    let files = [1.0, 2.0, 4.0].map(|side| place.file(&format!("{side}.json"), &square(side)));
    for engine in ["kinetic", "monotonic"] {
        let output = run(&["sum", &files[0], &files[1], &files[2], "--engine", engine]);
        assert_eq!(code(&output), 0, "{:?}", errors(&output));
        let sum = json::read(std::str::from_utf8(&output.stdout).unwrap()).unwrap();
        assert_eq!((sum.area(), sum.segments()), (49.0, 4));
    }
}

#[test]
fn one_region_is_no_sum() {
    let place = Place::new();
    let output = run(&["sum", &place.file("one.json", &square(1.0))]);
    assert_eq!(code(&output), 2);
}
