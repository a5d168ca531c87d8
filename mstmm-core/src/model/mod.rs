//! What a model is, with numbers: states, labels, parameters with their errors, estimates of frequencies.

pub(crate) mod asked;
pub(crate) mod axial_force_error;
pub(crate) mod chain_rule;
pub(crate) mod direction;
pub(crate) mod dislocation;
pub(crate) mod end_motion;
pub(crate) mod ends;
pub(crate) mod error;
pub(crate) mod estimates;
pub(crate) mod extent;
mod in_frame;
pub(crate) mod label;
pub(crate) mod load_error;
mod load_place;
pub(crate) mod member_plane;
pub(crate) mod motion_error;
pub(crate) mod peak_error;
pub(crate) mod plain;
pub(crate) mod plane_label;
pub(crate) mod random_error;
pub(crate) mod scaled_state;
pub(crate) mod search_error;
pub(crate) mod space_point;
pub(crate) mod spectrum_error;
pub(crate) mod speed_error;
pub(crate) mod state;
pub(crate) mod tensor;
pub(crate) mod tolerance_error;
pub(crate) mod track_error;
pub(crate) mod truncation_error;
pub(crate) mod turns;

pub(crate) use axial_force_error::AxialForceError;
pub(crate) use chain_rule::{Chain, Fields, NamedFields};
pub(crate) use direction::Direction;
pub(crate) use end_motion::EndMotion;
pub(crate) use ends::Ends;
pub(crate) use error::{InvalidParameter, ParameterError, Requirement, is_size_of_direction};
pub(crate) use estimates::FrequencyEstimates;
pub(crate) use extent::Extent;
pub(crate) use label::{Acting, Entry, Label, Load, Point, Spread};
pub(crate) use load_error::LoadError;
pub(crate) use member_plane::{MemberPlane, Skew, across, up_of};
pub(crate) use motion_error::MotionError;
pub(crate) use peak_error::PeakError;
pub(crate) use plain::{error, plain};
pub(crate) use plane_label::{
    Handle, Hold, MemberEnd, MemberLabel, PlaneActing, PlaneEntry, PlaneLoad, PlanePoint, Quantity, Site, SpreadLoad,
    Tied,
};
pub(crate) use random_error::RandomError;
pub(crate) use scaled_state::ScaledState;
pub(crate) use search_error::{SearchError, Spot};
pub(crate) use space_point::{InSpace, SpacePoint};
pub(crate) use spectrum_error::SpectrumError;
pub(crate) use speed_error::SpeedError;
pub(crate) use state::{Bending, Planar, Rotation, State, StateSpace, Translation};
pub(crate) use tensor::{Tensor, definite, least_moment};
pub(crate) use tolerance_error::ToleranceError;
pub(crate) use track_error::{NotATrack, TrackError};
pub(crate) use truncation_error::TruncationError;
pub(crate) use turns::hertz;
