//! Rigid body in planar motion, by its inertia about its input end or about its mass centre.

use crate::element::{Element, TransferMatrix};
use crate::model::{Extent, InvalidParameter, Planar, Requirement};
use crate::number::{Frequency, Parameter, Single};
use nalgebra::Matrix6;

/// Rigid body with one input and one output end in planar motion; small rotations.
///
/// Transfer matrix on `[X, Y, Θ, M, Qx, Qy]`, with the output end at (b1, b2) and the mass centre at (c1, c2):
///
/// ```text
/// 1            0             -b2                        0   0    0
/// 0            1             b1                         0   0    0
/// 0            0             1                          0   0    0
/// mλ²(b2-c2)   -mλ²(b1-c1)   λ²[J_I - m(b1c1 + b2c2)]   1   -b2  b1
/// -mλ²         0             mλ²c2                      0   1    0
/// 0            -mλ²          -mλ²c1                     0   0    1
/// ```
///
/// # Source
/// Eq. (15) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarBody<T> {
    /// Mass m \[kg\], zero or positive.
    pub mass: T,
    /// Moment of inertia J_I about the input end [kg m²], at least `mass * (centre_x² + centre_y²)`.
    pub inertia: T,
    /// Position b1 of the output end along x \[m\].
    pub output_x: T,
    /// Position b2 of the output end along y \[m\].
    pub output_y: T,
    /// Position c1 of the mass centre along x \[m\].
    pub centre_x: T,
    /// Position c2 of the mass centre along y \[m\].
    pub centre_y: T,
}

impl<T: Parameter> Element for PlanarBody<T> {
    type State = Planar;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::NonNegative.check("mass", self.mass)?;
        Requirement::Finite.check("output_x", self.output_x)?;
        Requirement::Finite.check("output_y", self.output_y)?;
        Requirement::Finite.check("centre_x", self.centre_x)?;
        Requirement::Finite.check("centre_y", self.centre_y)?;
        // the mass first: none has no moment, however far away
        let about_centre = self.mass * self.centre_x * self.centre_x + self.mass * self.centre_y * self.centre_y;
        Requirement::at_least(about_centre, "mass * (centre_x² + centre_y²)").check("inertia", self.inertia)?;
        Ok(self)
    }

    fn extent(built: &Self) -> Extent {
        let output = [built.output_x, built.output_y].map(T::to_f64);
        Extent { output, centre: Some([built.centre_x, built.centre_y].map(T::to_f64)), ..Extent::default() }
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for PlanarBody<T> {
    #[rustfmt::skip]
    fn transfer_matrix(built: &Self, x: S) -> Matrix6<S> {
        let (o, i) = (S::zero(), S::one());
        let (b1, b2) = (S::from_parameter(built.output_x), S::from_parameter(built.output_y));
        let lambda_squared = x.lambda_squared();
        let a = lambda_squared * built.mass;
        let ac1 = lambda_squared * (built.mass * built.centre_x);
        let ac2 = lambda_squared * (built.mass * built.centre_y);
        let j = lambda_squared * built.inertia;
        Matrix6::new(
            i,            o,            -b2,                   o, o,   o,
            o,            i,            b1,                    o, o,   o,
            o,            o,            i,                     o, o,   o,
            a * b2 - ac2, ac1 - a * b1, j - b1 * ac1 - b2 * ac2, i, -b2, b1,
            -a,           o,            ac2,                   o, i,   o,
            o,            -a,           -ac1,                  o, o,   i,
        )
    }
}

/// Rigid body in planar motion whose inertia is about its mass centre: a [`PlanarBody`] with `J_I = J_C + m (c1² + c2²)`.
///
/// # Source
/// Eq. (15) of the paper, and Steiner's theorem.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarCentralBody<T> {
    /// Mass m \[kg\], zero or positive.
    pub mass: T,
    /// Moment of inertia J_C about the mass centre [kg m²], zero or positive.
    pub inertia: T,
    /// Position b1 of the output end along x \[m\].
    pub output_x: T,
    /// Position b2 of the output end along y \[m\].
    pub output_y: T,
    /// Position c1 of the mass centre along x \[m\].
    pub centre_x: T,
    /// Position c2 of the mass centre along y \[m\].
    pub centre_y: T,
}

impl<T: Parameter> Element for PlanarCentralBody<T> {
    type State = Planar;
    type Built = PlanarBody<T>;

    fn build(self) -> Result<PlanarBody<T>, InvalidParameter> {
        let PlanarCentralBody { mass, inertia, output_x, output_y, centre_x, centre_y } = self;
        Requirement::NonNegative.check("mass", mass)?;
        Requirement::NonNegative.check("inertia", inertia)?;
        for (name, position) in
            [("output_x", output_x), ("output_y", output_y), ("centre_x", centre_x), ("centre_y", centre_y)]
        {
            Requirement::Finite.check(name, position)?;
        }
        let inertia = inertia + mass * centre_x * centre_x + mass * centre_y * centre_y;
        if Requirement::Finite.check("inertia", inertia).is_err() {
            let (parameter, value, requirement) = ("mass", mass.to_f64(), Requirement::Rescale);
            return Err(InvalidParameter { parameter, value, requirement });
        }
        Ok(PlanarBody { mass, inertia, output_x, output_y, centre_x, centre_y })
    }

    fn extent(built: &PlanarBody<T>) -> Extent {
        PlanarBody::extent(built)
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for PlanarCentralBody<T> {
    fn transfer_matrix(built: &PlanarBody<T>, x: S) -> Matrix6<S> {
        PlanarBody::transfer_matrix(built, x)
    }
}

#[cfg(test)]
impl super::laws::Sample for PlanarBody<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        let (mass, centre_x, centre_y) = (next(), next() - 1.0, next() - 1.0);
        PlanarBody {
            mass,
            inertia: mass * (centre_x * centre_x + centre_y * centre_y) + next(),
            output_x: next() - 1.0,
            output_y: next() - 1.0,
            centre_x,
            centre_y,
        }
    }
}

#[cfg(test)]
impl super::laws::Sample for PlanarCentralBody<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        let [mass, inertia] = [next(), next()];
        let [output_x, output_y, centre_x, centre_y] = [(); 4].map(|()| next() - 1.0);
        PlanarCentralBody { mass, inertia, output_x, output_y, centre_x, centre_y }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_without_mass_needs_no_inertia_wherever_its_centre_is() {
        let massless =
            PlanarBody { mass: 0.0, inertia: 0.0, output_x: 1.0, output_y: 0.0, centre_x: 1e200, centre_y: -1e200 };
        assert!(massless.build().is_ok());
    }
}
