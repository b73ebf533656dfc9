//! The summary: how many cases, what became of each engine, and the headline numbers. No status is left out.

use super::escape::{filter, text};
use super::folder::{Entry, Folder};
use super::number::{self, Toward};
use super::rank;
use super::rows;
use super::status;
use super::table::{Cell, Table};
use crate::row::Status;

/// Tiles with the headline numbers, and the table of statuses by engine.
pub fn html(folder: &Folder) -> String {
    tiles(&folder.entries) + &statuses(&folder.entries)
}

fn tiles(entries: &[Entry]) -> String {
    let engines = rank::distinct(entries.iter().map(|e| e.row.engine.as_str())).len();
    let families = rank::distinct(entries.iter().map(|e| e.row.family.as_str())).len();
    let cases = rank::distinct(entries.iter().map(|e| e.row.case.as_str())).len();
    let answerless = entries.iter().filter(|e| e.row.status != Status::Ok).count();
    let short = entries.iter().filter(|e| rank::falls_short(e)).count();
    let worst = rank::worst(entries);
    let mut tiles = tile(&number::count(entries.len()), "rows measured", "");
    tiles += &tile(&number::count(cases), &format!("{} families, {} engines", families, engines), "");
    tiles += &tile(&number::count(answerless), "not ok", if answerless > 0 { "bad" } else { "good" });
    tiles += &tile(&number::count(short), "not ok, or under 45 bits", if short > 0 { "bad" } else { "good" });
    if let Some(worst) = worst {
        let mu = rank::error(worst).map_or(String::new(), |mu| number::short(mu, Toward::Up));
        tiles += &tile(&mu, &format!("greatest mu_hi, row {}", rows::link(worst)), "");
    }
    format!("<div class=\"tiles\">{tiles}</div>\n")
}

/// `words` may hold links; both are HTML.
fn tile(figure: &str, words: &str, class: &str) -> String {
    format!("<p class=\"tile {class}\"><b>{figure}</b> {words}</p>")
}

fn statuses(entries: &[Entry]) -> String {
    let names = status::ALL.map(|s| (status::name(s), ""));
    let ends = [("least bits", "of the worst case"), ("greatest mu_hi", "of the worst case"), ("worst row", "")];
    let columns = [("engine", ""), ("version", ""), ("rows", "")].into_iter().chain(names).chain(ends);
    let mut table = Table::new("Rows by engine and status, with the worst of each engine", columns);
    for engine in rank::distinct(entries.iter().map(|e| e.row.engine.as_str())) {
        let of: Vec<&Entry> = entries.iter().filter(|e| e.row.engine == engine).collect();
        let versions = rank::distinct(of.iter().map(|e| e.row.engine_version.as_str())).join(", ");
        let mut cells = vec![Cell::text(engine), Cell::text(&versions), Cell::count(of.len())];
        cells.extend(status::ALL.map(|s| status_count(engine, s, of.iter().filter(|e| e.row.status == s).count())));
        cells.extend(worst_cells(rank::worst(of)));
        table.row(None, &cells);
    }
    table.html()
}

/// The count of a status, linked to the rows it counts.
fn status_count(engine: &str, status: Status, count: usize) -> Cell {
    if count == 0 {
        return Cell::html("<span class=\"quiet\">0</span>".to_owned());
    }
    let term = format!("{} {}", filter("engine", engine), filter("status", status::name(status)));
    let html = format!(
        "<a class=\"badge {}\" href=\"#rows\" data-filter=\"{}\">{}</a>",
        status::name(status),
        text(&term),
        number::count(count)
    );
    Cell::html(html).keyed(&count.to_string())
}

/// Bits, error and row of the worst entry; empty cells where nothing was measured.
pub fn worst_cells(worst: Option<&Entry>) -> [Cell; 3] {
    let Some(worst) = worst else { return [Cell::empty(), Cell::empty(), Cell::empty()] };
    let bits = rank::bits(worst).map_or(Cell::empty(), |bits| Cell::number(bits, number::bits(bits)));
    let mu = rank::error(worst).map_or(Cell::empty(), |mu| Cell::number(mu, number::short(mu, Toward::Up)));
    [bits, mu, Cell::html(rows::link(worst)).keyed(&worst.number.to_string())]
}
