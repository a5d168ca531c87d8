//! Discs of frames along a line.

use crate::elements::Disc;
use crate::elements::gyroscope::Gyroscope;
use crate::frame::assembly::{Assembly, at_node, called};
use crate::frame::bodies::Rigid;
use crate::frame::dimension::{Dimension, Line};
use crate::frame::parts::Parts;

/// A disc at a point of a line.
impl From<Disc<f64>> for Rigid<Line> {
    fn from(disc: Disc<f64>) -> Self {
        let Disc { mass, inertia, polar_inertia, speed } = disc;
        let gyroscope = Some(Gyroscope { polar_inertia, speed });
        Rigid { mass, inertia: Line::tensor(inertia), centre: None, turns: true, gyroscope }
    }
}

impl<D: Dimension> Assembly<'_, D> {
    /// The gyroscopic moments of discs, each between its point and the ground.
    pub(super) fn spin_discs(&mut self) {
        let frame = self.frame;
        for (index, body) in frame.bodies.iter().enumerate() {
            let Some(gyroscope) = body.rigid.gyroscope else { continue };
            let Some(point) = body.points.first().and_then(|handle| frame.own(*handle, frame.points.len())) else {
                continue;
            };
            let name = called("body", index, body.name.as_ref());
            let ends = [at_node(self.points[point].node), at_node(self.ground())];
            self.discs.push((index, self.parts.len()));
            let failed = self.join(&name, ends, &Parts::one(gyroscope)).err();
            failed.into_iter().for_each(|mistake| self.fail(name.clone(), mistake));
        }
    }
}
