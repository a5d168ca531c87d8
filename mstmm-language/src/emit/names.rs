//! Names and paths that several emitted items share, and where errors in them are shown.

use crate::ast::{Element, Kind, Model};
use crate::keywords::AXIAL_STIFFNESS;
use crate::plan::support;
use crate::spans::emitted_at;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote_spanned};
use std::collections::BTreeSet;

/// Paths and names that several emitted items share.
pub(super) struct Names {
    /// Path to the facade crate.
    facade: TokenStream,
    /// Where errors are shown that are about no token of the user's: at the name of the model.
    pub(super) here: Span,
    /// Path to everything that emitted code uses.
    pub(super) private: TokenStream,
    /// Type of the built system.
    pub(super) system: Ident,
    /// Type parameter: scalar of the parameters.
    pub(super) parameter: Ident,
    /// Type parameter: scalar of the frequency.
    pub(super) frequency: Ident,
    /// Type parameter: what counts during a pass.
    pub(super) counter: Ident,
}

impl Names {
    pub(super) fn of(model: &Model) -> Self {
        let facade = &model.facade;
        let here = emitted_at(facade, model.parameters.ident.span());
        Names {
            facade: facade.clone(),
            here,
            private: private_at(facade, here),
            system: format_ident!("{}System", model.parameters.ident),
            parameter: fresh("T", &model.names, here),
            frequency: fresh("S", &model.names, here),
            counter: fresh("C", &model.names, here),
        }
    }

    /// The span for code that is about a token of the user's: errors in it are shown there.
    pub(super) fn at(&self, token: Span) -> Span {
        emitted_at(&self.facade, token)
    }

    /// The span for code that is about an element.
    pub(super) fn at_element(&self, element: &Element) -> Span {
        self.at(element.kind.place().last)
    }

    /// Path of an element's type, at the user's tokens; of one that stretches that across itself.
    pub(super) fn element_type(&self, element: &Element) -> TokenStream {
        match &element.kind {
            Kind::Type(path) => quote::ToTokens::to_token_stream(path),
            Kind::Keyword(keyword) => {
                let span = self.at(keyword.span());
                let private = private_at(&self.facade, span);
                // `check` has refused unknown keywords
                let name = Ident::new(element.type_row().map_or("Beam", |row| row.name), span);
                quote_spanned!(span=> #private::elements::#name)
            }
        }
    }

    /// Type of an element with the system's type parameter, at the user's tokens.
    pub(super) fn element(&self, element: &Element) -> TokenStream {
        self.element_over(element, &self.parameter)
    }

    /// Type of an element over some scalar, at the user's tokens.
    pub(super) fn element_over(&self, element: &Element, scalar: &Ident) -> TokenStream {
        let kind = self.element_type(element);
        // a path of the user's own goes on in the user's meaning, so that rustc can join all its tokens
        let span = match &element.kind {
            Kind::Keyword(keyword) => self.at(keyword.span()),
            Kind::Type(_) => element.kind.place().last,
        };
        let scalar = located(scalar, span);
        let kind = quote_spanned!(span=> #kind<#scalar>);
        let Some(wrapper) = self.wrapper(element, span) else { return kind };
        quote_spanned!(span=> #wrapper<#kind>)
    }

    /// Path of the type that moves that of an element across itself.
    fn wrapper(&self, element: &Element, span: Span) -> Option<TokenStream> {
        let (private, name) = (private_at(&self.facade, span), Ident::new(element.wrapper()?, span));
        Some(quote_spanned!(span=> #private::elements::#name))
    }

    /// The struct of an element's parameters, all at its keyword, where rustc shows what is missing.
    pub(super) fn literal(&self, element: &Element, fields: &[(Ident, TokenStream)]) -> TokenStream {
        let (kind, span) = (self.element_type(element), element.kind.place().last);
        let literal = |kind: &TokenStream, fields: &mut dyn Iterator<Item = &(Ident, TokenStream)>| {
            let fields = fields.map(|(name, value)| quote_spanned!(self.at(name.span())=> #name: #value));
            let fields: Vec<TokenStream> = fields.collect();
            quote_spanned!(span=> #kind { #(#fields,)* })
        };
        let Some(wrapper) = self.wrapper(element, span) else { return literal(&kind, &mut fields.iter()) };
        let (along, across): (Vec<_>, Vec<_>) = fields.iter().partition(|(name, _)| name == AXIAL_STIFFNESS);
        let across = (Ident::new("across", span), literal(&kind, &mut across.into_iter()));
        literal(&wrapper, &mut along.into_iter().chain([&across]))
    }

    /// A field of the struct of an element's parameters, or of derivatives with respect to them.
    pub(super) fn field_of(&self, element: &Element, parameter: &Ident) -> TokenStream {
        let field = element.field(parameter);
        if element.wrapper().is_some() && field != AXIAL_STIFFNESS {
            let across = Ident::new("across", field.span());
            return quote_spanned!(field.span()=> #across.#field);
        }
        quote_spanned!(field.span()=> #field)
    }

    /// `<Type<T> as Trait>`, at the user's tokens.
    pub(super) fn element_as(&self, element: &Element, of: &str) -> TokenStream {
        let (kind, span) = (self.element(element), self.at_element(element));
        let of = self.trait_at(of, span);
        quote_spanned!(span=> <#kind as #of>)
    }

    /// A trait of the core; those of evaluation have the frequency as parameter.
    pub(super) fn trait_at(&self, name: &str, span: Span) -> TokenStream {
        let (private, name) = (private_at(&self.facade, span), Ident::new(name, span));
        if name == "Element" {
            return quote_spanned!(span=> #private::#name);
        }
        let frequency = located(&self.frequency, span);
        quote_spanned!(span=> #private::#name<#frequency>)
    }

    /// A trait of evaluation, with an associated type.
    pub(super) fn trait_with(&self, name: &str, span: Span, associated: &TokenStream) -> TokenStream {
        let (private, name, frequency) =
            (private_at(&self.facade, span), Ident::new(name, span), located(&self.frequency, span));
        quote_spanned!(span=> #private::#name<#frequency, #associated>)
    }

    /// A function of the core.
    pub(super) fn function_at(&self, name: &str, span: Span) -> TokenStream {
        let (private, name) = (private_at(&self.facade, span), Ident::new(name, span));
        quote_spanned!(span=> #private::#name)
    }

    /// What gives errors about an element the words of the model for fields that have other names; nothing without any.
    pub(super) fn called(&self, words: impl Iterator<Item = (&'static str, &'static str)>) -> TokenStream {
        let (fields, names): (Vec<_>, Vec<_>) = words.unzip();
        if names.is_empty() {
            return TokenStream::new();
        }
        let private = &self.private;
        quote_spanned!(self.here=> .map_err(|error| #private::ParameterError::called(error, &[#((#fields, #names)),*])))
    }

    /// A support, at the user's token.
    pub(super) fn support(&self, keyword: &Ident) -> TokenStream {
        let span = self.at(keyword.span());
        let private = private_at(&self.facade, span);
        let variant = Ident::new(&format!("{:?}", support(keyword)), span);
        quote_spanned!(span=> #private::Support::#variant)
    }
}

/// Path to everything that emitted code uses. The facade keeps its meaning and changes its place only.
fn private_at(facade: &TokenStream, span: Span) -> TokenStream {
    let facade = facade.clone().into_iter().map(|mut token| {
        token.set_span(token.span().located_at(span));
        token
    });
    let facade: TokenStream = facade.collect();
    quote_spanned!(span=> #facade::__private)
}

/// A name at another place.
fn located(name: &Ident, span: Span) -> Ident {
    Ident::new(&name.to_string(), span)
}

/// A type parameter that nothing in the model is called: expressions and paths of the user's own stand in its scope.
fn fresh(name: &str, taken: &BTreeSet<String>, span: Span) -> Ident {
    let mut name = name.to_owned();
    while taken.contains(&name) {
        name.push('_');
    }
    Ident::new(&name, span)
}
