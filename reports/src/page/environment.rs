//! Where and with what the run was made: `environment.json`, whatever it holds, as a table.

use super::folder::Folder;
use super::table::{Cell, Table};
use serde_json::Value;

/// The table; nested objects get dotted names.
pub fn html(folder: &Folder) -> String {
    let Some(environment) = &folder.environment else {
        return "<p>The folder holds no <code>environment.json</code>: where this was measured is not known.</p>\n"
            .to_owned();
    };
    let mut table = Table::new("environment.json", [("name", ""), ("value", "")]);
    for (name, value) in environment {
        add(&mut table, name, value);
    }
    table.html()
}

fn add(table: &mut Table, name: &str, value: &Value) {
    match value {
        Value::Object(inner) if !inner.is_empty() => {
            for (key, value) in inner {
                add(table, &format!("{name}.{key}"), value);
            }
        }
        Value::String(words) => table.row(None, &[Cell::text(name), Cell::text(words)]),
        other => table.row(None, &[Cell::text(name), Cell::text(&other.to_string())]),
    }
}
