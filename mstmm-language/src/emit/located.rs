//! Emits the code of a model with locations: its numbers, the built system, and what its evaluation asks of it.

mod drawn;
mod numbers;
mod overall;
mod own;
mod points;
mod prestress;
mod sensitivity;
mod sketch;
mod system;

use super::{Names, fields, labels, parameters, searched};
use crate::ast::{Element, Model};
use crate::check::Derivatives;
use crate::network::Network;
use crate::skeleton::{Member, Skeleton, What};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote_spanned};
use std::collections::BTreeMap;

/// All items of a model with locations, with the sections that no element has.
///
/// # Errors
/// Nothing joins a part of the model to the rest.
pub(crate) fn located(
    model: &Model,
    unused: &[Ident],
    network: &Network<'_>,
    skeleton: &Skeleton<'_>,
    derivatives: &Derivatives,
) -> syn::Result<TokenStream> {
    let apart = |name| {
        let message = format!("nothing joins {name} to the rest of the model: a model is one structure");
        syn::Error::new(model.parameters.ident.span(), message)
    };
    if skeleton.members.is_empty() {
        let message = "no element of this model has two ends: a model has a beam, a spring or a joint, and a body alone has nothing to compute";
        return Err(syn::Error::new(model.parameters.ident.span(), message));
    }
    let width = skeleton.width().map_err(apart)?;
    let names = Names::of(model);
    let parameters = parameters(model);
    let keeps_fields = !derivatives.are_none();
    let definition = system::definition(model, skeleton, keeps_fields, &names);
    let numbered = super::system::numbered(model, &numbers::numbers(skeleton, &names), &names);
    let labels = labels::labels(model, &names);
    let points = points::points(model, skeleton, &names);
    let sketch = sketch::sketch(skeleton, &names);
    let build = system::build(model, skeleton, keeps_fields, &names);
    let sensitivity = sensitivity::sensitivity(model, skeleton, derivatives, &names);
    let formulas = sensitivity::formulas(model, skeleton, derivatives, &names);
    let width = own::width(width, &names);
    let owned = own::own(network, skeleton, &names);
    let prestressed = prestress::prestressed(skeleton, &names);
    let placed = system::placed(model, skeleton, &width, &names);
    let drawn = drawn::drawn(model, &names);
    let charts = system::charts(skeleton, &names);
    let motions = system::motions(skeleton, &names);
    let overall = overall::overall(skeleton, &names);
    let system = system::system(skeleton, &names);
    let own_member = if own::has_own(network) { searched::own_member(&names) } else { Default::default() };
    let searched = searched::searched(own_member, &names);
    let unused = fields::unused(model, unused, &names);
    Ok(quote_spanned! {names.here=>
        #parameters
        #definition
        // what the user wrote sees no name of the code below
        #numbered
        #formulas
        const _: () = {
            #labels
            #points
            #sketch
            #owned
            #build
            #system
            #prestressed
            #placed
            #drawn
            #charts
            #motions
            #overall
            #sensitivity
            #searched
            #unused
        };
    })
}

impl Member<'_> {
    /// Where errors about the member are shown: at its keyword.
    fn span(&self, names: &Names) -> Span {
        self.what.element().map_or(names.here, |element| names.at_element(element))
    }

    /// Its type, at the user's token.
    fn kind(&self, names: &Names) -> TokenStream {
        let span = self.span(names);
        match self.what {
            What::Element(element) => names.element(element),
            What::Hinge(_) | What::Rigid => {
                let has_losses = self.what.element().is_some_and(Element::has_losses);
                let joint = if has_losses { "DampedJoint" } else { "Joint" };
                let (joint, parameter) = (names.function_at(joint, span), &names.parameter);
                quote_spanned!(span=> #joint<#parameter>)
            }
        }
    }
}

/// Field of the built system that holds a member.
fn field(member: usize, span: Span) -> Ident {
    format_ident!("member_{member}", span = span)
}

/// The members of each type, in a fixed order.
fn by_type<'s>(skeleton: &'s Skeleton<'_>, names: &Names) -> Vec<Vec<(usize, &'s Member<'s>)>> {
    let mut all: BTreeMap<String, Vec<_>> = BTreeMap::new();
    for (index, member) in skeleton.members.iter().enumerate() {
        all.entry(member.kind(names).to_string()).or_default().push((index, member));
    }
    all.into_values().collect()
}

/// What a trait for the built system asks of its members: a trait for each type.
fn bounds(of_members: &str, skeleton: &Skeleton<'_>, names: &Names) -> Vec<TokenStream> {
    let bound = |members: &Vec<(usize, &Member<'_>)>| {
        let (span, kind) = (members[0].1.span(names), members[0].1.kind(names));
        let bound = names.trait_at(of_members, span);
        quote_spanned!(span=> #kind: #bound)
    };
    by_type(skeleton, names).iter().map(bound).collect()
}

/// What is known of the member of an index, given the answer of its type about `built`: one call for all members of a type.
fn answers_of_members(
    skeleton: &Skeleton<'_>,
    names: &Names,
    answer: impl Fn(&TokenStream, Span) -> TokenStream,
) -> TokenStream {
    of_members(skeleton, names, &quote_spanned!(names.here=> &), answer)
}

/// What a type says of the member of an index, given how `built` is borrowed.
fn of_members(
    skeleton: &Skeleton<'_>,
    names: &Names,
    borrowed: &TokenStream,
    answer: impl Fn(&TokenStream, Span) -> TokenStream,
) -> TokenStream {
    let types = by_type(skeleton, names);
    let answers = types.iter().map(|members| {
        let answer = answer(&members[0].1.kind(names), members[0].1.span(names));
        let cases = members.iter().map(|(index, _)| {
            let field = field(*index, names.here);
            quote_spanned!(names.here=> #index => ::core::option::Option::Some(#borrowed self.#field))
        });
        quote_spanned! {names.here=>
            let built = match member {
                #(#cases,)*
                _ => ::core::option::Option::None,
            };
            if let ::core::option::Option::Some(built) = built {
                return ::core::option::Option::Some(#answer);
            }
        }
    });
    quote_spanned!(names.here=> #(#answers)* ::core::option::Option::None)
}
