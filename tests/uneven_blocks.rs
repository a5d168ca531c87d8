//! An element of one's own that decides by its numbers what kind of subspace it makes: in a block its lanes differ, and each
//! frequency is evaluated alone.

use mstmm::elements::Spring;
use mstmm::prelude::*;
use mstmm::{At, Element, Frequency, InvalidParameter, PlaneStep, Real, Scaled, Subspace, Tally, Translation};

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

    fn coefficients(built: &Self, at: &At<S>) -> Option<S> {
        (at.x.size() >= built.from.to_f64()).then(|| S::from_parameter(built.stiffness))
    }

    fn step<C: Tally<S>>(stiffness: &Option<S>, input: Subspace<S>, tally: &mut C) -> Subspace<S> {
        match stiffness {
            None => input,
            Some(stiffness) => <Spring<T> as PlaneStep<S>>::step(stiffness, input, tally),
        }
    }
}

system! {
    struct Latched {}
    fixed -> crate::Latch 1 { stiffness: 3.0, from: 2.0 } -> mass 2 { mass: 0.5 } -> spring 3 { stiffness: 2.0 } -> free;
}

#[test]
fn lanes_of_different_kinds_are_evaluated_alone() {
    let system = Latched {}.build().unwrap();
    let omegas: [f64; 64] = core::array::from_fn(|k| 0.1 * (k + 1) as f64);
    let (mut values, mut counts) = ([Scaled::new(0.0, 0); 64], [0; 64]);
    system.characteristics(&omegas, &mut values).unwrap();
    system.counts_below(&omegas, &mut counts).unwrap();
    for ((value, count), omega) in values.into_iter().zip(counts).zip(omegas) {
        let alone: Scaled<f64> = system.characteristic(omega);
        assert_eq!((value, count), (alone, system.count_below(omega)), "at {omega}");
    }
}
