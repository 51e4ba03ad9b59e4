//! The program `masse`.

use std::process::ExitCode;

fn main() -> ExitCode {
    masse::cli::main()
}
