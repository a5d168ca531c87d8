//! A model on the paper: anchors with their places, the parts between them, supports.

use crate::kind::Kind;
use crate::scene::Scene;
use crate::solid::Grip;
use crate::vector::Vector;
use crate::vector3::Vector3;
use crate::view::Sight;
use mstmm_core::{Label, MemberEnd, MemberLabel, PlanePoint, Point};

/// A model `M` on the paper.
#[derive(Debug)]
pub struct Figure<M> {
    pub(crate) anchors: Vec<Anchor<M>>,
    pub(crate) parts: Vec<Part<M>>,
    pub(crate) supports: Vec<Support>,
    /// The points of a tree, each with its anchor.
    pub(crate) spots: Vec<(Point<M>, usize)>,
    /// Size of a metre of the model on the paper.
    pub(crate) scale: f64,
    /// Where the origin of the model is on the paper.
    pub(crate) origin: Vector,
    /// How the model is seen.
    pub(crate) sight: Sight,
    /// Where it is in space; none of a model of the plane.
    pub(crate) scene: Option<Scene>,
}

/// A place to which parts are attached.
#[derive(Debug)]
pub(crate) struct Anchor<M> {
    pub(crate) at: Vector,
    pub(crate) moves: Moves<M>,
    /// What the source calls the point, where it has a name.
    pub(crate) name: Option<String>,
}

/// What an anchor moves with; displacements are in the axes of the model.
#[derive(Clone, Copy, Debug)]
pub enum Moves<M> {
    /// It is at rest.
    Rest,
    /// A point of a frame.
    Point(PlanePoint<M>),
    /// The end of a member of a frame.
    End(MemberEnd<M>),
    /// A path of a frame, along a direction.
    Path {
        /// Index of the node.
        node: usize,
        /// The direction, of length 1.
        along: Vector3,
    },
    /// A point of a tree.
    Tree {
        /// The point.
        point: Point<M>,
        /// The direction of its deflection, of length 1.
        along: Vector,
        /// Whether its rotation is drawn as its deflection.
        is_rotation: bool,
    },
    /// Another anchor, rigidly, at a way from it in the axes of the model \[m\].
    Tied {
        /// Index of the other anchor.
        anchor: usize,
        /// The way from it.
        arm: Vector3,
    },
}

/// A part of the model: an element, a body, a rigid link.
#[derive(Debug)]
pub(crate) struct Part<M> {
    /// What the source calls it; empty of links that drawings alone have.
    pub(crate) name: String,
    /// The name of its type, or its keyword where it has none.
    pub(crate) word: &'static str,
    pub(crate) kind: Kind,
    /// The anchors of its ends; of a body the points that it ties, the mass centre last.
    pub(crate) ends: Vec<usize>,
    pub(crate) inside: Option<Inside<M>>,
}

/// How a member is asked about its inside.
#[derive(Debug)]
pub enum Inside<M> {
    /// A member of a frame, with its length.
    Member(MemberLabel<M, ()>, f64),
    /// An element of a tree, with its length; its deflection is drawn along a direction.
    Element {
        /// The element.
        label: Label<M, ()>,
        /// Its length \[m\].
        length: f64,
        /// The direction of its deflection, of length 1.
        along: Vector,
        /// Whether its rotation is drawn as its deflection.
        is_rotation: bool,
    },
}

/// A support.
#[derive(Debug)]
pub(crate) struct Support {
    /// What the source calls it.
    pub(crate) name: String,
    pub(crate) anchor: usize,
    pub(crate) holds: Holds,
}

/// What a support holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Holds {
    All,
    Displacements,
    /// The displacement across a direction of the paper.
    Across(Vector),
    /// The displacement across a direction of the paper and the rotation.
    AcrossAndRotation(Vector),
    Rotation,
    /// What a support in space holds.
    InSpace(Grip),
}

impl Holds {
    /// The name of the symbol.
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Holds::All => "fixed",
            Holds::Displacements => "pinned",
            Holds::Across(_) => "roller",
            Holds::AcrossAndRotation(_) => "guided",
            Holds::Rotation => "rotation",
            Holds::InSpace(grip) => grip.held.symbol(),
        }
    }
}

impl<M> Moves<M> {
    pub(crate) fn copy(&self) -> Self {
        match *self {
            Moves::Rest => Moves::Rest,
            Moves::Point(point) => Moves::Point(point),
            Moves::End(end) => Moves::End(end),
            Moves::Path { node, along } => Moves::Path { node, along },
            Moves::Tree { point, along, is_rotation } => Moves::Tree { point, along, is_rotation },
            Moves::Tied { anchor, arm } => Moves::Tied { anchor, arm },
        }
    }
}

/// What the source calls a label alone: `b` of `conn b`.
pub(crate) fn label_of(name: &str) -> Option<&str> {
    let (_, label) = name.rsplit_once(' ')?;
    (!name.contains(" at ")).then_some(label)
}
