//! Joints: members between two points at one place.

use crate::elements::damped_joint::DampedJoint;
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
///
/// With a damping, a loss factor or a time of Kelvin and Voigt it has complex stiffnesses `κ = K (1 + iη)(1 + cλ) + dλ`, and the frame eigenvalues.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Hinge {
    stiffness: [Option<f64>; 3],
    damping: [Option<f64>; 3],
    /// Loss factor and time of Kelvin and Voigt.
    losses: [Option<f64>; 2],
}

/// Declares what a hinge names, by its place.
macro_rules! named {
    ($($(#[$doc:meta])* $name:ident: $list:ident[$place:literal];)*) => {
        impl Hinge {
            $(
                $(#[$doc])*
                #[must_use]
                pub const fn $name(mut self, value: f64) -> Self {
                    self.$list[$place] = Some(value);
                    self
                }
            )*
        }
    };
}

named! {
    /// The stiffness along x [N/m].
    stiffness_x: stiffness[0];
    /// The stiffness along y [N/m].
    stiffness_y: stiffness[1];
    /// The stiffness of the rotation [N m/rad].
    stiffness_rz: stiffness[2];
    /// The damping of a dashpot along x [N s/m].
    damping_x: damping[0];
    /// The damping of a dashpot along y [N s/m].
    damping_y: damping[1];
    /// The damping of a dashpot about z [N m s/rad].
    damping_rz: damping[2];
    /// The loss factor η of all stiffnesses.
    loss_factor: losses[0];
    /// The time c of Kelvin and Voigt of all stiffnesses \[s\].
    kelvin_voigt_time: losses[1];
}

impl Hinge {
    /// A hinge that names nothing yet: it would be rigid.
    pub const fn new() -> Self {
        Hinge { stiffness: [None; 3], damping: [None; 3], losses: [None; 2] }
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
        let Hinge { stiffness, damping, losses } = self;
        if damping.iter().chain(&losses).all(Option::is_none) {
            return FrameMember::known(Joint::hinge(D::FREEDOMS, stiffness));
        }
        FrameMember::known(DampedJoint::hinge(D::FREEDOMS, stiffness, damping, losses.map(Option::unwrap_or_default)))
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
