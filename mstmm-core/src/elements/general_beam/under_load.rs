//! Motions of a general beam under a uniform load.

use crate::elements::general_beam::constants::SectionAt;
use crate::elements::general_beam::inside::{BeamMotion, Vector, plus, times};
use crate::elements::general_beam::transfer::units_of_states;
use crate::elements::shared::uniform_load::{superposed, work};
use crate::model::{Ends, State};
use crate::number::{Oscillation, Real, Scalar, series};
use num_complex::Complex;
use num_traits::Zero;

/// Square of a wave number times l up to which waves are long.
const LONG: f64 = 1.0;
/// That from which on the waves of one pair are short beside long ones of the other.
const SHORT: f64 = 4.0;

impl<T: Real, S: Oscillation<T>> BeamMotion<T, S> {
    /// The state of a motion under a load of 1 per length, at a distance from the input end.
    fn under_load(&self, distance: T) -> State<S> {
        let [of_y, of_theta, of_m, of_q] = units_of_states(&self.beam);
        let loss = self.loss.to_complex();
        let load = Complex::from(self.beam.length / of_q) / loss;
        let [y, theta, m, q] = self.section.under_load(distance / self.beam.length).map(|entry| entry * load);
        let entries = [y * of_y, theta * of_theta, m * of_m * loss, q * of_q * loss];
        let [y, theta, m, q] = entries.map(S::from_complex);
        State { y, theta, m, q }
    }

    /// The work of a load of 1 per length on a motion.
    pub(super) fn load_work(&self, ends: &Ends<S>) -> S {
        work(ends, [T::zero(), self.beam.length].map(|distance| self.under_load(distance)))
    }

    /// The state at a distance from the input end under so many times that load.
    pub(super) fn state_under(&self, ends: &Ends<S>, load: S, distance: T) -> State<S> {
        let under = [T::zero(), self.beam.length, distance].map(|distance| self.under_load(distance));
        superposed(ends, load, under, |rest| self.state_at(rest, distance))
    }
}

impl<T: Real> SectionAt<Complex<T>> {
    /// The state under a load of 1, in units of l and EI: where all waves are short `Y = -1/h`; where those of one κ are long
    /// `Y = (cosh √κ x - 1)/h` of these, with `κ/h = -cut/κ'` of the other κ'; where all are long the series of `∫ exp(A x) dx`.
    fn under_load(&self, part: T) -> Vector<T> {
        let [larger, smaller] = self.waves.squares();
        let (zero, one) = (Complex::zero(), Complex::from(T::one()));
        if smaller.size() > LONG {
            return [-one / self.h, zero, zero, zero];
        }
        if larger.size() > SHORT {
            let square = smaller * (part * part);
            let curvature = -self.cut / larger;
            let cosh = one + square * series(square, 2, 2);
            let sinh = series(square, 1, 2) * part;
            let turned = (curvature + self.tau) / self.sigma;
            return [curvature * series(square, 2, 2) * (part * part), turned * sinh, turned * cosh, sinh];
        }
        let mut term = [zero, zero, zero, Complex::from(part)];
        let mut sum = term;
        for k in 2..=8 * T::SERIES_TERMS {
            let factor = part / T::from_f64(k as f64);
            term = times(self.derivative(term), Complex::from(factor));
            sum = plus(sum, term);
        }
        sum
    }
}
