//! Emits what motions need: the labels of the model as values, and the system as a tree whose elements can be visited.

use super::{Names, bounds, element_field, first_of_each_type, implement};
use crate::ast::{Label, Model};
use crate::plan::{Plan, Step};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote_spanned};

/// `Model::beam_1`, `Model::conn_2`: a value per label.
pub(super) fn labels(model: &Model, plan: &Plan<'_>, names: &Names) -> TokenStream {
    let private = &names.private;
    let (visibility, name) = (&model.parameters.vis, &model.parameters.ident);
    let labels = plan.steps.iter().enumerate().filter_map(|(index, step)| match step {
        Step::Element { element, input, .. } => {
            let (constant, doc) =
                (constant(&element.kind.name().to_string(), &element.label, names), format!(" `{element}`"));
            let kind = names.element_over(element, &format_ident!("f64"));
            Some(quote_spanned! {names.here=>
                #[doc = #doc]
                #visibility const #constant: #private::Label<#name, #kind> = #private::Label::new(#index, #input);
            })
        }
        Step::Connection { connection, .. } => {
            let (constant, doc) = (constant("conn", &connection.label, names), format!(" `{connection}`"));
            Some(quote_spanned! {names.here=>
                #[doc = #doc]
                #visibility const #constant: #private::Point<#name> = #private::Point::connection(#index);
            })
        }
        Step::Tip(_) | Step::Root { .. } => None,
    });
    quote_spanned! {names.here=>
        /// The labels of the sketch: elements and connections, as results about motions take them.
        #[allow(dead_code, non_upper_case_globals)]
        impl #name {
            #(#labels)*
        }
    }
}

pub(super) fn constant(keyword: &str, label: &Label, names: &Names) -> Ident {
    format_ident!("{keyword}_{}", label.to_string(), span = names.here)
}

/// `impl Planned`: the plan.
pub(super) fn planned(model: &Model, plan: &Plan<'_>, names: &Names) -> TokenStream {
    let (private, system, parameter, value) = (&names.private, &names.system, &names.parameter, &names.counter);
    let (name, count) = (&model.parameters.ident, plan.steps.len());
    let bounds = quote_spanned!(names.here=> ::core::marker::Copy + ::core::fmt::Debug);
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl<#parameter: #private::Real> #private::Planned for #system<#parameter> {
            type Model = #name;
            type PerStep<#value: #bounds> = [#value; #count];

            fn per_step<#value: #bounds>(value: #value) -> [#value; #count] {
                [value; #count]
            }

            fn scheme(&self) -> #private::Scheme<'_> {
                LAYOUT
            }
        }
    }
}

/// `impl DrawnTree`: the types and the extents of the elements.
pub(super) fn drawn(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    // what is no element is told elsewhere
    let bounds = bounds("Element", plan, names);
    let extents = plan.elements.iter().enumerate().map(|(index, element)| {
        let (steps, field) = (plan.steps_of(index), element_field(element, names));
        let (name, kind) = (element.type_name(), names.element_as(element, "Element"));
        quote_spanned!(names.here=> #(#steps)|* => (#name, #kind::extent(&self.#field)),)
    });
    let [index, text] = ["usize", "str"].map(|name| {
        let name = format_ident!("{name}");
        quote_spanned!(names.here=> ::core::primitive::#name)
    });
    let some = quote_spanned!(names.here=> ::core::option::Option);
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl<#parameter: #private::Real> #private::DrawnTree for #system<#parameter>
        where
            #(#bounds),*
        {
            fn drawn(&self, step: #index) -> #some<(&'static #text, #private::Extent)> {
                #some::Some(match step {
                    #(#extents)*
                    _ => return #some::None,
                })
            }
        }
    }
}

/// `impl Tree<S>`: a visit per element.
pub(super) fn tree(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let Names { private, frequency, .. } = names;
    let elements = || plan.elements.iter().enumerate();
    let types = first_of_each_type(plan, names);
    let waves = types.iter().map(|element| names.element_as(element, "PlaneStep"));
    let coefficients =
        || elements().map(|(_, element)| (element_field(element, names), names.element_as(element, "PlaneStep")));
    let evaluated = coefficients().map(|(_, step)| quote_spanned!(names.here=> #step::Coefficients));
    let values = coefficients().map(|(field, step)| quote_spanned!(names.here=> #step::coefficients(&self.#field, at)));
    let visits = elements().map(|(index, element)| {
        let (steps, field, kind) = (plan.steps_of(index), element_field(element, names), names.element(element));
        let index = Literal::usize_unsuffixed(index);
        quote_spanned! {names.here=>
            #(#steps)|* => visitor.element::<#kind>(&self.#field, evaluated.map(|evaluated| &evaluated.#index)),
        }
    });
    let some = quote_spanned!(names.here=> ::core::option::Option);
    let visitor = &names.counter;
    let body = quote_spanned! {names.here=>
        type Evaluated = (#(#evaluated,)*);

        fn at(x: #frequency) -> #private::FrequencyPowers<#frequency> {
            #private::FrequencyPowers::new(x, false #(|| #waves::WAVES)*)
        }

        fn evaluate(&self, at: &#private::FrequencyPowers<#frequency>) -> Self::Evaluated {
            (#(#values,)*)
        }

        fn visit<#visitor: #private::Visit<#frequency>>(
            &self,
            evaluated: #some<&Self::Evaluated>,
            step: usize,
            visitor: #visitor,
        ) -> #some<#visitor::Output> {
            #some::Some(match step {
                #(#visits)*
                _ => return #some::None,
            })
        }
    };
    implement("Tree", "Real", bounds("Moving", plan, names), &body, names)
}
