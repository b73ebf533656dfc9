//! The engines by name.

use super::cgal::Cgal;
use super::command::Program;
use super::offset::{self, Offset};
use super::own::Own;
use super::peer::{FEATURES, Peer};
use super::{Abilities, Engine};

/// The built-in engines that take all robustness steps.
pub const BUILT_IN: &[&str] = &["kinetic", "monotonic"];

/// The same, what lies deep inside the sum culled before it is arranged.
pub const CULLED: &[&str] = &["kinetic-culled", "monotonic-culled"];

/// The baselines without any (MS 8.3).
pub const NAIVE: &[&str] = &["naive-kinetic", "naive-monotonic"];

/// The kinetic convolution with the heuristic against falsely free points (MS 8.2).
pub const HEURISTIC: &[&str] = &["kinetic-heuristic"];

/// The convex convolution (MS 3), to compare with.
pub const CONVEX: &[&str] = &["convex"];

/// A name that is no engine's.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no engine is called {0}; there are {known}, the first two also with -without-{steps}, cmd:PROGRAM, {cgal}, and, with the cargo features {features}, those of others{peers}",
    known = [BUILT_IN, CULLED, NAIVE, HEURISTIC, CONVEX].concat().join(", "), steps = arcsum::robustness::Step::ALL.map(|(_, name)| name).join("|"),
    cgal = [Cgal::names(), offset::NAMES.map(str::to_owned).to_vec()].concat().join(", "), features = FEATURES.join(", "), peers = in_brackets(&Peer::names()))]
pub struct NoSuchEngine(pub String);

/// Names in brackets after a space, or nothing.
fn in_brackets(names: &[&str]) -> String {
    if names.is_empty() { String::new() } else { format!(" ({})", names.join(", ")) }
}

/// The engine of this name.
///
/// # Errors
/// When there is none.
pub fn engine(name: &str) -> Result<Box<dyn Engine>, NoSuchEngine> {
    if let Some(own) = Own::named(name) {
        return Ok(Box::new(own));
    }
    if let Some(cgal) = Cgal::named(name) {
        return Ok(Box::new(cgal));
    }
    if let Some(offset) = Offset::named(name) {
        return Ok(Box::new(offset));
    }
    if let Some(peer) = Peer::named(name) {
        return Ok(Box::new(peer));
    }
    if name.strip_prefix("cmd:").is_some_and(|p| !p.trim().is_empty()) {
        return Ok(Box::new(Program::new(name)));
    }
    Err(NoSuchEngine(name.to_owned()))
}

/// What the runner needs to know of an engine without asking it anything.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facts {
    /// The name.
    pub name: String,
    /// The version.
    pub version: String,
    /// What it can do.
    pub abilities: Abilities,
}

/// The facts of an engine.
///
/// # Errors
/// When there is no engine of this name.
pub fn facts(name: &str) -> Result<Facts, NoSuchEngine> {
    let engine = engine(name)?;
    Ok(Facts { name: engine.name().to_owned(), version: engine.version(), abilities: engine.abilities() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use arcsum::robustness::Step;

    #[test]
    fn engines_answer_to_their_names() {
        let steps = Step::ALL.map(|(_, step)| format!("monotonic-without-{step}"));
        let names = [BUILT_IN, CULLED, NAIVE, HEURISTIC, CONVEX].concat();
        for name in names.into_iter().chain(Peer::names()).map(str::to_owned).chain(steps) {
            assert_eq!(facts(&name).unwrap().name, name);
        }
    }

    #[test]
    fn others_are_refused() {
        for name in [
            "",
            "naive",
            "naive-",
            "naive-kinetic-heuristic",
            "naive-kinetic-without-gather",
            "kinetic-without-",
            "naive-kinetic-culled",
            "convex-culled",
            "kinetic-without-x",
            "cmd:",
            "naive-convex",
        ] {
            let refusal = engine(name).err().unwrap().to_string();
            assert!(refusal.contains("naive-monotonic") && refusal.contains("late-swaps"), "{refusal}");
        }
    }
}
