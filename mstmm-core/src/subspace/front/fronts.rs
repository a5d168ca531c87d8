//! Fronts at work: objects are taken up node by node, and what is left of each front is the next object.

use crate::number::Scalar;
use crate::subspace::front::chart::MOST_FREEDOMS;
use crate::subspace::front::eliminate::Choice;
use crate::subspace::front::matrix::Front;
use crate::subspace::front::objects::Objects;
use crate::subspace::front::target::Target;
use crate::subspace::front::total::Total;

/// Fronts at work, in memory of the caller's.
#[derive(Debug)]
pub struct Fronts<'r, S: Scalar> {
    pub(super) objects: Objects<'r, S>,
    pub(super) front: Front<'r, S>,
    /// Where each variable of the objects goes in the front.
    pub(super) targets: &'r mut [Target],
    pub(super) total: Total<S>,
    pub(super) choice: Choice,
}

/// A node that is eliminated.
#[derive(Clone, Copy, Debug)]
pub struct FrontNode<S> {
    /// Its index.
    pub(crate) index: u32,
    /// How many of the last objects it joins.
    pub(crate) objects: usize,
    /// The number of its motions, and whether the last one is a rotation.
    pub(crate) motions: usize,
    pub(crate) has_rotation: bool,
    /// Sizes of the inertia of its body, of displacements and of rotations.
    pub(crate) inertias: [f64; 2],
    /// λ² times the mass matrix of its body over its motions.
    pub(crate) body: Option<[[S; MOST_FREEDOMS]; MOST_FREEDOMS]>,
}

impl<S> FrontNode<S> {
    /// Whether a motion is the rotation.
    #[inline]
    pub(super) fn is_rotation(&self, motion: usize) -> bool {
        self.has_rotation && motion + 1 == self.motions
    }
}

impl<S: Scalar> Fronts<'_, S> {
    /// Δ and the count, once all nodes are eliminated.
    pub(crate) fn total(&self) -> &Total<S> {
        &self.total
    }
}
