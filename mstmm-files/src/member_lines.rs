//! Lines along the members of a structure, on which its shapes are sampled.

use crate::geometry::Geometry;
use mstmm_core::{Complex, Drawn, MemberLabel, MotionError, Oscillation, Placed, PlacedMotions, PlaneStates, System};

/// Lines along the members of a built structure, each with the same number of points, and the motions of these.
///
/// ```
/// use mstmm::frame::{Frame, Section};
/// use mstmm::network::Support;
/// use mstmm::prelude::*;
/// use mstmm_files::{MemberLines, Mode, write_vtp};
///
/// let mut frame = Frame::new();
/// let [foot, top, tip] = [[0.0, 0.0, 0.0], [0.0, 0.0, 3.0], [2.0, 0.0, 3.0]].map(|place| frame.point(place));
/// let steel = Section::new().axial_stiffness(4e8).torsional_stiffness(4e5).bending_stiffness(1e6);
/// let steel = steel.mass_per_length(20.0).polar_inertia_per_length(0.06);
/// frame.member(foot, top, steel);
/// frame.member(top, tip, steel);
/// frame.hold(foot, Support::Fixed);
/// let crane = frame.build()?;
///
/// let lines = MemberLines::of(&crane, 20);
/// let mut modes = Vec::new();
/// for root in &crane.frequencies(5)? {
///     let shape = crane.mode_shape(root)?;
///     modes.push(Mode::from(*root).with_vectors(lines.motions(&shape)?));
/// }
/// let mut file = Vec::new(); // or File::create("crane.vtp")?
/// write_vtp(&mut file, lines.geometry(), modes)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct MemberLines<M> {
    geometry: Geometry,
    members: Vec<(MemberLabel<M, ()>, f64)>,
    /// The number of points of each line.
    count: usize,
}

impl<M> MemberLines<M> {
    /// Lines along the members of a structure that lead from one place to another, each with `count` points, at least two.
    ///
    /// What lies at one place, or acts along a direction, has no line.
    ///
    /// ```
    /// use mstmm::prelude::*;
    /// use mstmm_files::MemberLines;
    ///
    /// system! {
    ///     struct Portal { ea: f64, ei: f64, m: f64 }
    ///     section steel { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
    ///     fixed at (0.0, 0.0) -> beam 1 { ..steel } -> conn b at (0.0, 3.0) -> beam 2 { ..steel } -> conn c at (4.0, 3.0)
    ///         <- beam 3 { ..steel } <- fixed at (4.0, 0.0);
    /// }
    ///
    /// let portal = Portal { ea: 4e8, ei: 1e6, m: 20.0 }.build()?;
    /// let lines = MemberLines::of(&portal, 20);
    /// let shape = portal.mode_shape(&portal.first_frequencies::<1>()?[0])?;
    /// assert_eq!((lines.geometry().lines.len(), lines.motions(&shape)?.len()), (3, 60));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of<Y: Drawn<Model = M> + System<Parameter = f64>>(structure: &Y, count: usize) -> Self {
        let members = structure.members().filter_map(|member| {
            let [from, to] = member.ends.map(|end| end.position.filter(|_| end.along.is_none()));
            let places = [from?, to?];
            (places[0] != places[1]).then(|| (member.name.to_string(), member.label, places))
        });
        MemberLines::through(members, count)
    }

    /// Lines through both places of each member.
    fn through(members: impl Iterator<Item = (String, MemberLabel<M, ()>, [[f64; 3]; 2])>, count: usize) -> Self {
        let mut lines = MemberLines { geometry: Geometry::default(), members: Vec::new(), count: count.max(2) };
        for (name, label, [from, to]) in members {
            let place = |part: f64| [0, 1, 2].map(|k| from[k] + (to[k] - from[k]) * part);
            lines.geometry.add_line(name, parts(lines.count).map(place));
            let [x, y, z] = [0, 1, 2].map(|k| to[k] - from[k]);
            lines.members.push((label, x.hypot(y).hypot(z)));
        }
        lines
    }

    /// The points and lines.
    pub fn geometry(&self) -> &Geometry {
        &self.geometry
    }

    /// The motions of all points in a shape, or in a response: displacements along x, y and z \[m\], and the rotations about them \[rad\].
    ///
    /// Along beams, bars and strings they are exact. Springs, dampers and rods without mass are straight between their ends.
    ///
    /// # Errors
    /// [`MotionError::OtherFrame`] or [`MotionError::NoSuchPoint`] for a shape of another structure.
    pub fn motions<Y, S>(&self, states: &PlaneStates<'_, Y, S>) -> Result<Vec<[Complex<f64>; 6]>, MotionError>
    where
        Y: PlacedMotions<S> + Placed<Model = M> + System<Parameter = f64>,
        S: Oscillation<f64> + Into<Complex<f64>>,
    {
        let mut motions = Vec::with_capacity(self.geometry.points.len());
        for &(label, length) in &self.members {
            for part in parts(self.count) {
                let own = match states.along(label, part * length) {
                    Ok(state) => [
                        state.displacement_x,
                        state.displacement_y,
                        state.displacement_z,
                        state.rotation_x,
                        state.rotation_y,
                        state.rotation_z,
                    ]
                    .map(Into::into),
                    Err(MotionError::NoInside) => {
                        let from = states.motion_of(label.input())?.map(Into::<Complex<f64>>::into);
                        let to = states.motion_of(label.output())?.map(Into::<Complex<f64>>::into);
                        std::array::from_fn(|k| from[k] + (to[k] - from[k]) * part)
                    }
                    Err(error) => return Err(error),
                };
                motions.push(own);
            }
        }
        Ok(motions)
    }
}

/// The places of points along a line, as parts of its length.
fn parts(count: usize) -> impl Iterator<Item = f64> {
    (0..count).map(move |k| k as f64 / (count - 1) as f64)
}
