//! Emits how formulas see the fields, and a warning for each field that none of them uses.

use super::Names;
use crate::ast::{Element, Field, Model};
use crate::spans::collect_names;
use proc_macro2::{Ident, Span, TokenStream};
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

/// A warning at each field that no formula uses, and at each section that no element has: the one of rustc about what is deprecated,
/// to which a macro can give words and a place.
pub(super) fn unused(model: &Model, sections: &[Ident], names: &Names) -> TokenStream {
    let unused = unused_fields(model);
    let fields =
        model.fields().filter(|field| unused.contains(&field.name)).map(|Field { name, conditions, .. }| {
            let note = format!("no parameter uses `{0}`: remove the field, or call it `_{0}`", name.unraw());
            let warning = warning(name.span(), "unused_field", &note, names);
            quote_spanned!(names.here=> #(#conditions)* #warning)
        });
    let sections = sections.iter().filter(|name| !name.unraw().to_string().starts_with('_')).map(|name| {
        let note = format!("no element has section `{0}`: remove it, or write `..{0}` in an element", name.unraw());
        warning(name.span(), "unused_section", &note, names)
    });
    quote_spanned!(names.here=> #(#fields)* #(#sections)*)
}

fn warning(place: Span, name: &str, note: &str, names: &Names) -> TokenStream {
    let span = names.at(place);
    let unused = Ident::new(name, span);
    quote_spanned! {span=>
        const _: () = {
            #[allow(non_upper_case_globals)]
            #[deprecated(note = #note)]
            const #unused: () = ();
            #unused
        };
    }
}
