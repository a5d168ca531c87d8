//! Frames: structures of points and members whose size the program decides, added one after the other and built.

mod assembly;
mod bodies;
mod dimension;
mod discs;
mod drawn;
mod ends;
mod entries;
mod error;
mod holds;
mod in_space;
mod joints;
mod masses;
mod member;
mod overall;
mod parts;
mod paths;
mod point;
mod section;
mod structure;
mod supports;
mod tensor;
#[cfg(test)]
mod tests;

pub use bodies::{PointMass, Rigid, RigidBody, RigidLink};
pub use dimension::{Dimension, Line, Place, Plane, Space};
pub use ends::{End, Ground, PathPoint};
pub use entries::{Body, Frame, Named};
pub use error::{BuildError, BuildErrors, Mistake};
pub use holds::{Hold, Roller};
pub use joints::{Hinge, Pin, Slider, Tie};
pub use member::{Bar, FrameElement, FrameMember, Member, OfBeam, OfJoint, OfLine, OfSpring, TautString};
pub use point::{InFrame, Point};
pub use section::{Section, UnknownParameter};
pub use structure::{DampedRotorStructure, DampedStructure, Framework, RotorStructure, Structure};
pub use tensor::Tensor;
