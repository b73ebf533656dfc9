//! The command `arcsum`.

use std::process::ExitCode;

fn main() -> ExitCode {
    arcsum_reports::command::main()
}
