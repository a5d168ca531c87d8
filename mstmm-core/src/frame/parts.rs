//! The parts of a member: in a plane structure one, in space up to three.

use crate::element::MemberElement;
use crate::elements::any_member::AnyMember;
use crate::elements::rotor_member::RotorMember;
use crate::frame::dimension::Dimension;
use crate::frame::error::Mistake;
use crate::model::{MemberPlane, up_of};
use crate::pass::network;
use mstmm_plan::{Freedoms, MOST_PARTS, freedoms_of_part};

/// The elements of a member in its planes: x and y with the rotation about z, x and z with that about -y, and the rotation about x. In a plane
/// structure, and of what has one motion, the first one is all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Parts {
    pub(crate) elements: [Option<RotorMember<f64>>; MOST_PARTS],
    /// The vector that is made its z axis, if it names one.
    pub(crate) up: Option<[f64; 3]>,
    /// Whether both planes through its axis are alike.
    pub(crate) is_symmetric: bool,
    /// A bit for each parameter that its section names.
    pub(crate) named: u32,
}

impl Parts {
    /// An element that is all of a member.
    pub(crate) fn one(element: impl Into<RotorMember<f64>>) -> Self {
        Parts { elements: [Some(element.into()), None, None], up: None, is_symmetric: false, named: 0 }
    }

    /// Elements that do not spin.
    pub(crate) fn of(elements: [Option<AnyMember<f64>>; MOST_PARTS]) -> Self {
        let elements = elements.map(|element| element.map(RotorMember::Standing));
        Parts { elements, up: None, is_symmetric: false, named: 0 }
    }

    /// The elements that are there, each with its plane among those of the member.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (usize, RotorMember<f64>)> {
        self.elements.into_iter().enumerate().filter_map(|(part, element)| Some((part, element?)))
    }

    /// Whether it stands at one place.
    pub(crate) fn is_joint(&self) -> bool {
        self.iter().any(|(_, element)| element.is_joint())
    }

    /// The one freedom of what stands in a path, X or RZ.
    pub(crate) fn motion(&self) -> Option<Freedoms> {
        match self.elements {
            [Some(element), None, None] if element.freedoms().count() == 1 && !element.is_joint() => {
                Some(element.freedoms())
            }
            _ => None,
        }
    }

    /// The freedoms that it has at its ends, in its own axes.
    pub(crate) fn freedoms(&self) -> Freedoms {
        let of_part = |(part, element): (usize, RotorMember<f64>)| freedoms_of_part(part, element.freedoms());
        self.iter().map(of_part).fold(Freedoms::NONE, Freedoms::union)
    }

    /// The freedoms that it brings to a point of a dimension.
    pub(crate) fn brought<D: Dimension>(&self) -> Freedoms {
        let brought = match self.motion() {
            Some(motion) if motion.is(Freedoms::RZ) => Freedoms::ROTATIONS,
            Some(_) => Freedoms::DISPLACEMENTS,
            // joints share what they tie, and what they let go moves on both sides
            None if self.freedoms().intersection(Freedoms::ROTATIONS).is_empty() => Freedoms::DISPLACEMENTS,
            None => Freedoms::SPACE,
        };
        brought.intersection(D::FREEDOMS)
    }

    /// The parts without the twist where both ends let it go: the member turns freely about itself, and nothing sees that.
    pub(crate) fn without_twist(self, released: [Freedoms; 2]) -> Self {
        let is_free = !self.is_joint() && released.iter().all(|released| released.contains(Freedoms::RX));
        let [first, second, twist] = self.elements;
        Parts { elements: [first, second, twist.filter(|_| !is_free)], ..self }
    }

    /// The plane of a part, given the x axis of its member, if that has one.
    ///
    /// # Errors
    /// [`Mistake::NoOrientation`] where the member leads along its `up`, [`Mistake::Up`] where that is no direction.
    pub(crate) fn plane<D: Dimension>(
        &self,
        part: usize,
        along: Option<[f64; 3]>,
    ) -> Result<MemberPlane<f64>, Mistake> {
        if D::FREEDOMS != Freedoms::SPACE {
            return Ok(MemberPlane::Structure);
        }
        match self.motion() {
            Some(motion) if motion.is(Freedoms::RZ) => return Ok(MemberPlane::About),
            Some(_) => return Ok(MemberPlane::Along),
            None if part == 2 => return Ok(MemberPlane::About),
            None => {}
        }
        if self.up.is_some_and(|up| !network::is_direction(up)) {
            return Err(Mistake::Up);
        }
        // where the ends have no direction, that is what is wrong
        let Some(along) = along else { return Ok(MemberPlane::First([0.0, 0.0, 1.0])) };
        let up = up_of(along, self.up, self.is_symmetric).map_err(|_| Mistake::NoOrientation)?;
        Ok(if part == 0 { MemberPlane::First(up) } else { MemberPlane::Second(up) })
    }
}

/// Sine of the angle between the directions of both ends of a joint up to which they are one, as two formulas of it are.
const ONE_DIRECTION: f64 = 1e-9;

/// Whether two vectors have one direction.
pub(crate) fn is_one_direction(one: [f64; 3], other: [f64; 3]) -> bool {
    let [x, y, z] = one;
    let [u, v, w] = other;
    let size = |vector: [f64; 3]| vector.iter().fold(0.0, |sum: f64, part| sum.hypot(*part));
    let across = size([y * w - z * v, z * u - x * w, x * v - y * u]);
    across <= ONE_DIRECTION * size(one) * size(other) && x * u + y * v + z * w > 0.0
}
