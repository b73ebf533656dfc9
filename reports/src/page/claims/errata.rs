//! The table of errata, each with its witness.

use crate::claims::errata::{ERRATA, Proof};
use crate::claims::record::written;
use crate::claims::registry::named;
use crate::page::escape::text;
use crate::page::table::{Cell, Table};

/// The table.
pub fn html() -> String {
    let columns = [("place", ""), ("printed", ""), ("right", ""), ("witness", "by the print, as corrected, in truth")];
    let mut table = Table::new("Where the papers are wrong or silent", columns);
    for erratum in ERRATA {
        let cells = [erratum.place, erratum.printed, erratum.right].map(Cell::text);
        table.row(None, &[cells.as_slice(), &[Cell::html(witness(&erratum.proof))]].concat());
    }
    table.html()
}

fn witness(proof: &Proof) -> String {
    match proof {
        Proof::Numbers(of, numbers) => {
            let [printed, right, truth] = numbers().map(written);
            format!("{}: {printed} by the print, {right} as corrected, {truth} in truth", text(of))
        }
        Proof::Claim(id) => {
            let stem = named(id).first().map_or_else(String::new, |claim| claim.stem());
            format!("<a href=\"#{stem}\">{}</a>", text(id))
        }
        Proof::Words(words) => text(words),
    }
}
