//! A frame while it is described: points, members, bodies, masses and supports, one after the other.

use crate::frame::bodies::Rigid;
use crate::frame::dimension::{Dimension, Place};
use crate::frame::ends::{End, PathPoint};
use crate::frame::holds::Hold;
use crate::frame::member::{FrameElement, FrameMember, Member};
use crate::frame::point::Point;
use crate::model::Handle;
use core::fmt::Debug;
use core::sync::atomic::{AtomicU32, Ordering};
use std::string::String;
use std::vec::Vec;

/// The number of the next frame. Zero is that of lists and sketches.
static NEXT: AtomicU32 = AtomicU32::new(1);

/// A point with a place.
#[derive(Clone, Debug)]
pub(crate) struct PointEntry<D: Dimension> {
    pub(crate) place: D::Place,
    pub(crate) holds: Vec<Hold<D>>,
    pub(crate) name: Option<String>,
}

/// A point of a path.
#[derive(Clone, Debug, Default)]
pub(crate) struct PathEntry {
    pub(crate) name: Option<String>,
}

/// A member.
#[derive(Clone, Debug)]
pub(crate) struct MemberEntry<D: Dimension> {
    pub(crate) ends: [End<D>; 2],
    pub(crate) member: FrameMember,
    pub(crate) name: Option<String>,
}

/// A body.
#[derive(Clone, Debug)]
pub(crate) struct BodyEntry<D: Dimension> {
    pub(crate) points: Vec<Handle>,
    pub(crate) rigid: Rigid<D>,
    pub(crate) name: Option<String>,
}

/// A mass on an end.
#[derive(Clone, Debug)]
pub(crate) struct MassEntry<D: Dimension> {
    pub(crate) on: End<D>,
    pub(crate) mass: f64,
}

/// A structure of points and members whose size the program decides, while it is described.
///
/// Points, members and bodies are handles: loads and answers take them. `D` is [`Line`](super::Line) or [`Plane`](super::Plane) by the first place. What
/// is added is checked by `build`, all at once. A frame that is changed is built again; its handles stay.
///
/// ```
/// use mstmm_core::frame::{Frame, Ground, RigidBody, Section};
/// use mstmm_core::elements::Spring;
/// use mstmm_core::search::NaturalFrequencies;
/// use mstmm_core::{FrameAnalysis, Freedoms, Support};
///
/// let mut frame = Frame::new();
/// let [foot, corner, far] = [[0.0, 0.0], [0.0, 3.0], [4.0, 3.0]].map(|place| frame.point(place));
/// let steel = Section::new().axial_stiffness(4e8).bending_stiffness(1e6).mass_per_length(20.0);
/// frame.hold(foot, Support::Fixed);
/// let column = frame.member(foot, corner, steel);
/// frame.member(corner, far.releasing(Freedoms::RZ), steel.shear_stiffness(2e8));
/// frame.member(corner.along([1.0, 0.0]), Ground, Spring { stiffness: 2e6 });
/// frame.body([corner], RigidBody { mass: 50.0, inertia: 8.0, centre: [0.0, 3.2] });
/// frame.hold(far, Freedoms::Y);
///
/// let portal = frame.build()?;
/// let root = portal.frequencies(1)?[0];
/// let sway = portal.frequency_response(corner.force_x(), far.displacement_x())?;
/// assert!(root.is_proven && sway.at(0.0)? > 0.0);
/// assert!(portal.mode_shape(&root)?.along(column, 1.5)?.moment.abs() > 0.0);
///
/// frame.replace(column, steel.axial_force(-1e4));
/// assert!(frame.build()?.frequencies(1)?[0].omega < root.omega);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Frame<D: Dimension> {
    pub(crate) number: u32,
    pub(crate) points: Vec<PointEntry<D>>,
    pub(crate) paths: Vec<PathEntry>,
    pub(crate) members: Vec<MemberEntry<D>>,
    pub(crate) bodies: Vec<BodyEntry<D>>,
    pub(crate) masses: Vec<MassEntry<D>>,
    /// What handles of other frames were given to.
    pub(crate) strangers: Vec<&'static str>,
}

/// The handle of a body of a frame.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    pub(crate) handle: Handle,
}

impl<D: Dimension> Default for Frame<D> {
    fn default() -> Self {
        Frame::new()
    }
}

impl<D: Dimension> Frame<D> {
    /// A frame without points.
    pub fn new() -> Self {
        Frame {
            number: NEXT.fetch_add(1, Ordering::Relaxed),
            points: Vec::new(),
            paths: Vec::new(),
            members: Vec::new(),
            bodies: Vec::new(),
            masses: Vec::new(),
            strangers: Vec::new(),
        }
    }

    fn handle(&self, index: usize) -> Handle {
        Handle::in_frame(index, self.number)
    }

    /// Adds a point at a place: `x` along a line, `[x, y]` in the plane.
    pub fn point(&mut self, place: impl Place<Dimension = D>) -> Point<D> {
        self.points.push(PointEntry { place: place.place(), holds: Vec::new(), name: None });
        Point::new(self.handle(self.points.len() - 1))
    }

    /// Adds a point of a path of one motion, without a place.
    pub fn path_point(&mut self) -> PathPoint<D> {
        self.paths.push(PathEntry::default());
        PathPoint::new(self.handle(self.paths.len() - 1))
    }

    /// Holds a point: by a `Support`, by `Freedoms`, or by a [`Roller`](super::Roller).
    pub fn hold(&mut self, point: Point<D>, hold: impl Into<Hold<D>>) {
        match self.own(point.handle, self.points.len()) {
            Some(index) => self.points[index].holds.push(hold.into()),
            None => self.strangers.push("hold"),
        }
    }

    /// Adds a member between two ends.
    pub fn member<E: FrameElement<D>>(
        &mut self,
        from: impl Into<End<D>>,
        to: impl Into<End<D>>,
        element: E,
    ) -> Member<E::Kind> {
        self.members.push(MemberEntry { ends: [from.into(), to.into()], member: element.member(), name: None });
        Member::of(self.handle(self.members.len() - 1))
    }

    /// Ties points by a [`RigidBody`](super::RigidBody) or a [`RigidLink`](super::RigidLink), or gives a point a [`PointMass`](super::PointMass).
    pub fn body(&mut self, points: impl AsRef<[Point<D>]>, body: impl Into<Rigid<D>>) -> Body {
        let points = points.as_ref().iter().map(|point| point.handle).collect();
        self.bodies.push(BodyEntry { points, rigid: body.into(), name: None });
        Body { handle: self.handle(self.bodies.len() - 1) }
    }

    /// Adds a mass to the motion of a path \[kg\], in a path of rotations a moment of inertia [kg m²]; at a point in a direction to the motion there, and
    /// without one to both displacements.
    pub fn mass(&mut self, on: impl Into<End<D>>, mass: f64) {
        self.masses.push(MassEntry { on: on.into(), mass });
    }

    /// Names a point, a member or a body, as errors call it.
    pub fn name(&mut self, item: impl Named, name: impl Into<String>) {
        let item = item.item();
        let place = match item {
            Item::Point(handle) => self.own(handle, self.points.len()).map(|index| &mut self.points[index].name),
            Item::Path(handle) => self.own(handle, self.paths.len()).map(|index| &mut self.paths[index].name),
            Item::Member(handle) => self.own(handle, self.members.len()).map(|index| &mut self.members[index].name),
            Item::Body(handle) => self.own(handle, self.bodies.len()).map(|index| &mut self.bodies[index].name),
        };
        match place {
            Some(place) => *place = Some(name.into()),
            None => self.strangers.push("name"),
        }
    }

    /// Puts another element in the place of that of a member.
    pub fn replace<E: FrameElement<D>>(&mut self, member: Member<E::Kind>, element: E) {
        match self.own(member.handle(), self.members.len()) {
            Some(index) => self.members[index].member = element.member(),
            None => self.strangers.push("replace"),
        }
    }

    /// The index that a handle of this frame means, if it is less than the number of entries.
    pub(crate) fn own(&self, handle: Handle, count: usize) -> Option<usize> {
        (handle.frame == self.number && handle.index < count).then_some(handle.index)
    }
}

/// What a name is given to.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub enum Item {
    Point(Handle),
    Path(Handle),
    Member(Handle),
    Body(Handle),
}

/// A handle that may have a name.
pub trait Named {
    /// What it stands for.
    #[doc(hidden)]
    fn item(self) -> Item;
}

impl<D> Named for Point<D> {
    fn item(self) -> Item {
        Item::Point(self.handle)
    }
}

impl<D> Named for PathPoint<D> {
    fn item(self) -> Item {
        Item::Path(self.handle)
    }
}

impl<K> Named for Member<K> {
    fn item(self) -> Item {
        Item::Member(self.handle())
    }
}

impl Named for Body {
    fn item(self) -> Item {
        Item::Body(self.handle)
    }
}
