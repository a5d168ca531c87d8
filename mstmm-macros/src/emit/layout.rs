//! Emits the plan as a constant, its size, and the checks that only types can make.

use super::Names;
use crate::keywords::{SUPPORTS, look_up};
use crate::plan::{Plan, Step};
use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};

/// `LAYOUT`, `N`, and one constant per check at the user's token.
pub(super) fn layout(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, system } = names;
    let count = plan.steps.len();
    let steps = plan.steps.iter().map(|step| emit_step(step, plan, names));
    let checks = plan.steps.iter().enumerate().map(|(index, step)| check(index, step));
    quote! {
        const LAYOUT: #private::Layout<'static, #count> = #private::Layout::new([#(#steps),*]);
        const N: usize = LAYOUT.size();
        #(#checks)*

        impl #system {
            /// Width of the reduced overall matrix: the number of unknowns at the boundaries.
            pub const N: usize = N;
        }
    }
}

fn emit_step(step: &Step<'_>, plan: &Plan<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    match step {
        Step::Tip(keyword) => {
            let support = support(keyword, names);
            quote!(#private::Step::Tip(#support))
        }
        Step::Element { element, input, .. } => {
            let kind = names.element_type(plan.elements[*element]);
            quote!(#private::Step::Element(#input, #private::space_of::<#kind<f64>>()))
        }
        Step::Connection { inputs, .. } => quote!(#private::Step::Connection(&[#(#inputs),*])),
        Step::Root { support: keyword, input } => {
            let support = support(keyword, names);
            quote!(#private::Step::Root(#input, #support))
        }
    }
}

pub(super) fn support(keyword: &Ident, names: &Names) -> TokenStream {
    let private = &names.private;
    // `check` has refused unknown keywords
    let variant = Ident::new(look_up(SUPPORTS, &keyword.to_string()).unwrap_or("Fixed"), keyword.span());
    quote!(#private::Support::#variant)
}

fn check(index: usize, step: &Step<'_>) -> TokenStream {
    match step {
        Step::Tip(keyword) | Step::Root { support: keyword, .. } => {
            quote_spanned!(keyword.span()=> const _: () = LAYOUT.check_support(#index);)
        }
        Step::Element { arrow, .. } => quote_spanned!(*arrow=> const _: () = LAYOUT.check_arrow(#index);),
        Step::Connection { label, .. } => quote_spanned!(*label=> const _: () = LAYOUT.check_connection(#index);),
    }
}
