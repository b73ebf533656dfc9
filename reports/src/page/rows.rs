//! The full table: every row of `results.csv`, every column that is not empty throughout.

use super::columns;
use super::escape::text;
use super::folder::{Entry, Folder};
use super::number;
use super::status;
use super::table::{Cell, Table, shortened};

/// The table with its filter box, its rows anchored as `r1`, `r2`, ...; `drawn[i]` tells whether row i + 1 has a picture.
pub fn html(folder: &Folder, drawn: &[bool]) -> String {
    if folder.entries.is_empty() {
        return "<p>The file <code>results.csv</code> holds no rows: nothing was measured.</p>\n".to_owned();
    }
    let filled = |i: &usize| folder.entries.iter().any(|e| e.cells.get(*i).is_some_and(|c| !c.is_empty()));
    let (shown, left_out): (Vec<usize>, Vec<usize>) = (0..folder.headers.len()).partition(filled);
    let header = |i: &usize| (&folder.headers[*i], columns::find(&folder.headers[*i]).meaning);
    let number = ("#", columns::find("#").meaning);
    let mut table = Table::new("All rows of results.csv", std::iter::once(number).chain(shown.iter().map(header)));
    for (entry, drawn) in folder.entries.iter().zip(drawn) {
        let cells: Vec<Cell> = std::iter::once(numbered(entry, *drawn))
            .chain(shown.iter().map(|i| field(entry, &folder.headers[*i], entry.cells.get(*i).unwrap_or(""))))
            .collect();
        table.row(Some(&format!("r{}", entry.number)), &cells);
    }
    format!("{FILTER}{}<div class=\"all\">{}</div>{}", not_shown(folder, &left_out), table.html(), glossary())
}

/// The link to the row of an entry.
pub fn link(entry: &Entry) -> String {
    format!("<a href=\"#r{0}\">{0}</a>", entry.number)
}

const FILTER: &str = "<form class=\"filter\" role=\"search\" hidden><label for=\"filter\">Rows with</label> \
<input id=\"filter\" type=\"search\" autocomplete=\"off\" spellcheck=\"false\" \
placeholder=\"words, or engine=kinetic bits&lt;45 status!=ok\" aria-describedby=\"matches\"> \
<output id=\"matches\" for=\"filter\"></output></form>\n";

fn numbered(entry: &Entry, drawn: bool) -> Cell {
    if !drawn {
        return Cell::html(entry.number.to_string());
    }
    let html = format!("<a class=\"drawn\" href=\"pictures/{}.svg\">{}</a>", entry.file_stem(), entry.number);
    Cell::html(html).keyed(&entry.number.to_string())
}

fn field(entry: &Entry, name: &str, raw: &str) -> Cell {
    let column = columns::find(name);
    match (name, raw.parse::<f64>()) {
        (_, _) if raw.is_empty() => Cell::empty(),
        ("status", _) => Cell::html(status::badge(entry.row.status)),
        ("bits", Ok(bits)) => Cell::number(bits, number::bits(bits)),
        (_, Ok(value)) if column.toward.is_some() => {
            Cell::number(value, number::short(value, column.toward.unwrap_or(number::Toward::Nearest)))
        }
        _ => shortened(raw),
    }
}

fn not_shown(folder: &Folder, left_out: &[usize]) -> String {
    if left_out.is_empty() {
        return String::new();
    }
    let names: Vec<String> = left_out.iter().map(|i| format!("<code>{}</code>", text(&folder.headers[*i]))).collect();
    format!("<p class=\"quiet\">Not measured in any row, so not shown: {}.</p>\n", names.join(", "))
}

fn glossary() -> String {
    let line = |c: &columns::Column| format!("<dt>{}</dt><dd>{}</dd>", text(c.name), text(c.meaning));
    let lines: String = columns::COLUMNS.iter().map(line).collect();
    format!("<details><summary>What the columns mean</summary><dl class=\"glossary\">{lines}</dl></details>\n")
}
