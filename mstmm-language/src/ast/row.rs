//! The rows of an element's keyword, and what they say of its type.

use super::{Element, Kind};
use crate::keywords::{
    CROSS, Dimension, Keyword, LocatedKeyword, RIGID_LINK, SPEED, STRING, STRING_BETWEEN_PLACES, TypeRow, element_of,
    located_of, neutral,
};
use proc_macro2::Ident;
use syn::ext::IdentExt;

impl Element {
    /// The row of the element's keyword; `None` for a type of the user and for a misspelt keyword.
    pub(crate) fn known(&self) -> Option<&'static Keyword> {
        match &self.kind {
            Kind::Keyword(_) if self.part_row.is_some() => self.part_row,
            Kind::Keyword(keyword) => {
                let is_of_path = keyword == STRING && !self.is_string_between_places();
                let dimension = if is_of_path { Dimension::Line } else { self.dimension };
                element_of(&keyword.to_string(), dimension)
            }
            Kind::Type(_) => None,
        }
    }

    /// Whether it is a string between two places; one of a path names its length.
    fn is_string_between_places(&self) -> bool {
        matches!(&self.kind, Kind::Keyword(keyword) if keyword == STRING)
            && self.dimension != Dimension::Line
            && !self.gives("length")
    }

    /// The row of the element's keyword in models with locations.
    pub(crate) fn located(&self) -> Option<&'static LocatedKeyword> {
        match &self.kind {
            Kind::Keyword(_) if self.is_string_between_places() => Some(&STRING_BETWEEN_PLACES),
            Kind::Keyword(keyword) => located_of(&keyword.to_string()),
            Kind::Type(_) => None,
        }
    }

    /// Its type in `mstmm_core::elements`, which its parameters select; `None` for a type of the user and for a misspelt keyword.
    pub(crate) fn type_row(&self) -> Option<&'static TypeRow> {
        Some(self.known()?.type_with(|name| self.gives(name)))
    }

    /// The type that moves its own across itself.
    pub(crate) fn wrapper(&self) -> Option<&'static str> {
        self.known().and_then(|keyword| keyword.wrapper)
    }

    /// The name of its type, or its keyword where it has none. A rigid link of the plane is a body without mass.
    pub(crate) fn type_name(&self) -> String {
        let keyword = self.kind.name().to_string();
        match self.type_row() {
            Some(_) if keyword == RIGID_LINK => "Lever".to_owned(),
            Some(row) => row.name.to_owned(),
            None => keyword,
        }
    }

    /// The field of its type that a parameter is, at the user's token.
    pub(crate) fn field(&self, parameter: &Ident) -> Ident {
        let name = parameter.unraw().to_string();
        match self.type_row().map_or(name.as_str(), |row| row.field(&name)) {
            field if field == name => parameter.clone(),
            field => Ident::new(field, parameter.span()),
        }
    }

    /// The fields of other names than their parameters, which it gives.
    pub(crate) fn renamed(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        let row = self.type_row();
        let all = row.map_or(&[][..], |row| row.renamed).iter();
        let own = all.filter(|(name, _)| self.gives(name)).map(|(name, field)| (*field, *name));
        // a part has the names of the model first
        let of_part = self.parameters().filter_map(move |parameter| {
            let known = row?.parameters.iter().chain(self.known()?.required);
            let name = known.copied().find(|name| parameter.name.unraw() == name)?;
            Some((row?.field(name), parameter.called?))
        });
        of_part.chain(own).collect::<Vec<_>>().into_iter()
    }

    /// The fields of its type that were left out, each with the value that it has as if it were not there.
    pub(crate) fn omitted(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let row = self.type_row();
        let all = row.map_or(&[][..], |row| row.parameters).iter().copied().filter(|name| !self.gives(name));
        all.map(move |name| {
            // a freedom with a dashpot gives way: it has no stiffness where none is named
            let has_dashpot = name.strip_prefix("stiffness_").is_some_and(|of| self.gives(&format!("damping_{of}")));
            let value = if has_dashpot { 0.0 } else { neutral(name) };
            (row.map_or(name, |row| row.field(name)), value)
        })
    }

    /// Whether it names the speed at which it spins, or pushes across a displacement: what tells both whirls of a rotor apart.
    pub(crate) fn spins(&self) -> bool {
        let of_type = self.type_row().map_or(&[][..], |row| row.parameters).iter();
        of_type.filter(|name| **name == SPEED || CROSS.contains(name)).any(|name| self.gives(name))
    }

    /// Whether it is of a type that has a loss factor.
    pub(crate) fn has_losses(&self) -> bool {
        self.type_row().is_some_and(|row| row.parameters.contains(&"loss_factor"))
    }

    /// Whether places give the element its length: its keyword asks for one where models have no locations.
    pub(crate) fn has_length_of_places(&self) -> bool {
        self.located().is_some_and(LocatedKeyword::spans_places)
    }
}
