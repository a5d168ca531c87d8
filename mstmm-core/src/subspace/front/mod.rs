//! Fronts: what is behind a set of ports, as a symmetric matrix over displacements and forces.
//!
//! A front belongs to variables, each a displacement u or a force f of a port. All relations follow from one quadratic form,
//! stationary in the variables that are eliminated:
//!
//! ```text
//! Π = ½ vᵀ X v + Σ f u(node)       u: f = ∂(½vᵀXv)/∂u       f: u = -∂(½vᵀXv)/∂f
//! ```
//!
//! X is a stiffness among displacements, minus a flexibility among forces, and kinematics between both. It stays bounded, since a
//! variable changes its kind where its entry would grow.

pub(crate) mod assembly;
pub(crate) mod chart;
pub(crate) mod eliminate;
pub(crate) mod fronts;
#[cfg(test)]
mod laws;
pub(crate) mod matrix;
pub(crate) mod objects;
mod path_chart;
mod pivot;
pub(crate) mod room;
mod target;
pub(crate) mod total;
pub(crate) mod triangle;
pub(crate) mod units;
pub(crate) mod variable;
