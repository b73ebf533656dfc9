//! The memory a process takes: the growth of its resident set, from `/proc` where the system has it (Linux 4.0 on).
//!
//! The kernel counts pages and gathers the counts of its processors now and then, so a growth is good to about 1 MB. A
//! process that computed before reuses memory it never gave back: whoever wants the need of a sum asks a fresh one.

use std::path::PathBuf;

/// A process whose greatest resident set is watched from now on.
#[derive(Debug)]
pub struct Watch {
    status: PathBuf,
    before: u64,
}

impl Watch {
    /// Watches the process of this id, or this one; none where the system does not tell or does not let us.
    #[must_use]
    pub fn start(process: Option<u32>) -> Option<Self> {
        let folder = PathBuf::from("/proc").join(process.map_or_else(|| "self".to_owned(), |id| id.to_string()));
        // 5 sets the greatest resident set back to the present one.
        std::fs::write(folder.join("clear_refs"), "5").ok()?;
        let status = folder.join("status");
        let before = kilobytes(&std::fs::read_to_string(&status).ok()?, "VmHWM")?;
        Some(Self { status, before })
    }

    /// How much larger the resident set has been since, in bytes; none if the process is gone.
    #[must_use]
    pub fn growth(&self) -> Option<u64> {
        let most = kilobytes(&std::fs::read_to_string(&self.status).ok()?, "VmHWM")?;
        Some(most.saturating_sub(self.before) * 1024)
    }
}

/// The number of kilobytes in the line of this name.
fn kilobytes(status: &str, name: &str) -> Option<u64> {
    let mut lines = status.lines().filter_map(|line| line.split_once(':'));
    let (_, value) = lines.find(|(key, _)| *key == name)?;
    value.trim().strip_suffix("kB")?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::hint::black_box;

    /// Planted: 64 MB that are written, and the same that are only asked for, which take no memory.
    #[test]
    fn memory_that_is_written_is_counted_and_a_growth_ends_with_its_watch() {
        let Some(watch) = Watch::start(None) else {
            eprintln!("skipped: this system has no /proc/self/clear_refs");
            return;
        };
        let size = 64 << 20;
        drop(black_box(vec![1_u8; size]));
        let grown = watch.growth().unwrap();
        assert!((60 << 20..128 << 20).contains(&grown), "{grown}");
        let again = Watch::start(None).unwrap();
        drop(black_box(Vec::<u8>::with_capacity(size)));
        let grown = again.growth().unwrap();
        assert!(grown < 48 << 20, "{grown}");
    }

    #[test]
    fn lines_without_a_number_tell_nothing() {
        assert_eq!(kilobytes("VmPeak:\t 7 kB\nVmHWM:\t   12 kB\n", "VmHWM"), Some(12));
        for odd in ["", "VmHWM", "VmHWM: 12", "VmHWM: x kB"] {
            assert_eq!(kilobytes(odd, "VmHWM"), None);
        }
        assert!(Watch::start(Some(u32::MAX)).is_none());
    }
}
