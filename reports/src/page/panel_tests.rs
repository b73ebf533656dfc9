//! Panels of simple regions: what is drawn, and that nothing is left out in silence.

use super::*;
use crate::page::sample;
use crate::row::Status;

fn plain_record() -> Record {
    sample::record(sample::row(1, Some(1e-15)))
}

fn heading_and_notes(panels: &[Panel], start: &str) -> String {
    let panel = panels.iter().find(|p| p.heading.starts_with(start)).unwrap();
    format!("{} | {}", panel.heading, panel.notes.join(" | "))
}

#[test]
fn panels_share_one_scale() {
    let panels = panels(&plain_record());
    let widths: Vec<f64> = panels.iter().map(|p| p.size[0]).collect();
    let margins = 2.0 * MARGIN;
    assert_eq!(panels.len(), 5);
    assert!((widths[0] - (SIDE / 2.0 + margins)).abs() < 1e-9, "{widths:?}");
    assert!((widths[2] - (SIDE + margins)).abs() < 1e-9 && widths[2] == widths[3]);
}

#[test]
fn zoom_is_stated() {
    let panels = panels(&plain_record());
    let words = heading_and_notes(&panels, "Worst point");
    assert_eq!(words, "Worst point, 20 times larger | at (2, 2) | mu is 1.40e-12 px here");
}

#[test]
fn inset_is_fitted_to_an_error_that_can_be_seen() {
    let mut record = plain_record();
    record.row.mu_lo = Some(1e-3);
    let fitted = heading_and_notes(&panels(&record), "Worst point");
    assert_eq!(fitted, "Worst point, 100 times larger | at (2, 2) | mu is 1.40e1 px here");
    record.row.mu_lo = Some(10.0);
    assert!(heading_and_notes(&panels(&record), "Worst point").starts_with("Worst point, 1 times larger"));
}

#[test]
fn no_worst_point_no_inset() {
    for (x, y) in [(None, Some(1.0)), (Some(f64::NAN), Some(1.0)), (Some(1.0), Some(f64::INFINITY))] {
        let mut record = plain_record();
        (record.row.worst_x, record.row.worst_y) = (x, y);
        let panels = panels(&record);
        assert_eq!(panels.len(), 4);
        assert!(panels.iter().all(|p| !p.body.contains("class=\"x\"")));
    }
}

#[test]
fn missing_empty_and_infinite_results_are_named() {
    let mut record = plain_record();
    record.result = None;
    record.row.status = Status::Crashed;
    assert_eq!(heading_and_notes(&panels(&record), "Result"), "Result: none | crashed");
    record.result = Some(Region::default());
    assert_eq!(heading_and_notes(&panels(&record), "Result"), "Result: 0 segments, 0 loops | empty");
    record.result = Some(Region::plane());
    let all = panels(&record);
    assert_eq!(heading_and_notes(&all, "Result"), "Result: 0 segments, 0 loops | the whole plane");
    assert!(all[3].body.contains("class=\"r\""));
    record.result = Some(sample::region(vec![sample::rectangle(0.0, 0.0, f64::INFINITY, 1.0)]));
    assert!(heading_and_notes(&panels(&record), "Result").contains("not drawn"));
}

#[test]
fn a_wild_result_does_not_shrink_the_rest() {
    let mut record = plain_record();
    record.result = Some(sample::region(vec![sample::rectangle(0.0, 0.0, 1e9, 1.0)]));
    let panels = panels(&record);
    assert!(heading_and_notes(&panels, "Result").contains("reaches beyond the frame"));
    assert!(panels[0].size[0] > 90.0, "{:?}", panels[0].size);
}

#[test]
fn left_out_segments_are_counted() {
    let mut record = plain_record();
    record.convolution = (0..5000).map(|i| [0.0, 0.0, 2.0, f64::from(i) / 2500.0, 0.0]).collect();
    let words = heading_and_notes(&panels(&record), "Convolution");
    assert_eq!(words, "Convolution: 5,000 segments | 3,000 of 5,000 drawn");
    record.convolution.clear();
    let words = heading_and_notes(&panels(&record), "Convolution");
    assert_eq!(words, "Convolution: 0 segments | the engine shows none");
}

#[test]
fn degenerate_regions_do_no_harm() {
    let mut record = plain_record();
    record.a = Region::default();
    record.b = sample::region(vec![vec![arcsum::region::Node::line(1.0, 1.0)]]);
    record.result = None;
    record.convolution.clear();
    for panel in panels(&record) {
        assert!(panel.size.iter().all(|s| s.is_finite() && *s > 0.0), "{panel:?}");
        assert!(!panel.body.contains("NaN") && !panel.body.contains("inf"), "{panel:?}");
    }
}
