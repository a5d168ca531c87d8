//! The deflection of a uniform member as its equation has it.

/// The deflection of a uniform member across itself, a solution of `y'''' = (κ₁ + κ₂) y'' - κ₁ κ₂ y` along `ξ = x/l`.
///
/// It is a sum of waves `e^{±√κ₁ ξ}` and `e^{±√κ₂ ξ}`. A string has one κ; the other one is zero, and no part of it has that one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deflection<S> {
    /// `κ₁ + κ₂`.
    pub sum: S,
    /// `κ₁ κ₂`.
    pub product: S,
    /// `(κ₁ - κ₂)²`, which a beam knows without cancellation.
    pub square: S,
    /// `y, y', y'', y'''` at both ends \[m\], derivatives along ξ.
    pub ends: [[S; 4]; 2],
}
