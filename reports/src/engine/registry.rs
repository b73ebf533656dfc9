//! The engines by name.

use super::command::Program;
use super::own::Own;
use super::{Abilities, Engine};
use arcsum::sum::Convolution;

/// The built-in engines.
pub const BUILT_IN: &[&str] = &["kinetic", "monotonic"];

/// A name that is no engine's.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no engine is called {0}; there are {known}, and cmd:PROGRAM", known = BUILT_IN.join(", "))]
pub struct NoSuchEngine(pub String);

/// The engine of this name.
///
/// # Errors
/// When there is none.
pub fn engine(name: &str) -> Result<Box<dyn Engine>, NoSuchEngine> {
    match name {
        "kinetic" => Ok(Box::new(Own(Convolution::Kinetic))),
        "monotonic" => Ok(Box::new(Own(Convolution::Monotonic))),
        _ if name.strip_prefix("cmd:").is_some_and(|p| !p.trim().is_empty()) => Ok(Box::new(Program::new(name))),
        _ => Err(NoSuchEngine(name.to_owned())),
    }
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
