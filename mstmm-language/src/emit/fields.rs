//! Emits how formulas see the fields, and a warning for each field that none of them uses.

use super::Names;
use crate::ast::{Element, Field, Model};
use crate::spans::collect_names;
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote_spanned};
use std::collections::BTreeSet;
use syn::ext::IdentExt;

/// The fields whose names occur in no formula, unless they begin with an underscore.
fn unused_fields(model: &Model) -> Vec<&Ident> {
    let mut used = BTreeSet::new();
    let mut uses = |formula: &dyn ToTokens| collect_names(formula.to_token_stream(), &mut used);
    model.lets.iter().for_each(|line| uses(line));
    model.elements().flat_map(Element::parameters).for_each(|parameter| uses(&parameter.expression()));
    model.coordinates().flat_map(|coordinates| &coordinates.parts).for_each(|part| uses(part));
    let names = model.fields().map(|field| field.name);
    names.filter(|name| !used.contains(&name.to_string()) && !name.unraw().to_string().starts_with('_')).collect()
}

/// `let length = self.length;` for each field.
pub(super) fn bindings(model: &Model, names: &Names) -> TokenStream {
    let unused = unused_fields(model);
    let fields = model.fields().map(|Field { name, conditions, .. }| {
        // rustc need not say again what the macro says
        let silence = unused.contains(&name).then(|| quote_spanned!(names.here=> #(#conditions)* let _ = #name;));
        quote_spanned!(names.here=> #(#conditions)* let #name = self.#name; #silence)
    });
    quote_spanned!(names.here=> #(#fields)*)
}

/// A warning at each field that no formula uses: the one of rustc about what is deprecated, to which a macro
/// can give words and a place.
pub(super) fn unused(model: &Model, names: &Names) -> TokenStream {
    let unused = unused_fields(model);
    let warnings =
        model.fields().filter(|field| unused.contains(&field.name)).map(|Field { name, conditions, .. }| {
            let span = names.at(name.span());
            let note = format!("no parameter uses `{0}`: remove the field, or call it `_{0}`", name.unraw());
            let unused = Ident::new("unused_field", span);
            quote_spanned! {span=>
                #(#conditions)*
                const _: () = {
                    #[allow(non_upper_case_globals)]
                    #[deprecated(note = #note)]
                    const #unused: () = ();
                    #unused
                };
            }
        });
    quote_spanned!(names.here=> #(#warnings)*)
}
