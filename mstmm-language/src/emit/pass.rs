//! Emits a pass of the plane method.

use super::{Names, bounds, element_field, first_of_each_type, implement, local};
use crate::plan::{Plan, Step};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote_spanned};

/// `impl Characteristic<S>`: one pass of the plane method, a line per step.
pub(super) fn characteristic(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, frequency, counter, .. } = names;
    let types = first_of_each_type(plan, names);
    let types = types.into_iter().map(|element| names.element_as(element, "PlaneStep"));
    let coefficients = plan.elements.iter().map(|element| {
        let (coefficients, field, kind) =
            (local("k", element, names), element_field(element, names), names.element(element));
        quote_spanned! {names.here=>
            let #coefficients = #private::coefficients::<#kind, #frequency, STEPS>(&self.#field, &at);
        }
    });
    let steps = plan.steps.iter().enumerate().map(|(index, step)| pass_step(index, step, plan, names));
    let count = plan.steps.len();
    let body = quote_spanned! {names.here=>
        #[inline(always)]
        fn pass<#counter: #private::RootCounter<#frequency>>(
            &self,
            x: #frequency,
            counter: &mut #counter,
        ) -> #private::Scaled<#frequency> {
            const STEPS: usize = #count;
            let at = #private::FrequencyPowers::new(x, false #(|| #types::WAVES)*);
            #(#coefficients)*
            #(#steps)*
        }
    };
    implement("Characteristic", "Parameter", bounds("PlaneStep", plan, names), &body, names)
}

/// One step of the pass: `let s3 = ..`, or at the end Δ.
fn pass_step(index: usize, step: &Step<'_>, plan: &Plan<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    let own = subspace(index, names);
    match step {
        Step::Tip(_) if plan.holds_connection(index) => TokenStream::new(),
        Step::Tip(keyword) => {
            let support = names.support(keyword);
            quote_spanned!(names.here=> let #own = #private::Subspace::Tip(#support, const { LAYOUT.space(#index) });)
        }
        // the last element ends in the root
        Step::Element { .. } if index + 2 == plan.steps.len() => TokenStream::new(),
        Step::Element { evaluated, input, .. } => {
            let element = plan.elements[*evaluated];
            let (coefficients, input) = (local("k", element, names), subspace(*input, names));
            let (kind, frequency, counter) = (names.element(element), &names.frequency, &names.counter);
            quote_spanned! {names.here=>
                let #own = #private::step::<#kind, #frequency, #counter, STEPS>(&#coefficients, #input, counter);
            }
        }
        Step::Connection { inputs, .. } => connection(index, inputs, plan, names),
        Step::Root { support, input } => root(support, *input, plan, names),
    }
}

/// A connection: its paths are joined, to its free state if it goes on wider, then supports hold it, then what does not go
/// on is left behind.
fn connection(index: usize, inputs: &[usize], plan: &Plan<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    let own = subspace(index, names);
    let (tips, paths): (Vec<usize>, Vec<usize>) =
        inputs.iter().partition(|input| matches!(plan.steps[**input], Step::Tip(_)));
    let held = tips.iter().map(|&tip| {
        let Step::Tip(keyword) = &plan.steps[tip] else { return TokenStream::new() };
        let support = names.support(keyword);
        quote_spanned!(names.here=> let #own = #private::Connecting::held(#own, #support);)
    });
    let mut joined = TokenStream::new();
    for (rank, &path) in paths.iter().enumerate() {
        let subspace = subspace(path, names);
        // a sum that enters another one
        let path = match &plan.steps[path] {
            Step::Connection { .. } => quote_spanned!(names.here=> #private::Connecting::rescaled(#subspace)),
            _ => subspace.into_token_stream(),
        };
        let (frequency, counter, first_two) = (&names.frequency, &names.counter, rank == 1);
        joined.extend(match rank {
            0 => quote_spanned!(names.here=> let #own = #path;),
            _ => quote_spanned! {names.here=>
                let #own = #private::join::<#frequency, #counter, #first_two, STEPS>(#own, #path, counter);
            },
        });
    }
    if joined.is_empty() {
        // supports alone hold what goes on
        joined = quote_spanned! {names.here=>
            let #own = #private::Subspace::Tip(#private::Support::Free, const { LAYOUT.space(#index) });
        };
    } else {
        joined.extend(quote_spanned! {names.here=>
            let #own = #private::Connecting::widened(#own, const { LAYOUT.output(#index) });
        });
    }
    quote_spanned! {names.here=>
        #joined
        #(#held)*
        let #own = #private::Connecting::narrowed(#own, const { LAYOUT.output(#index) }, counter);
    }
}

/// The end of the pass, Δ: the last element goes into the root at once.
fn root(support: &Ident, input: usize, plan: &Plan<'_>, names: &Names) -> TokenStream {
    let support = names.support(support);
    match &plan.steps[input] {
        Step::Element { evaluated, input, .. } => {
            let element = plan.elements[*evaluated];
            let (coefficients, input) = (local("k", element, names), subspace(*input, names));
            let Names { private, frequency, counter, .. } = names;
            let kind = names.element(element);
            quote_spanned! {names.here=>
                #private::root::<#kind, #frequency, #counter, STEPS>(&#coefficients, #input, #support, counter)
            }
        }
        _ => {
            let (private, input) = (&names.private, subspace(input, names));
            quote_spanned!(names.here=> #private::Connecting::at_root(#input, #support, counter))
        }
    }
}

/// The local variable of a step.
fn subspace(index: usize, names: &Names) -> Ident {
    format_ident!("s{index}", span = names.here)
}
