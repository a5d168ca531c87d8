//! How an element of a path reaches from one end to the other, for drawings.

/// Where an element has its output end and its mass centre, seen from its input end: x along the arrow, y a quarter of a turn on from there,
/// in \[m\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extent {
    /// The output end; zero of an element without extent, such as a spring.
    pub output: [f64; 2],
    /// The mass centre of a rigid body.
    pub centre: Option<[f64; 2]>,
    /// The radius of a round part: of a solid shaft of the same mass and rotary inertia, or of a disc of the same mass and polar inertia. Zero of others.
    pub radius: f64,
    /// The bending stiffness EI [N m²] of a beam, of a tapered one at its input end. Zero of others.
    pub bending_stiffness: f64,
}

impl Extent {
    /// The extent of an element that reaches so far along its arrow.
    pub fn along(length: f64) -> Self {
        Extent { output: [length, 0.0], ..Extent::default() }
    }

    /// The extent of what bends.
    #[must_use]
    pub(crate) fn of_stiffness(self, bending_stiffness: f64) -> Self {
        Extent { bending_stiffness, ..self }
    }

    /// The extent of a round part.
    #[must_use]
    pub(crate) fn of_radius(self, radius: f64) -> Self {
        Extent { radius, ..self }
    }
}
