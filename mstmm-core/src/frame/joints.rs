//! Joints: members between two points at one place.

use crate::elements::damped_joint::DampedJoint;
use crate::elements::joint::Joint;
use crate::frame::dimension::{Dimension, Plane, Space};
use crate::frame::error::Mistake;
use crate::frame::member::{FrameElement, FrameMember, OfJoint};
use crate::frame::parts::Parts;
use mstmm_plan::{Freedoms, MOST_PARTS, freedoms_in_part};

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
    stiffness: [Option<f64>; 6],
    damping: [Option<f64>; 6],
    /// Loss factor and time of Kelvin and Voigt.
    losses: [Option<f64>; 2],
    up: Option<[f64; 3]>,
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
    /// The stiffness along z [N/m], in space.
    stiffness_z: stiffness[3];
    /// The stiffness of the rotation about x [N m/rad], in space.
    stiffness_rx: stiffness[4];
    /// The stiffness of the rotation about y [N m/rad], in space.
    stiffness_ry: stiffness[5];
    /// The damping of a dashpot along z [N s/m], in space.
    damping_z: damping[3];
    /// The damping of a dashpot about x [N m s/rad], in space.
    damping_rx: damping[4];
    /// The damping of a dashpot about y [N m s/rad], in space.
    damping_ry: damping[5];
    /// The loss factor η of all stiffnesses.
    loss_factor: losses[0];
    /// The time c of Kelvin and Voigt of all stiffnesses \[s\].
    kelvin_voigt_time: losses[1];
}

impl Hinge {
    /// The vector that is made the z axis of a hinge in space whose x axis is a direction.
    #[must_use]
    pub const fn up(self, up: [f64; 3]) -> Self {
        Hinge { up: Some(up), ..self }
    }

    /// A hinge that names nothing yet: it would be rigid.
    pub const fn new() -> Self {
        Hinge { stiffness: [None; 6], damping: [None; 6], losses: [None; 2], up: None }
    }
}

/// A hinge without stiffness: two points share displacements and no rotation. In space it is a ball joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pin;

/// Two points share all but the displacement along x, or along the direction of an end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slider;

/// A joint in space that ties some freedoms rigidly, in axes whose x leads along the direction of its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tie {
    freedoms: Freedoms,
    up: Option<[f64; 3]>,
}

impl Tie {
    /// The joint that ties some freedoms.
    pub const fn of(freedoms: Freedoms) -> Self {
        Tie { freedoms, up: None }
    }

    /// The vector that is made the z axis of a joint whose x axis is a direction.
    #[must_use]
    pub const fn up(self, up: [f64; 3]) -> Self {
        Tie { up: Some(up), ..self }
    }

    /// Two points share displacements, and no rotation.
    pub const fn ball() -> Self {
        Tie::of(Freedoms::DISPLACEMENTS)
    }

    /// Two points share displacements and the rotation about x.
    pub const fn universal() -> Self {
        Tie::of(Freedoms::DISPLACEMENTS.union(Freedoms::RX))
    }

    /// Two points share all but the rotation about x.
    pub const fn revolute() -> Self {
        Tie::of(Freedoms::SPACE.without(Freedoms::RX))
    }

    /// Two points share all but the displacement along x.
    pub const fn prismatic() -> Self {
        Tie::of(Freedoms::SPACE.without(Freedoms::X))
    }

    /// Two points share all but the displacement along x and the rotation about it.
    pub const fn cylindrical() -> Self {
        Tie::of(Freedoms::SPACE.without(Freedoms::X).without(Freedoms::RX))
    }
}

/// The places of the freedoms of a part among the six of a point.
const OF_PART: [[Option<usize>; 3]; MOST_PARTS] =
    [[Some(0), Some(1), Some(2)], [None, Some(3), Some(5)], [None, None, Some(4)]];

/// The parts of a joint that ties freedoms rigidly but where a stiffness or a damping is given.
fn parts(freedoms: Freedoms, hinge: &Hinge) -> Parts {
    let mut elements = [None; MOST_PARTS];
    for (part, element) in elements.iter_mut().enumerate() {
        let of = |list: &[Option<f64>; 6]| OF_PART[part].map(|place| place.and_then(|place| list[place]));
        let (stiffness, damping) = (of(&hinge.stiffness), of(&hinge.damping));
        let own = freedoms_in_part(part, freedoms);
        let is_there = !own.is_empty() || stiffness.iter().chain(&damping).any(Option::is_some);
        *element = is_there.then(|| {
            if damping.iter().chain(&hinge.losses).all(Option::is_none) {
                return Joint::hinge(own, stiffness).into();
            }
            DampedJoint::hinge(own, stiffness, damping, hinge.losses.map(Option::unwrap_or_default)).into()
        });
    }
    let is_alike = |list: &[Option<f64>; 6]| list[1] == list[3] && list[2] == list[5];
    let is_symmetric = is_alike(&hinge.stiffness)
        && is_alike(&hinge.damping)
        && [[Freedoms::Y, Freedoms::Z], [Freedoms::RZ, Freedoms::RY]]
            .iter()
            .all(|[one, other]| freedoms.contains(*one) == freedoms.contains(*other));
    Parts { up: hinge.up, is_symmetric, ..Parts::of(elements) }
}

impl<D: Dimension> FrameElement<D> for Hinge {
    type Kind = OfJoint;

    fn member(self) -> FrameMember {
        let foreign = Freedoms::EACH.into_iter().enumerate().find(|(place, freedom)| {
            let is_named = self.stiffness[*place].is_some() || self.damping[*place].is_some();
            is_named && !D::FREEDOMS.contains(*freedom)
        });
        if foreign.is_some() || self.up.is_some() && D::FREEDOMS != Freedoms::SPACE {
            return FrameMember::of_parts(Err(Mistake::OtherDimension));
        }
        FrameMember::of_parts(Ok(parts(D::FREEDOMS, &self)))
    }
}

impl<D: Dimension> FrameElement<D> for Pin {
    type Kind = OfJoint;

    fn member(self) -> FrameMember {
        FrameMember::of_parts(Ok(parts(Freedoms::DISPLACEMENTS.intersection(D::FREEDOMS), &Hinge::new())))
    }
}

impl FrameElement<Plane> for Slider {
    type Kind = OfJoint;

    fn member(self) -> FrameMember {
        FrameMember::of_parts(Ok(parts(Freedoms::PLANE.without(Freedoms::X), &Hinge::new())))
    }
}

impl FrameElement<Space> for Slider {
    type Kind = OfJoint;

    fn member(self) -> FrameMember {
        FrameElement::<Space>::member(Tie::prismatic())
    }
}

impl FrameElement<Space> for Tie {
    type Kind = OfJoint;

    fn member(self) -> FrameMember {
        FrameMember::of_parts(Ok(Parts { up: self.up, ..parts(self.freedoms, &Hinge::new()) }))
    }
}

/// The parts of a joint that ties some freedoms rigidly.
pub(crate) fn rigid(freedoms: Freedoms) -> Parts {
    parts(freedoms, &Hinge::new())
}
