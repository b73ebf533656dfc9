//! The page of a bench, from tables made by hand.

use super::*;
use crate::bench::comparison::comparisons;
use crate::bench::fate::Fate;
use crate::bench::goals::reached;
use serde::Serialize;
use std::fs;

fn row(family: &str, size: u64, engine: &str, to_first: f64) -> Timing {
    Timing {
        case: format!("{family}_{size}"),
        family: family.into(),
        engine: engine.into(),
        polygonal: true,
        median_ms: Some(to_first * size as f64),
        to_first: Some(to_first),
        to_first_min: Some(to_first),
        correct: Some(true),
        sum_segments: Some(size),
        ..Timing::default()
    }
}

/// Three engines on two families: one is wrong once, crashes once and is left out once.
fn timings() -> Vec<Timing> {
    let stages =
        |row: Timing| Timing { t_convolution: Some(1.0), t_arrangement: Some(2.0), t_extraction: Some(1.0), ..row };
    let mut rows: Vec<Timing> = [10, 100, 1000, 10_000].map(|size| stages(row("fork", size, "ours", 1.0))).into();
    rows.push(row("star", 50, "ours", 1.0));
    rows.extend([row("fork", 10, "clipper2:union", 4.0), row("fork", 100, "clipper2:union", 9.0)]);
    rows.push(Timing {
        correct: Some(false),
        mu_hi: Some(0.25),
        note: "2 bits".into(),
        ..row("fork", 1000, "clipper2:union", 0.001)
    });
    let left_out = |status, note: &str, row: Timing| Timing {
        status,
        median_ms: None,
        to_first: None,
        to_first_min: None,
        correct: None,
        note: note.into(),
        ..row
    };
    rows.push(left_out(Fate::Crashed, "signal <11>", row("star", 50, "clipper2:union", 1.0)));
    rows.push(left_out(Fate::TooSlow, "too slow on 1000", row("fork", 10_000, "clipper2:union", 1.0)));
    rows
}

fn csv<T: Serialize>(file: &Path, rows: impl IntoIterator<Item = T>) {
    let mut writer = csv::Writer::from_path(file).unwrap();
    rows.into_iter().for_each(|row| writer.serialize(row).unwrap());
    writer.flush().unwrap();
}

fn page(timings: &[Timing]) -> (tempfile::TempDir, String) {
    let dir = tempfile::tempdir().unwrap();
    csv(&dir.path().join("timing.csv"), timings);
    csv(&dir.path().join("goals.csv"), reached(timings, "ours"));
    csv(&dir.path().join("comparison.csv"), comparisons(timings, "ours"));
    let page = fs::read_to_string(write(dir.path()).unwrap()).unwrap();
    (dir, page)
}

fn section<'a>(page: &'a str, id: &str) -> &'a str {
    let start = page.find(&format!("<section id=\"{id}\"")).unwrap();
    &page[start..start + page[start..].find("</section>").unwrap()]
}

#[test]
fn goals_say_what_is_met_missed_and_not_measured() {
    let (_dir, page) = page(&timings());
    let goals = section(&page, "goals");
    let union = &goals[goals.find("<th scope=\"row\">clipper2:union").unwrap()..];
    let union = &union[..union.find("</tr>").unwrap()];
    // The mean of 4 and 9; the wrong row would have made it far less.
    assert!(union.contains(">6</td>") && union.matches(">met</span>").count() == 2, "{union}");
    assert_eq!(goals.matches(">not measured</span>").count(), 2 * 7);
    assert!(goals.contains("sorting as many pairs") && !goals.contains(">missed<"));
}

#[test]
fn engines_by_family_count_what_does_not_count() {
    let (_dir, page) = page(&timings());
    let engines = section(&page, "engines");
    let theirs = &engines[engines.find("<th scope=\"row\">clipper2:union").unwrap()..];
    let theirs: Vec<&str> = theirs[..theirs.find("</tr>").unwrap()].split("<td").collect();
    for (cell, words) in [
        (theirs[1], &["<b>6</b>", "1 wrong", "1 crashed", "1 too slow"][..]),
        (theirs[2], &["<b>6</b>", "1 wrong", "1 too slow"]),
        (theirs[3], &["<b>–</b>", "1 crashed"]),
    ] {
        assert!(words.iter().all(|word| cell.contains(word)), "{cell}");
    }
    let wrong = section(&page, "wrong");
    let order: Vec<usize> = [">wrong<", ">crashed<", ">too slow<"].iter().map(|w| wrong.find(w).unwrap()).collect();
    assert!(order.is_sorted() && wrong.contains("signal &lt;11&gt;") && wrong.contains("2.50e-1"), "{wrong}");
}

#[test]
fn plots_show_every_time_where_it_belongs_and_ring_the_wrong_ones() {
    let (_dir, page) = page(&timings());
    let plots = section(&page, "plots");
    assert_eq!(plots.matches("<figure").count(), 1, "the family of one size has none");
    assert_eq!(plots.matches("class=\"ring\"").count(), 1);
    assert!(plots.contains("Ringed: 1 wrong. Not shown: 1 without a time."));
    let data = |class: &str| {
        let path = &plots[plots.find(&format!("class=\"line {class}\"")).unwrap()..];
        path.split(" d=\"").nth(1).unwrap().split('"').next().unwrap().to_owned()
    };
    let points: Vec<[f64; 2]> = data("s0")[1..]
        .split('L')
        .map(|p| {
            let mut numbers = p.split(' ').map(|v| v.parse::<f64>().unwrap());
            [numbers.next().unwrap(), numbers.next().unwrap()]
        })
        .collect();
    // Size and time grow alike: the points lie evenly on a line that rises.
    let steps: Vec<[f64; 2]> = points.windows(2).map(|w| [w[1][0] - w[0][0], w[1][1] - w[0][1]]).collect();
    assert_eq!(steps.len(), 3);
    for step in &steps {
        assert!((step[0] - steps[0][0]).abs() < 0.05 && (step[1] - steps[0][1]).abs() < 0.05, "{points:?}");
        assert!(step[0] > 10.0 && step[1] < -10.0);
    }
    assert_eq!(data("s1").matches('L').count(), 2);
}

#[test]
fn stages_have_shares() {
    let (_dir, page) = page(&timings());
    let stages = section(&page, "stages");
    assert!(stages.contains(">50%<") && stages.matches(">25%<").count() == 2, "{stages}");
    assert_eq!(stages.matches("<th scope=\"row\">").count(), 1, "who tells nothing has no row");
}

#[test]
fn the_page_is_made_of_the_tables_alone_and_links_to_the_other() {
    let (dir, page) = page(&timings());
    assert!(!page.contains("index.html") && !page.contains("http"));
    fs::write(dir.path().join("index.html"), "").unwrap();
    fs::remove_file(dir.path().join("goals.csv")).unwrap();
    let again = fs::read_to_string(write(dir.path()).unwrap()).unwrap();
    assert!(again.contains("<a href=\"index.html\">") && !again.contains("<section id=\"goals\""));
    let parts = |start: &str| -> Vec<String> {
        again.split(start).skip(1).map(|rest| rest[..rest.find('"').unwrap()].to_owned()).collect()
    };
    let ids = parts(" id=\"");
    assert!(parts("href=\"#").iter().all(|target| ids.contains(target)));
    fs::remove_file(dir.path().join("timing.csv")).unwrap();
    let error = write(dir.path()).unwrap_err().to_string();
    assert!(error.contains("timing.csv"), "{error}");
}

#[test]
fn a_broken_table_ends_in_one_sentence_and_no_rows_in_a_page() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("timing.csv");
    csv(&file, timings());
    let broken = fs::read_to_string(&file).unwrap().replacen("too slow,", "tired,", 1);
    fs::write(&file, broken).unwrap();
    let error = write(dir.path()).unwrap_err().to_string();
    assert!(error.contains("timing.csv, line 11: ") && error.contains("tired"), "{error}");
    assert!(!dir.path().join(FILE).exists());
    fs::write(&file, "case\n").unwrap();
    let page = fs::read_to_string(write(dir.path()).unwrap()).unwrap();
    assert!(page.contains("Nothing was timed") && page.contains("No family has timed cases"));
}
