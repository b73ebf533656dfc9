//! Compiles the shim where CGAL is found, and says so by `cfg(cgal_found)`.
//!
//! Found means that a small program against its Minkowski package compiles: headers, GMP and MPFR. Where it does not, or
//! without the feature, everything builds without CGAL, and its functions answer that it is not built in.

fn main() {
    println!("cargo::rustc-check-cfg=cfg(cgal_found)");
    println!("cargo::rerun-if-changed=cpp");
    println!("cargo::rerun-if-changed=build.rs");
    #[cfg(feature = "cgal")]
    shim::build();
}

#[cfg(feature = "cgal")]
mod shim {
    use std::path::{Path, PathBuf};

    /// Each is heavy to compile and instantiates what no other one does.
    const FILES: [&str; 9] = [
        "circles",
        "decompose_exact",
        "decompose_rational",
        "decompose_inexact",
        "convolve_exact",
        "convolve_inexact",
        "convolve_rational",
        "offset_exact",
        "shim",
    ];

    pub fn build() {
        let version = Path::new("/usr/include/CGAL/version.h");
        // A file that is not there would have this run at every build.
        if version.exists() {
            println!("cargo::rerun-if-changed={}", version.display());
        }
        if !probe_compiles() {
            absent("CGAL is not found (on Debian and Ubuntu: libcgal-dev)");
            return;
        }
        // Lints are checked without linking, in a place of their own: there the minutes would be spent once more.
        if std::env::var("RUSTC_WORKSPACE_WRAPPER").is_ok_and(|wrapper| wrapper.contains("clippy")) {
            println!("cargo::rustc-cfg=cgal_found");
            return;
        }
        let files = FILES.map(|file| Path::new("cpp").join(file).with_extension("cpp"));
        if let Err(error) = compiler().files(files).try_compile("arcsum_cgal") {
            absent(&format!("the shim does not compile with this CGAL ({error})").replace('\n', " "));
            return;
        }
        println!("cargo::rustc-link-lib=mpfr");
        println!("cargo::rustc-link-lib=gmp");
        println!("cargo::rustc-cfg=cgal_found");
    }

    fn absent(why: &str) {
        println!("cargo::warning={why}: its engines are not built in; after a change, cargo clean -p arcsum-cgal");
    }

    fn compiler() -> cc::Build {
        let mut build = cc::Build::new();
        // Beyond -O1 it compiles for twice as long and runs no faster.
        build.cpp(true).std("c++17").opt_level(1).debug(false).warnings(false);
        build.define("CGAL_USE_GMP", "1").define("CGAL_USE_MPFR", "1");
        // As in a release of its users: its assertions cost several times as much, and the inexact kernel fails many of
        // them on results that are good.
        build.define("CGAL_NDEBUG", None);
        build
    }

    /// Whether the compiler sees CGAL's Minkowski package, GMP and MPFR.
    fn probe_compiles() -> bool {
        let headers = ["CGAL/version.h", "CGAL/minkowski_sum_2.h", "gmp.h", "mpfr.h"];
        let line = |header: &str| format!("#if !__has_include(<{header}>)\n#error missing\n#endif\n");
        let Some(probe) = std::env::var_os("OUT_DIR").map(|out| PathBuf::from(out).join("probe.cpp")) else {
            return false;
        };
        std::fs::write(&probe, headers.map(line).concat()).is_ok()
            && compiler().cargo_metadata(false).cargo_warnings(false).file(probe).try_compile("probe").is_ok()
    }
}
