//! Questions about motions of plane structures: the trait that users call.

use crate::answer::modal::participation::Participation;
#[cfg(feature = "std")]
use crate::answer::modal::participation::{ParticipationFactor, collect};
use crate::answer::modal::response::ModalResponse;
use crate::answer::modal::state_space::{ModalStateSpace, each_of};
use crate::answer::modal::truncation::{Side, Truncation, check_list};
use crate::answer::moving_load::load::MovingLoad;
use crate::answer::network::about::factor;
use crate::answer::network::axial_forces::{AxialForces, axial_forces, settled_under, with_axial_forces};
use crate::answer::network::moving_mass::moving_mass;
use crate::answer::network::of_frame::{OfFrame, for_each_shape};
use crate::answer::network::own_load::OwnLoad;
use crate::answer::network::response::PlaneResponse;
use crate::answer::network::sensitivity::{PlaneChain, sensitivities};
use crate::answer::network::shape::{PlaneShape, PlaneShapes, all, simple};
use crate::answer::network::sketch::Sketch;
use crate::answer::network::track::moving_load;
use crate::answer::questions::MeaningOf;
use crate::answer::root::{Root, simple_root};
use crate::answer::sensitivity::Sensitivities;
use crate::model::{
    AxialForceError, Direction, MemberLabel, MotionError, ParameterError, PlaneEntry, PlaneLoad, TrackError,
    TruncationError,
};
use crate::number::Scalar;
use crate::pass::characteristic::System;
use crate::pass::network::{Drawn, MovingNetwork, Placed, PlaneFrequency, Prestressed};
use crate::search::{NaturalFrequency, Undamped};
use num_complex::Complex;

/// Shapes, internal forces and responses of a plane structure, by the names that [`ModalAnalysis`](crate::ModalAnalysis) has for trees.
pub trait FrameAnalysis: Placed + Sized {
    /// What stands where: points, members, bodies and supports, with their names and coordinates.
    fn sketch(&self) -> Sketch<'_, Self>
    where
        Self: Drawn,
    {
        Sketch { system: self }
    }

    /// The shape of a simple root: displacements of all points, displacements and forces of all ends of members.
    ///
    /// # Errors
    /// [`MotionError::Multiple`] for a multiple root, which has [`mode_shapes`](FrameAnalysis::mode_shapes);
    /// [`MotionError::NotARoot`] for a frequency that is no root of this system; [`MotionError::Unresolved`] where other roots are so
    /// close that shapes cannot be told apart, or where the motion is trapped inside a member; [`MotionError::LossFactor`] for `Im λ < 0` where something has a loss factor.
    #[inline(never)]
    fn mode_shape<S>(
        &self,
        root: &impl Root<Self::Parameter, Frequency = S>,
    ) -> Result<PlaneShape<'_, Self, S>, MotionError>
    where
        S: PlaneFrequency<<Self as System>::Parameter>,
        Self: MovingNetwork<S>,
    {
        simple(self, simple_root(root)?)
    }

    /// All shapes of a root, orthogonal with respect to the mass.
    ///
    /// # Errors
    /// As [`mode_shape`](FrameAnalysis::mode_shape); [`MotionError::Capacity`] for more than `CAP` shapes.
    #[inline(never)]
    fn mode_shapes<const CAP: usize, S>(
        &self,
        root: &impl Root<Self::Parameter, Frequency = S>,
    ) -> Result<PlaneShapes<'_, Self, S, CAP>, MotionError>
    where
        S: PlaneFrequency<<Self as System>::Parameter>,
        Self: MovingNetwork<S>,
    {
        all(self, root.frequency(), root.multiplicity())
    }

    /// The derivatives of a simple root with respect to all fields of the model, positions of points among them: dω/dp [rad/s per unit of
    /// the field], or dλ/dp [1/s per unit of the field] for an eigenvalue, exact, all in one call.
    ///
    /// # Errors
    /// [`MotionError::Multiple`] for a multiple root, whose parts move apart; [`MotionError::ZeroFrequency`] for ω = 0, since parameters
    /// move ω², whose root has no derivative there; else as [`mode_shape`](FrameAnalysis::mode_shape).
    fn sensitivity<S>(
        &self,
        root: &impl Root<Self::Parameter, Frequency = S>,
    ) -> Result<Sensitivities<Self, S>, MotionError>
    where
        S: PlaneFrequency<<Self as System>::Parameter>,
        Self: MovingNetwork<S> + PlaneChain<S>,
    {
        sensitivities(self, simple_root(root)?)
    }

    /// The response of a displacement, an internal force or a reaction to a harmonic load of 1, as a function of the frequency. Nothing is
    /// evaluated yet.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a point that this system has not got; [`MotionError::NoSuchFreedom`] and [`MotionError::NotHeld`]
    /// for a load or an entry that the point has not.
    fn frequency_response(
        &self,
        load: PlaneLoad<Self::Model>,
        entry: PlaneEntry<Self::Model>,
    ) -> Result<PlaneResponse<'_, Self>, MotionError> {
        PlaneResponse::new(self, load, entry)
    }

    /// The response of a displacement or an internal force in time to an impulse, a step or a force history, by superposition of the modes of
    /// some roots: up to `N` of them, besides those of rigid bodies.
    ///
    /// The roots are natural frequencies, or the eigenvalues of the closed upper half plane, each once. Besides their shapes it takes one
    /// response at rest, for the residual compliance. [`ModalResponse`] says what is superposed. Where a load is the motion of a support, an
    /// impulse is a motion of 1 m s and a step one of 1 m.
    ///
    /// # Errors
    /// [`MotionError::Capacity`] for more than `N` modes, or more than both 4 and `N` of one root; [`MotionError::Unsettled`] where roots
    /// close to zero hide the residual compliance; [`MotionError::NotModal`] for a reaction to the motion of a support;
    /// [`MotionError::LossFactor`] where something has a loss factor; else as
    /// [`mode_shape`](FrameAnalysis::mode_shape) and [`frequency_response`](FrameAnalysis::frequency_response).
    #[inline(never)]
    fn modal_response<'r, const N: usize, R>(
        &self,
        roots: impl IntoIterator<Item = &'r R>,
        load: PlaneLoad<Self::Model>,
        entry: PlaneEntry<Self::Model>,
    ) -> Result<ModalResponse<Self::Parameter, N, MeaningOf<Self, R>>, MotionError>
    where
        R: Root<<Self as System>::Parameter, Frequency: PlaneFrequency<<Self as System>::Parameter>> + 'r,
        Self: MovingNetwork<R::Frequency>,
    {
        const { assert!(!Self::SPINS, "a sum over modes of a rotor needs those of both whirls: take `frequency_response`") };
        ModalResponse::new(&OfFrame::new(self, load, entry)?, roots)
    }

    /// The modes of some roots as a state space whose inputs are loads and whose outputs are entries, as [`ModalStateSpace`] says: up to `MODES` shapes.
    ///
    /// # Errors
    /// [`MotionError::NotModal`] for the motion of a support, a dislocation or a reaction; else as [`modal_response`](FrameAnalysis::modal_response).
    #[inline(never)]
    fn state_space<'r, const MODES: usize, const I: usize, const O: usize>(
        &self,
        roots: impl IntoIterator<Item = &'r NaturalFrequency<<Self as System>::Parameter>> + Clone,
        loads: [PlaneLoad<Self::Model>; I],
        entries: [PlaneEntry<Self::Model>; O],
    ) -> Result<ModalStateSpace<<Self as System>::Parameter, MODES, I, O>, MotionError>
    where
        <Self as System>::Parameter: PlaneFrequency<<Self as System>::Parameter> + 'r,
        Self: MovingNetwork<<Self as System>::Parameter>,
    {
        const { assert!(!Self::SPINS, "a state space of a rotor needs the modes of both whirls: take `frequency_response`") };
        let source = |input: usize, output: usize| OfFrame::new(self, loads[input], entries[output]);
        ModalStateSpace::new(roots, source, |root, keep| {
            let each = |shape: &PlaneShape<'_, Self, <Self as System>::Parameter>| {
                let inputs = each_of(loads, |load| shape.work(load))?;
                let outputs = each_of(entries, |entry| shape.value(entry))?;
                keep(inputs, outputs).map(|()| Scalar::from_f64(0.0))
            };
            for_each_shape::<MODES, _, _, _>(self, root, each, &mut |_| Ok(()))
        })
    }

    /// How much of the mass the modes of some roots take with them along a direction, or about an axis, as [`Participation`] says: up to `N` shapes.
    ///
    /// # Errors
    /// [`MotionError::Capacity`] for more than `N` shapes, or more than both 4 and `N` of one root; else as [`moving_mass`](FrameAnalysis::moving_mass) and
    /// [`mode_shapes`](FrameAnalysis::mode_shapes).
    #[inline(never)]
    fn participation<'r, const N: usize, R>(
        &self,
        roots: impl IntoIterator<Item = &'r R>,
        direction: Direction<Self::Model>,
    ) -> Result<Participation<Self::Parameter, N>, MotionError>
    where
        R: Root<<Self as System>::Parameter, Frequency = <Self as System>::Parameter> + 'r,
        <Self as System>::Parameter: PlaneFrequency<<Self as System>::Parameter>,
        Self: MovingNetwork<<Self as System>::Parameter>,
    {
        const { assert!(!Self::SPINS, "modes of a rotor have no effective mass: take `frequency_response`") };
        let total = self.moving_mass(direction)?;
        Participation::new(total, roots, |root, add| {
            for_each_shape::<N, _, _, _>(self, root, |shape| factor(shape, direction), add)
        })
    }

    /// The factors of [`participation`](FrameAnalysis::participation) of any number of shapes, in a vector.
    ///
    /// # Errors
    /// As [`participation`](FrameAnalysis::participation), of which up to four shapes of one root have room.
    #[cfg(feature = "std")]
    fn participations<'r, R>(
        &self,
        roots: impl IntoIterator<Item = &'r R>,
        direction: Direction<Self::Model>,
    ) -> Result<std::vec::Vec<ParticipationFactor<Self::Parameter>>, MotionError>
    where
        R: Root<<Self as System>::Parameter, Frequency = <Self as System>::Parameter> + 'r,
        <Self as System>::Parameter: PlaneFrequency<<Self as System>::Parameter>,
        Self: MovingNetwork<<Self as System>::Parameter>,
    {
        const { assert!(!Self::SPINS, "modes of a rotor have no effective mass: take `frequency_response`") };
        let mut factors = std::vec::Vec::new();
        let each = |root: &R, add: &mut dyn FnMut(Self::Parameter) -> Result<(), MotionError>| {
            for_each_shape::<0, _, _, _>(self, root, |shape| factor(shape, direction), add)
        };
        collect(roots, each, |factor| {
            factors.push(factor);
            Ok(())
        })?;
        Ok(factors)
    }

    /// A bound for what a sum over the modes of some roots leaves out of a response, up to a reach \[rad/s\] below which these are all modes. [`Truncation`] has the theorem.
    ///
    /// # Errors
    /// [`TruncationError::Missing`] where these are not all modes below the reach, from the first one on in order, as a count proves it; [`TruncationError::Reach`] for a
    /// reach that is not positive; [`MotionError::Resonance`] for one at a root of the list; [`MotionError::NotModal`] for the motion of a support and for a reaction;
    /// [`MotionError::Resonance`] for a load along members of what floats; else as
    /// [`count_below`](crate::search::NaturalFrequencies::count_below) and [`modal_response`](FrameAnalysis::modal_response).
    #[inline(never)]
    fn truncation<'r, const N: usize>(
        &self,
        roots: impl IntoIterator<Item = &'r NaturalFrequency<<Self as System>::Parameter>> + Clone,
        load: PlaneLoad<Self::Model>,
        entry: PlaneEntry<Self::Model>,
        reach: <Self as System>::Parameter,
    ) -> Result<Truncation<<Self as System>::Parameter>, TruncationError>
    where
        <Self as System>::Parameter: PlaneFrequency<<Self as System>::Parameter> + 'r,
        Self: MovingNetwork<<Self as System>::Parameter> + Undamped,
    {
        check_list(self, roots.clone(), reach)?;
        let of_load = match load.dual() {
            Some(own) => OfFrame::new(self, load, own)?.side::<N>(roots.clone(), reach)?,
            None if load.is_spread() => Side::new::<N>(&OwnLoad::new(self, load)?, roots.clone(), reach, false)?,
            None => return Err(MotionError::NotModal.into()),
        };
        let own = entry.dual().ok_or(MotionError::NotModal)?;
        let of_entry = OfFrame::new(self, own, entry)?.side::<N>(roots, reach)?;
        Ok(Truncation::new(reach, of_load, of_entry))
    }

    /// An entry under a force of 1 N that moves across the members of a straight chain, in their order and along their arrows, as [`MovingLoad`] says: with up to `N` shapes of some roots, and
    /// its exact influence line.
    ///
    /// Members are uniform beams and strings between places of the plane; a reaction is an entry, too. The labels of one list have one type: see
    /// [`of_any_type`](MemberLabel::of_any_type).
    ///
    /// # Errors
    /// [`TrackError::NotATrack`] for members that are no straight chain; [`TrackError::NoWaves`] and [`TrackError::Coincide`] for one without wave numbers that are told apart;
    /// [`MotionError::ZeroFrequency`] for a root at rest; [`MotionError::Resonance`] where nothing holds a part of the structure; [`MotionError::Capacity`] for more than `N` shapes, or more
    /// than both 4 and `N` of one root; else as [`mode_shapes`](FrameAnalysis::mode_shapes) and [`frequency_response`](FrameAnalysis::frequency_response).
    #[inline(never)]
    fn moving_load<'r, const N: usize, const M: usize>(
        &self,
        roots: impl IntoIterator<Item = &'r NaturalFrequency<<Self as System>::Parameter>>,
        members: &[MemberLabel<Self::Model, impl Sized>; M],
        entry: PlaneEntry<Self::Model>,
    ) -> Result<MovingLoad<<Self as System>::Parameter, N, M>, TrackError>
    where
        <Self as System>::Parameter: PlaneFrequency<<Self as System>::Parameter> + 'r,
        Self: MovingNetwork<<Self as System>::Parameter>,
    {
        const { assert!(!Self::SPINS, "a sum over modes of a rotor needs those of both whirls: take `frequency_response`") };
        moving_load(self, roots, members.map(MemberLabel::handle), entry)
    }

    /// The axial forces of all members under loads at rest, tension positive, of first order: those of the structure as it is, in proportion to the loads.
    ///
    /// Each load has a value: a force \[N\], a moment [N m], a load along a member [N/m], an acceleration of a weight [m/s²], a motion of a support \[m\]. Under a load along it a member
    /// has the mean of both ends. Joints and springs in a direction of their own need no parameter for a force; in space a force of a member does not act on its twist.
    ///
    /// [`AxialForces`] has an example.
    ///
    /// # Errors
    /// [`AxialForceError::NoAxialForce`] for a member that carries a force and has no parameter for it; [`AxialForceError::Lever`] for a rigid link or body with forces on levers;
    /// [`AxialForceError::Slides`] for a joint or a released end that slides across a force; [`AxialForceError::Load`] for a value that is not finite; [`MotionError::LossFactor`] where
    /// something has a loss factor; else as [`at`](PlaneResponse::at) at rest.
    fn axial_forces(
        &self,
        loads: &[(PlaneLoad<Self::Model>, <Self as System>::Parameter)],
    ) -> Result<AxialForces<'_, Self>, AxialForceError>
    where
        Self: Prestressed + MovingNetwork<Complex<<Self as System>::Parameter>>,
        Complex<<Self as System>::Parameter>: PlaneFrequency<<Self as System>::Parameter>,
    {
        axial_forces(self, loads)
    }

    /// The structure with axial forces, which are added to those that its members have. Its frequencies, responses (P-Δ), shapes and sensitivities are those under these forces; the loads
    /// that made them are no part of it.
    ///
    /// # Errors
    /// [`ParameterError`] for a member that does not take its force, as a string that would be slack, and for forces of a structure with other members.
    fn with_axial_forces(&self, forces: &AxialForces<'_, Self>) -> Result<Self, ParameterError>
    where
        Self: Prestressed,
    {
        with_axial_forces(self, forces)
    }

    /// The structure with its axial forces of second order under loads: the forces are computed again in the structure with the last forces, until they stay. They are added to those that its
    /// members have.
    ///
    /// A structure far beyond its critical load may settle, too. Then its natural frequencies are refused as [`Unstable`](crate::SearchError::Unstable), and its responses have the wrong sign:
    /// ask for a frequency, or for [`critical_loads`](crate::search::critical_loads), before you trust a response.
    ///
    /// # Errors
    /// [`AxialForceError::Unsettled`] where the forces go on changing; else as [`axial_forces`](FrameAnalysis::axial_forces) and
    /// [`with_axial_forces`](FrameAnalysis::with_axial_forces).
    fn settled_under(
        &self,
        loads: &[(PlaneLoad<Self::Model>, <Self as System>::Parameter)],
    ) -> Result<Self, AxialForceError>
    where
        Self: Prestressed + MovingNetwork<Complex<<Self as System>::Parameter>>,
        Complex<<Self as System>::Parameter>: PlaneFrequency<<Self as System>::Parameter>,
    {
        settled_under(self, loads)
    }

    /// The mass that modes can move along a direction \[kg\]: of each member what it has along the direction, of each body what no support holds. It is what
    /// effective masses of all modes sum up to. About an axis it is a moment of inertia [kg m²].
    ///
    /// One part is never reached: at a held end a beam with rotary inertia and without shear has a layer of the mass `m r tanh(l/r)`, with `r² = ρI/m`, that
    /// no mode moves.
    ///
    /// # Errors
    /// [`MotionError::NoUniformLoad`] and [`MotionError::NoSuchFreedom`] where a member has no weight along the direction; [`MotionError::HeldMass`] for a body
    /// that supports hold in part, if rigid joints tie bodies other than motion by motion.
    fn moving_mass(&self, direction: Direction<Self::Model>) -> Result<<Self as System>::Parameter, MotionError>
    where
        <Self as System>::Parameter: PlaneFrequency<<Self as System>::Parameter>,
        Self: MovingNetwork<<Self as System>::Parameter>,
    {
        moving_mass(self, direction)
    }
}

impl<Y: Placed> FrameAnalysis for Y {}
