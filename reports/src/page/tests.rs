//! The page as a whole, from folders made by hand.

use super::*;
use crate::row::{Row, Status};
use std::collections::BTreeSet;
use tempfile::TempDir;

fn page_of(rows: &[Row], records: bool) -> (TempDir, String) {
    let dir = tempfile::tempdir().unwrap();
    sample::folder(dir.path(), rows, records);
    let page = write_and_read(dir.path());
    (dir, page)
}

fn write_and_read(dir: &Path) -> String {
    let file = write(dir).unwrap();
    assert_eq!(file, dir.join("index.html"));
    fs::read_to_string(file).unwrap()
}

/// The HTML of one section.
fn section<'a>(page: &'a str, id: &str) -> &'a str {
    let start = page.find(&format!("<section id=\"{id}\"")).unwrap();
    &page[start..start + page[start..].find("</section>").unwrap()]
}

fn mixed_rows() -> Vec<Row> {
    let mut rows: Vec<Row> = (1..=6).map(|i| sample::row(i, Some(1e-16 * i as f64))).collect();
    rows[1].mu_hi = Some(3.25e-6);
    rows[1].bits = Some(-(3.25e-6_f64).log2());
    rows[3] = Row { status: Status::Crashed, note: "signal 11".to_owned(), ..sample::row(4, None) };
    rows[4] = Row { status: Status::Timeout, ..sample::row(5, None) };
    rows[5].engine = "cgal-reduced".to_owned();
    rows
}

#[test]
fn the_worst_case_comes_first_with_its_numbers() {
    let (_dir, page) = page_of(&mixed_rows(), true);
    let worst = section(&page, "worst");
    assert!(worst.contains("<h3>case 2 "), "{worst}");
    assert!(worst.contains("3.25e-6") && worst.contains("arcsum verify &#39;case 2&#39; --engine kinetic"));
    assert!(worst.contains("Worst point, 20 times larger"));
    assert!(worst.contains("<summary>Worst of cgal-reduced"));
}

#[test]
fn a_witness_gives_the_command_to_replay() {
    let (dir, _) = page_of(&mixed_rows(), false);
    fs::create_dir(dir.path().join("witnesses")).unwrap();
    fs::write(dir.path().join("witnesses/0002.json"), "{}").unwrap();
    let page = write_and_read(dir.path());
    assert!(section(&page, "worst").contains("arcsum replay witnesses/0002.json"));
}

#[test]
fn every_status_is_counted() {
    let (_dir, page) = page_of(&mixed_rows(), false);
    let summary = section(&page, "summary");
    let kinetic = &summary[summary.find("<th scope=\"row\">kinetic").unwrap()..];
    let kinetic = &kinetic[..kinetic.find("</tr>").unwrap()];
    assert!(kinetic.contains("<td>5</td>"));
    assert!(
        kinetic.contains(
            "badge ok\" href=\"#rows\" data-filter=\"engine=&quot;kinetic&quot; status=&quot;ok&quot;\">3</a>"
        )
    );
    assert!(kinetic.contains("badge crashed") && kinetic.contains("badge timeout"));
    assert_eq!(kinetic.matches("<span class=\"quiet\">0</span>").count(), 3);
}

#[test]
fn every_row_is_there_with_its_picture() {
    let rows: Vec<Row> = (1..=123).map(|i| sample::row(i, Some(1e-16))).collect();
    let (dir, page) = page_of(&rows, true);
    let table = section(&page, "rows");
    for i in 1..=123 {
        assert!(table.contains(&format!("<tr id=\"r{i}\">")) && table.contains(&format!("<td>case {i}</td>")));
        assert!(table.contains(&format!("href=\"pictures/{i:04}.svg\"")));
        assert!(dir.path().join(format!("pictures/{i:04}.svg")).is_file());
    }
    assert_eq!(table.matches("<tr id=").count(), 123);
}

#[test]
fn names_from_files_are_text() {
    let evil = "<script>alert(\"1\")</script>&'";
    let mut rows = mixed_rows();
    for row in &mut rows {
        row.case = format!("{evil}{}", row.case);
        row.family = evil.to_owned();
        row.engine = format!("{evil}{}", row.engine);
        row.engine_version = evil.to_owned();
        row.note = evil.to_owned();
        row.direction = Some(evil.to_owned());
        row.failed_checks = Some("<script>alert(2)</script>".to_owned());
    }
    let dir = tempfile::tempdir().unwrap();
    sample::folder(dir.path(), &rows, true);
    fs::write(dir.path().join("environment.json"), r#"{"<script>": {"a": "<script>"}}"#).unwrap();
    fs::write(dir.path().join("claims.csv"), "id,verdict,<script>\n1,<script>,<script>\n").unwrap();
    let page = write_and_read(dir.path());
    assert_eq!(page.matches("<script").count(), 1, "only the page's own");
    assert!(page.contains("&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;&amp;&#39;case 2"));
    let picture = fs::read_to_string(dir.path().join("pictures/0002.svg")).unwrap();
    assert!(!picture.contains("<script") && picture.contains("&lt;script&gt;"));
}

#[test]
fn no_rows_make_a_page_that_says_so() {
    let dir = tempfile::tempdir().unwrap();
    let header = sample::headers().iter().collect::<Vec<_>>().join(",");
    for text in [String::new(), header + "\n"] {
        fs::write(dir.path().join("results.csv"), text).unwrap();
        let page = write_and_read(dir.path());
        assert!(section(&page, "rows").contains("holds no rows"));
        assert!(section(&page, "worst").contains("no worst case"));
    }
}

#[test]
fn special_numbers_are_shown_and_doubted() {
    let rows = [
        sample::row(1, Some(f64::NAN)),
        sample::row(2, Some(f64::INFINITY)),
        sample::row(3, Some(0.0)),
        Row { worst_x: None, worst_y: None, direction: None, ..sample::row(4, Some(1e-16)) },
    ];
    let (_dir, page) = page_of(&rows, true);
    assert!(section(&page, "worst").contains("<h3>case 1 "));
    assert!(page.contains("1 row with an error that is NaN or negative"));
    let table = section(&page, "rows");
    assert!(table.contains("<td>NaN</td>") && table.contains("<td>inf</td>"));
    assert!(section(&page, "bits").contains("1 without bits, 1 exact"));
}

#[test]
fn the_same_files_give_the_same_page_wherever_they_lie() {
    let (first, page) = page_of(&mixed_rows(), true);
    assert_eq!(write_and_read(first.path()), page, "written over itself");
    let (second, _) = page_of(&mixed_rows(), true);
    for dir in [&first, &second] {
        fs::write(dir.path().join("cases/0001.json"), "{").unwrap();
    }
    assert_eq!(write_and_read(first.path()), write_and_read(second.path()));
}

#[test]
fn a_broken_table_ends_in_one_sentence() {
    let dir = tempfile::tempdir().unwrap();
    let file = dir.path().join("results.csv");
    let good = sample::csv(&mixed_rows());
    let complaint = |text: &str| {
        fs::write(&file, text).unwrap();
        let error = write(dir.path()).unwrap_err().to_string();
        assert!(!dir.path().join("index.html").exists());
        error.strip_prefix(&format!("{}, ", file.display())).unwrap().to_owned()
    };
    assert_eq!(complaint(&good.replacen("3.25e-6", "wide", 1)), "line 3: `wide` is no number");
    let width = good.lines().find(|line| line.starts_with("case,")).unwrap().split(',').count();
    let torn = format!("line 5: the row has {} fields, the header {width}", width + 1);
    assert_eq!(complaint(&good.replacen("signal 11", "signal,11", 1)), torn);
    assert_eq!(complaint(&good.replacen("case,", "cas,", 1)), "line 2: missing field `case`");
    let status = complaint(&good.replacen("crashed", "tired", 1));
    assert!(status.starts_with("line 5: ") && status.contains("unknown variant `tired`"), "{status}");
}

#[test]
fn only_the_results_must_be_there() {
    let dir = tempfile::tempdir().unwrap();
    let error = write(dir.path()).unwrap_err();
    assert!(matches!(&error, PageError::Io { file, .. } if file.ends_with("results.csv")), "{error}");
    sample::folder(dir.path(), &mixed_rows(), false);
    for (file, text) in [("claims.csv", "id,verdict\nM1"), ("environment.json", "[1]"), ("timing.csv", "a\n\u{0}\n\"x")]
    {
        let whole = write(dir.path());
        assert!(whole.is_ok(), "{whole:?}");
        fs::write(dir.path().join(file), text).unwrap();
        let sound = file == "timing.csv";
        assert_eq!(write(dir.path()).is_ok(), sound, "{file}");
        fs::remove_file(dir.path().join(file)).unwrap();
    }
}

#[test]
fn a_broken_or_foreign_record_costs_only_its_picture() {
    let (dir, _) = page_of(&mixed_rows(), true);
    fs::write(dir.path().join("cases/0001.json"), "{\"row\": 1}").unwrap();
    fs::copy(dir.path().join("cases/0002.json"), dir.path().join("cases/0003.json")).unwrap();
    let page = write_and_read(dir.path());
    assert!(page.contains("row 1 has no picture: cases/0001.json, line 1: "));
    assert!(
        page.contains("row 3 has no picture: cases/0003.json, line 1: the record is that of case &quot;case 2&quot;")
    );
    assert!(!section(&page, "rows").contains("pictures/0001.svg"));
}

#[test]
fn short_rows_are_listed_with_their_notes() {
    let (_dir, page) = page_of(&mixed_rows(), false);
    let short = section(&page, "short");
    assert!(short.contains("signal 11") && short.contains("no note"));
    let order: Vec<usize> = ["case 4", "case 5", "case 2"].iter().map(|c| short.find(c).unwrap()).collect();
    assert!(order.is_sorted(), "{order:?}");
    assert!(!short.contains("case 1<"));
}

#[test]
fn failed_checks_are_counted_and_unchecked_rows_named() {
    let mut rows = mixed_rows();
    rows[0].failed_checks = Some("euler turns".to_owned());
    rows[2].failed_checks = Some("turns".to_owned());
    rows[3].failed_checks = None;
    rows[5].falsely_free = Some(2);
    let (_dir, page) = page_of(&rows, false);
    let checks = section(&page, "checks");
    let turns = &checks[checks.find("<th scope=\"row\">turns").unwrap()..];
    assert!(turns[..turns.find("</tr>").unwrap()].contains("rows <a href=\"#r1\">1</a>, <a href=\"#r3\">3</a>"));
    assert!(checks.contains("falsely free points") && checks.contains("1 row was not checked"));
    assert!(checks.contains("All checks held in 3 rows"));
}

#[test]
fn families_without_any_measurement_come_first() {
    let mut rows = mixed_rows();
    rows[3].family = "lost".to_owned();
    rows[0].family = "fine".to_owned();
    let (_dir, page) = page_of(&rows, false);
    let families = section(&page, "families");
    let order: Vec<usize> = ["lost", "squares", "fine"].map(|f| families.find(&format!(">{f}<")).unwrap()).to_vec();
    assert!(order.is_sorted(), "{order:?}");
}

#[test]
fn the_page_of_the_bench_is_linked_where_it_is() {
    let (dir, page) = page_of(&mixed_rows(), false);
    assert!(!page.contains("bench.html"));
    fs::write(dir.path().join("bench.html"), "").unwrap();
    assert!(write_and_read(dir.path()).contains("<a href=\"bench.html\">"));
}

#[test]
fn links_and_ids_fit_together() {
    let (dir, _) = page_of(&mixed_rows(), true);
    fs::write(dir.path().join("claims.csv"), "id,verdict\nM1,confirmed\n").unwrap();
    let page = write_and_read(dir.path());
    let parts = |start: &str| -> Vec<String> {
        page.split(start).skip(1).map(|rest| rest[..rest.find('"').unwrap()].to_owned()).collect()
    };
    let ids = parts(" id=\"");
    let set: BTreeSet<&String> = ids.iter().collect();
    assert_eq!(set.len(), ids.len(), "an id is used twice");
    for target in parts("href=\"#") {
        assert!(set.contains(&target), "nothing at #{target}");
    }
    assert!(page.contains("badge confirmed"));
    assert!(!page.contains("http"), "a page that opens from disk refers to nothing else");
}
