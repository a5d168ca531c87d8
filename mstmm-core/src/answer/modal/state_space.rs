//! Modes as a state space, for controllers and simulations.

use crate::answer::modal::damping::{check_count, checked, damped_by};
use crate::answer::modal::response::{ModalResponse, Superposed};
use crate::model::MotionError;
use crate::number::{List, Oscillation, Real, RealFrequency};
use crate::search::NaturalFrequency;
use num_complex::Complex;

/// A mode: its frequency, its damping ratio, what each load works on it and what each entry is of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StateMode<T, const I: usize, const O: usize> {
    pub(crate) omega: T,
    pub(crate) ratio: T,
    /// The place of its root in the list.
    pub(crate) root: usize,
    pub(crate) inputs: [T; I],
    pub(crate) outputs: [T; O],
}

impl<T: Real, const I: usize, const O: usize> Default for StateMode<T, I, O> {
    fn default() -> Self {
        let zero = T::zero();
        StateMode { omega: zero, ratio: zero, root: 0, inputs: [zero; I], outputs: [zero; O] }
    }
}

impl<T: Real, const I: usize, const O: usize> StateMode<T, I, O> {
    /// `λ = -ζω + iω_d`.
    pub(crate) fn lambda(&self) -> Complex<T> {
        damped_by(self.omega, self.ratio)
    }

    /// What an input of 1 adds to the rate of both states.
    pub(crate) fn gain(&self, input: usize) -> [T; 2] {
        let work = self.inputs[input];
        if self.omega.is_zero() { [T::zero(), work] } else { [T::zero(), -(work / self.lambda().im)] }
    }
}

/// The modes of some loads and entries as a linear system with `I` inputs, `O` outputs and two states for each of up to `MODES` shapes:
///
/// ```text
/// ẋ = A x + B u      y = C x + D u
/// ```
///
/// The states of a mode are `Re z` and `Im z` of its phasor, `ż = λ z + a u/(iω_d)` with `λ = -ζω + iω_d`, so that `Re z` is its coordinate and its block of A is
/// `[[-ζω, -ω_d], [ω_d, -ζω]]`; of a rigid body they are place and velocity. B has what each load works on each shape, C what each entry is of it. D is the residual compliance: modes that are not in the
/// list follow at once.
///
/// ```
/// use mstmm_core::frame::{Frame, Section};
/// use mstmm_core::search::NaturalFrequencies;
/// use mstmm_core::{FrameAnalysis, HoldOrder, Support};
///
/// let mut frame = Frame::new();
/// let [foot, tip] = [0.0, 2.0].map(|place| frame.point(place));
/// frame.hold(foot, Support::Fixed);
/// let beam = frame.member(foot, tip, Section::new().bending_stiffness(8.0).mass_per_length(1.5));
/// let cantilever = frame.build()?;
/// let roots = cantilever.frequencies(4)?;
/// let (loads, entries) = ([tip.force_y()], [tip.displacement_y(), beam.input().moment()]);
/// let space = cantilever.state_space::<4, 1, 2>(&roots, loads, entries)?.with_damping_ratio(0.1)?;
/// assert_eq!(space.states(), 8);
///
/// // a step, sampled at 1 kHz, ends at the static deflection l³/(3 EI)
/// let mut discrete = space.discrete(1e-3, HoldOrder::First)?;
/// let last = (0..200_000).map(|_| discrete.step(&[1.0])).last().ok_or("no step")?;
/// assert!((last[0] - 1.0 / 3.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ModalStateSpace<T, const MODES: usize, const I: usize, const O: usize> {
    pub(crate) modes: List<StateMode<T, I, O>, MODES>,
    pub(crate) feed: [[T; I]; O],
    roots: usize,
}

impl<T: Real, const MODES: usize, const I: usize, const O: usize> ModalStateSpace<T, MODES, I, O> {
    /// The space of some roots, given the response of an input and an output, and what hands on the works of all inputs on each shape of a root, and all outputs of it.
    ///
    /// # Errors
    /// [`MotionError::NotModal`] for the motion of a support, of which parts follow the rate; [`MotionError::Capacity`] for more shapes than `MODES`.
    pub(crate) fn new<'r, S: Superposed<T, NaturalFrequency<T>>>(
        roots: impl IntoIterator<Item = &'r NaturalFrequency<T>> + Clone,
        source: impl Fn(usize, usize) -> Result<S, MotionError>,
        for_each_shape: impl Fn(
            &NaturalFrequency<T>,
            &mut dyn FnMut([T; I], [T; O]) -> Result<(), MotionError>,
        ) -> Result<(), MotionError>,
    ) -> Result<Self, MotionError>
    where
        T: Oscillation<T> + 'r,
    {
        let mut space = ModalStateSpace { modes: List::new(), feed: [[T::zero(); I]; O], roots: 0 };
        for root in roots.clone() {
            for_each_shape(root, &mut |inputs, outputs| {
                let mode = StateMode { omega: root.omega, ratio: T::zero(), root: space.roots, inputs, outputs };
                space.modes.push(mode).map_err(|_| MotionError::Capacity { capacity: MODES })
            })?;
            space.roots += 1;
        }
        for output in 0..O {
            for input in 0..I {
                let source = source(input, output)?;
                if source.facts().is_motion {
                    return Err(MotionError::NotModal);
                }
                let products =
                    |_: &NaturalFrequency<T>, place: usize, add: &mut dyn FnMut(T) -> Result<(), MotionError>| {
                        let mut own = space.modes.iter().filter(|mode| mode.root == place);
                        own.try_for_each(|mode| add(mode.inputs[input] * mode.outputs[output]))
                    };
                let response = ModalResponse::<T, MODES, RealFrequency>::of_products(&source, roots.clone(), products)?;
                space.feed[output][input] = response.residual;
            }
        }
        Ok(space)
    }

    /// The number of states.
    pub fn states(&self) -> usize {
        2 * self.modes.len()
    }

    /// The space with a damping ratio in each mode.
    ///
    /// # Errors
    /// [`MotionError::DampingRatio`] for a ratio that is negative, or 1 and more.
    pub fn with_damping_ratio(self, ratio: T) -> Result<Self, MotionError> {
        self.with_ratios(|_, _| ratio)
    }

    /// The space with a damping ratio for each root of the list, in its order; a root at rest has none.
    ///
    /// # Errors
    /// [`MotionError::DampingRatios`] for another number of ratios than roots; else as [`with_damping_ratio`](ModalStateSpace::with_damping_ratio).
    pub fn with_damping_ratios(self, ratios: &[T]) -> Result<Self, MotionError> {
        check_count(ratios, self.roots)?;
        self.with_ratios(|root, _| ratios[root])
    }

    /// The space with a damping ratio for each mode by its frequency ω [rad/s].
    ///
    /// # Errors
    /// As [`with_damping_ratio`](ModalStateSpace::with_damping_ratio).
    pub fn with_damping_ratios_by(self, mut ratio: impl FnMut(T) -> T) -> Result<Self, MotionError> {
        self.with_ratios(|_, omega| ratio(omega))
    }

    fn with_ratios(mut self, mut ratio: impl FnMut(usize, T) -> T) -> Result<Self, MotionError> {
        for mode in self.modes.as_mut_slice().iter_mut().filter(|mode| !mode.omega.is_zero()) {
            mode.ratio = checked(ratio(mode.root, mode.omega))?;
        }
        Ok(self)
    }

    /// An entry of A, by two states; zero beyond them.
    pub fn a(&self, row: usize, column: usize) -> T {
        match self.modes.get(row / 2) {
            Some(mode) if row / 2 == column / 2 && mode.omega.is_zero() => {
                if [row % 2, column % 2] == [0, 1] {
                    T::one()
                } else {
                    T::zero()
                }
            }
            Some(mode) if row / 2 == column / 2 => {
                let Complex { re, im } = mode.lambda();
                match [row % 2, column % 2] {
                    [0, 1] => -im,
                    [1, 0] => im,
                    _ => re,
                }
            }
            _ => T::zero(),
        }
    }

    /// An entry of B, by a state and an input; zero beyond them.
    pub fn b(&self, row: usize, input: usize) -> T {
        let mode = self.modes.get(row / 2).filter(|_| input < I);
        mode.map_or(T::zero(), |mode| mode.gain(input)[row % 2])
    }

    /// An entry of C, by an output and a state; zero beyond them.
    pub fn c(&self, output: usize, column: usize) -> T {
        let mode = self.modes.get(column / 2).filter(|_| output < O && column.is_multiple_of(2));
        mode.map_or(T::zero(), |mode| mode.outputs[output])
    }

    /// An entry of D, by an output and an input: the residual compliance; zero beyond them.
    pub fn d(&self, output: usize, input: usize) -> T {
        self.feed.get(output).and_then(|row| row.get(input)).copied().unwrap_or(T::zero())
    }

    /// A, B, C and D, row by row.
    #[cfg(feature = "std")]
    pub fn matrices(&self) -> StateMatrices<T> {
        let states = self.states();
        let matrix = |rows: usize, columns: usize, entry: &dyn Fn(usize, usize) -> T| {
            (0..rows).map(|row| (0..columns).map(|column| entry(row, column)).collect()).collect()
        };
        StateMatrices {
            a: matrix(states, states, &|row, column| self.a(row, column)),
            b: matrix(states, I, &|row, column| self.b(row, column)),
            c: matrix(O, states, &|row, column| self.c(row, column)),
            d: matrix(O, I, &|row, column| self.d(row, column)),
        }
    }
}

/// The matrices of a state space, row by row.
#[cfg(feature = "std")]
#[derive(Clone, Debug, PartialEq)]
pub struct StateMatrices<T> {
    /// Of the states, on their rates.
    pub a: std::vec::Vec<std::vec::Vec<T>>,
    /// Of the inputs, on the rates.
    pub b: std::vec::Vec<std::vec::Vec<T>>,
    /// Of the states, on the outputs.
    pub c: std::vec::Vec<std::vec::Vec<T>>,
    /// Of the inputs, on the outputs.
    pub d: std::vec::Vec<std::vec::Vec<T>>,
}

/// A number of each value, or the first error.
pub(crate) fn each_of<V: Copy, T: Real, const N: usize>(
    values: [V; N],
    number: impl Fn(V) -> Result<T, MotionError>,
) -> Result<[T; N], MotionError> {
    let mut numbers = [T::zero(); N];
    for (own, value) in numbers.iter_mut().zip(values) {
        *own = number(value)?;
    }
    Ok(numbers)
}
