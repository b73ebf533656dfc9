//! d
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::error::Budget;
use arcsum_reports::bridge::{plain, unit};
use arcsum_reports::row::Record;
fn main() {
    for f in std::env::args().skip(1) {
        let r: Record = serde_json::from_str(&std::fs::read_to_string(&f).unwrap()).unwrap();
        let t = std::time::Instant::now();
        let e = Reference::new(&plain(&r.a), &plain(&r.b), unit(&r.a, &r.b), Budget::default());
        match e {
            Ok(e) => {
                println!(
                    "{} {} pieces {} undecided {} {:?}",
                    f,
                    r.row.case,
                    e.sum().pieces.len(),
                    e.undecided(),
                    t.elapsed()
                );
                println!("{:?} {:?}", e.measure(&plain(&r.result.unwrap())), t.elapsed());
            }
            Err(x) => println!("{f} {x}"),
        }
    }
}
