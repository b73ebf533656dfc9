//! Tables of the page: one way to write them, all sortable by the script.
//!
//! A cell sorts by its key: the exact value, where the page shows a shortened one.

use super::escape::text;
use super::file::Sheet;
use super::number;

/// A cell as HTML, with the value it sorts by.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    html: String,
    key: Option<String>,
}

/// A table under construction. The first cell of a row is its heading.
#[derive(Clone, Debug)]
pub struct Table {
    caption: String,
    head: String,
    body: String,
    rows: usize,
}

impl Cell {
    /// Text from a file.
    pub fn text(raw: &str) -> Self {
        Self { html: text(raw), key: None }
    }

    /// A count.
    pub fn count(count: usize) -> Self {
        let html = number::count(count);
        Self { key: (count >= 1000).then(|| count.to_string()), html }
    }

    /// A number shortened to `shown`.
    pub fn number(value: f64, shown: String) -> Self {
        let exact = format!("{value:e}");
        let exact = if value.is_finite() { exact } else { shown.clone() };
        Self { key: (exact != shown).then_some(exact), html: shown }
    }

    /// What is known to be HTML already.
    pub fn html(html: String) -> Self {
        Self { html, key: None }
    }

    /// The same cell, sorted by `key`.
    pub fn keyed(self, key: &str) -> Self {
        Self { key: Some(key.to_owned()), ..self }
    }

    /// Nothing was measured.
    pub fn empty() -> Self {
        Self::html(String::new())
    }
}

impl Table {
    /// A table with a caption and columns given as name and meaning; no meaning, no tooltip.
    pub fn new<'a>(caption: &str, columns: impl IntoIterator<Item = (&'a str, &'a str)>) -> Self {
        let heading = |(name, meaning): (&str, &str)| {
            let title = if meaning.is_empty() { String::new() } else { format!(" title=\"{}\"", text(meaning)) };
            format!("<th scope=\"col\"{title}>{}</th>", text(name))
        };
        let head = columns.into_iter().map(heading).collect();
        Self { caption: caption.to_owned(), head, body: String::new(), rows: 0 }
    }

    /// Adds a row; `id` is its anchor, if any.
    pub fn row(&mut self, id: Option<&str>, cells: &[Cell]) {
        let id = id.map(|id| format!(" id=\"{id}\"")).unwrap_or_default();
        self.body.push_str(&format!("<tr{id}>"));
        for (i, cell) in cells.iter().enumerate() {
            let (open, close) = if i == 0 { ("<th scope=\"row\"", "</th>") } else { ("<td", "</td>") };
            self.body.push_str(open);
            if let Some(key) = &cell.key {
                self.body.push_str(&format!(" title=\"{}\"", text(key)));
            }
            self.body.push('>');
            self.body.push_str(&cell.html);
            self.body.push_str(close);
        }
        self.body.push_str("</tr>\n");
        self.rows += 1;
    }

    /// Whether it has no rows.
    pub fn is_empty(&self) -> bool {
        self.rows == 0
    }

    /// The table inside a box that scrolls. The box can be focused, so that keys scroll it too.
    pub fn html(&self) -> String {
        let caption = text(&self.caption);
        format!(
            "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{caption}\"><table>\
             <caption>{caption}</caption>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody></table></div>\n",
            self.head, self.body
        )
    }
}

/// A CSV file as it is.
pub fn plain(caption: &str, sheet: &Sheet) -> String {
    let mut table = Table::new(caption, sheet.headers.iter().map(|name| (name, "")));
    for row in &sheet.rows {
        let cells: Vec<Cell> = row.iter().zip(sheet.headers.iter()).map(|(raw, name)| plain_cell(name, raw)).collect();
        table.row(None, &cells);
    }
    let note = if table.is_empty() { "<p>The file has no rows.</p>\n" } else { "" };
    note.to_owned() + &table.html()
}

/// Verdicts on their colour, long fractions shortened, everything else as it is.
fn plain_cell(name: &str, raw: &str) -> Cell {
    match (name, raw) {
        ("verdict", "confirmed" | "refuted" | "undecided" | "not tested") => {
            Cell::html(format!("<span class=\"badge {}\">{raw}</span>", raw.replace(' ', "-")))
        }
        _ => shortened(raw),
    }
}

/// A field of a file; a fraction of more than eight characters is cut to four significant digits.
pub fn shortened(raw: &str) -> Cell {
    let fraction = raw.len() > 8 && raw.contains(['.', 'e']);
    match raw.parse::<f64>() {
        Ok(value) if fraction && value.is_finite() => {
            let digits = format!("{value:.3e}");
            let tame = value == 0.0 || (1e-3..1e6).contains(&value.abs());
            let shown = digits.parse::<f64>().ok().filter(|_| tame).map_or(digits, |v| v.to_string());
            Cell::html(text(&shown)).keyed(raw)
        }
        _ => Cell::text(raw),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_keep_the_exact_value() {
        let cell = Cell::number(1.2345e-16, "1.24e-16".to_owned());
        assert_eq!(cell.key.as_deref(), Some("1.2345e-16"));
        assert_eq!(Cell::number(f64::INFINITY, "inf".to_owned()).key, None);
        assert_eq!(shortened("12.3456789012"), Cell::html("12.35".to_owned()).keyed("12.3456789012"));
        assert_eq!(shortened("1.23456789e-17"), Cell::html("1.235e-17".to_owned()).keyed("1.23456789e-17"));
        assert_eq!(shortened("1234567890"), Cell::text("1234567890"));
        assert_eq!(shortened("deadbeef.e"), Cell::text("deadbeef.e"));
    }

    #[test]
    fn files_are_escaped() {
        let record = |fields: &[&str]| csv::StringRecord::from(fields.to_vec());
        let sheet = Sheet { headers: record(&["<i>", "verdict"]), rows: vec![record(&["<b>", "<b>"])] };
        let html = plain("<u>", &sheet);
        assert!(html.contains("&lt;i&gt;") && html.contains("&lt;b&gt;") && html.contains("&lt;u&gt;"));
        assert!(!html.contains("<b>") && !html.contains("<i>") && !html.contains("<u>"));
    }
}
