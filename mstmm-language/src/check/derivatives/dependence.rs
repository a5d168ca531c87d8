//! How a value depends on the fields.

use std::collections::BTreeSet;

/// The dependence of a value on the fields that have derivatives; it gives the type of the value in the rewritten formula.
#[derive(Clone)]
pub(super) enum Dependence {
    /// The value depends on no field, and stays as the user wrote it.
    None,
    /// It is a number with derivatives, and depends on the fields of these indices.
    Number(BTreeSet<usize>),
    /// A tuple, by its parts.
    Tuple(Vec<Dependence>),
}

impl Dependence {
    pub(super) fn is_none(&self) -> bool {
        matches!(self, Dependence::None)
    }

    pub(super) fn is_tuple(&self) -> bool {
        matches!(self, Dependence::Tuple(_))
    }

    /// The fields.
    pub(super) fn fields(&self) -> BTreeSet<usize> {
        match self {
            Dependence::None => BTreeSet::new(),
            Dependence::Number(fields) => fields.clone(),
            Dependence::Tuple(parts) => parts.iter().flat_map(Dependence::fields).collect(),
        }
    }

    /// A tuple, if any part depends on fields.
    pub(super) fn of_tuple(parts: Vec<Dependence>) -> Self {
        if parts.iter().all(Dependence::is_none) { Dependence::None } else { Dependence::Tuple(parts) }
    }

    /// How a value depends on fields that may be either of two, or is made of two numbers.
    pub(super) fn joined(self, other: &Dependence) -> Self {
        match (self, other) {
            (Dependence::Tuple(parts), Dependence::Tuple(others)) => {
                Dependence::Tuple(parts.into_iter().zip(others).map(|(part, other)| part.joined(other)).collect())
            }
            (Dependence::None, other) => other.clone(),
            (tuple @ Dependence::Tuple(_), _) => tuple,
            (number @ Dependence::Number(_), other) => Dependence::Number(&number.fields() | &other.fields()),
        }
    }

    /// The dependence of a value that is made of several values.
    pub(super) fn all<'a>(values: impl IntoIterator<Item = &'a Dependence>) -> Self {
        let fields: BTreeSet<usize> = values.into_iter().flat_map(Dependence::fields).collect();
        if fields.is_empty() { Dependence::None } else { Dependence::Number(fields) }
    }
}
