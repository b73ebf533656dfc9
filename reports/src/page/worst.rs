//! The worst case, with its numbers, its picture and the command that measures it again: first the worst of all, then
//! the worst of every other engine, folded.

use super::escape::{shell, text};
use super::folder::{Entry, Folder};
use super::number::{self, Toward};
use super::picture;
use super::rank;
use super::rows;
use super::status;

/// The section, or a sentence when nothing was measured.
pub fn html(folder: &Folder) -> String {
    let Some(worst) = rank::worst(&folder.entries) else {
        return "<p>No row has an error that was measured: there is no worst case to show.</p>\n".to_owned();
    };
    let engines = rank::distinct(folder.entries.iter().map(|e| e.row.engine.as_str()));
    let others = engines.into_iter().filter(|engine| *engine != worst.row.engine);
    let others = others.filter_map(|engine| rank::worst(folder.entries.iter().filter(|e| e.row.engine == engine)));
    let folded: String = others
        .map(|e| {
            let mu = rank::error(e).map_or(String::new(), |mu| number::short(mu, Toward::Up));
            let engine = text(&e.row.engine);
            format!("<details><summary>Worst of {engine}: mu_hi {mu}</summary>{}</details>\n", case(folder, e))
        })
        .collect();
    format!("<article>{}</article>\n{folded}", case(folder, worst))
}

fn case(folder: &Folder, entry: &Entry) -> String {
    let heading = format!(
        "<h3>{} <small>{} · {} {} · row {}</small> {}</h3>\n",
        text(&entry.row.case),
        text(&entry.row.family),
        text(&entry.row.engine),
        text(&entry.row.engine_version),
        rows::link(entry),
        status::badge(entry.row.status)
    );
    let picture = match folder.record(entry) {
        Ok(Some(record)) => format!("<div class=\"panels\">{}</div>\n", picture::figures(&record)),
        Ok(None) => format!("<p class=\"quiet\">No picture: the folder has no record of row {}.</p>\n", entry.number),
        Err(error) => format!("<p class=\"quiet\">No picture: {}.</p>\n", text(&error.to_string())),
    };
    heading + &numbers(entry) + &command(folder, entry) + &picture
}

/// The measured numbers in full, not rounded.
fn numbers(entry: &Entry) -> String {
    let row = &entry.row;
    let exact = |value: Option<f64>| value.map_or("not measured".to_owned(), |v| format!("{v:e}"));
    let point = match row.worst_x.zip(row.worst_y) {
        Some((x, y)) => format!("({x}, {y}) in input units"),
        None => "not kept".to_owned(),
    };
    let direction = match row.direction.as_deref() {
        Some("result") => "a point of the result far from the sum".to_owned(),
        Some("sum") => "a point of the sum far from the result".to_owned(),
        Some(other) => other.to_owned(),
        None => "not kept".to_owned(),
    };
    let sizes =
        format!("A {}, B {}, convolution {}", row.n, row.m, row.sums.map_or("unknown".to_owned(), |s| s.to_string()));
    let lines = [
        ("mu_hi", exact(row.mu_hi)),
        ("mu_lo", exact(row.mu_lo)),
        ("bits", row.bits.map_or("none".to_owned(), |b| b.to_string())),
        ("attained at", direction),
        ("which is", point),
        ("segments", sizes),
        ("note", row.note.clone()),
    ];
    let line = |(name, value): &(&str, String)| format!("<div><dt>{name}</dt><dd>{}</dd></div>", text(value));
    let told = lines.iter().filter(|(_, value)| !value.is_empty());
    format!("<dl class=\"numbers\">{}</dl>\n", told.map(line).collect::<String>())
}

/// How to measure the case again: from its witness, from its file, or from its seed.
fn command(folder: &Folder, entry: &Entry) -> String {
    let (command, words) = match folder.witness(entry) {
        Some(witness) => (format!("arcsum replay {}", shell(&witness)), "from this folder"),
        None => {
            let (case, engine) = (shell(&entry.row.case), shell(&entry.row.engine));
            (format!("arcsum verify {case} --engine {engine}"), "this folder holds no witness of the row")
        }
    };
    let seed = entry.row.seed.map_or(String::new(), |seed| format!("; made from seed {seed}"));
    format!(
        "<p>Measure it again: <code class=\"command\">{}</code> <small>({words}{seed})</small></p>\n",
        text(&command)
    )
}
