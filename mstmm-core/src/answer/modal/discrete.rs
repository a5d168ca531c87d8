//! State spaces in steps of time, as controllers run them.

use crate::answer::modal::state_space::{ModalStateSpace, StateMode};
use crate::model::MotionError;
use crate::number::{List, Real, exponential, phi_1, phi_2};
use num_complex::Complex;

/// What inputs do between samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HoldOrder {
    /// Each stays at its last sample, as behind a digital converter.
    Zero,
    /// Each runs linearly from sample to sample, as a measured load does.
    First,
}

/// A mode in steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DiscreteMode<T, const I: usize, const O: usize> {
    pub(crate) growth: [[T; 2]; 2],
    pub(crate) inputs: [[T; 2]; I],
    /// What an input at the end of a step adds, which outputs have at once: at rest it is taken off the states.
    after: [[T; 2]; I],
    pub(crate) outputs: [T; O],
}

impl<T: Real, const I: usize, const O: usize> Default for DiscreteMode<T, I, O> {
    fn default() -> Self {
        let zero = T::zero();
        DiscreteMode { growth: [[zero; 2]; 2], inputs: [[zero; 2]; I], after: [[zero; 2]; I], outputs: [zero; O] }
    }
}

/// A state space in steps of time, with its states: `y = C x + D u`, and then `x ← E x + G u`.
///
/// A step of modes that are blocks takes `8 + 4I + 2O` operations for each and `2IO` besides, allocates nothing, and is exact at any length: it has no limit of
/// stability. Of inputs that run linearly a part stands in D, so that a step needs the last sample alone.
#[derive(Clone, Copy, Debug)]
pub struct DiscreteStateSpace<T, const MODES: usize, const I: usize, const O: usize> {
    pub(crate) modes: List<DiscreteMode<T, I, O>, MODES>,
    pub(crate) feed: [[T; I]; O],
    states: [[T; 2]; MODES],
    is_at_rest: bool,
    dt: T,
}

impl<T: Real, const MODES: usize, const I: usize, const O: usize> ModalStateSpace<T, MODES, I, O> {
    /// The space in steps of `dt` \[s\], exact for inputs that are constant or run linearly between samples.
    ///
    /// # Errors
    /// [`MotionError::TimeStep`] for a step that is not positive or not finite.
    pub fn discrete(&self, dt: T, order: HoldOrder) -> Result<DiscreteStateSpace<T, MODES, I, O>, MotionError> {
        DiscreteStateSpace::new(self, dt, order)
    }
}

impl<T: Real, const MODES: usize, const I: usize, const O: usize> DiscreteStateSpace<T, MODES, I, O> {
    fn new(space: &ModalStateSpace<T, MODES, I, O>, dt: T, order: HoldOrder) -> Result<Self, MotionError> {
        if !(dt > T::zero() && dt.size().is_finite()) {
            return Err(MotionError::TimeStep { step: dt.to_f64() });
        }
        let mut discrete = DiscreteStateSpace {
            modes: List::new(),
            feed: space.feed,
            states: [[T::zero(); 2]; MODES],
            is_at_rest: true,
            dt,
        };
        for mode in &space.modes {
            let (growth, gains) = steps(mode, dt, order);
            let mut own = DiscreteMode { growth, outputs: mode.outputs, ..DiscreteMode::default() };
            for input in 0..I {
                let [before, after] = gains(input);
                own.inputs[input] = plus(before, through(&growth, after));
                own.after[input] = after;
                for (output, value) in mode.outputs.iter().enumerate() {
                    discrete.feed[output][input] += *value * after[0];
                }
            }
            discrete.modes.push(own).map_err(|_| MotionError::Capacity { capacity: MODES })?;
        }
        Ok(discrete)
    }

    /// Takes the next sample of the inputs and gives the outputs at its time; the first is that of t = 0, at rest.
    pub fn step(&mut self, inputs: &[T; I]) -> [T; O] {
        if self.is_at_rest {
            self.begin(inputs);
        }
        let mut outputs = self.feed.map(|row| row.iter().zip(inputs).fold(T::zero(), |sum, (d, u)| sum + *d * *u));
        for (mode, state) in self.modes.iter().zip(&mut self.states) {
            for (output, value) in outputs.iter_mut().zip(mode.outputs) {
                *output += value * state[0];
            }
            let grown = through(&mode.growth, *state);
            *state = mode.inputs.iter().zip(inputs).fold(grown, |sum, (gain, u)| plus(sum, gain.map(|part| part * *u)));
        }
        outputs
    }

    /// Begins at rest under the first sample.
    fn begin(&mut self, inputs: &[T; I]) {
        self.is_at_rest = false;
        for (mode, state) in self.modes.iter().zip(&mut self.states) {
            let at_once = mode.after.iter().zip(inputs);
            *state = at_once.fold([T::zero(); 2], |sum, (after, u)| plus(sum, after.map(|part| -(part * *u))));
        }
    }

    /// Puts all states to rest.
    pub fn reset(&mut self) {
        self.states = [[T::zero(); 2]; MODES];
        self.is_at_rest = true;
    }

    /// The step \[s\].
    pub fn dt(&self) -> T {
        self.dt
    }

    /// The number of states.
    pub fn states(&self) -> usize {
        2 * self.modes.len()
    }

    /// An entry of E, by two states; zero beyond them.
    pub fn e(&self, row: usize, column: usize) -> T {
        let mode = self.modes.get(row / 2).filter(|_| row / 2 == column / 2);
        mode.map_or(T::zero(), |mode| mode.growth[row % 2][column % 2])
    }

    /// An entry of G, by a state and an input; zero beyond them.
    pub fn g(&self, row: usize, input: usize) -> T {
        let gains = self.modes.get(row / 2).and_then(|mode| mode.inputs.get(input));
        gains.map_or(T::zero(), |gain| gain[row % 2])
    }

    /// What an input at the end of a step adds to a state, which outputs have at once: at rest under a first sample u the states are less by that times u. Zero where inputs are held.
    pub fn after(&self, row: usize, input: usize) -> T {
        let gains = self.modes.get(row / 2).and_then(|mode| mode.after.get(input));
        gains.map_or(T::zero(), |gain| gain[row % 2])
    }

    /// An entry of C, by an output and a state; zero beyond them.
    pub fn c(&self, output: usize, column: usize) -> T {
        let value = self.modes.get(column / 2).and_then(|mode| mode.outputs.get(output));
        value.filter(|_| column.is_multiple_of(2)).copied().unwrap_or(T::zero())
    }

    /// An entry of D, by an output and an input; zero beyond them.
    pub fn d(&self, output: usize, input: usize) -> T {
        self.feed.get(output).and_then(|row| row.get(input)).copied().unwrap_or(T::zero())
    }

    /// The same in single precision, at rest. A frequency errs by some 1e-8 of itself, what decays in a step by 1e-7 of the state.
    pub fn single(&self) -> DiscreteStateSpace<f32, MODES, I, O> {
        let short = |number: T| number.to_f64() as f32;
        let modes = self.modes.map(|mode| DiscreteMode {
            growth: mode.growth.map(|row| row.map(short)),
            inputs: mode.inputs.map(|gain| gain.map(short)),
            after: mode.after.map(|gain| gain.map(short)),
            outputs: mode.outputs.map(short),
        });
        let feed = self.feed.map(|row| row.map(short));
        DiscreteStateSpace { modes, feed, states: [[0.0; 2]; MODES], is_at_rest: true, dt: short(self.dt) }
    }
}

/// The growth of both states of a mode in a step, and what an input of 1 at its begin and at its end adds to them.
fn steps<T: Real, const I: usize, const O: usize>(
    mode: &StateMode<T, I, O>,
    dt: T,
    order: HoldOrder,
) -> ([[T; 2]; 2], impl Fn(usize) -> [[T; 2]; 2]) {
    let (zero, one, half) = (T::zero(), T::one(), T::from_f64(0.5));
    let lambda = mode.lambda();
    let z = lambda * dt;
    let is_rigid = mode.omega.is_zero();
    let growth = if is_rigid {
        [[one, dt], [zero, one]]
    } else {
        let Complex { re, im } = exponential(z);
        [[re, -im], [im, re]]
    };
    let mode = *mode;
    let gains = move |input: usize| {
        let gain = mode.gain(input);
        let whole = |first: Complex<T>| {
            let product = Complex::new(gain[0], gain[1]) * first * dt;
            [product.re, product.im]
        };
        let [all, end] = if is_rigid {
            let (place, velocity) = (gain[1] * dt * dt * half, gain[1] * dt);
            [[place, velocity], [place / T::from_f64(3.0), velocity * half]]
        } else {
            [whole(phi_1(z)), whole(phi_2(z))]
        };
        match order {
            HoldOrder::Zero => [all, [zero; 2]],
            HoldOrder::First => [plus(all, end.map(|part| -part)), end],
        }
    };
    (growth, gains)
}

fn plus<T: Real>([a, b]: [T; 2], [c, d]: [T; 2]) -> [T; 2] {
    [a + c, b + d]
}

/// Two states behind a step.
fn through<T: Real>([[a, b], [c, d]]: &[[T; 2]; 2], [x, y]: [T; 2]) -> [T; 2] {
    [*a * x + *b * y, *c * x + *d * y]
}
