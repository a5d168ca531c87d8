//! Elements of one's own besides the string: one that turns, one that damps, one whose numbers are known.

use mstmm::element::{
    Chart, Charted, Element, FrequencyEstimates, FrequencyPowers, InvalidParameter, MemberNumbers, Rotation,
    Translation,
};
use mstmm::number::{ComplexFrequency, Frequency, Parameter};

/// A torsion spring.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coil<T> {
    pub(crate) stiffness: T,
}

impl<T: Parameter> Element for Coil<T> {
    type State = Rotation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Ok(self)
    }

    fn estimate(coil: &Self, estimates: &mut FrequencyEstimates) {
        estimates.torsional_stiffness(coil.stiffness.to_f64());
    }
}

impl<T: Parameter, S: Frequency<T>> Charted<S> for Coil<T> {
    fn chart(coil: &Self, _at: &FrequencyPowers<S>, _distance: S) -> Chart<S> {
        Chart::torsion_spring(S::from_parameter(coil.stiffness))
    }
}

/// A dashpot, at complex λ only.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dashpot<T> {
    pub(crate) damping: T,
}

impl<T: Parameter> Element for Dashpot<T> {
    type State = Translation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Ok(self)
    }
}

impl<T: Parameter, S: ComplexFrequency<T>> Charted<S> for Dashpot<T> {
    fn chart(dashpot: &Self, at: &FrequencyPowers<S>, _distance: S) -> Chart<S> {
        Chart::spring(at.x * dashpot.damping)
    }
}

/// A taut string that hands its numbers on, so that searches evaluate its frames at many frequencies at once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known<T> {
    pub(crate) length: T,
    pub(crate) tension: T,
    pub(crate) mass_per_length: T,
}

impl<T: Parameter> Element for Known<T> {
    type State = Translation;
    type Built = cable::Cable<T>;

    fn build(self) -> Result<cable::Cable<T>, InvalidParameter> {
        let Known { length, tension, mass_per_length } = self;
        cable::Cable { length, tension, mass_per_length }.build()
    }

    fn estimate(cable: &cable::Cable<T>, estimates: &mut FrequencyEstimates) {
        cable::Cable::estimate(cable, estimates);
    }

    fn member_numbers(cable: &cable::Cable<T>) -> MemberNumbers {
        let [length, tension, mass] = [cable.length, cable.tension, cable.mass_per_length].map(T::to_f64);
        MemberNumbers::uniform_line(0, [length, tension, mass, 0.0])
    }
}

impl<T: Parameter, S: Frequency<T>> Charted<S> for Known<T> {
    fn chart(cable: &cable::Cable<T>, at: &FrequencyPowers<S>, distance: S) -> Chart<S> {
        cable::Cable::chart(cable, at, distance)
    }
}
