//! Forces that move along a straight chain of members: exact influence lines, and modes by closed forms.

pub(crate) mod crossing;
pub(crate) mod load;
pub(crate) mod wave_sum;
