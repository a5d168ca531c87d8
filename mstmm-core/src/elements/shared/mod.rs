//! Formulas that several elements share.

pub(crate) mod arm;
pub(crate) mod axial_force;
pub(crate) mod back_transfer;
pub(crate) mod bending_chart;
pub(crate) mod bending_motion;
pub(crate) mod chart_form;
pub(crate) mod chart_scalar;
pub(crate) mod compliance;
pub(crate) mod compound;
pub(crate) mod connector;
pub(crate) mod damped_line;
pub(crate) mod damped_stiffness;
pub(crate) mod damped_ties;
pub(crate) mod dissipation;
pub(crate) mod krylov;
pub(crate) mod line_forms;
pub(crate) mod line_step;
pub(crate) mod longitudinal_chart;
pub(crate) mod massless;
pub(crate) mod relation;
pub(crate) mod rod_motion;
pub(crate) mod same_built;
pub(crate) mod spin;
pub(crate) mod uniform_line;
pub(crate) mod uniform_load;
