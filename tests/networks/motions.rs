//! Shapes, responses and sensitivities of plane structures.

mod balance;
mod by_minors;
mod damped;
mod exact;
mod large;
mod responses;
mod sensitivities;
mod trusses;
