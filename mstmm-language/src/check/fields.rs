//! The struct of parameters has named fields of type `f64` and no generics.

use crate::ast::NO_SENSITIVITY;
use crate::diagnostics::Errors;
use syn::spanned::Spanned;
use syn::{Attribute, Fields, ItemStruct, Meta, Type};

pub(super) fn fields(item: &ItemStruct, errors: &mut Errors) {
    for attribute in item.attrs.iter().filter(|attribute| attribute.path().is_ident("cfg")) {
        let message = "write `#[cfg(..)]` before `system!`: it is about the whole model";
        errors.add(syn::Error::new_spanned(attribute, message));
    }
    for attribute in marks(&item.attrs) {
        let message = "`#[no_sensitivity]` marks a field: write it in front of the field that is meant";
        errors.add(syn::Error::new_spanned(attribute, message));
    }
    if !item.generics.params.is_empty() {
        let message = "the struct of a model takes no generic parameters: its fields are all `f64`";
        errors.add(syn::Error::new_spanned(&item.generics, message));
    }
    match &item.fields {
        Fields::Named(fields) => {
            for field in &fields.named {
                if let Some(name) = field.ident.as_ref().filter(|name| *name == "_") {
                    errors.push(name.span(), "a field of a model has a name: parameters are written by it");
                }
                for attribute in marks(&field.attrs).filter(|mark| !matches!(mark.meta, Meta::Path(_))) {
                    let message = "`#[no_sensitivity]` takes no arguments: a formula takes its field as a plain number";
                    errors.add(syn::Error::new_spanned(attribute, message));
                }
                if !is_number(&field.ty) {
                    let message = "a field of a model is an `f64`: compute anything else in a `let` line";
                    errors.add(syn::Error::new_spanned(&field.ty, message));
                }
            }
        }
        Fields::Unit => {}
        Fields::Unnamed(fields) => {
            let message = "the struct of a model has named fields, `struct Model { length: f64, .. }`";
            errors.push(fields.span(), message);
        }
    }
}

/// Whether a type is `f64`.
pub(super) fn is_number(kind: &Type) -> bool {
    matches!(kind, Type::Path(path) if path.path.is_ident("f64"))
}

/// The attributes that take a field out of sensitivities.
fn marks(attributes: &[Attribute]) -> impl Iterator<Item = &Attribute> {
    attributes.iter().filter(|attribute| attribute.path().is_ident(NO_SENSITIVITY))
}
