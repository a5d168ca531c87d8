//! The methods: how they are named and drawn.

use crate::error::ReportError;
use crate::marker::{Look, Marker};
use crate::palette::{BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION};
use rivals::runs::{CERTIFIED, P_VERSION};

/// A method in plots and tables.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Method {
    /// Its name in the runs.
    pub(crate) name: &'static str,
    /// A word for labels in plots.
    pub(crate) label: &'static str,
    pub(crate) look: Look,
}

const fn method(name: &'static str, label: &'static str, look: Look) -> Method {
    Method { name, label, look }
}

/// All methods, in the order of legends and tables.
pub(crate) const METHODS: [Method; 6] = [
    method(CERTIFIED, "certified", Look { hue: BLUE, marker: Marker::Circle, dash: None }),
    method("plain method", "plain", Look { hue: ORANGE, marker: Marker::Square, dash: None }),
    method("scan for minima", "scan", Look { hue: VERMILION, marker: Marker::Triangle, dash: None }),
    method("Hermite elements", "Hermite", Look { hue: GREEN, marker: Marker::Diamond, dash: Some(7) }),
    method(P_VERSION, "p-version", Look { hue: PURPLE, marker: Marker::Wedge, dash: Some(3) }),
    method("contour integral", "contour", Look { hue: SKY, marker: Marker::Cross, dash: Some(12) }),
];

/// The method of a name.
pub(crate) fn named(name: &str) -> Result<&'static Method, ReportError> {
    METHODS.iter().find(|method| method.name == name).ok_or_else(|| ReportError::UnknownMethod(name.to_owned()))
}
