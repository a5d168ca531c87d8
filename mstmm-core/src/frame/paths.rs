//! The motion of points of paths: a displacement, or a rotation.

use crate::frame::dimension::Dimension;
use crate::frame::ends::Seat;
use crate::frame::entries::Frame;
use mstmm_plan::Freedoms;
use std::vec;
use std::vec::Vec;

/// The one motion of each point of a path, X or RZ; none where its members have not one.
pub(crate) fn motions<D: Dimension>(frame: &Frame<D>) -> Vec<Option<Freedoms>> {
    let mut met = vec![Freedoms::NONE; frame.paths.len()];
    for entry in &frame.members {
        let Ok(parts) = entry.member.parts else { continue };
        for end in &entry.ends {
            if let Seat::Path(handle) = end.seat
                && let Some(path) = frame.own(handle, frame.paths.len())
            {
                met[path] = met[path].union(parts.motion().unwrap_or(Freedoms::SPACE));
            }
        }
    }
    met.into_iter().map(|met| (met.count() == 1).then_some(met)).collect()
}
