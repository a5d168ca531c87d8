//! The line along an element of the plane, with damping or without.

use crate::element::{Forms, Inside};
use crate::elements::in_plane::across::{Along, AlongGradient};
use crate::elements::shared::damped_line::DampedLine;
use crate::elements::shared::longitudinal_chart::LongitudinalWaves;
use crate::elements::shared::rod_motion::Stretch;
use crate::elements::shared::uniform_line::{LineSection, UniformLine};
use crate::number::{ComplexFrequency, Frequency, FrequencyPowers, Oscillation, Parameter, Real, Scalar, Single};
use nalgebra::Matrix2;

/// The waves of a line at a frequency.
pub(crate) trait AlongWaves<S: Scalar> {
    /// The waves of a line of a length, without their functions.
    fn longitudinal(&self, at: &FrequencyPowers<S>, length: S) -> LongitudinalWaves<S>;

    /// The transfer matrix on `[X, Qx]`.
    fn transfer_matrix(&self, x: S) -> Matrix2<S>
    where
        S: Single;
}

/// The motions of a line.
pub(crate) trait AlongMotion<S: Scalar> {
    /// The forms of two motions.
    fn forms(&self, first: &Stretch<S>, second: &Stretch<S>) -> Forms<S>;

    /// The length of the line and its wave number.
    fn inside(&self, x: S) -> Inside;

    /// Displacement and axial force at a distance from the input end.
    fn state_at(&self, motion: &Stretch<S>, distance: f64) -> [S; 2];

    /// The derivatives of the dynamic work.
    fn gradient(&self, motion: &Stretch<S>) -> AlongGradient<S>;

    /// The work of a load of 1 per length on a motion.
    fn load_work(&self, motion: &Stretch<S>) -> S;

    /// Displacement and axial force at a distance from the input end under so many times that load.
    fn state_under(&self, motion: &Stretch<S>, load: S, distance: f64) -> [S; 2];
}

impl<T: Parameter> Along<T> for UniformLine<T> {
    fn length_and_stiffness(&self) -> [T; 2] {
        [self.section.length, self.section.stiffness]
    }
}

impl<T: Parameter> Along<T> for DampedLine<T> {
    fn length_and_stiffness(&self) -> [T; 2] {
        self.line.length_and_stiffness()
    }
}

impl<T: Parameter, S: Frequency<T>> AlongWaves<S> for UniformLine<T> {
    /// In extended precision they follow from the parameters and the length, since `build` has rounded.
    fn longitudinal(&self, at: &FrequencyPowers<S>, length: S) -> LongitudinalWaves<S> {
        if S::IS_EXTENDED {
            return LineSection { length, ..self.section.map(S::from_parameter) }.waves_at(at.lambda_squared);
        }
        self.longitudinal(at.lambda_squared)
    }

    fn transfer_matrix(&self, x: S) -> Matrix2<S>
    where
        S: Single,
    {
        self.transfer_matrix(x, false)
    }
}

impl<T: Real, S: Oscillation<T>> AlongMotion<S> for UniformLine<T> {
    fn forms(&self, first: &Stretch<S>, second: &Stretch<S>) -> Forms<S> {
        let [mass, stiffness] = self.section.forms(first, second);
        Forms { mass, stiffness, ..Forms::none() }
    }

    fn inside(&self, x: S) -> Inside {
        self.section.inside(x)
    }

    fn state_at(&self, motion: &Stretch<S>, distance: f64) -> [S; 2] {
        self.section.at(motion, T::from_f64(distance))
    }

    fn gradient(&self, motion: &Stretch<S>) -> AlongGradient<S> {
        let [length, stiffness, mass, _] = self.section.gradient(motion);
        AlongGradient { length, stiffness, mass, damping: [S::zero(); 3] }
    }

    fn load_work(&self, motion: &Stretch<S>) -> S {
        self.section.undamped_load_work(motion)
    }

    fn state_under(&self, motion: &Stretch<S>, load: S, distance: f64) -> [S; 2] {
        self.section.undamped_at_under(motion, load, T::from_f64(distance))
    }
}

impl<T: Parameter, S: ComplexFrequency<T>> AlongWaves<S> for DampedLine<T> {
    fn longitudinal(&self, at: &FrequencyPowers<S>, length: S) -> LongitudinalWaves<S> {
        self.longitudinal(at, length)
    }

    fn transfer_matrix(&self, x: S) -> Matrix2<S>
    where
        S: Single,
    {
        self.waves(&FrequencyPowers::new(x, false)).transfer_matrix(false)
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> AlongMotion<S> for DampedLine<T> {
    fn forms(&self, first: &Stretch<S>, second: &Stretch<S>) -> Forms<S> {
        self.forms(first, second)
    }

    fn inside(&self, x: S) -> Inside {
        self.inside(x)
    }

    fn state_at(&self, motion: &Stretch<S>, distance: f64) -> [S; 2] {
        self.state_at(motion, T::from_f64(distance))
    }

    fn gradient(&self, motion: &Stretch<S>) -> AlongGradient<S> {
        let ([length, stiffness, mass, _], damping) = self.gradient(motion);
        AlongGradient { length, stiffness, mass, damping }
    }

    fn load_work(&self, motion: &Stretch<S>) -> S {
        self.load_work(motion)
    }

    fn state_under(&self, motion: &Stretch<S>, load: S, distance: f64) -> [S; 2] {
        self.state_under(motion, load, T::from_f64(distance))
    }
}
