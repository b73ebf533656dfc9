//! A claim in full: what it says, the number, the control, the erratum, the plot, the worst input and the command.

use super::{badge, plot};
use crate::claims::Test;
use crate::claims::finding::{Finding, Worst};
use crate::claims::input::Input;
use crate::claims::record::{Record, written};
use crate::claims::registry::named;
use crate::page::escape::text;
use crate::page::{panel, picture};

/// The parts of the sum's side around the worst point: to see where it is, and what happens in the last places.
const PARTS: [f64; 3] = [0.05, 1e-6, 1e-14];

/// Numbers of an input that are shown.
const MOST_NUMBERS: usize = 12;

/// The card.
pub fn html(record: &Record) -> String {
    let Record { id, place, says, erratum, quantity, finding, .. } = record;
    let stem = record.stem();
    let mut body = format!(
        "<article id=\"{stem}\"><h3>{} {}</h3>\n<p>{} <span class=\"quiet\">({})</span></p>\n",
        text(id),
        badge(finding.verdict.word()),
        text(says),
        text(place)
    );
    if !quantity.is_empty() {
        body += &format!("<p>{}</p>\n", text(&measured(record)));
    }
    body += &paragraph("", &finding.note);
    body += &paragraph("Erratum: ", erratum);
    if let Some(control) = &record.control {
        body += &controlled(&record.plants, control);
    }
    body += &plot::html(&finding.plot, finding.bound);
    if let Some(worst) = &finding.worst {
        body += &worst_input(&stem, worst);
        body += &record.picture.as_ref().map_or_else(String::new, |found| {
            format!("<div class=\"charts\">{}</div>\n", picture::framed(&panel::closer(found, &PARTS)))
        });
    }
    body + &command(record) + "</article>\n"
}

fn paragraph(label: &str, words: &str) -> String {
    if words.is_empty() { String::new() } else { format!("<p>{label}{}</p>\n", text(words)) }
}

fn measured(record: &Record) -> String {
    let Finding { lo, hi, bound, cases, undecided, .. } = &record.finding;
    let unit = if record.unit == "1" { String::new() } else { format!(" {}", record.unit) };
    let value = if lo == hi { written(*lo) } else { format!("between {} and {}", written(*lo), written(*hi)) };
    let bound = bound.map_or_else(String::new, |bound| format!("; bound {}", written(bound)));
    let open = if *undecided > 0 { format!(", {undecided} of them undecided") } else { String::new() };
    format!("Measured, {}: {value}{unit}{bound}; {cases} cases{open}.", record.quantity)
}

fn controlled(plants: &str, control: &Finding) -> String {
    let verdict = badge(control.verdict.word());
    format!("<p>Control, {}: {verdict} {} in {} cases.</p>\n", text(plants), written(control.lo), control.cases)
}

fn worst_input(stem: &str, worst: &Worst) -> String {
    let what = match &worst.input {
        Input::Pair(case) => format!("{}, {} and {} segments", case.name, case.a.segments(), case.b.segments()),
        Input::Numbers(numbers) => {
            let shown: Vec<String> = numbers.values.iter().take(MOST_NUMBERS).map(|v| format!("{v:e}")).collect();
            let more = if numbers.values.len() > MOST_NUMBERS { ", ..." } else { "" };
            format!("{}: {}{more}", numbers.of, shown.join(", "))
        }
    };
    let file = format!("witnesses/{stem}.json");
    format!("<p>Worst input: {} (<a href=\"{file}\">{file}</a>).</p>\n", text(&what))
}

fn command(record: &Record) -> String {
    let effort = format!("{:?}", record.effort).to_lowercase();
    let again = format!("arcsum claims {} --effort {effort} --seed {}", record.stem(), record.seed);
    let on_single_inputs = named(&record.id).iter().any(|claim| matches!(claim.test, Test::Sup(_)));
    let replay = if record.finding.worst.is_some() && on_single_inputs {
        format!("<br><code>arcsum replay witnesses/{}.json</code>", record.stem())
    } else {
        String::new()
    };
    format!("<p><code>{}</code>{replay}</p>\n", text(&again))
}
