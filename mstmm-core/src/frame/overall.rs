//! The overall transfer equation of a frame.

use crate::element::MemberElement;
use crate::frame::dimension::Dimension;
use crate::frame::structure::Framework;
use crate::pass::network::{NetworkError, OverallNetwork};

impl<D: Dimension, E: MemberElement<Parameter = f64>> Framework<D, E> {
    /// The overall transfer equation `U_all z_all = 0`, with `overall_matrix` and `overall_determinant`.
    ///
    /// `N` unknowns are half of the entries of a state at each support, at the free tips of paths and at the root, all entries of the state of a member
    /// at each cut, and a jump for each freedom that an end releases.
    ///
    /// ```
    /// use mstmm_core::frame::{Frame, Section};
    /// use mstmm_core::{Evaluate, Support};
    ///
    /// let mut frame = Frame::new();
    /// let [foot, elbow, tip] = [[0.0, 0.0, 0.0], [0.0, 0.0, 3.0], [2.0, 0.0, 3.0]].map(|place| frame.point(place));
    /// let steel = Section::new().axial_stiffness(4e8).bending_stiffness(1e6).mass_per_length(20.0);
    /// let steel = steel.torsional_stiffness(8e5).polar_inertia_per_length(0.1);
    /// frame.member(foot, elbow, steel);
    /// frame.member(elbow, tip, steel);
    /// frame.hold(foot, Support::Fixed);
    /// let crane = frame.build()?;
    /// let equation = crane.overall::<12>()?;
    /// let first = crane.frequencies(1)?[0].omega;
    /// let [below, above] = [0.99, 1.01].map(|part| equation.overall_determinant(part * first).mantissa());
    /// assert!(below * above < 0.0);
    /// # use mstmm_core::search::NaturalFrequencies;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`NetworkError::Unknowns`] for another `N` than that of the frame.
    pub fn overall<const N: usize>(&self) -> Result<OverallNetwork<'_, Self, N>, NetworkError> {
        OverallNetwork::new(self)
    }
}
