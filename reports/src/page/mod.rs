//! The page of a run: `index.html` and one SVG picture a case, made from the files of an output folder alone.
//!
//! [`write()`] reads `results.csv`, the other tables, `environment.json` and the records in `cases/`, and returns the path
//! of the page. No engine runs and nothing is fetched: style and script are inside, and the page opens from disk. The
//! same files give the same page, byte for byte.
//!
//! Files are numbered by the row they belong to, from 1 with four digits: `cases/0001.json` is read, `pictures/0001.svg`
//! written, `witnesses/0001.json` named in the command that measures the worst case again.

pub mod bench;
mod bins;
mod chart;
mod checks;
pub mod claims;
mod columns;
mod cumulative;
mod doubts;
mod edge;
mod environment;
mod escape;
mod families;
mod file;
mod folder;
mod histogram;
mod number;
mod panel;
mod path;
mod picture;
mod rank;
mod rows;
mod scatter;
mod short;
mod status;
mod summary;
mod table;
mod view;
mod worst;

#[cfg(test)]
mod sample;
#[cfg(test)]
mod tests;

use folder::Folder;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Why a page could not be made.
#[derive(Debug, thiserror::Error)]
pub enum PageError {
    /// A file cannot be read or written.
    #[error("{}: {source}", file.display())]
    Io {
        /// The file.
        file: PathBuf,
        /// The system's reason.
        source: io::Error,
    },
    /// A file is not what its name says.
    #[error("{}, line {line}: {reason}", file.display())]
    Broken {
        /// The file.
        file: PathBuf,
        /// The line of the first fault, from 1.
        line: u64,
        /// What is wrong with it.
        reason: String,
    },
}

/// A part of the page: anchor, heading and HTML.
struct Section {
    id: &'static str,
    title: &'static str,
    html: String,
}

/// Tables shown as they are: file, anchor and heading. Each is optional.
const SHEETS: [(&str, &str, &str); 7] = [
    ("claims.csv", "claims", "Claims of the papers"),
    ("timing.csv", "timing", "Times"),
    ("comparison.csv", "comparison", "Times of one engine against another"),
    ("goals.csv", "goals", "Goals against peers"),
    ("iterated.csv", "iterated", "Iterated sums"),
    ("packing.csv", "packing", "Packing"),
    ("goldens.csv", "goldens", "Known answers"),
];

const STYLE: &str = include_str!("style.css");
const SCRIPT: &str = include_str!("script.js");
const GUIDE: &str = include_str!("guide.html");

/// Writes `index.html` and `pictures/` from the other files of the output folder `dir`; returns the path of the page.
///
/// A record that is missing or broken costs its picture, and the page says so; it is no error.
///
/// # Errors
///
/// If `results.csv` is missing, if a table or `environment.json` is there but broken, or if a file cannot be written.
pub fn write(dir: &Path) -> Result<PathBuf, PageError> {
    let folder = Folder::read(dir)?;
    let sheets = sheets(&folder)?;
    let mut broken = Vec::new();
    let drawn = draw(dir, &folder, &mut broken)?;
    let page = page(&folder, sheets, &drawn, &broken);
    let file = dir.join("index.html");
    save(&file, &page)?;
    Ok(file)
}

/// Draws the picture of every row that has a record, and returns which have.
fn draw(dir: &Path, folder: &Folder, broken: &mut Vec<String>) -> Result<Vec<bool>, PageError> {
    let pictures = dir.join("pictures");
    let mut drawn = vec![false; folder.entries.len()];
    for (entry, drawn) in folder.entries.iter().zip(&mut drawn) {
        match folder.record(entry) {
            Ok(Some(record)) => {
                fs::create_dir_all(&pictures).map_err(|source| PageError::Io { file: pictures.clone(), source })?;
                save(&pictures.join(entry.file_stem() + ".svg"), &picture::document(&record))?;
                *drawn = true;
            }
            Ok(None) => {}
            Err(error) => broken.push(format!("row {} has no picture: {}", entry.number, error.within(dir))),
        }
    }
    Ok(drawn)
}

fn save(file: &Path, text: &str) -> Result<(), PageError> {
    fs::write(file, text).map_err(|source| PageError::Io { file: file.to_owned(), source })
}

/// The tables that are there, in the order of [`SHEETS`].
fn sheets(folder: &Folder) -> Result<Vec<Section>, PageError> {
    let mut sections = Vec::new();
    for (file, id, title) in SHEETS {
        if let Some(sheet) = folder.sheet(file)? {
            sections.push(Section { id, title, html: table::plain(file, &sheet) });
        }
    }
    Ok(sections)
}

fn page(folder: &Folder, mut sheets: Vec<Section>, drawn: &[bool], broken: &[String]) -> String {
    let entries = &folder.entries;
    let section = |id, title, html| Section { id, title, html };
    let mut sections = vec![
        section("summary", "Summary", summary::html(folder)),
        section("worst", "The worst case", worst::html(folder)),
    ];
    if sheets.first().is_some_and(|s| s.id == "claims") {
        sections.push(sheets.remove(0));
    }
    sections.push(section("families", "Worst by family", families::html(entries)));
    sections.push(section("checks", "Failed checks", checks::html(entries)));
    sections.push(section("bits", "Distribution of bits", charts(folder)));
    sections.push(section("short", "Short of 45 bits", short::html(entries)));
    sections.append(&mut sheets);
    sections.push(section("rows", "All rows", rows::html(folder, drawn)));
    sections.push(section("environment", "Environment", environment::html(folder)));
    let doubts = doubts::html(entries, broken);
    let others = [(claims::FILE, "The claims"), (bench::FILE, "The bench")];
    let others: Vec<_> = others.into_iter().filter(|(file, _)| folder.has(file)).collect();
    document("arcsum: measured errors", GUIDE, &others, &doubts, &sections)
}

/// A page of these sections below its guide and what is to be doubted; `others` are files and names of pages to link to.
fn document(title: &str, guide: &str, others: &[(&str, &str)], doubts: &str, sections: &[Section]) -> String {
    let mut links: String = sections.iter().map(|s| format!("<a href=\"#{}\">{}</a>", s.id, s.title)).collect();
    links.extend(others.iter().map(|(file, name)| format!("<a href=\"{file}\">{name}</a>")));
    let body: String = sections.iter().map(Section::html).collect();
    let first = sections.first().map_or("", |section| section.id);
    let style = picture::STYLE;
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{title}</title>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<style>\n{STYLE}{style}</style>\n</head>\n<body>\n\
         <a class=\"skip\" href=\"#{first}\">Skip to the numbers</a>\n<header>{guide}<nav aria-label=\"Sections\">{links}</nav>\
         </header>\n<main>\n{doubts}{body}</main>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n"
    )
}

fn charts(folder: &Folder) -> String {
    let entries = &folder.entries;
    if entries.is_empty() {
        return "<p>No rows, no distribution.</p>\n".to_owned();
    }
    let engines = rank::distinct(entries.iter().map(|e| e.row.engine.as_str()));
    let histograms = histogram::html(entries, &engines);
    let (below, size) = (cumulative::html(entries, &engines), scatter::html(entries, &engines));
    format!(
        "<div class=\"charts\">{histograms}</div>\n<div class=\"charts\"><div>{below}</div><div>{size}</div></div>\n"
    )
}

impl Section {
    fn html(&self) -> String {
        let (id, title, html) = (self.id, self.title, &self.html);
        format!(
            "<section id=\"{id}\" aria-labelledby=\"{id}-title\">\n<h2 id=\"{id}-title\">{title}</h2>\n{html}</section>\n"
        )
    }
}

impl PageError {
    /// The sentence with the file named from the folder on: where a folder lies must not change its page.
    fn within(&self, dir: &Path) -> String {
        let near = |file: &Path| file.strip_prefix(dir).unwrap_or(file).display().to_string();
        match self {
            Self::Io { file, source } => format!("{}: {source}", near(file)),
            Self::Broken { file, line, reason } => format!("{}, line {line}: {reason}", near(file)),
        }
    }
}
