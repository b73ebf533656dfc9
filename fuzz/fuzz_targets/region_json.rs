//! Fuzzes the reader and the validator of regions. Outside cargo-fuzz it runs the files named as arguments.

#![cfg_attr(fuzzing, no_main)]

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|data: &[u8]| {
    arcsum_fuzz::region_json(data);
});

#[cfg(not(fuzzing))]
fn main() -> std::io::Result<()> {
    for file in std::env::args_os().skip(1) {
        println!("{}: {}", file.display(), arcsum_fuzz::region_json(&std::fs::read(&file)?));
    }
    Ok(())
}
