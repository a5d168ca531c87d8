//! Frames: structures of points and members whose size the program decides, added one after the other and built.

mod assembly;
mod bodies;
mod dimension;
mod ends;
mod entries;
mod error;
mod holds;
mod joints;
mod member;
mod paths;
mod point;
mod section;
mod structure;

pub use bodies::{PointMass, Rigid, RigidBody, RigidLink};
pub use dimension::{Dimension, Line, Place, Plane};
pub use ends::{End, Ground, PathPoint};
pub use entries::{Body, Frame, Named};
pub use error::{BuildError, BuildErrors, Mistake};
pub use holds::{Hold, Roller};
pub use joints::{Hinge, Pin, Slider};
pub use member::{Bar, FrameElement, FrameMember, Member, OfBeam, OfJoint, OfLine, OfSpring, TautString};
pub use point::{InFrame, Point};
pub use section::{Section, UnknownParameter};
pub use structure::{DampedStructure, Framework, Structure};
