//! Built frames: structures that are searched and asked.

use crate::element::{
    MemberChart, MemberElement, MemberEnds, MemberMatrix, MemberNumbers, MemberSlopes, MemberSpins, MemberTransfer,
    MemberVisit, VisitMember,
};
use crate::elements::any_member::{AnyMember, UndampedMember};
use crate::elements::rotor_member::{RotorMember, UndampedRotorMember};
use crate::frame::assembly::{Assembly, NetworkPart};
use crate::frame::dimension::{Dimension, Line};
use crate::frame::entries::{Body, Frame};
use crate::frame::error::{BuildError, BuildErrors, Mistake};
use crate::frame::in_space::{called_in, name_in};
use crate::frame::point::InFrame;
use crate::model::{FrequencyEstimates, Handle, InvalidParameter, MotionError, Skew, Spot, Tied};
use crate::number::{Frequency, FrequencyPowers, Scalar, Scaled, Single};
use crate::pass::characteristic::{Characteristic, System};
use crate::pass::network::{
    Motions, Network, NetworkError, Part, Placed, PlacedCharts, PlacedMotions, PlacedNode, PlacedTransfers, Placement,
    Prestressed, StiffnessModel, Vectors,
};
use crate::pass::searched::{ComplexPasses, RealPasses, Spectrum, Undamped};
use crate::proof::visit::Visitor;
use crate::structure::{Chart, StructureScalar};
use crate::subspace::RootCounter;
use core::marker::PhantomData;
use core::ops::Range;
use mstmm_plan::{Freedoms, NetworkOrder};
use std::string::String;
use std::vec::Vec;

/// A built frame of members `E`.
#[derive(Clone, Debug)]
pub struct Framework<D, E: MemberElement> {
    pub(super) network: Network<E, Vectors>,
    pub(super) number: u32,
    pub(super) points: Vec<Tied>,
    pub(super) places: Vec<[f64; 3]>,
    /// The supports: a point, what is held, and how it moves in a direction.
    pub(super) supports: Vec<(usize, Freedoms, Option<Skew<f64>>)>,
    /// The node and the mass centre of each body.
    bodies: Vec<(usize, [f64; 3])>,
    /// The bodies that spin, each with the part of its gyroscopic moment.
    discs: Vec<(usize, usize)>,
    /// The first part of each member of the frame in the network, and behind the last one. Parts of supports and of masses in a direction follow.
    pub(super) first_parts: Vec<usize>,
    of: PhantomData<fn() -> D>,
}

/// A built frame without damping: it has natural frequencies, shapes, responses.
pub type Structure<D> = Framework<D, UndampedMember<f64>>;

/// A built frame with damping: it has eigenvalues, shapes, responses.
pub type DampedStructure<D> = Framework<D, AnyMember<f64>>;

/// A built rotor without damping, as a whirl sees it: it has natural frequencies, shapes, responses.
pub type RotorStructure = Framework<Line, UndampedRotorMember<f64>>;

/// A built rotor with damping, as a whirl sees it: it has eigenvalues, shapes, responses.
pub type DampedRotorStructure = Framework<Line, RotorMember<f64>>;

impl<D: Dimension> Frame<D> {
    /// Builds the structure, if nothing in it is damped.
    ///
    /// # Errors
    /// [`BuildErrors`]: all that is wrong, each with the name or the number of its part.
    pub fn build(&self) -> Result<Structure<D>, BuildErrors> {
        Framework::built(self, |member| standing(member)?.undamped().ok_or(Mistake::Damped))
    }

    /// Builds the structure with what is damped in it: it has eigenvalues, and responses.
    ///
    /// # Errors
    /// As [`build`](Frame::build).
    pub fn build_damped(&self) -> Result<DampedStructure<D>, BuildErrors> {
        Framework::built(self, standing)
    }
}

impl Frame<Line> {
    /// The rotor without damping in forward whirl.
    pub(crate) fn forward(&self) -> Result<RotorStructure, BuildErrors> {
        Framework::built(self, |member| member.undamped().ok_or(Mistake::DampedRotor))
    }

    /// The rotor with damping in forward whirl.
    pub(crate) fn damped_forward(&self) -> Result<DampedRotorStructure, BuildErrors> {
        Framework::built(self, Ok)
    }
}

/// A member of a frame that is no rotor.
fn standing(member: RotorMember<f64>) -> Result<AnyMember<f64>, Mistake> {
    member.standing().ok_or(Mistake::OfRotor)
}

impl<D: Dimension, E: MemberElement<Parameter = f64>> Framework<D, E> {
    /// Builds a frame with what a function makes of its members.
    fn built(frame: &Frame<D>, element: impl Fn(RotorMember<f64>) -> Result<E, Mistake>) -> Result<Self, BuildErrors> {
        let mut assembly = Assembly::of(frame);
        let (mut parts, mut named) = (Vec::new(), Vec::new());
        for index in 0..assembly.parts.len() {
            let NetworkPart { ends, plane, element: any } = assembly.parts[index];
            let called = assembly.called[index].clone();
            match element(any) {
                Ok(element) => {
                    parts.push(Part { ends, plane, element });
                    named.push(called);
                }
                Err(mistake) => assembly.fail(called.0, mistake),
            }
        }
        let Assembly { nodes, names, is_of_path, points, bodies, discs, mut errors, first_parts, .. } = assembly;
        let (mut of_nodes, mut of_whole) = (Vec::new(), Vec::new());
        let network = Network::with_paths(
            &nodes,
            (parts.len(), |index| parts[index]),
            |node| is_of_path[node],
            |error| {
                let mut mistake = Mistake::of(error);
                let (list, part) = match error {
                    NetworkError::Parameter { member, .. }
                    | NetworkError::SamePlace { member, .. }
                    | NetworkError::TwoPlaces { member, .. }
                    | NetworkError::Direction { member }
                    | NetworkError::NoSuchNode { member, .. } => {
                        let (name, part, parameters) = &named[member];
                        if let Mistake::Parameter(error) = &mut mistake {
                            error.parameter = called_in(*parameters, *part, error.parameter);
                        }
                        (&mut errors, name.clone())
                    }
                    NetworkError::InvalidNode { node, .. } => (&mut of_nodes, names[node].clone()),
                    NetworkError::Apart { node } => (&mut of_whole, names[node].clone()),
                    _ => (&mut of_whole, String::from("the frame")),
                };
                list.push(BuildError { part, mistake });
            },
        );
        // what is wrong with each part of a member is said once
        errors.dedup();
        errors.append(&mut of_nodes);
        // what hangs together is known where all parts are right
        if errors.is_empty() {
            errors = of_whole;
        }
        let network = network.filter(|_| errors.is_empty()).ok_or(BuildErrors(errors))?;
        let places = frame.points.iter().map(|point| D::in_space(point.place)).collect();
        let holds = frame
            .points
            .iter()
            .enumerate()
            .flat_map(|(point, entry)| entry.holds.iter().map(move |hold| (point, hold)));
        let supports = holds.map(|(point, hold)| (point, hold.freedoms, hold.skew)).collect();
        let number = frame.number;
        Ok(Framework { network, number, points, places, supports, bodies, discs, first_parts, of: PhantomData })
    }
}

impl<D: Dimension, E: MemberElement<Parameter = f64>> System for Framework<D, E> {
    type Parameter = f64;
    const HAS_PHASES: bool = false;
    const IS_NETWORK: bool = true;
    const MAY_BUCKLE: bool = E::MAY_BUCKLE;
    const SPINS: bool = E::SPINS;

    fn in_numbers(&self) -> Option<StiffnessModel<'_>> {
        self.network.in_numbers()
    }

    fn name_parts(&self, visitor: &mut dyn Visitor) {
        self.network.name_parts(visitor);
    }

    fn is_flat(&self) -> bool {
        self.network.is_flat()
    }

    fn spot_of(&self, place: usize) -> Spot {
        self.spot(place)
    }

    fn spot_of_member(&self, member: usize) -> Spot {
        Spot::Member(self.first_parts.partition_point(|part| *part <= member).saturating_sub(1))
    }

    fn may_buckle(&self) -> bool {
        self.network.may_buckle()
    }

    fn frequency_estimates(&self) -> FrequencyEstimates {
        self.network.frequency_estimates()
    }
}

impl<D: Dimension, E: MemberElement<Parameter = f64>> Placed for Framework<D, E> {
    type Model = InFrame;
    type Memory = Vectors;

    fn node(&self, node: usize) -> (&PlacedNode<f64>, &Motions<f64>) {
        self.network.node(node)
    }

    fn placement(&self, member: usize) -> &Placement<f64> {
        self.network.placement(member)
    }

    fn numbers(&self) -> &[MemberNumbers] {
        self.network.numbers()
    }

    fn place(&self, place: usize) -> [f64; 3] {
        self.places[place]
    }

    fn frame_number(&self) -> u32 {
        self.number
    }

    fn point(&self, point: Handle) -> Result<Tied, MotionError> {
        let index = self.own(point)?;
        self.points.get(index).copied().ok_or(MotionError::NoSuchPoint { index })
    }

    fn member_of(&self, member: Handle) -> Result<usize, MotionError> {
        self.parts(member).map(|parts| parts.start)
    }

    fn parts_of(&self, member: Handle) -> Result<Range<usize>, MotionError> {
        self.parts(member)
    }

    fn parts_from(&self, first: usize) -> Range<usize> {
        let behind = self.first_parts.partition_point(|part| *part <= first);
        match (self.first_parts.get(behind), behind.checked_sub(1).and_then(|own| self.first_parts.get(own))) {
            (Some(next), Some(own)) if *own == first => first..*next,
            (Some(_), _) => first..first,
            // parts of supports and of masses in a direction
            (None, _) => first..first + 1,
        }
    }

    fn spot(&self, node: usize) -> Spot {
        let point = self.points.iter().position(|point| point.node == node);
        point.map_or(Spot::Node(node), Spot::Point)
    }

    fn order(&self) -> NetworkOrder<'_> {
        self.network.order()
    }

    fn sizes(&self) -> [usize; 2] {
        self.network.sizes()
    }

    fn width(&self) -> usize {
        self.network.width()
    }
}

impl<D: Dimension, E: MemberElement<Parameter = f64>> Framework<D, E> {
    /// The frame as the other whirl sees it.
    pub(crate) fn turned_round(self) -> Self
    where
        E: MemberSpins,
    {
        Framework { network: self.network.turned_round(), ..self }
    }

    /// The node and the mass centre of a body.
    ///
    /// # Errors
    /// [`MotionError::OtherFrame`] for a body of another frame, [`MotionError::NoSuchPoint`] for one that was added later.
    pub(crate) fn body(&self, body: Body) -> Result<(usize, [f64; 3]), MotionError> {
        let index = self.own(body.handle)?;
        self.bodies.get(index).copied().ok_or(MotionError::NoSuchPoint { index })
    }

    /// `∂L/∂p` for a parameter of the gyroscopic moment of a body by its name, given the motion of each part.
    pub(crate) fn slope_of_spin<S: Scalar>(
        &self,
        body: Body,
        motion: impl Fn(usize) -> MemberEnds<S>,
        name: &str,
    ) -> Option<S>
    where
        E: MemberSlopes<S>,
    {
        let (_, part) = self.discs.iter().find(|(index, _)| *index == body.handle.index)?;
        self.network.slope(*part, &motion(*part), name)
    }

    /// `∂L/∂p` for a parameter of a member by its name in a frame, given the motion of each of its parts.
    pub(crate) fn slope<S: Scalar>(
        &self,
        parts: Range<usize>,
        motion: impl Fn(usize) -> MemberEnds<S>,
        name: &str,
    ) -> Option<S>
    where
        E: MemberSlopes<S>,
    {
        let of_part = |part: usize| {
            let place = self.placement(part).part();
            self.slope_of_part(part, &motion(part), name_in(name, place)?)
        };
        let slopes = parts.filter_map(of_part);
        slopes.reduce(|sum, slope| sum + slope)
    }

    /// `∂L/∂p` for a parameter of a part by its name there.
    fn slope_of_part<S: Scalar>(&self, member: usize, motion: &MemberEnds<S>, name: &str) -> Option<S>
    where
        E: MemberSlopes<S>,
    {
        let of = |name: &str| self.network.slope(member, motion, name);
        match name {
            // the length of a beam is that between its points
            "length" if self.placement(member).freedoms.count() > 1 => None,
            "stiffness_rz" => of("stiffness_theta"),
            "damping_rz" => of("damping_theta"),
            "stiffness_theta" | "damping_theta" => None,
            _ => of(name),
        }
    }
}

impl<D, E: MemberElement> Framework<D, E> {
    /// The parts of a member in the network.
    fn parts(&self, member: Handle) -> Result<Range<usize>, MotionError> {
        let index = self.own(member)?;
        match self.first_parts[index.min(self.first_parts.len())..] {
            [first, end, ..] => Ok(first..end),
            _ => Err(MotionError::NoSuchPoint { index }),
        }
    }

    /// The index of what a handle of its frame means.
    fn own(&self, Handle { index, frame }: Handle) -> Result<usize, MotionError> {
        if frame == self.number { Ok(index) } else { Err(MotionError::OtherFrame { index }) }
    }
}

impl<D: Dimension, E: MemberElement<Parameter = f64>> Prestressed for Framework<D, E> {
    fn add_axial_force(&mut self, member: usize, force: [f64; 2]) -> Option<Result<bool, InvalidParameter>> {
        self.network.add_axial_force(member, force)
    }

    fn describe(&mut self) {
        self.network.describe();
    }

    fn name_of_member(&self, member: usize) -> &'static str {
        self.network.name_of_member(member)
    }
}

impl<D: Dimension, E, S> PlacedCharts<S> for Framework<D, E>
where
    E: MemberElement<Parameter = f64> + MemberChart<S>,
    S: Frequency<f64>,
{
    fn chart(&self, member: usize, at: &FrequencyPowers<S>, length: S) -> Option<Chart<S>> {
        self.network.chart(member, at, length)
    }
}

impl<D: Dimension, E, S> PlacedMotions<S> for Framework<D, E>
where
    E: MemberElement<Parameter = f64> + MemberVisit<S>,
    S: Frequency<f64>,
{
    fn visit_member<V: VisitMember<S>>(&self, member: usize, visitor: V) -> Option<V::Output> {
        self.network.visit_member(member, visitor)
    }
}

impl<D: Dimension, E, S> PlacedTransfers<S> for Framework<D, E>
where
    E: MemberElement<Parameter = f64> + MemberMatrix<S>,
    S: Frequency<f64> + Single,
{
    fn transfer(&self, member: usize, x: S) -> Option<MemberTransfer<S>> {
        self.network.transfer(member, x)
    }
}

impl<D: Dimension, E, S> Characteristic<S> for Framework<D, E>
where
    E: MemberElement<Parameter = f64> + MemberChart<S>,
    S: Frequency<f64> + StructureScalar,
{
    fn pass<C: RootCounter<S>>(&self, x: S, counter: &mut C) -> Scaled<S> {
        self.network.pass(x, counter)
    }
}

impl<D: Dimension, E: MemberElement<Parameter = f64>> Undamped for Framework<D, E> where Self: RealPasses {}

impl<D: Dimension, E: MemberElement<Parameter = f64>> Spectrum for Framework<D, E> where Self: ComplexPasses {}
