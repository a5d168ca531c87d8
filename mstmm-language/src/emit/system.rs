//! Emits the built system and `build()`.

use super::fields::bindings;
use super::sensitivity::member;
use super::{Names, element_field, first_of_each_type};
use crate::ast::{Element, Field, Model, Parameter};
use crate::plan::{Plan, Step};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{ToTokens, quote_spanned};

/// The struct of elements, and the functions that make it from the parameters.
pub(super) fn system(model: &Model, plan: &Plan<'_>, keeps_fields: bool, names: &Names) -> TokenStream {
    let definition = definition(model, plan, keeps_fields, names);
    let build = build(model, plan, names);
    let of_numbers = of_numbers(model, plan, keeps_fields, names);
    quote_spanned! {names.here=>
        #definition
        #build
        #of_numbers
    }
}

/// `impl System`: what searches ask of all systems, and the visit of its parts.
pub(super) fn implementation(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let (private, system, parameter) = (&names.private, &names.system, &names.parameter);
    let steps = plan.steps.len();
    let of_steps = plan.steps.iter().map(|step| match step {
        Step::Tip(keyword) | Step::Root { support: keyword, .. } => keyword.to_string(),
        Step::Element { element, .. } => element.to_string(),
        Step::Connection { connection, .. } => connection.to_string(),
    });
    let numbers = plan.elements.iter().enumerate().map(|(index, element)| {
        let (of_steps, field) = (plan.steps_of(index), element_field(element, names));
        let kind = names.element_as(element, "Element");
        quote_spanned!(names.at_element(element)=> #(#of_steps)|* => #kind::member_numbers(&self.#field),)
    });
    let elements = first_of_each_type(plan, names).into_iter().map(|element| names.element_as(element, "Element"));
    let elements: Vec<TokenStream> = elements.collect();
    let spins = plan.spins().then(|| quote_spanned!(names.here=> const SPINS: bool = true;));
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl<#parameter: #private::Real> #private::System for #system<#parameter> {
            type Parameter = #parameter;
            const STANDS_IN_LINE: bool = #steps <= #private::LONGEST_IN_LANES && Self::HAS_PHASES;
            const HAS_PHASES: bool = #(#elements::IS_STRAIGHT)&&*;
            const MAY_BUCKLE: bool = #(#elements::MAY_BUCKLE)||*;
            #spins

            fn name_parts(&self, visitor: &mut dyn #private::Visitor) {
                let numbers = |step: ::core::primitive::usize| match step {
                    #(#numbers)*
                    _ => #private::MemberNumbers::Other,
                };
                #private::visit_steps(LAYOUT, &numbers, visitor);
            }

            fn spot_of(&self, place: ::core::primitive::usize) -> #private::Spot {
                #private::Spot::Named([#(#of_steps),*][place])
            }

            fn frequency_estimates(&self) -> #private::FrequencyEstimates {
                self.estimates
            }
        }
    }
}

/// The struct of elements.
fn definition(model: &Model, plan: &Plan<'_>, keeps_fields: bool, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    let kept = kept_fields(model, keeps_fields, names);
    let (visibility, model) = (&model.parameters.vis, &model.parameters.ident);
    let fields = plan.elements.iter().map(|element| {
        let (field, kind) = (element_field(element, names), names.element_as(element, "Element"));
        let doc = format!(" `{element}`");
        quote_spanned!(names.at_element(element)=> #[doc = #doc] #field: #kind::Built)
    });
    let doc =
        format!("The built system of [`{model}`]: evaluate it at a frequency, or search its frequencies.\n\n{plan}");
    let doc = doc.lines().map(|line| format!(" {line}"));
    // The size of a struct is known if that of its last field is. Were an element the last, a type that is none would be
    // an error wherever the system occurs.
    quote_spanned! {names.here=>
        #(#[doc = #doc])*
        #[derive(::core::clone::Clone, ::core::fmt::Debug)]
        #visibility struct #system<#parameter: #private::Parameter = f64> {
            #(#fields,)*
            #(#kept,)*
            estimates: #private::FrequencyEstimates,
            parameter: ::core::marker::PhantomData<#parameter>,
        }
    }
}

/// What a built system keeps of the fields: `field_length: f64`.
pub(super) fn kept_fields<'m>(
    model: &'m Model,
    keeps_fields: bool,
    names: &'m Names,
) -> impl Iterator<Item = TokenStream> + 'm {
    model.fields().filter(move |_| keeps_fields).map(|field| {
        let (member, conditions) = (member(&field, names), field.conditions);
        let doc = format!(" The field `{}`", field.name);
        quote_spanned!(names.here=> #(#conditions)* #[doc = #doc] #member: ::core::primitive::f64)
    })
}

/// The fields as a built system keeps them: `field_length: self.length`.
pub(super) fn values_of_fields<'m>(
    model: &'m Model,
    keeps_fields: bool,
    names: &'m Names,
) -> impl Iterator<Item = TokenStream> + 'm {
    model.fields().filter(move |_| keeps_fields).map(|field| {
        let (member, Field { name, conditions, .. }) = (member(&field, names), field);
        quote_spanned!(names.here=> #(#conditions)* #member: self.#name)
    })
}

/// `build()` of a model whose numbers are parameters of elements.
fn build(model: &Model, plan: &Plan<'_>, names: &Names) -> TokenStream {
    let doc = [
        "Validates all parameters and builds the system.",
        "The error names the first element with a parameter out of its range, the parameter and its value.",
    ];
    build_functions(model, doc, plan.spins(), names)
}

/// `build` and `build_as`, given what they do and which number their error names. A rotor has its system twice.
pub(super) fn build_functions(model: &Model, doc: [&str; 2], spins: bool, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    let of_numbers = quote_spanned!(names.here=> #system<#parameter>);
    let build_of = quote_spanned!(names.here=> #private::Build::build_of(self, &#private::Numbered::numbers(self)));
    // a system is handed on as it is returned: it may be large
    let [built, built_as, result] = if spins {
        [
            quote_spanned!(names.here=> #private::Rotor<#system>),
            quote_spanned!(names.here=> #private::Rotor<#of_numbers>),
            quote_spanned!(names.here=> ::core::result::Result::Ok(#private::Rotor::new(#build_of?))),
        ]
    } else {
        [quote_spanned!(names.here=> #system), of_numbers, build_of]
    };
    let (visibility, name) = (&model.parameters.vis, &model.parameters.ident);
    let [what, errors] = doc.map(|line| format!(" {line}"));
    quote_spanned! {names.here=>
        impl #name {
            #[doc = #what]
            ///
            /// # Errors
            #[doc = #errors]
            #visibility fn build(&self) -> ::core::result::Result<#built, #private::ParameterError> {
                self.build_as()
            }

            /// Builds the system over another scalar, such as `f32` or the double-double `DoubleDouble`.
            ///
            /// # Errors
            /// As `build`.
            #visibility fn build_as<#parameter: #private::Real>(
                &self,
            ) -> ::core::result::Result<#built_as, #private::ParameterError> {
                #result
            }
        }
    }
}

/// `impl Numbered`, `impl Build` and `impl Model`: the numbers of all elements, and the struct of elements from numbers of any type. A rotor is no model of sweeps, since these ask one system.
fn of_numbers(model: &Model, plan: &Plan<'_>, keeps_fields: bool, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    let name = &model.parameters.ident;
    let literal = elements_of_numbers(model, plan, keeps_fields, names);
    let plain = quote_spanned!(names.here=> |k: ::core::primitive::usize| #private::Scalar::from_f64(numbers[k]));
    let (elements, of_model) = if plan.spins() {
        (quote_spanned!(names.here=> { let number = #plain; #literal }), None)
    } else {
        let of_model = quote_spanned! {names.here=>
            #[automatically_derived]
            impl #private::Model for #name {
                type System<#parameter: #private::Parameter> = #system<#parameter>;

                fn build(&self) -> ::core::result::Result<#system, #private::ParameterError> {
                    self.build_as()
                }

                fn of_numbers<#parameter: #private::Parameter>(
                    &self,
                    number: impl ::core::ops::Fn(::core::primitive::usize) -> #parameter,
                ) -> ::core::result::Result<#system<#parameter>, #private::ParameterError> {
                    ::core::result::Result::Ok(#literal)
                }
            }
        };
        (quote_spanned!(names.here=> #private::Model::of_numbers(self, #plain)?), Some(of_model))
    };
    let estimates = estimates(plan, names);
    let build = quote_spanned! {names.here=>
        let mut system = #elements;
        #estimates
    };
    let numbers = plan.elements.iter().flat_map(|element| element.parameters());
    let numbers: Vec<_> = numbers.map(|parameter| number(parameter, names)).collect();
    let numbered = numbered(model, &numbers, names);
    let build_of = build_of(model, &build, names);
    quote_spanned!(names.here=> #numbered #build_of #of_model)
}

/// The struct of built elements, given a `number` of each place.
fn elements_of_numbers(model: &Model, plan: &Plan<'_>, keeps_fields: bool, names: &Names) -> TokenStream {
    let system = &names.system;
    let kept = values_of_fields(model, keeps_fields, names);
    let mut place = 0_usize;
    let elements = plan.elements.iter().map(|element| built(element, &mut place, names));
    quote_spanned! {names.here=>
        #system {
            #(#elements,)*
            #(#kept,)*
            estimates: ::core::default::Default::default(),
            parameter: ::core::marker::PhantomData,
        }
    }
}

/// What estimates the frequencies of a `system` for the searches.
fn estimates(plan: &Plan<'_>, names: &Names) -> TokenStream {
    let estimates = plan.elements.iter().enumerate().map(|(index, element)| {
        let (span, element_field, kind) =
            (names.at_element(element), element_field(element, names), names.element_as(element, "Element"));
        let estimate = quote_spanned!(span=> #kind::estimate(&system.#element_field, &mut system.estimates););
        // equal elements are built once, but each adds its length
        match plan.uses_of(index) {
            1 => estimate,
            uses => quote_spanned!(span=> for _ in 0..#uses { #estimate }),
        }
    });
    quote_spanned!(names.here=> #(#estimates)* system.estimates.finish();)
}

/// `impl Numbered`, given all numbers.
pub(super) fn numbered(model: &Model, numbers: &[TokenStream], names: &Names) -> TokenStream {
    let private = &names.private;
    let (name, lets, count) = (&model.parameters.ident, &model.lets, numbers.len());
    let bindings = bindings(model, names);
    quote_spanned! {names.here=>
        // not marked as derived: rustc would be silent about a field that nothing uses
        impl #private::Numbered for #name {
            type Numbers = [::core::primitive::f64; #count];

            fn numbers(&self) -> [::core::primitive::f64; #count] {
                #bindings
                #(#lets)*
                [#(#numbers),*]
            }
        }
    }
}

/// `impl Build`, given what builds a `system` of numbers.
pub(super) fn build_of(model: &Model, build: &TokenStream, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    let name = &model.parameters.ident;
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl #private::Build for #name {
            type System<#parameter: #private::Parameter> = #system<#parameter>;

            fn build_of<#parameter: #private::Real>(
                &self,
                numbers: &Self::Numbers,
            ) -> ::core::result::Result<#system<#parameter>, #private::ParameterError> {
                #build
                ::core::result::Result::Ok(system)
            }
        }
    }
}

/// The built element, `field: build::<Type<T>>(Type { parameter: number(3), .. }, name)?`, with the numbers from a place on.
fn built(element: &Element, place: &mut usize, names: &Names) -> TokenStream {
    let (span, field, name) = (names.at_element(element), element_field(element, names), element.to_string());
    let (build, of_system) = (names.function_at("build", span), names.element(element));
    let (literal, called) =
        (names.literal(element, &fields_of(element, place, names)), names.called(element.renamed()));
    quote_spanned!(span=> #field: #build::<#of_system>(#literal, #name)#called?)
}

/// The fields of an element's parameters: those that are given with the numbers from a place on, those that were left out as if they were
/// not there.
pub(super) fn fields_of(element: &Element, place: &mut usize, names: &Names) -> Vec<(Ident, TokenStream)> {
    let (span, private) = (names.at_element(element), &names.private);
    let given = element.parameters().map(|parameter| {
        let (name, of_place) = (element.field(&parameter.name), *place);
        *place += 1;
        let number = quote_spanned!(names.at(name.span())=> number(#of_place));
        (name, number)
    });
    let omitted = element.omitted().map(|(name, value)| {
        let value = match value {
            f64::INFINITY => quote_spanned!(span=> ::core::primitive::f64::INFINITY),
            _ => quote_spanned!(span=> 0.0),
        };
        (Ident::new(name, span), quote_spanned!(span=> #private::Scalar::from_f64(#value)))
    });
    given.chain(omitted).collect()
}

/// A parameter as a number; a type that is not `f64` is shown at the expression.
pub(super) fn number(parameter: &Parameter, names: &Names) -> TokenStream {
    let (name, span) = (&parameter.name, names.at(parameter.name.span()));
    let value = parameter.value.as_ref().map_or_else(|| name.to_token_stream(), ToTokens::to_token_stream);
    // the user's own token, so that rustc shows what it expects and nothing of the code around it
    number_of(&value, name.span(), span)
}

/// The value of an expression as a number, where the type that is expected is shown at one place, and the code around at another.
pub(super) fn number_of(value: &TokenStream, expected: Span, span: Span) -> TokenStream {
    let number = Ident::new("number", span);
    let float = quote_spanned!(expected=> ::core::primitive::f64);
    quote_spanned!(span=> {
        let #number: #float = #value;
        #number
    })
}
