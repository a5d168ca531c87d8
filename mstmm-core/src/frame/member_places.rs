//! Where the members of a built frame are.

use crate::element::MemberElement;
use crate::frame::dimension::Dimension;
use crate::frame::point::InFrame;
use crate::frame::structure::Framework;
use crate::model::{Handle, MemberLabel};
use crate::pass::network::Placed;

impl<D: Dimension, E: MemberElement<Parameter = f64>> Framework<D, E> {
    /// The members that lead from one place to another, in the order in which they were added, each with both places in space \[m\]. What lies at
    /// one place, or acts along a direction, is not among them.
    ///
    /// ```
    /// use mstmm_core::frame::{Bar, Frame, Ground, Section};
    /// use mstmm_core::elements::Spring;
    /// use mstmm_core::Support;
    ///
    /// let mut frame = Frame::new();
    /// let [foot, top] = [[0.0, 0.0, 0.0], [0.0, 3.0, 4.0]].map(|place| frame.point(place));
    /// let steel = Section::new().axial_stiffness(4e8).bending_stiffness(1e6).mass_per_length(20.0);
    /// frame.member(foot, top, Bar(steel));
    /// frame.member(top.along([1.0, 0.0, 0.0]), Ground, Spring { stiffness: 2e4 });
    /// frame.member(top.along([0.0, 4.0, -3.0]), Ground, Spring { stiffness: 2e4 });
    /// frame.hold(foot, Support::Pinned);
    ///
    /// let places: Vec<_> = frame.build()?.member_places().map(|(_, places)| places).collect();
    /// assert_eq!(places, [[[0.0, 0.0, 0.0], [0.0, 3.0, 4.0]]]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn member_places(&self) -> impl Iterator<Item = (MemberLabel<InFrame, ()>, [[f64; 3]; 2])> {
        (0..self.first_parts.len() - 1).filter_map(|member| {
            let placement = self.placement(self.first_parts[member]);
            let is_placed =
                |end: usize| !self.node(placement.node_of(end)).1.is_of_path && placement.along(end).is_none();
            let places = [0, 1].map(|end| placement.place_of(end));
            let is_line = is_placed(0) && is_placed(1) && places[0] != places[1];
            is_line.then(|| (MemberLabel::of(Handle::in_frame(member, self.number)), places))
        })
    }
}
