//! Rows, records and folders made by hand for the tests of the page.

use super::folder::Entry;
use crate::row::{Record, Row, Status};
use arcsum::region::{Node, Region};
use csv::StringRecord;
use std::fs;
use std::path::Path;

/// A good row of case `case <number>`.
pub fn row(number: usize, mu_hi: Option<f64>) -> Row {
    Row {
        case: format!("case {number}"),
        family: "squares".to_owned(),
        engine: "kinetic".to_owned(),
        engine_version: "1.0".to_owned(),
        status: if mu_hi.is_some_and(|mu| !mu.is_nan()) { Status::Ok } else { Status::Undecided },
        seed: None,
        mu_lo: mu_hi.map(|mu| mu / 2.0),
        mu_hi,
        bits: mu_hi.map(|mu| -mu.log2()),
        direction: Some("sum".to_owned()),
        worst_x: Some(2.0),
        worst_y: Some(2.0),
        mu_realized_lo: None,
        mu_realized_hi: None,
        rho_lo: None,
        rho_hi: None,
        pd_lo: None,
        pd_hi: None,
        trap: None,
        tested: None,
        left_out: None,
        falsely_free: None,
        innocent: None,
        open: None,
        falsely_blocked: None,
        separation_lo: None,
        separation_hi: None,
        samples: None,
        samples_failed: None,
        sampled_mu: None,
        sampled_lo: None,
        n: 4,
        m: 4,
        sums: Some(8),
        vertices: None,
        crossings: None,
        k: None,
        late: None,
        gather: None,
        cancelled: None,
        order_conflict: None,
        cells: None,
        bubbles: None,
        cracks: None,
        result_segments: Some(4),
        result_loops: Some(1),
        exact_loops: Some(1),
        exact_bits: Some(256),
        failed_checks: Some("none".to_owned()),
        t_convolution: None,
        t_arrangement: None,
        t_extraction: None,
        note: String::new(),
    }
}

/// Entries numbered from 1 with these errors; their cells are those of the CSV file.
pub fn entries(errors: &[Option<f64>]) -> Vec<Entry> {
    let rows = errors.iter().enumerate().map(|(i, mu)| row(i + 1, *mu));
    rows.enumerate().map(|(i, row)| Entry { number: i + 1, row, cells: StringRecord::new() }).collect()
}

/// The rows as the text of `results.csv`.
pub fn csv(rows: &[Row]) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row).unwrap();
    }
    String::from_utf8(writer.into_inner().unwrap()).unwrap()
}

/// The columns of `results.csv`.
pub fn headers() -> StringRecord {
    let text = csv(&[row(1, None)]);
    csv::Reader::from_reader(text.as_bytes()).headers().unwrap().clone()
}

/// A rectangle.
pub fn rectangle(x: f64, y: f64, width: f64, height: f64) -> Vec<Node> {
    vec![Node::line(x, y), Node::line(x + width, y), Node::line(x + width, y + height), Node::line(x, y + height)]
}

/// A bounded region of these loops.
pub fn region(loops: Vec<Vec<Node>>) -> Region {
    Region { name: None, loops, unbounded: false }
}

/// The unit square plus itself, measured as `row` says.
pub fn record(row: Row) -> Record {
    let square = region(vec![rectangle(0.0, 0.0, 1.0, 1.0)]);
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    let side = |i: usize| {
        let ([x0, y0], [x1, y1]) = (corners[i], corners[(i + 1) % 4]);
        [x0, y0, x1, y1, 0.0]
    };
    let result = Some(region(vec![rectangle(0.0, 0.0, 2.0, 2.0)]));
    Record { row, a: square.clone(), b: square, result, convolution: (0..4).map(side).collect() }
}

/// Writes `results.csv` and, with `records`, one record a row.
pub fn folder(dir: &Path, rows: &[Row], records: bool) {
    fs::write(dir.join("results.csv"), csv(rows)).unwrap();
    if records {
        fs::create_dir_all(dir.join("cases")).unwrap();
        for (i, row) in rows.iter().enumerate() {
            let text = serde_json::to_string(&record(row.clone())).unwrap();
            fs::write(dir.join(format!("cases/{:04}.json", i + 1)), text).unwrap();
        }
    }
}
