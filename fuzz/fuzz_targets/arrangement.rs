//! Fuzzes arrangements. Outside cargo-fuzz it runs the files named as arguments.

#![cfg_attr(fuzzing, no_main)]

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    arcsum_fuzz::arrangement(data);
});

#[cfg(not(fuzzing))]
fn main() -> std::io::Result<()> {
    for file in std::env::args_os().skip(1) {
        println!("{}: {:?}", file.display(), arcsum_fuzz::arrangement(&std::fs::read(&file)?));
    }
    Ok(())
}
