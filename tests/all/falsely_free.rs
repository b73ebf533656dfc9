//! The search for falsely free points: that it can find some, and what it found. The witnesses say what is true of the
//! monotonic engine so far: points with rho > mu where MS, Theorem 4, has none. A test that fails here because they are gone
//! is good news.

use arcsum_reports::attack::sieve::sieve;
use arcsum_reports::attack::tally::what;
use arcsum_reports::attack::{Attack, Found, Search, What};
use arcsum_reports::engine::Engine;
use arcsum_reports::engine::own::Own;
use arcsum_reports::judge::{judge, separation};
use arcsum_reports::run::witness::Witness;
use std::convert::Infallible;
use std::fs;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

fn witnesses() -> Vec<(String, Witness)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("witnesses");
    let mut files: Vec<_> =
        fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    let name = |file: &Path| file.file_stem().expect("a name").to_string_lossy().into_owned();
    files.iter().map(|file| (name(file), Witness::read(file).expect("a witness"))).collect()
}

/// Regions far more than 2 mu separated, and a point taken for free whose overlap has an inradius far above mu. The sieve
/// passes it.
#[test]
fn separated_regions_with_falsely_free_points() {
    let all = witnesses();
    assert!(!all.is_empty());
    for (name, Witness { case, engine, measured, .. }) in all {
        let mut own = Own::named(&engine).expect("an engine of ours");
        let answer = own.sum(&case.a, &case.b).expect("valid");
        let judged = judge(&case, &engine, &answer);
        let (mu, free) = (judged.mu_hi.expect("a bracket"), judged.free.expect("tested"));
        let separation = separation::measure(&case).expect("sound").lo.expect("a bracket");
        assert!(mu < 1e-15 && separation > 1e-4, "{name}: {mu:e}, {separation:e}");
        assert!(free.falsely_free > 0 && free.rho.lo > Some(10.0 * mu), "{name}: {free:?}");
        assert!(sieve(&case, own.options()).expect("a sum").suspects > 0, "{name}");
        assert_ne!(what(&measured), Some(What::Unseparated), "{name}");
    }
}

/// What a search of some pairs finds in an engine.
fn found(engine: &str, probes: u64) -> Vec<Found> {
    let search = Search { engine: engine.into(), seed: 1, probes, time: Duration::from_secs(600) };
    let mut attack = Attack::new(search).expect("an engine of ours");
    let mut all = Vec::new();
    let done: Result<(), Infallible> = attack.run(&AtomicBool::new(false), |found| {
        all.push(found);
        Ok(())
    });
    assert!(done.is_ok() && attack.tally.probes() >= probes);
    all
}

/// The kinetic convolution is known to have falsely free points (MS 7): the search finds some.
#[test]
fn the_search_finds_bubbles_of_the_kinetic_engine() {
    let found = found("kinetic", 1_000);
    assert!(found.iter().any(|found| matches!(found.what, What::Inside | What::Boundary)), "{found:?}");
    assert!(Attack::new(Search { engine: "clipper".into(), seed: 1, probes: 1, time: Duration::ZERO }).is_err());
}
