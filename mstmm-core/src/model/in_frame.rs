//! Loads at the same place of another frame, whose points and members have the same indices.

use crate::model::plane_label::{Handle, PlaneActing, PlaneLoad, Site, SpreadLoad};

impl PlaneActing {
    /// The same in another frame.
    fn in_frame(self, frame: u32) -> Self {
        let handle = |handle: Handle| Handle { frame, ..handle };
        let site = |site: Site| match site {
            Site::Point(point) => Site::Point(handle(point)),
            Site::Tied(tied) => Site::Tied(tied),
            Site::End { member, end } => Site::End { member: handle(member), end },
        };
        match self {
            PlaneActing::Force(at, axis) => PlaneActing::Force(site(at), axis),
            PlaneActing::Motion(at, axis) => PlaneActing::Motion(site(at), axis),
            PlaneActing::Dislocation(member, end, force) => PlaneActing::Dislocation(handle(member), end, force),
            PlaneActing::Spread(load) => PlaneActing::Spread(SpreadLoad { member: load.member.map(handle), ..load }),
        }
    }
}

impl<M> PlaneLoad<M> {
    /// The load at the same place of another frame.
    pub(crate) fn in_frame(self, frame: u32) -> Self {
        PlaneLoad::new(self.acting.in_frame(frame))
    }
}
