//! Forces on levers of what is rigid: where that turns, they work.
//!
//! A force F at a distance a from the point about which a body turns by θ works `½ F·(θ × (θ × a))` of second order. So forces that keep their directions add the potential energy
//! `½ θᵀ S θ` with `S = Σ (F·a) 1 - ½ (F aᵀ + a Fᵀ)`, in the plane `½ (F·a) θ²`: that of the axial force of a rigid link between two places.

use crate::answer::network::states::PlaneStates;
use crate::answer::network::under_load::UnderLoad;
use crate::model::{AxialForceError, MotionError};
use crate::number::{Frequency, Real};
use crate::pass::characteristic::System;
use crate::pass::network::vector::{displacements, dot, norm};
use crate::pass::network::{PerNode, Placed};
use mstmm_plan::Freedoms;
use num_complex::Complex;

/// Roundings of the largest product of a force and a lever below which a sum of them is none.
const ROUNDING: f64 = 64.0;

/// The rotations whose products an entry of S belongs to: xx, yy, zz, xy, yz, zx.
const ENTRIES: [[Freedoms; 2]; 6] = [
    [Freedoms::RX, Freedoms::RX],
    [Freedoms::RY, Freedoms::RY],
    [Freedoms::RZ, Freedoms::RZ],
    [Freedoms::RX, Freedoms::RY],
    [Freedoms::RY, Freedoms::RZ],
    [Freedoms::RZ, Freedoms::RX],
];

/// The sums S of all nodes, under several loads.
pub(super) struct Levers<'a, Y: Placed> {
    system: &'a Y,
    /// Of each node S, and the largest product of a force and a lever.
    sums: PerNode<Y, ([Y::Parameter; 6], f64)>,
    largest_force: f64,
}

impl<'a, T: Real, Y: Placed + System<Parameter = T>> Levers<'a, Y> {
    pub(super) fn new(system: &'a Y) -> Self {
        Levers { system, sums: system.per_node(([T::zero(); 6], 0.0)), largest_force: 0.0 }
    }

    /// The largest force at an end of a member, all loads added up.
    pub(super) fn largest_force(&self) -> f64 {
        self.largest_force
    }

    /// Adds the forces of a motion at rest, so many times.
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
            for (end, motion) in states.member(member)?.iter().enumerate() {
                let forces = displacements(states.in_global_axes(member, end, motion.forces));
                let force = forces.map(|force| -(force.re * times));
                largest = largest.max(norm(force).to_f64());
                self.add_force(placement.node_of(end), force, placement.offset(end));
            }
        }
        for node in 0..nodes {
            if let Some([force, from]) = under.force_on(node)? {
                self.add_force(node, force.map(|force| force * times), from);
            }
        }
        self.largest_force += largest;
        Ok(())
    }

    /// Adds a force at a distance from a node.
    fn add_force(&mut self, node: usize, force: [T; 3], from: [T; 3]) {
        if from.iter().all(|part| part.is_zero()) {
            return;
        }
        let ([x, y, z], [a, b, c]) = (force, from);
        let half = T::from_f64(0.5);
        let all = dot(force, from);
        let own = [
            all - x * a,
            all - y * b,
            all - z * c,
            -(half * (x * b + y * a)),
            -(half * (y * c + z * b)),
            -(half * (z * a + x * c)),
        ];
        let (sum, size) = &mut self.sums.as_mut()[node];
        sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        *size += (norm(force) * norm(from)).to_f64();
    }

    /// Checks that no sum works on the rotations that nodes have.
    ///
    /// # Errors
    /// [`AxialForceError::Lever`] for the first node in which one does.
    pub(super) fn check(&self) -> Result<(), AxialForceError> {
        for (node, (sum, size)) in self.sums.as_ref().iter().enumerate().take(self.system.sizes()[0]) {
            let held = self.system.node(node).0.held;
            let works = |entry: &usize| !ENTRIES[*entry].iter().any(|rotation| held.contains(*rotation));
            let worst = (0..ENTRIES.len()).filter(works).map(|entry| sum[entry].to_f64());
            let worst = worst.fold(0.0, |worst: f64, own| if own.abs() > worst.abs() { own } else { worst });
            if worst.abs() > ROUNDING * T::EPSILON * size {
                return Err(AxialForceError::Lever { point: self.system.spot(node), stiffness: worst });
            }
        }
        Ok(())
    }
}
