//! The page from records written by hand.

use super::*;
use crate::claims::bench::Bench;
use crate::claims::bench::Effort;
use crate::claims::record::Record;
use std::sync::atomic::AtomicBool;

fn folder(ids: &[&str]) -> tempfile::TempDir {
    let dir = tempfile::tempdir().unwrap();
    std::fs::create_dir(dir.path().join("claims")).unwrap();
    let bench = Bench { effort: Effort::Quick, seed: 1, stop: &AtomicBool::new(false) };
    for id in ids {
        let claim = registry::named(id).remove(0);
        let record = Record::of(&claim, &bench);
        let file = dir.path().join("claims").join(claim.stem() + ".json");
        std::fs::write(file, serde_json::to_string(&record).unwrap()).unwrap();
    }
    dir
}

#[test]
fn a_page_has_a_card_a_claim_and_is_the_same_again() {
    let dir = folder(&["M12 corrected", "M36"]);
    let page = std::fs::read_to_string(write(dir.path()).unwrap().unwrap()).unwrap();
    for part in [
        "id=\"M12_corrected\"",
        "badge confirmed",
        "badge not-tested",
        "badge refuted",
        "Errata",
        "arcsum claims M12_corrected",
    ] {
        assert!(page.contains(part), "{part}");
    }
    let again = std::fs::read_to_string(write(dir.path()).unwrap().unwrap()).unwrap();
    assert_eq!(page, again);
}

#[test]
fn nothing_comes_of_nothing_and_a_broken_record_is_told() {
    let dir = folder(&[]);
    assert_eq!(write(dir.path()).unwrap(), None);
    std::fs::write(dir.path().join("claims/M36.json"), "{").unwrap();
    let error = write(dir.path()).unwrap_err().to_string();
    assert!(error.contains("M36.json") && error.contains("line 1"), "{error}");
}
