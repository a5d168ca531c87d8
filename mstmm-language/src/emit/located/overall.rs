//! Emits the overall transfer equation of a model with locations: its width, its paths, and the transfer matrices of its members.

use super::super::{Names, implement};
use super::{answers_of_members, bounds};
use crate::skeleton::Skeleton;
use proc_macro2::{Literal, TokenStream};
use quote::quote_spanned;

/// `N`, `PATHS`, `impl PlacedTransfers<S>` and `impl Evaluate<S>`.
pub(super) fn overall(skeleton: &Skeleton<'_>, names: &Names) -> TokenStream {
    let Names { private, system, frequency, .. } = names;
    let nodes = skeleton.nodes.len();
    // where the macro does not know the width the paths do
    let (from_paths, size) = match skeleton.overall() {
        Some(overall) => {
            let size = Literal::usize_unsuffixed(overall.unknowns);
            (TokenStream::new(), quote_spanned!(names.here=> #size))
        }
        None => {
            let from_paths = quote_spanned!(names.here=> const N: ::core::primitive::usize = SKETCH.unknowns(PATHS););
            (from_paths, quote_spanned!(names.here=> N))
        }
    };
    let single = quote_spanned!(names.here=> #frequency: #private::Single);
    let all_bounds: Vec<TokenStream> = bounds("TransferMatrix", skeleton, names).into_iter().chain([single]).collect();
    let transfers = transfers(skeleton, all_bounds.clone(), names);
    let body = quote_spanned! {names.here=>
        type Matrix = #private::SMatrix<#frequency, #size, #size>;

        fn overall_matrix(&self, x: #frequency) -> Self::Matrix {
            #private::overall_matrix::<#size, Self, #frequency>(self, PATHS, x)
        }

        fn overall_determinant(&self, x: #frequency) -> #private::Scaled<#frequency> {
            #private::overall_determinant::<#size, Self, #frequency>(self, PATHS, x)
        }
    };
    let evaluate = implement("Evaluate", "Real", all_bounds, &body, names);
    quote_spanned! {names.here=>
        #[allow(long_running_const_eval)]
        const PATHS: &[#private::PathNode; #nodes] = &SKETCH.paths();

        #from_paths

        impl #system {
            /// Width of the overall matrix: the number of unknowns at the boundaries and at cuts.
            pub const N: usize = #size;
        }
        #transfers
        #evaluate
    }
}

/// `impl PlacedTransfers<S>`.
fn transfers(skeleton: &Skeleton<'_>, bounds: Vec<TokenStream>, names: &Names) -> TokenStream {
    let Names { private, frequency, .. } = names;
    let transfers = answers_of_members(skeleton, names, |kind, span| {
        let transfer = names.function_at("member_transfer", span);
        quote_spanned!(names.here=> #transfer::<#kind, #frequency>(built, x))
    });
    let body = quote_spanned! {names.here=>
        fn transfer(
            &self,
            member: ::core::primitive::usize,
            x: #frequency,
        ) -> ::core::option::Option<#private::MemberTransfer<#frequency>> {
            #transfers
        }
    };
    implement("PlacedTransfers", "Real", bounds, &body, names)
}
