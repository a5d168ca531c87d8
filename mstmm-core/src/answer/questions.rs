//! Questions about motions: the trait that users call.

use crate::answer::frequency_response::FrequencyResponse;
use crate::answer::modal::moving_mass::moving_mass;
use crate::answer::modal::of_tree::{OfTree, for_each_shape};
use crate::answer::modal::participation::Participation;
use crate::answer::modal::response::ModalResponse;
use crate::answer::modal::state_space::{ModalStateSpace, each_of};
use crate::answer::modal::truncation::{Truncation, check_list};
use crate::answer::mode_shape::{ModeShape, ShapeList, simple};
use crate::answer::repeated_root::all_shapes;
use crate::answer::root::{Root, simple_root};
use crate::answer::sensitivity::{Sensitivities, sensitivities};
use crate::answer::tree_sketch::TreeSketch;
use crate::element::ListElement;
use crate::model::{Chain, Direction, Entry, Load, MotionError, TruncationError};
use crate::number::{Frequency, Oscillation, Scalar};
use crate::pass::characteristic::System;
use crate::pass::drawn_tree::DrawnTree;
use crate::pass::route::Place;
use crate::pass::step_list::StepList;
use crate::pass::tree::{ExtendedTree, Planned};
use crate::search::{NaturalFrequency, Undamped};
use mstmm_plan::Freedoms;

/// The meaning of the frequencies of roots: [`RealFrequency`](crate::number::frequency::RealFrequency) or
/// [`ComplexEigenvalue`](crate::number::frequency::ComplexEigenvalue).
pub(crate) type MeaningOf<Y, R> =
    <<R as Root<<Y as System>::Parameter>>::Frequency as Frequency<<Y as System>::Parameter>>::Meaning;

/// Shapes, sensitivities and responses of a built system.
///
/// A thread of 192 kB is enough, of 768 kB in debug builds; for a response at one frequency 128 and 384. What a list needs, its
/// [`PlannedList`](crate::PlannedList) says.
pub trait ModalAnalysis: System {
    /// What stands in which path: supports, elements and connections with their names, the lengths of beams and the arms of bodies.
    ///
    /// Planar elements between supports have it, too.
    fn sketch(&self) -> TreeSketch<'_, Self>
    where
        Self: DrawnTree,
    {
        TreeSketch { system: self }
    }

    /// The shape of a simple root, exact at any mode number: states at all ends of elements and at any point of a beam.
    ///
    /// Planes are carried from the tips to the root and from the root to the tips. They meet in the shape, which is taken at the
    /// dominant entry. From there states are recovered against the directions of the planes, so that growing waves hide no digits.
    ///
    /// # Errors
    /// [`MotionError::Multiple`] for a multiple root, which has [`mode_shapes`](ModalAnalysis::mode_shapes);
    /// [`MotionError::NotARoot`] for a frequency that is no root of this system; [`MotionError::Unresolved`] where other roots
    /// are so close that the states do not fit together, or where the motion is trapped inside an element; [`MotionError::LossFactor`] for `Im λ < 0` where something has a loss factor.
    fn mode_shape<S>(
        &self,
        root: &impl Root<<Self as System>::Parameter, Frequency = S>,
    ) -> Result<ModeShape<'_, Self, S>, MotionError>
    where
        S: Oscillation<<Self as System>::Parameter>,
        Self: ExtendedTree<S>,
    {
        simple(self, simple_root(root)?)
    }

    /// All shapes of a root, orthogonal with respect to the mass (undamped) or to `(λ₁ + λ₂) M + C` (damped).
    ///
    /// The shapes of a multiple root span the residue of the response at its pole, which is a sum over frequencies around it.
    ///
    /// # Errors
    /// As [`mode_shape`](ModalAnalysis::mode_shape); [`MotionError::Capacity`] for more than `CAP` shapes, and
    /// [`MotionError::Defective`] for a multiple eigenvalue with too few of them.
    fn mode_shapes<const CAP: usize, S>(
        &self,
        root: &impl Root<<Self as System>::Parameter, Frequency = S>,
    ) -> Result<ShapeList<'_, Self, S, CAP>, MotionError>
    where
        S: Oscillation<<Self as System>::Parameter>,
        Self: ExtendedTree<S>,
    {
        all_shapes(self, root)
    }

    /// The derivatives of a simple root with respect to all fields of the model: dω/dp [rad/s per unit of the field], or dλ/dp [1/s
    /// per unit of the field] for an eigenvalue, exact, all in one call.
    ///
    /// They take one pass from the tips, one from the root, and the derivatives of the dynamic work of each element at its states.
    ///
    /// # Errors
    /// [`MotionError::Multiple`] for a multiple root, whose parts move apart; [`MotionError::ZeroFrequency`] for ω = 0, since
    /// parameters move ω², whose root has no derivative there; [`MotionError::NotARoot`] for a frequency that is no root of this
    /// system.
    fn sensitivity<S>(
        &self,
        root: &impl Root<<Self as System>::Parameter, Frequency = S>,
    ) -> Result<Sensitivities<Self, S>, MotionError>
    where
        S: Oscillation<<Self as System>::Parameter>,
        Self: ExtendedTree<S> + Chain<S>,
    {
        sensitivities(self, simple_root(root)?)
    }

    /// The response of an entry of a state to a harmonic load of 1, as a function of the frequency.
    ///
    /// Its unit is that of the entry per N, or per N m. It is exact at every frequency, damped or not, and in the static limit: to
    /// rounding of the largest states, divided by the distance to the next root where that is close. At the load itself the entry is
    /// taken on the side that its point names. Nothing is evaluated yet.
    ///
    /// A connection whose output has fewer states also takes loads and entries of its inputs.
    ///
    /// # Errors
    /// [`MotionError::NoSuchEntry`] for a load or an entry that no state at its point carries, such as a moment in a
    /// translation path.
    fn frequency_response(
        &self,
        load: Load<<Self as Planned>::Model>,
        entry: Entry<<Self as Planned>::Model>,
    ) -> Result<FrequencyResponse<'_, Self>, MotionError>
    where
        Self: Planned,
    {
        FrequencyResponse::new(self, load, entry)
    }

    /// The response of an entry of a state in time to an impulse, a step or a force history, by superposition of the modes of
    /// some roots: up to `N` of them, besides those of rigid bodies.
    ///
    /// The roots are natural frequencies, or the eigenvalues of the closed upper half plane, each once. Eigenvalues of the lower half
    /// plane are skipped: each is the conjugate of one above.
    ///
    /// Besides the shapes it takes one response at rest, for the residual compliance. Where a part of the system is not held, this
    /// is extrapolated, with the poles at zero, from some hundreds of responses at low frequencies.
    ///
    /// # Errors
    /// [`MotionError::NoSuchEntry`] for a load or an entry that no state at its point carries;
    /// [`MotionError::Capacity`] for more than `N` modes, or more than both 4 and `N` of one root;
    /// [`MotionError::Unsettled`] where roots close to zero hide the residual compliance; [`MotionError::LossFactor`] where something has a
    /// loss factor; else as
    /// [`mode_shape`](ModalAnalysis::mode_shape) and [`mode_shapes`](ModalAnalysis::mode_shapes).
    ///
    /// [`ModalResponse`] has an example.
    fn modal_response<'r, const N: usize, R>(
        &self,
        roots: impl IntoIterator<Item = &'r R>,
        load: Load<<Self as Planned>::Model>,
        entry: Entry<<Self as Planned>::Model>,
    ) -> Result<ModalResponse<Self::Parameter, N, MeaningOf<Self, R>>, MotionError>
    where
        R: Root<<Self as System>::Parameter> + 'r,
        Self: ExtendedTree<R::Frequency> + Sized,
    {
        const { assert!(!Self::SPINS, "a sum over modes of a rotor needs those of both whirls: take `frequency_response`") };
        ModalResponse::new(&OfTree::new(self, load, entry)?, roots)
    }

    /// The modes of some roots as a state space whose inputs are loads and whose outputs are entries, as [`ModalStateSpace`] says: up to `MODES` shapes.
    ///
    /// # Errors
    /// [`MotionError::NotModal`] for a dislocation, as the motion of a support is one; else as [`modal_response`](ModalAnalysis::modal_response).
    fn state_space<'r, const MODES: usize, const I: usize, const O: usize>(
        &self,
        roots: impl IntoIterator<Item = &'r NaturalFrequency<<Self as System>::Parameter>> + Clone,
        loads: [Load<<Self as Planned>::Model>; I],
        entries: [Entry<<Self as Planned>::Model>; O],
    ) -> Result<ModalStateSpace<<Self as System>::Parameter, MODES, I, O>, MotionError>
    where
        <Self as System>::Parameter: Oscillation<<Self as System>::Parameter> + 'r,
        Self: ExtendedTree<<Self as System>::Parameter> + Sized,
    {
        const { assert!(!Self::SPINS, "a state space of a rotor needs the modes of both whirls: take `frequency_response`") };
        let source = |input: usize, output: usize| OfTree::new(self, loads[input], entries[output]);
        ModalStateSpace::new(roots, source, |root, keep| {
            let each = |shape: &ModeShape<'_, Self, <Self as System>::Parameter>| {
                let inputs = each_of(loads, |load| shape.work(load))?;
                let outputs = each_of(entries, |entry| {
                    Place::of_entry(self, entry)
                        .map(|Place { step, beyond, coordinate }| shape.at(step, beyond).entry(coordinate))
                })?;
                keep(inputs, outputs).map(|()| Scalar::from_f64(0.0))
            };
            for_each_shape::<MODES, _, _, _>(self, root, each, &mut |_| Ok(()))
        })
    }

    /// How much of the mass the modes of some roots take with them, as [`Participation`] says: up to `N` shapes. Deflections have one direction, y.
    ///
    /// # Errors
    /// [`MotionError::Capacity`] for more than `N` shapes, or more than both 4 and `N` of one root; else as [`moving_mass`](ModalAnalysis::moving_mass) and
    /// [`mode_shapes`](ModalAnalysis::mode_shapes).
    fn participation<'r, const N: usize, R>(
        &self,
        roots: impl IntoIterator<Item = &'r R>,
        direction: Direction<<Self as Planned>::Model>,
    ) -> Result<Participation<Self::Parameter, N>, MotionError>
    where
        R: Root<<Self as System>::Parameter, Frequency = <Self as System>::Parameter> + 'r,
        <Self as System>::Parameter: Oscillation<<Self as System>::Parameter>,
        Self: ExtendedTree<<Self as System>::Parameter> + Sized,
    {
        const { assert!(!Self::SPINS, "modes of a rotor have no effective mass: take `frequency_response`") };
        let total = self.moving_mass(direction)?;
        Participation::new(total, roots, |root, add| {
            for_each_shape::<N, _, _, _>(self, root, |shape| shape.work(Load::self_weight()), add)
        })
    }

    /// A bound for what a sum over the modes of some roots leaves out of a response, up to a reach \[rad/s\] below which these are all modes. [`Truncation`] has the theorem.
    ///
    /// # Errors
    /// [`TruncationError::Missing`] where these are not all modes below the reach, from the first one on in order, as a count proves it; [`TruncationError::Reach`] for a
    /// reach that is not positive; [`MotionError::Resonance`] for one at a root of the list; [`TruncationError::Spread`] for a load along elements, or a weight; else as
    /// [`count_below`](crate::search::NaturalFrequencies::count_below) and [`modal_response`](ModalAnalysis::modal_response).
    fn truncation<'r, const N: usize>(
        &self,
        roots: impl IntoIterator<Item = &'r NaturalFrequency<<Self as System>::Parameter>> + Clone,
        load: Load<<Self as Planned>::Model>,
        entry: Entry<<Self as Planned>::Model>,
        reach: <Self as System>::Parameter,
    ) -> Result<Truncation<<Self as System>::Parameter>, TruncationError>
    where
        <Self as System>::Parameter: Oscillation<<Self as System>::Parameter> + 'r,
        Self: ExtendedTree<<Self as System>::Parameter> + Undamped + Sized,
    {
        check_list(self, roots.clone(), reach)?;
        let own = load.dual().ok_or(TruncationError::Spread)?;
        let load = OfTree::new(self, load, own)?.side::<N>(roots.clone(), reach)?;
        let entry = OfTree::new(self, entry.dual(), entry)?.side::<N>(roots, reach)?;
        Ok(Truncation::new(reach, load, entry))
    }

    /// The mass that modes can move along y \[kg\]: that of all members whose deflection is y, and of each body what no support holds. It is what effective
    /// masses of all modes sum up to.
    ///
    /// One part is never reached: at a held end a beam with rotary inertia and without shear has a layer of the mass `m r tanh(l/r)`, with `r² = ρI/m`, that
    /// no mode moves.
    ///
    /// # Errors
    /// [`MotionError::NoSuchFreedom`] for another direction than y; [`MotionError::NoUniformLoad`] for an element whose weight is not known;
    /// [`MotionError::HeldMass`] for a body that a support holds in part.
    fn moving_mass(
        &self,
        direction: Direction<<Self as Planned>::Model>,
    ) -> Result<<Self as System>::Parameter, MotionError>
    where
        <Self as System>::Parameter: Oscillation<<Self as System>::Parameter>,
        Self: ExtendedTree<<Self as System>::Parameter>,
    {
        let freedom = Freedoms::EACH[direction.axis];
        if freedom.is(Freedoms::Y) { moving_mass(self) } else { Err(MotionError::NoSuchFreedom { freedom }) }
    }
}

impl<Y: Planned + ?Sized> ModalAnalysis for Y {}

/// A list without a plan has none: the bounds of each question say so.
impl<E: ListElement> ModalAnalysis for StepList<'_, E> {}
