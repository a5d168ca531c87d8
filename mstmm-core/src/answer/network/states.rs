//! What a plane structure does in one motion.

use crate::model::{MotionError, PlaneEntry, Quantity, Site};
use crate::number::{Frequency, Parameter, Size};
use crate::pass::network::{NetworkMotion, Placed};
use crate::subspace::EndMotion;

/// Signs of forces on a member, along it, across and of the moment, in its axial force, shear and bending moment: at the input end and
/// at the output end, where the sketch of a beam has them as at a cut.
const SIGNS: [[f64; 3]; 2] = [[-1.0, 1.0, -1.0], [1.0, -1.0, 1.0]];

/// The displacements and forces of a plane structure in one motion.
#[derive(Debug)]
pub struct PlaneStates<'a, Y: Placed, S: Frequency<Y::Parameter>> {
    pub(crate) system: &'a Y,
    pub(crate) x: S,
    pub(crate) motion: NetworkMotion<Y, S>,
}

impl<Y: Placed, S: Frequency<Y::Parameter>> Clone for PlaneStates<'_, Y, S> {
    fn clone(&self) -> Self {
        PlaneStates { ..*self }
    }
}

impl<'a, Y: Placed, S: Frequency<Y::Parameter>> PlaneStates<'a, Y, S> {
    /// A quantity at a point: a displacement, an internal force, a reaction.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a node or a member that this system has not got.
    pub fn value(&self, entry: PlaneEntry<Y::Model>) -> Result<S, MotionError> {
        match entry.quantity {
            Quantity::Displacement(site, axis) => Ok(self.displacements(site)?[axis]),
            Quantity::Reaction(node, axis) => Ok(self.reaction(node)?[axis]),
            Quantity::Internal { member, end, force } => {
                Ok(self.member(member)?[end].forces[force] * S::from_f64(SIGNS[end][force]))
            }
        }
    }

    /// Displacements \[m\], \[m\], \[rad\] and forces \[N\], \[N\], [N m] of both ends of a member, along it, across it and of the rotation.
    /// The forces act on the member.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a member that this system has not got.
    pub fn member(&self, member: usize) -> Result<&[EndMotion<S>; 2], MotionError> {
        let members = &self.motion.members.as_ref()[..self.system.sizes()[1]];
        members.get(member).ok_or(MotionError::NoSuchPoint { index: member })
    }

    /// Displacements x \[m\], y \[m\] and the rotation \[rad\] of a node.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a node that this system has not got.
    pub fn node(&self, node: usize) -> Result<[S; 3], MotionError> {
        let nodes = &self.motion.nodes.as_ref()[..self.system.sizes()[0]];
        nodes.get(node).copied().ok_or(MotionError::NoSuchPoint { index: node })
    }

    /// The displacements of a point.
    fn displacements(&self, site: Site) -> Result<[S; 3], MotionError> {
        match site {
            Site::Node(node) => self.node(node),
            Site::Tied { node, place } => {
                let [x, y, rotation] = self.node(node)?;
                let [to_x, to_y] = offset::<Y, S>(self.system, node, place);
                Ok([x - rotation * to_y, y + rotation * to_x, rotation])
            }
            Site::End { member, end } => {
                let [along, across, rotation] = self.member(member)?[end].displacements;
                let [c, s] = self.system.placement(member).axis::<S>(end);
                Ok([c * along - s * across, s * along + c * across, rotation])
            }
        }
    }

    /// The largest sum of forces on the motions of a node, beside the largest force of a member or of inertia; a moment counts by the
    /// longest member.
    pub(crate) fn imbalance(&self) -> f64 {
        let [nodes, members] = self.system.sizes();
        let lengths = (0..members).map(|member| self.system.placement(member).own_length().to_f64());
        let length = Some(lengths.fold(0.0, f64::max)).filter(|length| *length > 0.0).unwrap_or(1.0);
        let size = |forces: &[S; 3]| {
            let [x, y, moment] = forces.map(|force| force.size().first());
            x.max(y).max(moment / length)
        };
        let ends = self.motion.members.as_ref()[..members].iter().flatten();
        let mut largest = ends.map(|end| size(&end.forces)).fold(0.0, f64::max);
        let mut worst = 0.0_f64;
        for (node, displacements) in self.motion.nodes.as_ref()[..nodes].iter().enumerate() {
            for (row, displacement) in self.inertia(node).iter().zip(displacements) {
                largest = largest.max(size(&row.map(|entry| entry * *displacement)));
            }
            let motions = self.system.node(node).1;
            let sum = self.reaction(node).unwrap_or([S::zero(); 3]);
            worst = worst.max(size(&motions.displacements(motions.parts_of(sum))));
        }
        if worst > 0.0 { worst / largest } else { 0.0 }
    }

    /// λ² times the mass matrix of the body of a node.
    fn inertia(&self, node: usize) -> [[S; 3]; 3] {
        let lambda_squared = self.x.lambda_squared();
        self.system.node(node).0.mass_matrix::<S>().map(|row| row.map(|entry| lambda_squared * entry))
    }

    /// What a support does to its node, but for loads there: the inertia of its body less the forces of members.
    fn reaction(&self, node: usize) -> Result<[S; 3], MotionError> {
        let displacements = self.node(node)?;
        let mut sum = self.inertia(node).map(|row| {
            let terms = row.iter().zip(displacements).map(|(entry, displacement)| *entry * displacement);
            terms.fold(S::zero(), |sum, term| sum + term)
        });
        for (member, ends) in self.motion.members.as_ref()[..self.system.sizes()[1]].iter().enumerate() {
            let placement = self.system.placement(member);
            for (end, motion) in ends.iter().enumerate().filter(|(end, _)| placement.node_of(*end) == node) {
                let [along, across, moment] = motion.forces;
                let ([c, s], [x, y]) = (placement.axis::<S>(end), placement.offset::<S>(end));
                let force = [c * along - s * across, s * along + c * across];
                sum[0] += force[0];
                sum[1] += force[1];
                sum[2] += moment + x * force[1] - y * force[0];
            }
        }
        Ok(sum)
    }
}

/// Where a place is from the node that ties it.
pub(super) fn offset<Y: Placed, S: Frequency<Y::Parameter>>(system: &Y, node: usize, place: usize) -> [S; 2] {
    let (to, from) = (system.place(place), system.node(node).0.position);
    [0, 1].map(|k| S::from_parameter(to[k]) - S::from_parameter(from[k]))
}
