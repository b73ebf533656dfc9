//! The C ABI of the shim: the only place with unsafe code.

#[cfg(cgal_found)]
pub use found::{sum, version};
#[cfg(not(cgal_found))]
pub use missing::{sum, version};

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
    use std::ffi::{CStr, CString, c_char, c_int};

    unsafe extern "C" {
        fn arcsum_cgal_version() -> *const c_char;
        fn arcsum_cgal_sum(strategy: c_int, kernel: c_int, a: *const c_char, b: *const c_char) -> *mut c_char;
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

    /// The version of CGAL, if it is built in.
    #[must_use]
    pub fn version() -> Option<String> {
        None
    }

    /// No sum.
    pub fn sum(_: Method, _: &str, _: &str) -> Result<String, CgalError> {
        Err(CgalError::NotBuiltIn)
    }
}
