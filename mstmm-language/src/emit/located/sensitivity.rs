//! Emits the derivatives of a model with locations with respect to its fields: the chain rule from members, places and masses.

use super::super::formulas::{Formula, of_element};
use super::super::sensitivity::{fields, variables};
use super::super::{Names, implement};
use super::numbers::{Number, geometry};
use super::system::fields_of_joint;
use super::{by_type, field};
use crate::ast::{Element, Model};
use crate::check::Derivatives;
use crate::skeleton::{Member, Skeleton, What};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote_spanned};
use syn::{Expr, Index};

/// `impl Fields` and `impl PlaneChain<S>`.
pub(super) fn sensitivity(
    model: &Model,
    skeleton: &Skeleton<'_>,
    derivatives: &Derivatives,
    names: &Names,
) -> TokenStream {
    let Names { private, frequency, .. } = names;
    let fields = fields(model, names);
    let body = if derivatives.are_none() { TokenStream::new() } else { sums(model, skeleton, derivatives, names) };
    let body = quote_spanned! {names.here=>
        fn plane_chain(
            &self,
            states: &#private::PlaneStates<'_, Self, #frequency>,
        ) -> Self::PerField<#frequency> {
            let zeros = <Self as #private::Fields>::per_field(#private::Scalar::from_f64(0.0));
            let mut chain = #private::ChainRule::new(zeros);
            #body
            chain.finish()
        }
    };
    let parameter = &names.parameter;
    let plane = quote_spanned!(names.here=> #frequency: #private::PlaneFrequency<#parameter>);
    let types = by_type(skeleton, names);
    let gradients = types.iter().map(|members| gradient_bound(members[0].1, names));
    let bounds = core::iter::once(plane).chain(gradients).collect();
    let chain = implement("PlaneChain", "Real", bounds, &body, names);
    quote_spanned!(names.here=> #fields #chain)
}

/// `impl Formulas`: the formulas of all numbers over a box of fields.
pub(super) fn formulas(
    model: &Model,
    skeleton: &Skeleton<'_>,
    derivatives: &Derivatives,
    names: &Names,
) -> TokenStream {
    if derivatives.are_none() {
        return TokenStream::new();
    }
    let of_sketch = geometry(skeleton).map(|number| formula(number?, derivatives).map(Formula::of_sketch));
    let of_members = skeleton.members.iter().filter_map(|member| member.what.element());
    let of_members = of_members.flat_map(|element| of_element(element, derivatives));
    super::super::formulas::formulas(model, of_sketch.chain(of_members), derivatives, names)
}

/// What members, places, directions and masses add.
fn sums(model: &Model, skeleton: &Skeleton<'_>, derivatives: &Derivatives, names: &Names) -> TokenStream {
    let private = &names.private;
    let (variables, lets) = (variables(model, names), &derivatives.lets);
    let members = skeleton.members.iter().enumerate().map(|(index, member)| summand(index, member, derivatives, names));
    let numbers: Vec<_> = geometry(skeleton).collect();
    let (count, members_count) = (numbers.len(), skeleton.members.len());
    let formulas = numbers.into_iter().enumerate().filter_map(|(index, number)| {
        let formula = number.and_then(|number| formula(number, derivatives))?;
        Some((index, formula))
    });
    let (places, formulas): (Vec<_>, Vec<_>) = formulas.unzip();
    let order = (0..formulas.len()).map(Index::from);
    quote_spanned! {names.here=>
        #(#variables)*
        #(#lets)*
        let mut lengths = [#private::Scalar::from_f64(0.0); #members_count];
        #(#members)*
        let mut slopes = [#private::Scalar::from_f64(0.0); #count];
        #private::geometry_slopes(&SKETCH, states, &self.geometry, &lengths, &mut slopes);
        let numbers = (#(#formulas,)*);
        #(chain.add(slopes[#places], numbers.#order);)*
    }
}

/// The formula of a number of the sketch that depends on fields.
fn formula<'d>(number: Number<'_>, derivatives: &'d Derivatives) -> Option<&'d Expr> {
    match number {
        Number::Part(part) => derivatives.of_number(part),
        Number::Parameter(parameter) => derivatives.of_number(&parameter.expression()),
    }
}

/// `Type<T>: MemberGradient<S>`, which gives the derivatives of its parameters.
fn gradient_bound(member: &Member<'_>, names: &Names) -> TokenStream {
    let (span, kind, frequency) = (member.span(names), member.kind(names), &names.frequency);
    let gradient = match member.what {
        What::Element(element) => names.element_over(element, frequency),
        What::Hinge(_) | What::Rigid => {
            let elements = names.function_at("elements", span);
            let has_losses = member.what.element().is_some_and(Element::has_losses);
            let hinge = Ident::new(if has_losses { "DampedPlanarHinge" } else { "PlanarHinge" }, span);
            quote_spanned!(span=> #elements::#hinge<#frequency>)
        }
    };
    let motion = names.trait_with("MemberGradient", span, &quote_spanned!(span=> Gradient = #gradient));
    quote_spanned!(span=> #kind: #motion)
}

/// The field of the derivatives of a joint, at the user's token.
fn field_of_joint(parameter: &Ident) -> Ident {
    let field = fields_of_joint().find(|(_, name)| parameter == name);
    field.map_or_else(|| parameter.clone(), |(field, _)| Ident::new(field, parameter.span()))
}

/// What a member adds: the derivatives of its parameters, and what its length does.
fn summand(index: usize, member: &Member<'_>, derivatives: &Derivatives, names: &Names) -> TokenStream {
    let Some(element) = member.what.element() else { return TokenStream::new() };
    let span = member.span(names);
    let (kind, field) = (member.kind(names), field(index, names.here));
    let gradient = names.trait_at("MemberGradient", span);
    let parameters = derivatives.of(element);
    let field_of = |name: &Ident| match member.what {
        What::Hinge(_) => field_of_joint(name).to_token_stream(),
        What::Element(_) | What::Rigid => names.field_of(element, name),
    };
    let (parameters, values): (Vec<_>, Vec<_>) =
        parameters.iter().map(|(name, value)| (field_of(name), *value)).unzip();
    let order = (0..values.len()).map(Index::from);
    let length = element.has_length_of_places().then(|| {
        let length = names.field_of(element, &Ident::new("length", names.here));
        quote_spanned!(names.here=> lengths[#index] = gradient.#length;)
    });
    quote_spanned! {names.here=>
        let values = (#(#values,)*);
        let gradient = <#kind as #gradient>::member_gradient(&self.#field, &states.member_ends(#index));
        #(chain.add(gradient.#parameters, values.#order);)*
        #length
    }
}
