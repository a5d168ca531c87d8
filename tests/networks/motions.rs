//! Shapes, responses and sensitivities of plane structures.

mod at_rest;
mod balance;
mod by_minors;
mod damped;
mod equal_members;
mod exact;
mod in_time;
mod inside;
mod large;
mod repeated;
mod responses;
mod sensitivities;
mod sketched;
mod supports;
mod ties;
mod trusses;
mod uniform_loads;
