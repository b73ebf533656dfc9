//! The binary `arcsum` from outside: what it prints, writes and returns.

mod bench;
mod cgal;
mod claims;
mod engines;
mod input;
mod replay;
mod resume;
mod samples;
mod sums;
mod tables;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tempfile::TempDir;

/// The command `arcsum` with these arguments.
fn arcsum(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_arcsum"));
    command.args(arguments);
    command
}

fn run(arguments: &[&str]) -> Output {
    arcsum(arguments).output().unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap_or(-1)
}

fn errors(output: &Output) -> Vec<String> {
    String::from_utf8_lossy(&output.stderr).lines().map(str::to_owned).collect()
}

/// A temporary folder and files in it.
struct Place(TempDir);

impl Place {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn text(&self, name: &str) -> String {
        self.path(name).to_str().unwrap().to_owned()
    }

    /// Writes a file and returns its path as text.
    fn file(&self, name: &str, text: &str) -> String {
        let path = self.path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
        self.text(name)
    }

    /// An engine in the shell: `each` is run for every case, which it finds in `$line`.
    fn engine(&self, name: &str, each: &str) -> String {
        format!("cmd:sh {}", self.file(name, &format!("while read -r line; do\n{each}\ndone\n")))
    }
}

/// A square of this side as JSON.
fn square(side: f64) -> String {
    format!(r#"{{"loops":[[{{"x":0,"y":0}},{{"x":{side},"y":0}},{{"x":{side},"y":{side}}},{{"x":0,"y":{side}}}]]}}"#)
}

/// The rows of `results.csv` with the times left out.
fn rows(folder: &Path) -> Vec<Vec<String>> {
    let mut reader = csv::Reader::from_path(folder.join("results.csv")).unwrap();
    let times: Vec<bool> = reader.headers().unwrap().iter().map(|h| h.starts_with("t_")).collect();
    let keep = |r: csv::StringRecord| r.iter().zip(&times).filter(|(_, t)| !**t).map(|(f, _)| f.to_owned()).collect();
    reader.records().map(|r| keep(r.unwrap())).collect()
}

/// A column of `results.csv`.
fn column(folder: &Path, name: &str) -> Vec<String> {
    let mut reader = csv::Reader::from_path(folder.join("results.csv")).unwrap();
    let index = reader.headers().unwrap().iter().position(|h| h == name).unwrap();
    reader.records().map(|r| r.unwrap()[index].to_owned()).collect()
}
