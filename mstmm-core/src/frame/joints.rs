//! Joints: members between two points at one place.

use crate::elements::joint::Joint;
use crate::frame::dimension::{Dimension, Plane};
use crate::frame::member::{FrameElement, FrameMember, OfJoint};
use mstmm_plan::Freedoms;

/// A hinge: what it names is flexible, and what it does not name is rigid. Zero lets go.
///
/// ```
/// use mstmm_core::frame::{Frame, Hinge, Plane, Section, Ground};
/// use mstmm_core::search::NaturalFrequencies;
/// use mstmm_core::Support;
///
/// let steel = Section::new().axial_stiffness(4e8).bending_stiffness(1e6).mass_per_length(20.0);
/// let mut frame = Frame::new();
/// let [foot, below, above, top] = [[0.0, 0.0], [0.0, 1.0], [0.0, 1.0], [0.0, 2.0]].map(|place| frame.point(place));
/// frame.hold(foot, Support::Fixed);
/// frame.member(foot, below, steel);
/// frame.member(below, above, Hinge::new().stiffness_rz(1e5));
/// frame.member(above, top, steel);
/// let soft = frame.build()?.frequencies(1)?[0].omega;
/// # let _ = soft;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hinge {
    elastic: [Option<f64>; 3],
}

impl Hinge {
    /// A hinge that names nothing yet: it would be rigid.
    pub const fn new() -> Self {
        Hinge { elastic: [None; 3] }
    }

    /// The stiffness along x [N/m].
    #[must_use]
    pub const fn stiffness_x(mut self, stiffness: f64) -> Self {
        self.elastic[0] = Some(stiffness);
        self
    }

    /// The stiffness along y [N/m].
    #[must_use]
    pub const fn stiffness_y(mut self, stiffness: f64) -> Self {
        self.elastic[1] = Some(stiffness);
        self
    }

    /// The stiffness of the rotation [N m/rad].
    #[must_use]
    pub const fn stiffness_rz(mut self, stiffness: f64) -> Self {
        self.elastic[2] = Some(stiffness);
        self
    }
}

/// A hinge without stiffness: two points share displacements and no rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pin;

/// Two points share all but the displacement along x, or along the direction of an end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slider;

impl<D: Dimension> FrameElement<D> for Hinge {
    type Kind = OfJoint;

    fn member(self) -> FrameMember {
        let rigid = Freedoms::SINGLE.into_iter().zip(self.elastic).filter(|(_, stiffness)| stiffness.is_none());
        let rigid = rigid.fold(Freedoms::NONE, |sum, (freedom, _)| sum.union(freedom)).intersection(D::FREEDOMS);
        FrameMember::known(Joint::of(rigid, self.elastic))
    }
}

impl<D: Dimension> FrameElement<D> for Pin {
    type Kind = OfJoint;

    fn member(self) -> FrameMember {
        FrameMember::known(Joint::rigid(Freedoms::X.union(Freedoms::Y).intersection(D::FREEDOMS)))
    }
}

impl FrameElement<Plane> for Slider {
    type Kind = OfJoint;

    fn member(self) -> FrameMember {
        FrameMember::known(Joint::rigid(Freedoms::Y.union(Freedoms::RZ)))
    }
}
