//! Validation: regions valid by construction pass, each planted defect is found and named, small polygons are judged as by
//! exact arithmetic, and the collection that the variable ARCSUM_DATA names gets the verdicts it comes with.

use arcsum::format::{json, load, read_file};
use arcsum::region::{Curve, Node, Region};
use arcsum::validate::{Contact, Invalid, Place, validate};
use arcsum_tests::valid::{backwards, petals, polygon, single, square, stars};
use proptest::prelude::*;
use std::path::{Path, PathBuf};

fn kind(region: &Region) -> &'static str {
    validate(region).err().map_or("valid", |invalid| invalid.kind())
}

fn loops(loops: &[&[Node]]) -> Region {
    Region { loops: loops.iter().map(|l| l.to_vec()).collect(), ..Region::default() }
}

fn node(x: f64, y: f64, curve: Curve) -> Node {
    Node { x, y, curve }
}

/// The counter-clockwise circle as two half circles, starting on the right.
fn circle(x: f64, y: f64, radius: f64) -> Vec<Node> {
    vec![node(x + radius, y, Curve::Bulge(1.0)), node(x - radius, y, Curve::Bulge(1.0))]
}

fn scaled(nodes: &[Node], factor: f64) -> Vec<Node> {
    let curve = |c| match c {
        Curve::Radius(r) => Curve::Radius(r * factor),
        other => other,
    };
    nodes.iter().map(|n| node(n.x * factor, n.y * factor, curve(n.curve))).collect()
}

/// The same set in other words, all of which must be judged alike.
fn restatements(nodes: &[Node], turn: usize) -> Vec<Region> {
    let region = single(nodes.to_vec());
    let mut rotated = nodes.to_vec();
    rotated.rotate_left(turn % nodes.len());
    let powers = [2f64.powi(-900), 2f64.powi(990)];
    let mut all = vec![region.negated(), region.complement(), single(rotated), region];
    all.extend(powers.map(|power| single(scaled(nodes, power))));
    all
}

proptest! {
    #[test]
    fn star_shaped_polygons_are_valid(star in stars(), turn: usize) {
        for region in restatements(&star, turn) {
            prop_assert_eq!(validate(&region), Ok(()));
        }
    }

    #[test]
    fn loops_of_arcs_are_valid(petals in petals(), turn: usize) {
        for region in restatements(&petals, turn) {
            prop_assert_eq!(validate(&region), Ok(()));
        }
    }

    #[test]
    fn rings_are_valid_and_their_parts_swapped_are_not(outer in stars(), inner in petals()) {
        // Radii are at least 1 outside and at most 10 inside once shrunk by 20.
        let hole = single(scaled(&inner, 0.05)).complement().loops.remove(0);
        prop_assert_eq!(validate(&loops(&[&outer, &hole])), Ok(()));
        prop_assert_eq!(validate(&loops(&[&hole, &outer])), Ok(()));
        prop_assert_eq!(kind(&loops(&[&outer, &scaled(&inner, 0.05)])), "wrong orientation");
        prop_assert_eq!(kind(&loops(&[&hole])), "wrong orientation");
    }

    #[test]
    fn planted_defects_of_numbers_are_found_in_place(star in stars(), at: usize, petal in petals()) {
        for nodes in [star, petal] {
            let at = at % nodes.len();
            let place = Place { loop_index: 0, vertex: at };
            let with = |change: fn(&mut Node)| {
                let mut nodes = nodes.clone();
                change(&mut nodes[at]);
                validate(&single(nodes)).unwrap_err()
            };
            prop_assert_eq!(with(|n| n.x = f64::NAN), Invalid::NotFinite(place));
            prop_assert_eq!(with(|n| n.y = f64::NEG_INFINITY), Invalid::NotFinite(place));
            prop_assert_eq!(with(|n| n.curve = Curve::Bulge(f64::INFINITY)), Invalid::NotFinite(place));
            prop_assert_eq!(with(|n| n.y = -2f64.powi(1001)), Invalid::TooFar(place));
            prop_assert_eq!(with(|n| n.curve = Curve::Bulge(1e308)), Invalid::TooFar(place));
            let chord_place = match with(|n| n.curve = Curve::Radius(-1e-9)) {
                Invalid::LongChord { place, .. } => Some(place),
                _ => None,
            };
            prop_assert_eq!(chord_place, Some(place));
            let mut doubled = nodes.clone();
            doubled.insert(at, nodes[at]);
            prop_assert_eq!(validate(&single(doubled)), Err(Invalid::ZeroLength(place)));
        }
    }

    #[test]
    fn planted_tiny_coordinates_are_too_large_a_spread(star in stars(), at: usize) {
        let mut nodes = star;
        let at = at % nodes.len();
        nodes[at].x = 1e-290;
        prop_assert_eq!(kind(&single(nodes)), "too large");
    }

    #[test]
    fn planted_self_intersections_are_found(star in stars(), at: usize, other: usize) {
        let (n, at) = (star.len(), at % star.len());
        let (tip, next) = (star[at], star[(at + 1) % n]);
        let inserted = |nodes: &[Node]| {
            let mut loop_nodes = star.clone();
            loop_nodes.splice(at + 1..at + 1, nodes.iter().copied());
            kind(&single(loop_nodes))
        };
        // Through the centre and far out on the other side.
        prop_assert_eq!(inserted(&[Node::line(-20.0 * tip.x, -20.0 * tip.y)]), "self-intersection");
        // To the next vertex, back, and there again.
        prop_assert_eq!(inserted(&[next, tip]), "self-intersection");
        // To another vertex, which the boundary then visits twice.
        let far = star[(at + 2 + other % (n - 3)) % n];
        prop_assert_eq!(inserted(&[far]), "self-intersection");
        prop_assert_eq!(kind(&single(backwards(star))), "wrong orientation");
    }

    #[test]
    fn planted_overlaps_are_found(nodes in prop_oneof![stars(), petals()], dx in -0.3..0.3, dy in 0.01..0.3) {
        // Two shifted copies of one shape overlap and neither holds the other.
        let shifted: Vec<Node> = nodes.iter().map(|n| node(n.x + dx, n.y + dy, n.curve)).collect();
        prop_assert_eq!(kind(&loops(&[&nodes, &shifted])), "overlapping loops");
        prop_assert_eq!(kind(&loops(&[&nodes, &nodes])), "overlapping loops");
        let complement = single(nodes.clone()).complement().loops.remove(0);
        prop_assert_eq!(kind(&loops(&[&nodes, &complement])), "overlapping loops");
    }

    #[test]
    fn crossings_of_arcs_are_found_down_to_the_tolerance(size in -30i32..0, angle in 0.0..std::f64::consts::TAU) {
        // Circles of radius 1 that overlap by a little: by 2^-30 clearly, and by 2^-44 not.
        let at = |overlap: f64| (libm::cos(angle) * (2.0 - overlap), libm::sin(angle) * (2.0 - overlap));
        let pair = |(x, y): (f64, f64)| loops(&[&circle(0.0, 0.0, 1.0), &circle(x, y, 1.0)]);
        prop_assert_eq!(kind(&pair(at(2f64.powi(size)))), "overlapping loops");
        prop_assert_eq!(kind(&pair(at(2f64.powi(-44)))), "valid");
    }
}

proptest! {
    #[test]
    fn loops_must_not_touch_themselves(angle in 0.0..std::f64::consts::TAU) {
        // A half circle of radius 10 hangs from the upper side down to the lower one.
        let (sin, cos) = libm::sincos(angle);
        let hanging = |depth: f64| {
            let corners = [(-20.0, 0.0), (-20.0, -depth), (20.0, -depth), (20.0, 0.0), (10.0, 0.0), (-10.0, 0.0)];
            let turned = corners.map(|(x, y)| Node::line(x * cos - y * sin, x * sin + y * cos));
            let mut nodes = turned.to_vec();
            nodes[4].curve = Curve::Bulge(-1.0);
            kind(&single(nodes))
        };
        prop_assert_eq!(hanging(10.0 - 1e-9), "self-intersection");
        prop_assert_eq!(hanging(10.0), "self-intersection");
        prop_assert_eq!(hanging(10.0 + 1e-9), "valid");
    }
}

proptest! {
    #[test]
    fn slim_crescents_are_valid_one_way_round(angle in 0.0..std::f64::consts::TAU, bulge in 0.01..2.0, slim in 10..22i32) {
        let (sin, cos) = libm::sincos(angle);
        let crescent = |outer: f64, inner: f64| {
            single(vec![node(3.0, 4.0, Curve::Bulge(outer)), node(3.0 + cos, 4.0 + sin, Curve::Bulge(-inner))])
        };
        let thicker = bulge + 2f64.powi(-slim);
        prop_assert_eq!(kind(&crescent(thicker, bulge)), "valid");
        prop_assert_eq!(kind(&crescent(-bulge, -thicker)), "valid");
        prop_assert_eq!(kind(&crescent(bulge, thicker)), "wrong orientation");
        prop_assert_ne!(kind(&crescent(bulge, bulge)), "valid");
    }
}

#[test]
fn half_circles_may_have_the_last_bit_of_their_radius_wrong() {
    let circle = |radius| single(vec![node(7.0, 5.0, Curve::Radius(radius)), node(5.0, 5.0, Curve::Radius(radius))]);
    for radius in [1.0, 1f64.next_down(), 1f64.next_up()] {
        assert_eq!(validate(&circle(radius)), Ok(()), "{radius}");
    }
    assert_eq!(kind(&circle(1.0 - 1e-14)), "chord longer than the diameter");
}

#[test]
fn loops_must_not_pinch_off_however_little() {
    for size in [1.0, 1e-3, 1e-6, 1e-9, 1e-12] {
        let mut nodes = square(0.0, 10.0);
        nodes[1].curve = Curve::Bulge(0.1);
        nodes[2].curve = Curve::Bulge(0.5);
        let pinch = [node(10.0 + size, 10.0 + 2.0 * size, Curve::Bulge(0.5)), node(10.0, 10.0, Curve::Bulge(0.1))];
        nodes.splice(3..3, pinch);
        assert_eq!(kind(&single(nodes)), "self-intersection", "{size}");
    }
}

#[test]
fn each_kind_of_defect_is_named() {
    let big = square(0.0, 10.0);
    let hole = backwards(square(2.0, 8.0));
    let bar = |x: f64| polygon(&[(x, -1.0), (x + 1.0, -1.0), (x + 1.0, 11.0), (x, 11.0)]);
    let cases: [(Region, &str); 12] = [
        (Region::default(), "empty"),
        (single(polygon(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0)])), "empty"),
        (single(vec![]), "open loop"),
        (single(polygon(&[(0.0, 0.0)])), "open loop"),
        (single(polygon(&[(0.0, 0.0), (1.0, 0.0)])), "open loop"),
        (single(vec![node(0.0, 0.0, Curve::Bulge(0.3)), node(1.0, 0.0, Curve::Bulge(-0.3))]), "empty"),
        (loops(&[&big, &backwards(square(2.0, 12.0))]), "overlapping loops"),
        (loops(&[&big, &bar(4.0)]), "overlapping loops"),
        (loops(&[&big, &backwards(square(12.0, 14.0))]), "wrong orientation"),
        (loops(&[&big, &square(2.0, 4.0)]), "wrong orientation"),
        (loops(&[&big, &hole, &backwards(square(3.0, 7.0))]), "wrong orientation"),
        (loops(&[&big, &backwards(polygon(&[(0.0, 1.0), (1.0, 0.0), (9.0, 9.0)]))]), "overlapping loops"),
    ];
    for (region, expected) in cases {
        assert_eq!(kind(&region), expected, "{}", json::write(&region));
    }
}

#[test]
fn touches_are_allowed_unless_they_cut_the_interior() {
    let big = square(0.0, 12.0);
    let diamond = |x: f64, y: f64| backwards(polygon(&[(x - 2.0, y), (x, y - 2.0), (x + 2.0, y), (x, y + 2.0)]));
    let [west, middle, east] = [2.0, 6.0, 10.0].map(|x| diamond(x, 6.0));
    let cases: [(&[&[Node]], &str); 8] = [
        (&[&big, &west], "valid"),
        (&[&big, &west, &middle], "valid"),
        (&[&big, &west, &middle, &east], "overlapping loops"),
        // Four holes around a point, and around a fifth place that they close off.
        (&[&big, &diamond(4.0, 6.0), &diamond(8.0, 6.0), &diamond(6.0, 8.0), &diamond(6.0, 4.0)], "overlapping loops"),
        // An island that touches its hole twice.
        (&[&big, &backwards(square(2.0, 10.0)), &backwards(diamond(6.0, 8.0)), &square(5.0, 6.0)], "valid"),
        // Three squares that touch in a ring are three parts of the region.
        (&[&square(0.0, 1.0), &square(1.0, 2.0), &polygon(&[(1.0, 0.0), (2.0, -1.0), (2.0, 1.0)])], "valid"),
        // Half circles with common ends: a lens touches the circle twice.
        (
            &[&circle(0.0, 0.0, 2.0), &[node(-2.0, 0.0, Curve::Bulge(-0.5)), node(2.0, 0.0, Curve::Bulge(-0.5))]],
            "overlapping loops",
        ),
        // The same circles, one of them inside and tangent in a vertex.
        (&[&circle(0.0, 0.0, 2.0), &single(circle(1.0, 0.0, 1.0)).complement().loops[0]], "valid"),
    ];
    for (region, expected) in cases.map(|(nodes, expected)| (loops(nodes), expected)) {
        assert_eq!(kind(&region), expected, "{:?}\n{}", validate(&region), json::write(&region));
    }
}

/// A comb of long thin teeth, turned so that the bounding boxes of all its teeth overlap.
fn slanted_comb(teeth: usize) -> Vec<Node> {
    let width = 4.0 * teeth as f64;
    let mut points = vec![(-1.0, 0.0), (-1.0, -1.0), (width, -1.0)];
    points.extend((0..teeth).flat_map(|i| {
        let y = 2.0 * i as f64;
        [(width, y), (0.0, y), (0.0, y + 1.0), (width, y + 1.0)]
    }));
    points.push((-1.0, width));
    polygon(&points.iter().map(|(x, y)| (2.0 * x - y, x + 2.0 * y)).collect::<Vec<_>>())
}

#[test]
fn large_polygons_are_judged_in_full() {
    let comb = slanted_comb(25_000);
    assert_eq!(validate(&single(comb.clone())), Ok(()));
    for at in [4, 50_000, 99_998] {
        // The tip of a tooth's side moved across the gap and beyond the next tooth.
        let mut nodes = comb.clone();
        nodes[at].x -= 4.0;
        nodes[at].y += 8.0;
        let Err(Invalid::SelfIntersection(meeting)) = validate(&single(nodes)) else { panic!("nothing found at {at}") };
        let distance = |place: Place| place.vertex.abs_diff(at);
        assert!(distance(meeting.first).min(distance(meeting.second)) <= 1, "{meeting} instead of at {at}");
    }
}

#[test]
fn cusps_of_half_a_turn_are_refused() {
    // A crescent: two circles tangent at (0, 0).
    let crescent = vec![
        node(0.0, 0.0, Curve::Bulge(1.0)),
        node(4.0, 0.0, Curve::Bulge(1.0)),
        node(0.0, 0.0, Curve::Bulge(-1.0)),
        node(2.0, 0.0, Curve::Bulge(-1.0)),
    ];
    assert_eq!(kind(&single(crescent)), "self-intersection");
    let moon = vec![node(0.0, 0.0, Curve::Bulge(1.0)), node(4.0, 0.0, Curve::Line), node(2.0, 0.0, Curve::Bulge(-1.0))];
    let contact = |invalid| match invalid {
        Invalid::SelfIntersection(meeting) => meeting.contact,
        other => panic!("{other}"),
    };
    assert_eq!(contact(validate(&single(moon)).unwrap_err()), Contact::Fold);
}

/// All JSON files in the folders of the collection, and whether they are in the folder of invalid ones.
fn collection(root: &Path) -> Vec<(PathBuf, bool)> {
    let entries = |path: &Path| -> Vec<PathBuf> {
        let list = std::fs::read_dir(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        list.map(|entry| entry.unwrap().path()).collect()
    };
    let folders = entries(root).into_iter().filter(|path| path.is_dir());
    let files = folders.flat_map(|folder| entries(&folder));
    let json = files.filter(|path| path.extension().is_some_and(|e| e == "json"));
    json.map(|path| (path.clone(), path.parent().is_some_and(|p| p.ends_with("invalid_open")))).collect()
}

/// Valid by sampling, refused here: in each of them two circle segments form a cusp of exactly 180 degrees (memo A4).
const CUSPS: [&str; 4] = ["parallel_offset_L591", "parallel_offset_L709", "parallel_offset_L331", "kin98"];

#[test]
fn the_collection_gets_the_verdicts_it_comes_with() {
    let Some(root) = std::env::var_os("ARCSUM_DATA") else {
        println!("skipped: ARCSUM_DATA names no folder of regions");
        return;
    };
    let (mut valid, mut refused, mut cusps, mut wrong) = (0, 0, 0, Vec::new());
    for (path, defective) in collection(Path::new(&root)) {
        let region = read_file(&path).unwrap();
        assert_eq!(json::read(&json::write(&region)).unwrap(), region);
        let cusp = CUSPS.iter().any(|name| path.to_string_lossy().contains(name));
        match load(&path) {
            Ok(_) if !defective && !cusp => valid += 1,
            Err(error) if defective && error.to_string().lines().count() == 1 => refused += 1,
            Err(error) if cusp && error.to_string().contains("cusp") => cusps += 1,
            outcome => wrong.push(format!("{}: {:?}", path.display(), outcome.err())),
        }
    }
    println!("{valid} valid, {refused} defective and refused, {cusps} refused for a cusp");
    assert!(valid > 0 && wrong.is_empty(), "{wrong:#?}");
}
