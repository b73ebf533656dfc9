//! Reading and writing regions, and the exact orientation that validation rests on.

use arcsum::exact::{Grid, orientation};
use arcsum::format::{Cause, FormatError, json, load, read_file};
use arcsum::region::{Curve, Node, Region};
use arcsum_reports::cases::rng::Rng;
use glam::DVec2;
use proptest::prelude::*;
use rug::Rational;
use std::cmp::Ordering;
use std::fs;

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |v| v.is_finite())
}

fn nodes() -> impl Strategy<Value = Node> {
    let nonzero = || finite().prop_filter("nonzero", |v| *v != 0.0);
    let curve = prop_oneof![Just(Curve::Line), nonzero().prop_map(Curve::Bulge), nonzero().prop_map(Curve::Radius)];
    (finite(), finite(), curve).prop_map(|(x, y, curve)| Node { x, y, curve })
}

fn regions() -> impl Strategy<Value = Region> {
    let loops = prop::collection::vec(prop::collection::vec(nodes(), 0..6), 0..4);
    (prop::option::of(any::<String>()), loops, any::<bool>()).prop_map(|(name, loops, unbounded)| Region {
        name,
        loops,
        unbounded,
    })
}

proptest! {
    #[test]
    fn numbers_read_back_bit_by_bit(value in finite()) {
        let text = json::number(value);
        prop_assert_eq!(text.parse::<f64>().unwrap().to_bits(), value.to_bits());
        let region = json::read(&format!(r#"{{"loops": [[{{"x": {text}, "y": 0}}]]}}"#)).unwrap();
        prop_assert_eq!(region.loops[0][0].x.to_bits(), value.to_bits());
    }

    #[test]
    fn numbers_have_no_more_digits_than_needed(value in finite()) {
        let digits = |text: &str| text.split('e').next().unwrap().trim_matches(['-', '0', '.']).replace('.', "").len();
        let shortest = format!("{value:e}");
        prop_assert_eq!(digits(&json::number(value)), digits(&shortest));
    }

    #[test]
    fn regions_read_back(region in regions()) {
        let written = json::write(&region);
        let again = json::read(&written).unwrap();
        prop_assert_eq!(format!("{:?}", &again), format!("{:?}", &region));
        prop_assert_eq!(json::write(&again), written);
    }
}

#[test]
fn the_written_form_is_fixed() {
    let nodes = vec![
        Node::line(0.0, -0.0),
        Node { x: 1.0, y: 0.1, curve: Curve::Bulge(1e-7) },
        Node { x: 1e300, y: 123_456_789.0, curve: Curve::Radius(-2.5) },
    ];
    let region = Region { name: Some("a \"b\"".into()), loops: vec![nodes, vec![]], unbounded: true };
    let expected = r#"{"name": "a \"b\"", "loops": [
[{"x": 0, "y": -0},
 {"x": 1, "y": 0.1, "bulge": 1e-7},
 {"x": 1e300, "y": 123456789, "radius": -2.5}],
[]], "unbounded": true}
"#;
    assert_eq!(json::write(&region), expected);
}

#[test]
fn regions_inside_other_files_have_the_same_form() {
    let text = r#"{"loops":[[{"x":0.5,"y":1.0,"radius":2.5}]],"unbounded":true}"#;
    let region = json::read(text).unwrap();
    assert_eq!(serde_json::to_string(&region).unwrap(), text);
    assert_eq!(serde_json::from_str::<(Region,)>(&format!("[{text}]")).unwrap().0, region);
}

#[test]
fn what_is_not_finite_is_written_as_something_every_reader_refuses() {
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let text = json::write(&Region { loops: vec![vec![Node::line(value, 0.0)]], ..Region::default() });
        assert!(matches!(json::read(&text), Err(FormatError::NotFinite { line: 2, .. })), "{text}");
    }
}

#[test]
fn unknown_keys_are_ignored_and_absent_ones_have_their_default() {
    let text = r#"{"units": 4, "loops": [[{"z": [1, {"x": 2}], "x": 1, "y": 2, "bulge": 0}]], "source": null}"#;
    let expected = Region { loops: vec![vec![Node::line(1.0, 2.0)]], ..Region::default() };
    assert_eq!(json::read(text).unwrap(), expected);
}

#[test]
fn each_refusal_names_its_place_and_reason() {
    let nested = format!(r#"{{"loops": {}1{}}}"#, "[".repeat(100_000), "]".repeat(100_000));
    let cases = [
        ("", "line 1, column 0: EOF while parsing a value"),
        (r#"{"loops": [[{"x": 1, "y": 2}"#, "line 1, column 28: EOF while parsing a list"),
        ("{\"loops\": [\n[NaN]]}", "line 2, column 2: expected value"),
        ("{\"loops\": [[\n{\"x\": 1e999, \"y\": 0}]]}", "line 2, column 11: the number is not finite"),
        ("{\"loops\": [[\n{\"x\": -1e999, \"y\": 0}]]}", "line 2, column 12: the number is not finite"),
        (r#"{"loops": [[{"x": 1}]]}"#, "line 1, column 20: missing field `y`"),
        (r#"{"unbounded": true}"#, "line 1, column 19: missing field `loops`"),
        (r#"{"loops": [], "loops": []}"#, "line 1, column 21: duplicate field `loops`"),
        (r#"{"loops": [[{"x": 1, "x": 1, "y": 0}]]}"#, "line 1, column 24: duplicate field `x`"),
        (
            r#"{"loops": [[{"x": 1, "y": 0, "bulge": 1, "radius": 2}]]}"#,
            "line 1, column 53: a vertex has both a bulge and a radius",
        ),
        (r#"{"loops": [[{"x": "1", "y": 0}]]}"#, "line 1, column 21: invalid type: string \"1\", expected f64"),
        (nested.as_str(), "line 1, column 12: invalid type: sequence, expected a vertex, {\"x\": ..., \"y\": ...}"),
        (r#"["name", [], false]"#, "line 1, column 0: invalid type: sequence, expected a region, {\"loops\": ...}"),
        (r#"{"loops": []} x"#, "line 1, column 15: trailing characters"),
    ];
    for (text, reason) in cases {
        assert_eq!(json::read(text).unwrap_err().to_string(), reason, "{}", &text[..text.len().min(80)]);
    }
}

#[test]
fn ignored_values_may_nest_without_bound() {
    let nested = format!(r#"{{"loops": [], "z": {}1{}}}"#, "[".repeat(1_000_000), "]".repeat(1_000_000));
    assert_eq!(json::read(&nested), Ok(Region::default()));
}

#[test]
fn too_many_vertices_are_refused() {
    let vertices = vec![r#"{"x":0,"y":0}"#; 1_000_001].join(",");
    let error = json::read(&format!(r#"{{"loops":[[{vertices}]]}}"#)).unwrap_err();
    assert_eq!(error, FormatError::TooLarge { vertices: 1_000_001 });
}

#[test]
fn file_errors_name_the_file_in_one_sentence() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, content: &[u8]| {
        let path = folder.path().join(name);
        fs::write(&path, content).unwrap();
        path
    };
    let bowtie = br#"{"loops": [[{"x": 0, "y": 0}, {"x": 2, "y": 2}, {"x": 2, "y": 0}, {"x": 0, "y": 3}]]}"#;
    let bowtie = file("bowtie.json", bowtie);
    assert!(read_file(&bowtie).is_ok());
    let cases = [
        (
            load(&bowtie),
            "self-intersection: the curves from loop 0, vertex 0 and from loop 0, vertex 2 cross at (1.2, 1.2)",
        ),
        (load(&file("broken.JSON", b"{")), "line 1, column 1: EOF while parsing an object"),
        (load(&file("bytes.json", b"{\xff}")), "byte 1 is not part of a UTF-8 text"),
        (load(&file("region.dwg", b"{}")), "the extension is not that of a region file (json)"),
    ];
    for (outcome, reason) in cases {
        let error = outcome.unwrap_err();
        assert_eq!(error.to_string(), format!("{}: {reason}", error.path.display()));
    }
    let missing = load(&folder.path().join("missing.json")).unwrap_err();
    assert!(matches!(missing.cause, Cause::Io(_)));
    assert!(missing.to_string().contains("missing.json: cannot be read: "));
}

/// The sign of the determinant in rational numbers.
fn judged(a: DVec2, b: DVec2, c: DVec2) -> Ordering {
    let q = |v: f64| Rational::from_f64(v).unwrap();
    let left = (q(a.x) - q(c.x)) * (q(b.y) - q(c.y));
    let right = (q(a.y) - q(c.y)) * (q(b.x) - q(c.x));
    left.cmp(&right)
}

/// The sign of the determinant in plain floating point: the planted bug.
fn rounded(a: DVec2, b: DVec2, c: DVec2) -> Ordering {
    let det = (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
    det.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

/// Three points, the third within a few ulps of the line through the others, with magnitudes from 2^-`spread`/2 to
/// 2^`spread`/2 times 2^`middle`.
fn nearly_collinear(random: &mut Rng, middle: i32, spread: i32) -> [DVec2; 3] {
    let mut number = || {
        let exponent = middle + (random.unit() * f64::from(spread)) as i32 - spread / 2;
        libm::ldexp((random.unit() - 0.5) * 2.0, exponent)
    };
    let (a, b) = (DVec2::new(number(), number()), DVec2::new(number(), number()));
    let c = a + (b - a) * *random.pick(&[-1.0, 0.25, 0.5, 0.7, 2.0, 3.0]);
    let mut nudge = |v: f64| f64::from_bits(v.to_bits() + random.below(3) as u64);
    [a, b, DVec2::new(nudge(c.x), nudge(c.y))]
}

#[test]
fn orientation_agrees_with_rational_numbers_where_rounding_fails() {
    let mut random = Rng::new(1, "tests");
    let (mut cases, mut wrong) = (0, 0);
    for (middle, spread) in [(0, 2), (0, 60), (996, 6), (-996, 6), (0, 780), (600, 780), (-640, 780), (-1060, 20)] {
        for _ in 0..20_000 {
            let points = nearly_collinear(&mut random, middle, spread);
            let Ok(grid) = Grid::of(points.into_iter().flat_map(|p| [p.x, p.y])) else { continue };
            let [a, b, c] = points.map(|p| grid.scale_point(p.x, p.y));
            let truth = judged(a, b, c);
            let [p, q, r] = points;
            assert_eq!(judged(p, q, r), truth, "the grid changed {points:?}");
            assert_eq!(orientation(a, b, c), truth, "{points:?}");
            assert_eq!(orientation(b, a, c), truth.reverse(), "{points:?}");
            assert_eq!(orientation(b, c, a), truth, "{points:?}");
            cases += 1;
            wrong += usize::from(rounded(a, b, c) != truth);
        }
    }
    println!("{cases} nearly collinear triples, {wrong} of them wrong in plain floating point");
    assert!(cases > 100_000, "too few triples fit a grid: {cases}");
    assert!(wrong > cases / 100, "the triples are too easy: rounding fails on {wrong} of {cases}");
}

#[test]
fn the_grid_tells_how_far_coordinates_spread() {
    let power = |exponent| libm::ldexp(1.0, exponent);
    assert!(Grid::of([power(450), power(-449)]).is_ok());
    assert_eq!(Grid::of([power(450), power(-450)]), Err(901));
    assert_eq!(Grid::of([f64::MAX, f64::from_bits(1)]), Err(2098));
    assert!(Grid::of([0.0, -0.0]).is_ok());
    assert_eq!(Grid::of([power(999), power(100) + power(60), -power(70)]), Grid::of([power(999), power(60)]));
}
