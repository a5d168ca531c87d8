//! Rigid disc on a shaft.

use crate::element::{BackTransfer, BodyNumbers, Element, Energies, MemberNumbers, PlaneStep, Spins, TransferMatrix};
use crate::elements::point_mass::{PointMass, PointMassCoefficients};
use crate::elements::shared::line_forms::displacements;
use crate::elements::shared::spin::Spin;
use crate::model::{Bending, Ends, Extent, FrequencyEstimates, InvalidParameter};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Scalar, Scaled, Single};
use crate::subspace::{Covector, RootCounter, Subspace};
use mstmm_plan::{Coordinate, Support};
use nalgebra::Matrix4;

/// Rigid disc on a shaft, with gyroscopic moments: a [`PointMass`] that spins.
///
/// Transfer matrix on `[Y, Θ, M, Q]`: the identity plus `-I_d ω² + I_p Ω ω` at (M, Θ) and `mω²` at (Q, Y), with the displacements of a
/// [`SpinningBeam`](crate::elements::SpinningBeam).
///
/// # Source
/// Eq. (16) of the paper with `b = c = 0`, with the gyroscopic moment of Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010), 3.5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc<T> {
    /// Mass m \[kg\], zero or positive.
    pub mass: T,
    /// Moment of inertia I_d about a diameter [kg m²], zero or positive.
    pub inertia: T,
    /// Polar moment of inertia I_p about the axis [kg m²], zero or positive.
    pub polar_inertia: T,
    /// Speed Ω [rad/s] about the axis, of either sign.
    pub speed: T,
}

/// A disc as a whirl sees it.
#[derive(Clone, Copy, Debug)]
pub struct BuiltDisc<T> {
    at_rest: PointMass<T>,
    spin: Spin<T>,
}

impl<T: Parameter> BuiltDisc<T> {
    fn of<S: Frequency<T>>(&self, x: S, lambda_squared: S) -> PointMassCoefficients<S> {
        let moment = self.spin.momentum::<S>() * x.signed_omega();
        PointMassCoefficients {
            a: lambda_squared * self.at_rest.mass,
            j: lambda_squared * self.at_rest.inertia + moment,
        }
    }
}

impl<T: Parameter> Element for Disc<T> {
    type State = Bending;
    type Built = BuiltDisc<T>;

    fn build(self) -> Result<BuiltDisc<T>, InvalidParameter> {
        let at_rest = PointMass { mass: self.mass, inertia: self.inertia }.build()?;
        let spin = Spin::new(self.polar_inertia, self.speed);
        spin.check("polar_inertia")?;
        Ok(BuiltDisc { at_rest, spin })
    }

    fn estimate(built: &BuiltDisc<T>, estimates: &mut FrequencyEstimates) {
        PointMass::estimate(&built.at_rest, estimates);
        built.spin.estimate(estimates, 1.0);
    }

    /// Of a thin disc, `I_p = m r²/2`.
    fn extent(built: &BuiltDisc<T>) -> Extent {
        let square = (built.spin.polar_inertia / built.at_rest.mass).to_f64();
        Extent::default().of_radius(Scalar::sqrt(square + square))
    }

    fn member_numbers(built: &BuiltDisc<T>) -> MemberNumbers {
        let [mass, inertia] = [built.at_rest.mass, built.at_rest.inertia].map(T::words);
        MemberNumbers::Disc(BodyNumbers { mass, inertia, ..BodyNumbers::default() }, built.spin.numbers())
    }
}

impl<T: Parameter> Spins for Disc<T> {
    fn turned_round(built: BuiltDisc<T>) -> BuiltDisc<T> {
        BuiltDisc { spin: built.spin.turned_round(), ..built }
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for Disc<T> {
    fn transfer_matrix(built: &BuiltDisc<T>, x: S) -> Matrix4<S> {
        let PointMassCoefficients { a, j } = built.of(x, x.lambda_squared());
        let mut u = Matrix4::identity();
        (u[(2, 1)], u[(3, 0)]) = (j, -a);
        u
    }
}

impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for Disc<T> {
    type Coefficients = PointMassCoefficients<S>;

    #[inline(always)]
    fn coefficients(built: &BuiltDisc<T>, at: &FrequencyPowers<S>) -> PointMassCoefficients<S> {
        built.of(at.x, at.lambda_squared)
    }

    #[inline(always)]
    fn step<C: RootCounter<S>>(disc: &Self::Coefficients, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        PointMass::<T>::step(disc, input, counter)
    }

    fn root<C: RootCounter<S>>(
        disc: &Self::Coefficients,
        input: Subspace<S>,
        support: Support,
        counter: &mut C,
    ) -> Scaled<S> {
        PointMass::<T>::root(disc, input, support, counter)
    }
}

impl<T: Real, S: Oscillation<T>> BackTransfer<S> for Disc<T> {
    type BackCoefficients = PointMassCoefficients<S>;
    const SYMMETRIC: bool = true;

    fn reversed(built: &BuiltDisc<T>) -> BuiltDisc<T> {
        *built
    }

    fn back_coefficients(built: &BuiltDisc<T>, at: &FrequencyPowers<S>) -> PointMassCoefficients<S> {
        Self::coefficients(built, at)
    }

    fn back_transfer(disc: &PointMassCoefficients<S>, input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
        PointMass::<T>::back_transfer(disc, input, covector)
    }
}

impl<T: Real, S: Oscillation<T>> Energies<S> for Disc<T> {
    type Gradient = Disc<S>;

    fn units(built: &BuiltDisc<T>, at: &FrequencyPowers<S>) -> [f64; 2] {
        let PointMassCoefficients { a, j } = Self::coefficients(built, at);
        [S::size(a), S::size(j)]
    }

    fn mass_form(built: &BuiltDisc<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        PointMass::mass_form(&built.at_rest, first, second)
    }

    fn stiffness_form(_built: &BuiltDisc<T>, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    fn damping_form(built: &BuiltDisc<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.spin.form(displacements(Coordinate::Theta, first, second))
    }

    fn gradient(built: &BuiltDisc<T>, ends: &Ends<S>) -> Disc<S> {
        let PointMass { mass, inertia } = PointMass::gradient(&built.at_rest, ends);
        let [polar_inertia, speed] = built.spin.gradient(ends.x, displacements(Coordinate::Theta, ends, ends));
        Disc { mass, inertia, polar_inertia, speed }
    }
}

#[cfg(test)]
impl super::laws::Sample for Disc<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        Disc { mass: next(), inertia: next(), polar_inertia: next(), speed: next() - 1.25 }
    }

    fn lossless(self) -> Self {
        Disc { speed: 0.0, ..self }
    }
}
