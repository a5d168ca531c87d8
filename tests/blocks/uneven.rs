//! An element of one's own that decides by its numbers what kind of subspace it makes: in a block its lanes differ, and each
//! frequency is evaluated alone.

use mstmm::element::{
    BackTransfer, Covector, Element, Ends, Energies, FrequencyPowers, InvalidParameter, PlaneStep, RootCounter,
    Subspace, Translation,
};
use mstmm::elements::Spring;
use mstmm::number::{Frequency, Oscillation, Real, Scaled};
use mstmm::prelude::*;

/// A spring that is not there below a frequency.
#[derive(Clone, Copy, Debug)]
pub struct Latch<T> {
    /// Stiffness [N/m].
    pub stiffness: T,
    /// The frequency [rad/s].
    pub from: T,
}

impl<T: Real> Element for Latch<T> {
    type State = Translation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Ok(self)
    }
}

impl<T: Real, S: Frequency<T>> PlaneStep<S> for Latch<T> {
    type Coefficients = Option<S>;

    fn coefficients(built: &Self, at: &FrequencyPowers<S>) -> Option<S> {
        (at.x.size() >= built.from.to_f64()).then(|| S::from_parameter(built.stiffness))
    }

    fn step<C: RootCounter<S>>(stiffness: &Option<S>, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        match stiffness {
            None => input,
            Some(stiffness) => <Spring<T> as PlaneStep<S>>::step(stiffness, input, counter),
        }
    }
}

impl<T: Real, S: Oscillation<T>> BackTransfer<S> for Latch<T> {
    type BackCoefficients = Option<S>;
    const SYMMETRIC: bool = true;

    fn reversed(built: &Self) -> Self {
        *built
    }

    fn back_coefficients(built: &Self, at: &FrequencyPowers<S>) -> Option<S> {
        <Self as PlaneStep<S>>::coefficients(built, at)
    }

    fn back_transfer(stiffness: &Option<S>, input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
        match stiffness {
            None => covector,
            Some(stiffness) => <Spring<T> as BackTransfer<S>>::back_transfer(stiffness, input, covector),
        }
    }
}

impl<T: Real, S: Oscillation<T>> Energies<S> for Latch<T> {
    type Gradient = Latch<S>;

    fn units(built: &Self, _at: &FrequencyPowers<S>) -> [f64; 2] {
        [built.stiffness.to_f64(), 0.0]
    }

    fn mass_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    fn stiffness_form(built: &Self, first: &Ends<S>, second: &Ends<S>) -> S {
        <Spring<T> as Energies<S>>::stiffness_form(&Spring { stiffness: built.stiffness }, first, second)
    }

    fn gradient(built: &Self, ends: &Ends<S>) -> Latch<S> {
        let spring = <Spring<T> as Energies<S>>::gradient(&Spring { stiffness: built.stiffness }, ends);
        Latch { stiffness: spring.stiffness, from: S::zero() }
    }
}

system! {
    struct Latched {}
    fixed -> crate::uneven::Latch 1 { stiffness: 3.0, from: 2.0 } -> mass 2 { mass: 0.5 } -> spring 3 { stiffness: 2.0 } -> free;
}

#[test]
fn lanes_of_different_kinds_are_evaluated_alone() {
    let system = Latched {}.build().unwrap();
    let omegas: [f64; 64] = core::array::from_fn(|k| 0.1 * (k + 1) as f64);
    let (mut values, mut counts) = ([Scaled::new(0.0, 0); 64], [Ok(0); 64]);
    system.characteristics(&omegas, &mut values).unwrap();
    system.counts_below(&omegas, &mut counts).unwrap();
    for ((value, count), omega) in values.into_iter().zip(counts).zip(omegas) {
        let alone: Scaled<f64> = system.characteristic(omega);
        assert_eq!((value, count), (alone, system.count_below(omega)), "at {omega}");
    }
}

#[test]
fn responses_of_lanes_of_different_kinds_are_those_alone() {
    let system = Latched {}.build().unwrap();
    // none of them is a resonance
    let omegas: [f64; 64] = core::array::from_fn(|k| 0.0973 * (k + 1) as f64);
    let points = [Latched::Latch_1.output(), Latched::mass_2.output(), Latched::spring_3.output()];
    for (load, entry) in points.iter().flat_map(|load| points.iter().map(|entry| (load.force(), entry.deflection()))) {
        let response = system.frequency_response(load, entry).unwrap();
        let mut values = [0.0; 64];
        response.on(&omegas, &mut values).unwrap();
        let alone = omegas.map(|omega| response.at(omega).unwrap());
        assert_eq!(values.map(f64::to_bits), alone.map(f64::to_bits), "{load:?} {entry:?}");
    }
}
