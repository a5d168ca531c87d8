//! Forces that a structure carries at rest, under several loads, and what they do where no parameter takes it.
//!
//! A force F at a distance a from the point about which a body turns by θ works `½ F·(θ × (θ × a))` of second order. So forces that keep their directions add the potential energy
//! `½ θᵀ S θ` with `S = Σ (F·a) 1 - ½ (F aᵀ + a Fᵀ)`, in the plane `½ (F·a) θ²`: that of the axial force of a rigid link between two places.
//!
//! A joint that lets its ends slide by s along d, which turns with them, adds `s (θ × d)·F`: nothing where it carries no force across d.

use crate::answer::network::states::PlaneStates;
use crate::answer::network::under_load::UnderLoad;
use crate::element::MemberNumbers;
use crate::model::{AxialForceError, MemberPlane, MotionError};
use crate::number::{Frequency, Real, Scalar};
use crate::pass::characteristic::System;
use crate::pass::network::vector::{displacements, dot, sum};
use crate::pass::network::{PerMember, PerNode, Placed, Prestressed};
use mstmm_plan::Freedoms;
use num_complex::Complex;

/// Roundings of its terms below which a sum over loads, or over the forces on a node, is none: a force has some of itself, and some tens of forces meet.
const ROUNDING: f64 = 64.0;

/// Rounding of forces at rest, in roundings of the largest force in extended precision. Forces of slender members are differences of displacements times stiffnesses `2^36 = EA l²/EI` times as
/// large: a slenderness of 260,000, or one of 1,000 beside a stiffness 70,000 times as large.
const NOISE: f64 = (1_u64 << 36) as f64;

/// The rotations whose products an entry of S belongs to: xx, yy, zz, xy, yz, zx.
const ENTRIES: [[Freedoms; 2]; 6] = [
    [Freedoms::RX, Freedoms::RX],
    [Freedoms::RY, Freedoms::RY],
    [Freedoms::RZ, Freedoms::RZ],
    [Freedoms::RX, Freedoms::RY],
    [Freedoms::RY, Freedoms::RZ],
    [Freedoms::RZ, Freedoms::RX],
];

/// The forces on levers of a node.
#[derive(Clone, Copy, Debug)]
struct Lever<T> {
    /// S.
    sum: [T; 6],
    /// The sum of the products of a force and a lever, and the sum of levers.
    size: f64,
    arms: f64,
}

/// What a part of a member carries.
#[derive(Clone, Copy, Debug)]
struct Part<T> {
    /// The forces on both ends along the axes of the structure.
    ends: [[T; 3]; 2],
    /// The axial force, the mean of both ends, and the sum of its sizes under all loads.
    axial: T,
    size: f64,
}

/// What a structure carries under several loads.
pub(super) struct Carried<'a, Y: Placed> {
    system: &'a Y,
    levers: PerNode<Y, Lever<Y::Parameter>>,
    parts: PerMember<Y, Part<Y::Parameter>>,
    /// The size below which a force is rounding.
    noise: f64,
}

impl<'a, T: Real, Y: Placed + System<Parameter = T>> Carried<'a, Y> {
    pub(super) fn new(system: &'a Y) -> Self {
        let zero = T::zero();
        let levers = system.per_node(Lever { sum: [zero; 6], size: 0.0, arms: 0.0 });
        let parts = system.per_member(Part { ends: [[zero; 3]; 2], axial: zero, size: 0.0 });
        Carried { system, levers, parts, noise: 0.0 }
    }

    /// Adds the forces of the motion under a load of 1, times the value of the load.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`] for forces out of range.
    pub(super) fn add(
        &mut self,
        under: &UnderLoad<'_, Y>,
        states: &PlaneStates<'_, Y, Complex<T>>,
        times: T,
    ) -> Result<(), MotionError>
    where
        Complex<T>: Frequency<T>,
    {
        let [nodes, members] = self.system.sizes();
        let mut largest = 0.0_f64;
        for member in 0..members {
            let placement = self.system.placement(member);
            let ends = states.member(member)?;
            let [from, to] = [0, 1].map(|end| ends[end].internal(end)[0].re);
            let axial = times * T::from_f64(0.5) * (from + to);
            for (end, motion) in ends.iter().enumerate() {
                let forces = displacements(states.in_global_axes(member, end, motion.forces));
                let force = forces.map(|force| force.re * times);
                largest = largest.max(size_of(&force));
                let own = &mut self.parts.as_mut()[member];
                own.ends[end] = sum(own.ends[end], force);
                self.add_lever(placement.node_of(end), force.map(|force| -force), placement.offset(end));
            }
            let own = &mut self.parts.as_mut()[member];
            own.axial += axial;
            own.size += axial.size();
        }
        for node in 0..nodes {
            if let Some([force, from]) = under.force_on(node)? {
                self.add_lever(node, force.map(|force| force * times), from);
            }
        }
        self.noise += NOISE * <T::Extended as Scalar>::EPSILON * largest;
        if self.noise.is_finite() { Ok(()) } else { Err(MotionError::NotFinite { frequency: 0.0 }) }
    }

    /// Adds a force at a distance from a node.
    fn add_lever(&mut self, node: usize, force: [T; 3], from: [T; 3]) {
        if from.iter().all(|part| part.is_zero()) {
            return;
        }
        let ([x, y, z], [a, b, c]) = (force, from);
        let (all, half) = (dot(force, from), T::from_f64(0.5));
        let own = [
            all - x * a,
            all - y * b,
            all - z * c,
            -(half * (x * b + y * a)),
            -(half * (y * c + z * b)),
            -(half * (z * a + x * c)),
        ];
        let Lever { sum, size, arms } = &mut self.levers.as_mut()[node];
        sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        *size += 3.0 * size_of(&force) * size_of(&from);
        *arms += size_of(&from);
    }

    /// The axial force of a part of a member; zero where it is rounding.
    pub(super) fn axial(&self, member: usize) -> T {
        let Part { axial, size, .. } = self.parts.as_ref()[member];
        let is_rounding = axial.size() <= self.noise.max(ROUNDING * T::EPSILON * size);
        if is_rounding && axial.size().is_finite() { T::zero() } else { axial }
    }

    /// Checks that no forces work on rotations of what is rigid.
    ///
    /// # Errors
    /// [`AxialForceError::Lever`] for the first node on which they do.
    pub(super) fn check_levers(&self) -> Result<(), AxialForceError> {
        for (node, lever) in self.levers.as_ref().iter().enumerate().take(self.system.sizes()[0]) {
            let held = self.system.node(node).0.held;
            let works = |entry: &usize| !ENTRIES[*entry].iter().any(|rotation| held.contains(*rotation));
            let worst = (0..ENTRIES.len()).filter(works).map(|entry| lever.sum[entry].to_f64());
            let worst = worst.fold(0.0, |worst: f64, own| if own.abs() > worst.abs() { own } else { worst });
            if worst.abs() > ROUNDING * T::EPSILON * lever.size + self.noise * lever.arms {
                return Err(AxialForceError::Lever { point: self.system.spot(node), stiffness: worst });
            }
        }
        Ok(())
    }

    /// Checks that no joint and no released end slides across a force.
    ///
    /// # Errors
    /// [`AxialForceError::Slides`] for the first one that does.
    pub(super) fn check_slides(&self) -> Result<(), AxialForceError>
    where
        Y: Prestressed,
    {
        let members = self.system.sizes()[1];
        for first in (0..members).filter(|member| self.system.placement(*member).part() == 0) {
            for end in 0..2 {
                let force = self.across_slides(first, end);
                if force > self.noise {
                    let (member, name) = (self.system.spot_of_member(first), self.system.name_of_member(first));
                    return Err(AxialForceError::Slides { member, name, force });
                }
            }
        }
        Ok(())
    }

    /// The size of the force across which an end of a member slides: of a joint what it does not tie, of others what is released. What slides on the ground, as a roller does, does
    /// not turn that.
    fn across_slides(&self, first: usize, end: usize) -> f64 {
        let placement = self.system.placement(first);
        let is_joint = matches!(self.system.numbers()[first].parted().0, MemberNumbers::Joint(..));
        if placement.rests(end) || is_joint && placement.rests(1 - end) {
            return 0.0;
        }
        let is_in_plane = placement.plane() == MemberPlane::Structure;
        let of_parts = self.system.parts_from(first).map(|part| self.parts.as_ref()[part].ends[end]);
        let force = of_parts.fold([T::zero(); 3], sum);
        let (mut tied, mut slides, mut across) = (0, false, 0.0_f64);
        for part in self.system.parts_from(first) {
            let placement = self.system.placement(part);
            let of_ends = match self.system.numbers()[part].parted().0 {
                MemberNumbers::Joint(rigid, _) => {
                    slides = true;
                    rigid
                }
                _ => {
                    let released = placement.released(end);
                    slides |= released.contains(Freedoms::X) || released.contains(Freedoms::Y);
                    placement.freedoms.without(released)
                }
            };
            let axes = placement.axes::<T>(end);
            for (freedom, axis) in [(Freedoms::X, axes.along), (Freedoms::Y, axes.across)] {
                if of_ends.contains(freedom) && placement.part() != 2 {
                    tied += 1;
                    across = across.max(dot(force, axis).size());
                }
            }
        }
        let all = if is_in_plane { 2 } else { 3 };
        match (slides, all - tied.min(all)) {
            (false, _) | (true, 0) => 0.0,
            // along its one direction a force does not turn anything
            (true, 1) => across,
            (true, _) => size_of(&force),
        }
    }
}

/// The size of the largest part of a vector.
fn size_of<T: Real>(vector: &[T; 3]) -> f64 {
    vector.iter().map(|part| part.size()).fold(0.0, f64::max)
}
