//! Emits the built system of a model with locations, `build()`, and its traits.

use super::super::system::{build_functions, build_of, fields_of, kept_fields, values_of_fields};
use super::super::{Names, implement};
use super::numbers::{count, geometry};
use super::{answers_of_members, bounds, by_type, field};
use crate::ast::{Element, Model};
use crate::keywords::Dimension;
use crate::skeleton::{Member, Skeleton, What};
use proc_macro2::{Ident, TokenStream};
use quote::quote_spanned;
use syn::ext::IdentExt;

/// The struct of the skeleton and of built members.
pub(super) fn definition(model: &Model, skeleton: &Skeleton<'_>, keeps_fields: bool, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    let kept = kept_fields(model, keeps_fields, names);
    let count = geometry(skeleton).count();
    let (visibility, model) = (&model.parameters.vis, &model.parameters.ident);
    let (nodes, members) = (skeleton.nodes.len(), skeleton.members.len());
    let fields = skeleton.members.iter().enumerate().map(|(index, member)| {
        let (span, kind) = (member.span(names), member.kind(names));
        let (field, element) = (field(index, span), names.trait_at("Element", span));
        let doc = format!(" `{}`", member.name);
        quote_spanned!(span=> #[doc = #doc] #field: <#kind as #element>::Built)
    });
    let doc = format!(
        "The built system of [`{model}`]: evaluate it at a frequency, or search its frequencies.\n\n{skeleton}"
    );
    let doc = doc.lines().map(|line| format!(" {line}"));
    quote_spanned! {names.here=>
        #(#[doc = #doc])*
        #[derive(::core::clone::Clone, ::core::fmt::Debug)]
        #visibility struct #system<#parameter: #private::Parameter = f64> {
            skeleton: #private::Skeleton<#parameter, #nodes, #members>,
            #(#fields,)*
            #(#kept,)*
            /// The numbers of places, directions and masses
            geometry: [::core::primitive::f64; #count],
            estimates: #private::FrequencyEstimates,
        }
    }
}

/// `build()`, and how a system is made of the numbers: the skeleton, the members and the estimates of the searches.
pub(super) fn build(model: &Model, skeleton: &Skeleton<'_>, keeps_fields: bool, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    let mut place = count(skeleton);
    let members = skeleton.members.iter().enumerate().map(|(index, member)| built(index, member, &mut place, names));
    let kept = values_of_fields(model, keeps_fields, names);
    let build = quote_spanned! {names.here=>
        let number = |k: ::core::primitive::usize| <#parameter as #private::Scalar>::from_f64(numbers[k]);
        let skeleton = #private::Skeleton::new(&SKETCH, numbers)?;
        let mut system = #system {
            #(#members,)*
            #(#kept,)*
            geometry: ::core::array::from_fn(|k: ::core::primitive::usize| numbers[k]),
            skeleton,
            estimates: ::core::default::Default::default(),
        };
        #private::Prestressed::describe(&mut system);
    };
    let build_of = build_of(model, &build, names);
    let doc = [
        "Validates all places and parameters and builds the system.",
        "The error names the first place or element with a number out of its range, and the number.",
    ];
    let functions = build_functions(model, doc, false, names);
    quote_spanned!(names.here=> #build_of #functions)
}

/// A built member, with the numbers from a place on: `member_3: build_member::<InPlane<Beam<T>>>(InPlane { .. }, name)?`.
fn built(index: usize, member: &Member<'_>, place: &mut usize, names: &Names) -> TokenStream {
    let (span, kind, name) = (member.span(names), member.kind(names), &member.name);
    let (field, build) = (field(index, span), names.function_at("build_member", span));
    let value = match member.what {
        What::Rigid => {
            let freedoms = super::sketch::freedom_set(&member.freedoms, names);
            quote_spanned!(span=> <#kind>::rigid(#freedoms))
        }
        What::Hinge(element) => {
            let first = *place;
            *place += element.parameters().count();
            let optional = |words: &[&str]| optional_number(element, words, first, names);
            let freedoms = super::sketch::freedom_set(&member.freedoms, names);
            let stiffness = STIFFNESSES_OF_JOINT.map(|(_, words)| optional(words));
            if element.has_losses() {
                let damping = DAMPINGS_OF_JOINT.map(|(_, word)| optional(&[word]));
                let losses = ["loss_factor", "kelvin_voigt_time"].map(|word| optional(&[word]));
                let private = &names.private;
                let zero = quote_spanned!(span=> #private::Scalar::from_f64(0.0));
                quote_spanned!(span=> <#kind>::hinge(#freedoms, [#(#stiffness),*], [#(#damping),*], [#(#losses.unwrap_or(#zero)),*]))
            } else {
                quote_spanned!(span=> <#kind>::hinge(#freedoms, [#(#stiffness),*]))
            }
        }
        What::Element(element) => literal(index, element, place, names),
    };
    let called = match member.what {
        What::Element(element) => names.called(element.renamed()),
        What::Hinge(element) => called_in_joint(element, names),
        What::Rigid => TokenStream::new(),
    };
    quote_spanned!(span=> #field: #build::<#kind>(#value, #name)#called?)
}

/// The fields of the derivatives of a joint, and the parameters that each may be: of displacements and about z.
const STIFFNESSES_OF_JOINT: [(&str, &[&str]); 3] = [
    ("stiffness_x", &["stiffness_x"]),
    ("stiffness_y", &["stiffness_y"]),
    ("stiffness_theta", &["stiffness_rz", "stiffness_theta"]),
];
const DAMPINGS_OF_JOINT: [(&str, &str); 3] =
    [("damping_x", "damping_x"), ("damping_y", "damping_y"), ("damping_theta", "damping_rz")];

/// The fields of the derivatives of a joint, each with a parameter that it is.
pub(super) fn fields_of_joint() -> impl Iterator<Item = (&'static str, &'static str)> {
    let stiffnesses = STIFFNESSES_OF_JOINT.into_iter();
    stiffnesses.flat_map(|(field, words)| words.iter().map(move |word| (field, *word))).chain(DAMPINGS_OF_JOINT)
}

/// A parameter of a hinge, if it is named: `Some(number(3))`.
fn optional_number(element: &Element, words: &[&str], first: usize, names: &Names) -> TokenStream {
    let named = element.parameters().position(|parameter| words.iter().any(|word| parameter.name.unraw() == word));
    let Some(index) = named else { return quote_spanned!(names.here=> ::core::option::Option::None) };
    let place = first + index;
    quote_spanned!(names.here=> ::core::option::Option::Some(number(#place)))
}

/// What gives errors about a joint the names of the parameters of its hinge.
fn called_in_joint(element: &Element, names: &Names) -> TokenStream {
    names.called(fields_of_joint().filter(|(field, word)| field != word && element.gives(word)))
}

/// The struct of an element's parameters, with its length where its type has one.
fn literal(index: usize, element: &Element, place: &mut usize, names: &Names) -> TokenStream {
    let span = names.at_element(element);
    let mut fields = fields_of(element, place, names);
    if element.has_length_of_places() {
        fields.insert(0, (Ident::new("length", span), quote_spanned!(span=> skeleton.length(#index))));
    }
    names.literal(element, &fields)
}

/// `impl System`.
pub(super) fn system(skeleton: &Skeleton<'_>, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    let may_buckle = by_type(skeleton, names).into_iter().map(|members| {
        let (span, kind) = (members[0].1.span(names), members[0].1.kind(names));
        let element = names.trait_at("Element", span);
        quote_spanned!(span=> <#kind as #element>::MAY_BUCKLE)
    });
    let is_in_space = skeleton.dimension == Dimension::Space;
    let is_flat = is_in_space.then(|| {
        quote_spanned! {names.here=>
            fn is_flat(&self) -> ::core::primitive::bool {
                self.skeleton.is_flat()
            }
        }
    });
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl<#parameter: #private::Real> #private::System for #system<#parameter> {
            type Parameter = #parameter;
            const HAS_PHASES: bool = false;
            const IS_NETWORK: bool = true;
            const MAY_BUCKLE: bool = #(#may_buckle)||*;

            fn in_numbers(&self) -> ::core::option::Option<#private::StiffnessModel<'_>> {
                self.skeleton.in_numbers(&#private::Placed::order(self))
            }

            fn name_parts(&self, visitor: &mut dyn #private::Visitor) {
                #private::visit_network(self, visitor);
            }

            #is_flat

            fn spot_of(&self, place: ::core::primitive::usize) -> #private::Spot {
                #private::Placed::spot(self, place)
            }

            fn spot_of_member(&self, member: ::core::primitive::usize) -> #private::Spot {
                #private::Spot::Named(SKETCH.members[member].name)
            }

            fn frequency_estimates(&self) -> #private::FrequencyEstimates {
                self.estimates
            }
        }
    }
}

/// `impl Placed`.
pub(super) fn placed(model: &Model, skeleton: &Skeleton<'_>, width: &TokenStream, names: &Names) -> TokenStream {
    let Names { private, system, parameter, .. } = names;
    let model = &model.parameters.ident;
    let (nodes, members) = (skeleton.nodes.len(), skeleton.members.len());
    let is_in_space = skeleton.dimension == Dimension::Space;
    let parts = is_in_space.then(|| {
        quote_spanned! {names.here=>
            fn parts_from(&self, first: ::core::primitive::usize) -> ::core::ops::Range<::core::primitive::usize> {
                SKETCH.parts(first)
            }
        }
    });
    quote_spanned! {names.here=>
        #[automatically_derived]
        impl<#parameter: #private::Real> #private::Placed for #system<#parameter> {
            type Model = #model;
            type Memory = #private::Arrays<#width, #nodes, #members>;

            fn sizes(&self) -> [::core::primitive::usize; 2] {
                [#nodes, #members]
            }

            fn place(&self, place: ::core::primitive::usize) -> [#parameter; 3] {
                SKETCH.place(&self.geometry, place)
            }

            fn node(
                &self,
                node: ::core::primitive::usize,
            ) -> (&#private::PlacedNode<#parameter>, &#private::Motions<#parameter>) {
                self.skeleton.node(node)
            }

            fn placement(&self, member: ::core::primitive::usize) -> &#private::Placement<#parameter> {
                self.skeleton.placement(member)
            }

            fn numbers(&self) -> &[#private::MemberNumbers] {
                self.skeleton.numbers()
            }

            #parts

            fn spot(&self, node: ::core::primitive::usize) -> #private::Spot {
                SKETCH.spot(node)
            }

            fn order(&self) -> #private::NetworkOrder<'_> {
                ORDER.order()
            }
        }
    }
}

/// `impl PlacedCharts<S>` and `impl Characteristic<S>`.
pub(super) fn charts(skeleton: &Skeleton<'_>, names: &Names) -> TokenStream {
    let Names { private, frequency, counter, .. } = names;
    let bounds = bounds("Charted", skeleton, names);
    let charts = answers_of_members(skeleton, names, |kind, span| {
        let charted = names.trait_at("Charted", span);
        quote_spanned!(names.here=> <#kind as #charted>::chart(built, at, length))
    });
    let body = quote_spanned! {names.here=>
        fn chart(
            &self,
            member: ::core::primitive::usize,
            at: &#private::FrequencyPowers<#frequency>,
            length: #frequency,
        ) -> ::core::option::Option<#private::Chart<#frequency>> {
            #charts
        }
    };
    let charts = implement("PlacedCharts", "Real", bounds.clone(), &body, names);
    let body = quote_spanned! {names.here=>
        fn pass<#counter: #private::RootCounter<#frequency>>(
            &self,
            x: #frequency,
            counter: &mut #counter,
        ) -> #private::Scaled<#frequency> {
            #private::network_pass::<Self, #frequency, #counter>(self, x, counter)
        }
    };
    let compiled = quote_spanned!(names.here=> #frequency: #private::StructureScalar);
    let bounds = bounds.into_iter().chain([compiled]).collect();
    let characteristic = implement("Characteristic", "Real", bounds, &body, names);
    quote_spanned!(names.here=> #charts #characteristic)
}

/// `impl PlacedMotions<S>`.
pub(super) fn motions(skeleton: &Skeleton<'_>, names: &Names) -> TokenStream {
    let Names { private, frequency, .. } = names;
    let visits =
        answers_of_members(skeleton, names, |kind, _| quote_spanned!(names.here=> visitor.member::<#kind>(built)));
    let body = quote_spanned! {names.here=>
        fn visit_member<V: #private::VisitMember<#frequency>>(
            &self,
            member: ::core::primitive::usize,
            visitor: V,
        ) -> ::core::option::Option<V::Output> {
            #visits
        }
    };
    implement("PlacedMotions", "Real", bounds("MemberMotion", skeleton, names), &body, names)
}
