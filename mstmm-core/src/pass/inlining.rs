//! Inlining of the steps of a pass.
//!
//! An inlined pass is fastest. But a hundred inlined beams take minutes to compile, and so do a few in extended precision, where
//! a multiplication is ten instructions. So every scalar has a longest inlined pass, in steps. In a model of a few steps the
//! compiler leaves out most of each step, and calls would be longer.

use crate::element::PlaneStep;
use crate::number::{FrequencyPowers, Scalar, Scaled};
use crate::subspace::{Connecting, NoCount, RootCounter, Subspace};
use mstmm_plan::Support;

/// The coefficients of an element in a pass.
#[doc(hidden)]
#[inline(always)]
pub fn coefficients<E: PlaneStep<S>, S: Scalar, const STEPS: usize>(
    built: &E::Built,
    at: &FrequencyPowers<S>,
) -> E::Coefficients {
    if STEPS <= S::LONGEST_IN_LINE { E::coefficients(built, at) } else { called_coefficients::<E, S>(built, at) }
}

#[inline(never)]
fn called_coefficients<E: PlaneStep<S>, S: Scalar>(built: &E::Built, at: &FrequencyPowers<S>) -> E::Coefficients {
    E::coefficients(built, at)
}

/// A step of a pass.
#[doc(hidden)]
#[inline(always)]
pub fn step<E: PlaneStep<S>, S: Scalar, C: RootCounter<S>, const STEPS: usize>(
    coefficients: &E::Coefficients,
    input: Subspace<S>,
    counter: &mut C,
) -> Subspace<S> {
    if STEPS <= S::LONGEST_IN_LINE {
        E::step(coefficients, input, counter)
    } else {
        called_step::<E, S, C>(coefficients, input, counter)
    }
}

#[inline(never)]
fn called_step<E: PlaneStep<S>, S: Scalar, C: RootCounter<S>>(
    coefficients: &E::Coefficients,
    input: Subspace<S>,
    counter: &mut C,
) -> Subspace<S> {
    E::step(coefficients, input, counter)
}

/// The last step of a pass, from the input of the last element to Δ.
#[doc(hidden)]
#[inline(always)]
pub fn root<E: PlaneStep<S>, S: Scalar, C: RootCounter<S>, const STEPS: usize>(
    coefficients: &E::Coefficients,
    input: Subspace<S>,
    support: Support,
    counter: &mut C,
) -> Scaled<S> {
    if STEPS <= S::LONGEST_IN_LINE {
        into_root::<E, S, C>(coefficients, input, support, counter)
    } else {
        called_root::<E, S, C>(coefficients, input, support, counter)
    }
}

/// Takes a subspace through the last element into the root, and behind waves the one a quarter of a turn ahead, if a counter wants it.
#[inline(always)]
pub(crate) fn into_root<E: PlaneStep<S>, S: Scalar, C: RootCounter<S>>(
    coefficients: &E::Coefficients,
    input: Subspace<S>,
    support: Support,
    counter: &mut C,
) -> Scaled<S> {
    let delta = E::root(coefficients, input, support, counter);
    if let (false, Subspace::Plane(plane)) = (E::WAVES, &input)
        && let Some(turned) = counter.turned(plane)
    {
        counter.delta_ahead(E::root(coefficients, Subspace::Plane(turned), support, &mut NoCount));
    }
    delta
}

#[inline(never)]
fn called_root<E: PlaneStep<S>, S: Scalar, C: RootCounter<S>>(
    coefficients: &E::Coefficients,
    input: Subspace<S>,
    support: Support,
    counter: &mut C,
) -> Scaled<S> {
    into_root::<E, S, C>(coefficients, input, support, counter)
}

/// The join of the first two paths at a connection, or of a further path to their sum, whose entries may have grown.
#[doc(hidden)]
#[inline(always)]
pub fn join<S: Scalar, C: RootCounter<S>, const FIRST_TWO: bool, const STEPS: usize>(
    sum: Subspace<S>,
    path: Subspace<S>,
    counter: &mut C,
) -> Subspace<S> {
    if STEPS > S::LONGEST_IN_LINE {
        return called_join(sum, path, counter);
    }
    if FIRST_TWO { sum.joined(path, counter) } else { sum.rescaled().joined(path, counter) }
}

#[inline(never)]
fn called_join<S: Scalar, C: RootCounter<S>>(sum: Subspace<S>, path: Subspace<S>, counter: &mut C) -> Subspace<S> {
    sum.rescaled().joined(path, counter)
}
