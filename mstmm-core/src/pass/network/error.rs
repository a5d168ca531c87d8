//! Networks that cannot be built.

use crate::model::InvalidParameter;
use crate::model::error;
use core::fmt;

/// A network that cannot be built.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum NetworkError {
    /// The network has no node that could move.
    Empty,
    /// A member has an end at a node that there is not.
    NoSuchNode {
        /// Index of the member.
        member: usize,
        /// Index of the node.
        node: usize,
    },
    /// A place, a mass or a direction is not a finite number, a mass is negative, or a direction is zero.
    InvalidNode {
        /// Index of the node.
        node: usize,
        /// What is wrong.
        problem: &'static str,
    },
    /// A member has a parameter out of its range.
    Parameter {
        /// Index of the member.
        member: usize,
        /// What the member is.
        element: &'static str,
        /// The parameter.
        error: InvalidParameter,
    },
    /// Both ends of a member are at one place, where it has no length and no direction.
    SamePlace {
        /// Index of the member.
        member: usize,
        /// Indices of its nodes.
        nodes: [usize; 2],
    },
    /// The ends of a joint are at two places.
    TwoPlaces {
        /// Index of the member.
        member: usize,
        /// Indices of its nodes.
        nodes: [usize; 2],
    },
    /// A member has a direction that is zero, not finite or beyond 1e±70, or that it does not take: beams act between their ends, torsion
    /// springs about z.
    Direction {
        /// Index of the member.
        member: usize,
    },
    /// Nothing joins a node to the others.
    Apart {
        /// Index of the node.
        node: usize,
    },
    /// Arrays have room for fewer nodes or members.
    Room {
        /// Nodes and members of the network.
        nodes: usize,
        /// Members of the network.
        members: usize,
    },
    /// More unknowns are there at once than `WIDTH`.
    Width {
        /// Number of its variables.
        needed: usize,
    },
    /// The overall transfer equation has another number of unknowns than `N`.
    Unknowns {
        /// Number of its unknowns.
        needed: usize,
    },
}

impl fmt::Display for NetworkError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            NetworkError::Empty => write!(f, "the network has no members"),
            NetworkError::NoSuchNode { member, node } => {
                write!(f, "member {member} has an end at node {node}, which is not in the list of nodes")
            }
            NetworkError::InvalidNode { node, problem } => write!(f, "node {node}: {problem}"),
            NetworkError::Parameter { member, element, error } => write!(f, "member {member}, {element}: {error}"),
            NetworkError::SamePlace { member, nodes: [from, to] } => {
                write!(f, "member {member} has both ends at one place, at nodes {from} and {to}: ")?;
                write!(f, "a beam needs a length, a spring between such nodes a direction, `.along(..)`")
            }
            NetworkError::TwoPlaces { member, nodes: [from, to] } => {
                write!(f, "member {member} is a joint of nodes {from} and {to}, which are not at one place")
            }
            NetworkError::Direction { member } => {
                write!(f, "member {member} has a direction that is zero, not finite, or not its own to choose: ")?;
                write!(f, "springs and dampers of translations take one")
            }
            NetworkError::Apart { node } => {
                write!(f, "nothing joins node {node} to the rest: a network hangs together; search two networks")
            }
            NetworkError::Room { nodes, members } => {
                write!(f, "the arrays are too small for {nodes} nodes and {members} members: ")?;
                write!(f, "`Arrays::<_, {nodes}, {members}>` has room for them")
            }
            NetworkError::Width { needed } => {
                write!(f, "up to {needed} unknowns are there at once: `Arrays::<{needed}, _, _>` has room for them")
            }
            NetworkError::Unknowns { needed } => {
                write!(f, "the overall transfer equation has {needed} unknowns: ask for `overall::<{needed}>()`")
            }
        }
    }
}

error! { NetworkError }
