//! The procedural macro behind `mstmm::system!`: a shell around `mstmm-language`.
#![forbid(unsafe_code)]

use proc_macro::TokenStream;

/// Expands `(path to mstmm) model`; called by `mstmm::system!` alone, which knows the path.
#[doc(hidden)]
#[proc_macro]
pub fn expand_system(input: TokenStream) -> TokenStream {
    mstmm_language::expand(input.into()).into()
}
