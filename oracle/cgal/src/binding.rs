//! The C ABI of the shim: the only place with unsafe code.

#[cfg(cgal_found)]
pub use found::{combine, offset, offset_exact, sum, version};
#[cfg(not(cgal_found))]
pub use missing::{combine, offset, offset_exact, sum, version};

/// Whether CGAL is built in.
#[must_use]
pub fn built_in() -> bool {
    cfg!(cgal_found)
}

#[cfg(cgal_found)]
#[allow(unsafe_code, reason = "a foreign interface")]
mod found {
    use crate::error::CgalError;
    use crate::method::Method;
    use arcsum_oracle::boolean::Operation;
    use std::ffi::{CStr, CString, c_char, c_int};

    unsafe extern "C" {
        fn arcsum_cgal_version() -> *const c_char;
        fn arcsum_cgal_sum(strategy: c_int, kernel: c_int, a: *const c_char, b: *const c_char) -> *mut c_char;
        fn arcsum_cgal_offset(region: *const c_char, radius: *const c_char, error: f64) -> *mut c_char;
        fn arcsum_cgal_offset_exact(region: *const c_char, radius: *const c_char) -> *mut c_char;
        fn arcsum_cgal_combine(operation: c_int, a: *const c_char, b: *const c_char) -> *mut c_char;
        fn arcsum_cgal_free(answer: *mut c_char);
    }

    /// The version of CGAL, if it is built in.
    #[must_use]
    pub fn version() -> Option<String> {
        // SAFETY: the shim returns a literal that ends in a zero.
        let text = unsafe { CStr::from_ptr(arcsum_cgal_version()) };
        Some(text.to_string_lossy().into_owned())
    }

    /// The text of the sum of two regions in text.
    pub fn sum(method: Method, a: &str, b: &str) -> Result<String, CgalError> {
        let (a, b) = (owned(a)?, owned(b)?);
        let (strategy, kernel) = (method.strategy() as c_int, method.kernel() as c_int);
        // SAFETY: both texts end in a zero and outlive the call, which keeps neither.
        taken(unsafe { arcsum_cgal_sum(strategy, kernel, a.as_ptr(), b.as_ptr()) })
    }

    /// The text of the offset of a region by a disc, with an error of at most so much.
    pub fn offset(region: &str, radius: &str, error: f64) -> Result<String, CgalError> {
        let (region, radius) = (owned(region)?, owned(radius)?);
        // SAFETY: as for sums.
        taken(unsafe { arcsum_cgal_offset(region.as_ptr(), radius.as_ptr(), error) })
    }

    /// The text of the exact offset of a region by a disc.
    pub fn offset_exact(region: &str, radius: &str) -> Result<String, CgalError> {
        let (region, radius) = (owned(region)?, owned(radius)?);
        // SAFETY: as for sums.
        taken(unsafe { arcsum_cgal_offset_exact(region.as_ptr(), radius.as_ptr()) })
    }

    /// The text of a set operation on two regions of line and circle segments.
    pub fn combine(operation: Operation, a: &str, b: &str) -> Result<String, CgalError> {
        let (a, b) = (owned(a)?, owned(b)?);
        // SAFETY: as for sums.
        taken(unsafe { arcsum_cgal_combine(operation as c_int, a.as_ptr(), b.as_ptr()) })
    }

    fn owned(text: &str) -> Result<CString, CgalError> {
        CString::new(text).map_err(|e| CgalError::Refused(e.to_string()))
    }

    /// The text of an answer, which is freed.
    fn taken(answer: *mut c_char) -> Result<String, CgalError> {
        if answer.is_null() {
            return Err(CgalError::Failed("no memory for an answer".into()));
        }
        // SAFETY: the shim returns a text of its own that ends in a zero and is nobody else's; it is freed once.
        unsafe {
            let text = CStr::from_ptr(answer).to_string_lossy().into_owned();
            arcsum_cgal_free(answer);
            Ok(text)
        }
    }
}

#[cfg(not(cgal_found))]
mod missing {
    use crate::error::CgalError;
    use crate::method::Method;
    use arcsum_oracle::boolean::Operation;

    /// The version of CGAL, if it is built in.
    #[must_use]
    pub fn version() -> Option<String> {
        None
    }

    /// No offset.
    pub fn offset(_: &str, _: &str, _: f64) -> Result<String, CgalError> {
        Err(CgalError::NotBuiltIn)
    }

    /// No offset.
    pub fn offset_exact(_: &str, _: &str) -> Result<String, CgalError> {
        Err(CgalError::NotBuiltIn)
    }

    /// No set operation.
    pub fn combine(_: Operation, _: &str, _: &str) -> Result<String, CgalError> {
        Err(CgalError::NotBuiltIn)
    }

    /// No sum.
    pub fn sum(_: Method, _: &str, _: &str) -> Result<String, CgalError> {
        Err(CgalError::NotBuiltIn)
    }
}
