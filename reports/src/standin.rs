//! Thin stand-ins for parts of the engine and the oracle that are not in the workspace yet.

pub mod format {
    use arcsum::region::Region;
    use std::path::Path;

    pub fn read_file(path: &Path) -> Result<Region, String> {
        let text = std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
        serde_json::from_str(&text).map_err(|e| format!("{}: {e}", path.display()))
    }

    pub fn to_json(region: &Region) -> String {
        serde_json::json!(region).to_string()
    }

    pub fn write_file(path: &Path, region: &Region) -> Result<(), String> {
        std::fs::write(path, to_json(region)).map_err(|e| format!("{}: {e}", path.display()))
    }
}

pub mod page {
    use std::path::Path;

    pub fn write(_: &Path) -> Result<(), String> {
        Ok(())
    }
}

pub mod validate {
    use arcsum::region::Region;

    pub fn validate(region: &Region) -> Result<(), String> {
        if region.loops.is_empty() { Err("the region is empty".into()) } else { Ok(()) }
    }
}

pub mod sum {
    use arcsum::region::Region;
    use std::time::Duration;

    #[derive(Default)]
    pub struct Options {}
    #[derive(Default)]
    pub struct Audit {
        pub sums: usize,
        pub vertices: usize,
        pub faces: usize,
        pub late: usize,
        pub gather: usize,
        pub euler_ok: bool,
        pub winding_ok: bool,
    }
    #[derive(Default)]
    pub struct Times {
        pub convolution: Duration,
        pub arrangement: Duration,
        pub extraction: Duration,
    }
    #[derive(Default)]
    pub struct Sum {
        pub region: Region,
        pub audit: Audit,
        pub times: Times,
        pub convolution: Vec<[f64; 5]>,
    }

    pub fn sum(_: &Region, _: &Region, _: &Options) -> Result<Sum, String> {
        Err("the engine is not in the workspace yet".into())
    }
}

pub mod oracle {
    use arcsum_oracle::plain::PlainRegion;

    pub struct Exact {
        pub loops: Vec<Vec<[f64; 2]>>,
    }
    pub struct Bracket {
        pub lo: f64,
        pub hi: f64,
        pub direction: &'static str,
        pub witness: [f64; 2],
    }

    pub fn sum(_: &PlainRegion, _: &PlainRegion) -> Result<Exact, String> {
        Err("the oracle is not in the workspace yet".into())
    }

    pub fn hausdorff(_: &PlainRegion, _: &Exact, _: f64) -> Bracket {
        Bracket { lo: 0.0, hi: f64::INFINITY, direction: "result", witness: [0.0, 0.0] }
    }
}
