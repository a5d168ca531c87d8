//! Cross sections: area, second moments, torsion constant and shear coefficients from sizes, with their derivatives.
//!
//! A section is a struct of its sizes. Its methods check them and return [`Properties`] and [`ShearCoefficients`]. Sizes are `f64`, or
//! [`Partials`](crate::Partials), whose results have the derivatives by each size. The unit of sizes is free; in metres results are in m² and m⁴.
//!
//! The x axis is that of the member, y and z are the axes of its cross section. Widths are along y, heights along z. So `i_y = ∫ z² dA` is the
//! moment of a bending about y, and the shear coefficient `y` that of a deflection along y.
//!
//! ```
//! use mstmm_core::sections::{Rectangle, Tube};
//!
//! let (steel, shear_modulus) = (2.1e11, 8.1e10);
//! let leg = Tube { outer: 0.2, inner: 0.18 }.properties()?;
//! let (bending_stiffness, torsional_stiffness) = (steel * leg.i_y, shear_modulus * leg.torsion);
//! assert!((bending_stiffness / 5.672e6 - 1.0).abs() < 1e-3);
//! assert!((torsional_stiffness / 4.376e6 - 1.0).abs() < 1e-3);
//!
//! let plank = Rectangle { width: 0.2, height: 0.03 };
//! let shear = plank.shear_coefficients(0.3)?;
//! let shear_stiffness_z = shear.z * shear_modulus * plank.properties()?.area;
//! assert!((shear_stiffness_z / 4.129e8 - 1.0).abs() < 1e-3);
//! # Ok::<(), mstmm_core::InvalidParameter>(())
//! ```
//!
//! By how much a property changes with a size:
//!
//! ```
//! use mstmm_core::Partials;
//! use mstmm_core::sections::Round;
//!
//! let rod = Round { diameter: Partials::<1>::variable(0.02, 0) }.properties()?;
//! // d⁴ has the derivative 4 d³
//! assert!((rod.i_y.partials[0] - 4.0 * rod.i_y.value / 0.02).abs() < 1e-18);
//! # Ok::<(), mstmm_core::InvalidParameter>(())
//! ```
//!
//! In formulas of `system!` stand the functions of the same names in small letters: [`round`], [`tube`], [`rectangle`], [`box_section`], [`i_section`].

mod formulas;
mod number;
mod properties;
mod rectangle;
mod round;
mod walls;

pub use formulas::{
    box_section, box_shear, i_section, i_shear, rectangle, rectangle_shear, round, round_shear, tube, tube_shear,
};
pub use number::Number;
pub use properties::{Properties, ShearCoefficients};
pub use rectangle::Rectangle;
pub use round::{Round, Tube};
pub use walls::{BoxSection, ISection};

#[cfg(test)]
mod tests;
