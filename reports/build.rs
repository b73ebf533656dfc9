//! Stamps the binary with the compiler, the flags and the commit it was built from; `environment.json` shows them.

use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    stamp("ARCSUM_RUSTC", said(&rustc, &["--version"]));
    stamp("ARCSUM_COMMIT", said("git", &["rev-parse", "HEAD"]));
    stamp("ARCSUM_PROFILE", std::env::var("PROFILE").ok());
    stamp("ARCSUM_TARGET", std::env::var("TARGET").ok());
    stamp("ARCSUM_RUSTFLAGS", std::env::var("CARGO_ENCODED_RUSTFLAGS").ok().map(|f| f.replace('\x1f', " ")));
    // The log of HEAD grows with every commit; sources from an archive have none, and no commit either.
    if let Some(log) = said("git", &["rev-parse", "--git-path", "logs/HEAD"]) {
        println!("cargo::rerun-if-changed={log}");
    }
}

fn stamp(name: &str, value: Option<String>) {
    println!("cargo::rustc-env={name}={}", value.unwrap_or_default());
}

fn said(program: &str, arguments: &[&str]) -> Option<String> {
    let output = Command::new(program).args(arguments).output().ok().filter(|o| o.status.success())?;
    Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}
