//! Sensitivities of frames: how a root moves with the parameters of members and bodies.

use crate::answer::network::geometry::body_slopes;
use crate::answer::network::shape::{PlaneShape, simple};
use crate::answer::root::{Root, moved_by_work, simple_root};
use crate::element::{MemberChart, MemberElement, MemberSlopes, MemberVisit};
use crate::frame::{Body, Dimension, Framework, Member};
use crate::model::MotionError;
use crate::pass::network::vector::{difference, moved};
use crate::pass::network::{Placed, PlaneFrequency};
use mstmm_plan::Freedoms;

/// The derivatives of a root with respect to the parameters of a frame, dω/dp or dλ/dp, by handles and names.
#[derive(Debug)]
pub struct FrameSensitivities<'a, D: Dimension, E: MemberElement<Parameter = f64>, S: PlaneFrequency<f64>> {
    frame: &'a Framework<D, E>,
    shape: PlaneShape<'a, Framework<D, E>, S>,
}

/// What has parameters in a frame: a member or a body.
pub trait Asked<D: Dimension, E: MemberElement<Parameter = f64>, S: PlaneFrequency<f64>> {
    /// `∂L/∂p` for the parameter of a name.
    #[doc(hidden)]
    fn slope(self, sensitivities: &FrameSensitivities<'_, D, E, S>, name: &str) -> Result<Option<S>, MotionError>;
}

impl<D: Dimension, E: MemberElement<Parameter = f64>> Framework<D, E> {
    /// The derivatives of a simple root with respect to the parameters of members and bodies.
    ///
    /// ```
    /// use mstmm_core::frame::{Frame, Section};
    /// use mstmm_core::search::NaturalFrequencies;
    /// use mstmm_core::Support;
    ///
    /// let mut frame = Frame::new();
    /// let [foot, tip] = [0.0, 2.0].map(|place| frame.point(place));
    /// frame.hold(foot, Support::Fixed);
    /// let beam = frame.member(foot, tip, Section::new().bending_stiffness(8.0).mass_per_length(1.5));
    /// let cantilever = frame.build()?;
    /// let root = cantilever.frequencies(1)?[0];
    /// // ω grows as the root of the stiffness
    /// let slope = cantilever.sensitivity(&root)?.of(beam, "bending_stiffness")?;
    /// assert!((slope / (root.omega / 16.0) - 1.0).abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`mode_shape`](crate::FrameAnalysis::mode_shape); [`MotionError::ZeroFrequency`] for a root at zero.
    pub fn sensitivity<S>(
        &self,
        root: &impl Root<f64, Frequency = S>,
    ) -> Result<FrameSensitivities<'_, D, E, S>, MotionError>
    where
        S: PlaneFrequency<f64>,
        E: MemberVisit<S> + MemberChart<S> + MemberChart<S::Extended> + MemberChart<S::WithSlope>,
    {
        let x = simple_root(root)?;
        if x.is_zero() {
            return Err(MotionError::ZeroFrequency);
        }
        let shape = simple(self, x)?;
        Ok(FrameSensitivities { frame: self, shape })
    }
}

impl<D: Dimension, E: MemberElement<Parameter = f64>, S: PlaneFrequency<f64>> FrameSensitivities<'_, D, E, S> {
    /// The derivative with respect to a parameter of a member, by the name that its section or its struct has, or to `mass` or `inertia` of a body and to
    /// `polar_inertia` and `speed` of a disc; in
    /// space to `inertia_xx`, `_yy`, `_zz`, `_xy`, `_yz` or `_zx`, each entry of the tensor that stands twice once.
    ///
    /// # Errors
    /// [`MotionError::NoSuchParameter`] where there is no derivative of this name; [`MotionError::OtherFrame`] for a handle of another frame.
    pub fn of(&self, item: impl Asked<D, E, S>, name: &str) -> Result<S, MotionError> {
        let slope = item.slope(self, name)?.ok_or(MotionError::NoSuchParameter)?;
        Ok(slope * moved_by_work(self.shape.x))
    }
}

impl<K, D, E, S> Asked<D, E, S> for Member<K>
where
    D: Dimension,
    E: MemberElement<Parameter = f64> + MemberSlopes<S>,
    S: PlaneFrequency<f64>,
{
    fn slope(self, sensitivities: &FrameSensitivities<'_, D, E, S>, name: &str) -> Result<Option<S>, MotionError> {
        let FrameSensitivities { frame, shape } = sensitivities;
        Ok(frame.slope(frame.parts_of(self.handle())?, |part| shape.member_ends(part), name))
    }
}

impl<D, E, S> Asked<D, E, S> for Body
where
    D: Dimension,
    E: MemberElement<Parameter = f64> + MemberSlopes<S>,
    S: PlaneFrequency<f64>,
{
    fn slope(self, sensitivities: &FrameSensitivities<'_, D, E, S>, name: &str) -> Result<Option<S>, MotionError> {
        let FrameSensitivities { frame, shape } = sensitivities;
        let (node, centre) = frame.body(self)?;
        let position = Placed::node(*frame, node).0.position;
        let to_centre = difference(position, centre).map(S::from_f64);
        let (square, centre) = (shape.x.lambda_squared(), moved(shape.all_of(node)?, to_centre));
        let (by_mass, by_entries) = body_slopes(square, centre);
        let names: &[_] = if D::FREEDOMS == Freedoms::SPACE { &ENTRIES } else { &["", "", "inertia"] };
        let entry = names.iter().position(|entry| *entry == name).map(|entry| by_entries[entry]);
        Ok(match name {
            "mass" => Some(by_mass),
            _ => entry.or_else(|| frame.slope_of_spin(self, |part| shape.member_ends(part), name)),
        })
    }
}

/// The entries of the inertia of a body in space.
const ENTRIES: [&str; 6] = ["inertia_xx", "inertia_yy", "inertia_zz", "inertia_xy", "inertia_yz", "inertia_zx"];
