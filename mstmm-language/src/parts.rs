//! The parts of elements in space: each is an element of the plane, with the parameters that it has there.

use crate::ast::{Element, Kind, Model, Parameter};
use crate::keywords::{Dimension, PAIRS, Role, in_space};
use mstmm_plan::HINGE_PARTS;
use proc_macro2::Ident;
use quote::ToTokens;
use syn::ext::IdentExt;

/// Gives each element of a model in space its parts.
pub(crate) fn split(model: &mut Model) {
    for element in model.elements_mut().filter(|element| element.dimension == Dimension::Space) {
        element.parts = [0, 1, 2].map(|part| part_of(element, part).map(Box::new));
    }
}

/// One part of an element, if it has that.
fn part_of(element: &Element, part: usize) -> Option<Element> {
    let Kind::Keyword(keyword) = &element.kind else { return None };
    element.located().filter(|row| matches!(row.role, Role::Member | Role::Joint))?;
    let of_space = in_space(&keyword.to_string())?;
    let part_row = Some(of_space.part(part)?);
    let parameters = element.parameters().filter_map(|parameter| {
        let name = parameter.name.unraw().to_string();
        let own = of_space.name_in(part, &name)?;
        if own == name {
            return Some(parameter.clone());
        }
        let value = Some(parameter.expression());
        let called = PAIRS
            .iter()
            .flat_map(|pair| pair.planes)
            .chain(HINGE_PARTS.map(|(of_hinge, ..)| of_hinge))
            .find(|known| *known == name);
        Some(Parameter { name: Ident::new(own, parameter.name.span()), value, called, ..parameter.clone() })
    });
    Some(Element {
        kind: element.kind.clone(),
        label: element.label.clone(),
        parameters: Some(parameters.collect()),
        spread: Vec::new(),
        dimension: Dimension::Plane,
        location: None,
        part_row,
        parts: [None, None, None],
    })
}

/// The parameters of a hinge that are alike where both of its planes are.
const ALIKE: [[&str; 2]; 4] = [
    ["stiffness_y", "stiffness_z"],
    ["stiffness_rz", "stiffness_ry"],
    ["damping_y", "damping_z"],
    ["damping_rz", "damping_ry"],
];

impl Element {
    /// Whether both of its planes through x are written alike.
    pub(crate) fn is_symmetric(&self) -> bool {
        let value = |name: &str| {
            let mut named = self.parameters().filter(|parameter| parameter.name.unraw() == name);
            named.next().map(|parameter| parameter.expression().to_token_stream().to_string())
        };
        PAIRS.iter().map(|pair| pair.planes).chain(ALIKE).all(|[one, other]| value(one) == value(other))
    }
}
