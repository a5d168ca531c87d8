//! A drawing: a model, and what is drawn over it.

use crate::captions::in_one_line;
use crate::diagram::{Diagram, Force, diagrams};
use crate::diagram_in_space::{Ordinate, diagrams_in_space, ordinates};
use crate::error::DrawingError;
use crate::figure::Figure;
use crate::loads::{Loaded, Loading};
use crate::motion::{Motion, forces};
use crate::projection::project;
use crate::shape::{Number, Shape};
use crate::sketched::Sketched;
use crate::sketched::private::Figured;
use crate::units::Units;
use crate::view::View;
use mstmm_core::Whirl;
use std::fmt;
use std::path::Path;

/// The largest displacement on the paper, as a part of the size of the model, and within what bounds.
const REACH: f64 = 0.11;
const LEAST_REACH: f64 = 22.0;
const MOST_REACH: f64 = 56.0;

/// A drawing of a model `M`, which prints as SVG.
pub struct Drawing<M> {
    pub(crate) figure: Figure<M>,
    /// A motion, and its unit on the paper with the phase at which the largest displacement is seen.
    pub(crate) motion: Option<(Motion, Number)>,
    /// A force with its diagrams, and its unit on the paper.
    pub(crate) force: Option<(Force, Vec<Diagram>, f64)>,
    /// Whether the force is that of a mode.
    pub(crate) is_of_mode: bool,
    pub(crate) loads: Vec<Loaded>,
    pub(crate) units: Units,
    pub(crate) title: Option<String>,
    ordinates: Ordinates,
    /// The whirl of which the motion is, where its orbits are drawn.
    pub(crate) whirl: Option<Whirl>,
    /// Whether points and parts have their labels.
    pub(crate) is_labelled: bool,
}

/// The values of a force along members, for other views.
enum Ordinates {
    None,
    InPlane(Vec<Vec<[f64; 2]>>),
    InSpace(Vec<Vec<Ordinate>>),
}

impl Ordinates {
    /// The diagrams of a force, and its unit on the paper.
    fn diagrams<M>(&self, figure: &Figure<M>, force: Force) -> Result<(Force, Vec<Diagram>, f64), DrawingError> {
        let found = match self {
            Ordinates::None => None,
            Ordinates::InPlane(values) => diagrams(figure, force, values),
            Ordinates::InSpace(values) => diagrams_in_space(figure, force, values),
        };
        let (diagrams, scale) = found.ok_or(DrawingError::NoForce { force: force.name() })?;
        Ok((force, diagrams, scale))
    }
}

impl<M> fmt::Debug for Drawing<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Drawing").field("parts", &self.figure.parts.len()).finish_non_exhaustive()
    }
}

impl<M> Drawing<M> {
    /// The drawing of a built system: of a frame where its points are, of one in space by the isometric [view](View), of a tree of paths along its bending
    /// paths.
    ///
    /// # Errors
    /// [`DrawingError::Empty`] for a model without points, [`DrawingError::NotFinite`] and [`DrawingError::Size`] for one that no scale
    /// puts on the paper.
    pub fn of<Y, Kind>(system: &Y) -> Result<Self, DrawingError>
    where
        Y: Sketched<Kind> + Figured<Kind, Model = M>,
    {
        Ok(Drawing {
            figure: system.figure()?,
            motion: None,
            force: None,
            is_of_mode: false,
            loads: Vec::new(),
            units: Units::default(),
            title: None,
            ordinates: Ordinates::None,
            whirl: None,
            is_labelled: true,
        })
    }

    /// The drawing with a motion over it: a mode shape, or of a frame the states of a response. Where the reader's settings allow, it moves.
    /// A mode has no sign: it is drawn with its largest displacement upwards, or to the right; a response is drawn as it is.
    ///
    /// # Errors
    /// [`DrawingError::Motion`] where the motion is not known, [`DrawingError::MotionNotFinite`] where it is not finite.
    pub fn mode(mut self, shape: &impl Shape<M>) -> Result<Self, DrawingError> {
        let motion = Motion::of(&self.figure, shape)?;
        let reach = reach(&self.figure, &motion);
        self.motion = Some((motion, reach));
        Ok(self)
    }

    /// The drawing with the orbits of a mode of a rotor: each point goes round its circle from the dot on, in the sense of the whirl.
    ///
    /// ```
    /// use mstmm::prelude::*;
    /// use mstmm_drawing::Drawing;
    ///
    /// system! {
    ///     struct Overhung { speed: f64 }
    ///     fixed -> beam 1 {
    ///         length: 0.6, bending_stiffness: 6e4, mass_per_length: 15.0, rotary_inertia: 2.4e-3, polar_inertia_per_length: 4.8e-3, speed
    ///     } -> disc 2 { mass: 30.0, inertia: 0.3, polar_inertia: 0.6, speed } -> free;
    /// }
    ///
    /// let rotor = Overhung { speed: 300.0 }.build()?;
    /// let forward = rotor.whirl(Whirl::Forward);
    /// let shape = forward.mode_shape(&forward.first_frequencies::<1>()?[0])?;
    /// let drawing = Drawing::of(forward)?.mode(&shape)?.orbits(Whirl::Forward);
    /// assert!(drawing.to_string().contains("orbit"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn orbits(mut self, whirl: Whirl) -> Self {
        self.whirl = Some(whirl);
        self
    }

    /// The drawing with an internal force of all beams over it, of a mode shape or the states of a response: of a complex motion its real part.
    ///
    /// # Errors
    /// As [`mode`](Drawing::mode); [`DrawingError::NoForce`] where no member has such a force, or all are zero.
    pub fn forces<S: Shape<M>>(mut self, shape: &S, force: Force) -> Result<Self, DrawingError> {
        let (_, phase) = Motion::of(&self.figure, shape)?.largest();
        let turn = Number::from_polar(1.0, -phase);
        self.ordinates = match self.figure.scene {
            Some(_) => Ordinates::InSpace(ordinates(&self.figure, shape, force, turn)?),
            None => Ordinates::InPlane(forces(&self.figure, shape, force, turn)?),
        };
        self.force = Some(self.ordinates.diagrams(&self.figure, force)?);
        self.is_of_mode = S::IS_MODE;
        Ok(self)
    }

    /// The drawing with a load as an arrow where it acts, times an amount, which is written beside it: a force, a moment, a load along a member, the
    /// weight of all or the acceleration of the ground. Arrows show the sense, so the amount is written without its sign; a load of zero has none.
    ///
    /// ```
    /// use mstmm::prelude::*;
    /// use mstmm_drawing::{Drawing, Force};
    ///
    /// system! {
    ///     struct Bracket { arm: f64 }
    ///     fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> conn tip at (arm, 0.0);
    /// }
    ///
    /// let bracket = Bracket { arm: 2.0 }.build()?;
    /// let load = Bracket::conn_tip.force_y();
    /// let states = bracket.frequency_response(load, Bracket::conn_tip.displacement_y())?.states(0.0)?;
    /// // states are those under 1 N upwards
    /// let drawing = Drawing::of(&bracket)?.titled("Bracket under 1 N").forces(&states, Force::Moment)?.load(load, 1.0)?;
    /// let svg = drawing.to_string();
    /// assert!(svg.contains("moment [N m]") && svg.contains("1.00 N") && svg.contains("Bracket under 1 N"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`DrawingError::NoPlace`] where it acts on nothing that is drawn, [`DrawingError::LoadNotFinite`] for an amount that is not finite.
    pub fn load(mut self, load: impl Loading<M>, amount: f64) -> Result<Self, DrawingError> {
        if !amount.is_finite() {
            return Err(DrawingError::LoadNotFinite { amount });
        }
        let arrows = load.arrows(&self.figure);
        if arrows.is_empty() {
            return Err(DrawingError::NoPlace);
        }
        self.loads.push(Loaded { arrows, amount, is_acceleration: load.is_acceleration() });
        Ok(self)
    }

    /// The drawing with a title above it.
    ///
    /// ```
    /// use mstmm_drawing::Drawing;
    /// let system = paper::models::two_spans().build().unwrap();
    /// let drawing = Drawing::of(&system)?.titled("Two spans, a < b & c");
    /// assert!(drawing.to_string().contains("Two spans, a &lt; b &amp; c"));
    /// # Ok::<(), mstmm_drawing::DrawingError>(())
    /// ```
    #[must_use]
    pub fn titled(mut self, title: impl AsRef<str>) -> Self {
        self.title = Some(in_one_line(title.as_ref()));
        self
    }

    /// The drawing with other names of the units of force and of length, in which the numbers of the model are: `units("kN", "m")`. Without them
    /// they are N and m. Nothing is converted.
    ///
    /// ```
    /// use mstmm_drawing::{Drawing, Force};
    /// use mstmm::prelude::*;
    /// let system = paper::models::two_spans().build().unwrap();
    /// let shape = system.mode_shape(&system.first_frequencies::<1>()?[0])?;
    /// let drawing = Drawing::of(&system)?.forces(&shape, Force::Moment)?.units("kN", "cm");
    /// assert!(drawing.to_string().contains("moment [kN cm]"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn units(mut self, force: impl AsRef<str>, length: impl AsRef<str>) -> Self {
        self.units = Units { force: in_one_line(force.as_ref()), length: in_one_line(length.as_ref()) };
        self
    }

    /// The drawing of a model in space from another side. Without a view it is [isometric](View::isometric); a model of the plane stays as it is.
    ///
    /// # Errors
    /// [`DrawingError::View`] for an angle that is not finite, [`DrawingError::Size`] for a model that no scale puts on the paper.
    pub fn view(mut self, view: View) -> Result<Self, DrawingError> {
        project(&mut self.figure, view)?;
        if let Some((motion, unit)) = &mut self.motion {
            *unit = reach(&self.figure, motion);
        }
        if let Some((force, ..)) = self.force {
            self.force = Some(self.ordinates.diagrams(&self.figure, force)?);
        }
        Ok(self)
    }

    /// The drawing without labels of points and parts, as large models want it. Diagrams keep their values.
    ///
    /// ```
    /// use mstmm_drawing::Drawing;
    /// let system = paper::models::two_spans().build().unwrap();
    /// let [with, without] = [Drawing::of(&system)?, Drawing::of(&system)?.without_labels()].map(|drawing| drawing.to_string());
    /// assert!(without.len() < with.len());
    /// # Ok::<(), mstmm_drawing::DrawingError>(())
    /// ```
    #[must_use]
    pub fn without_labels(mut self) -> Self {
        self.is_labelled = false;
        self
    }

    /// Writes the drawing to a file.
    ///
    /// # Errors
    /// [`DrawingError::Io`] where the file refuses.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<(), DrawingError> {
        Ok(std::fs::write(path, self.to_string())?)
    }
}

/// The unit of a motion on the paper, with the phase at which its largest displacement is seen.
fn reach<M>(figure: &Figure<M>, motion: &Motion) -> Number {
    let places = || figure.anchors.iter().map(|anchor| anchor.at);
    let extent = |axis: usize| {
        let ends = places().map(|place| place[axis]);
        ends.clone().fold(f64::NEG_INFINITY, f64::max) - ends.fold(f64::INFINITY, f64::min)
    };
    let height = (REACH * extent(0).max(extent(1))).clamp(LEAST_REACH, MOST_REACH);
    let (largest, phase) = motion.largest();
    let reach = Some(height / largest).filter(|reach| reach.is_finite()).unwrap_or(0.0);
    Number::from_polar(reach, -phase)
}
