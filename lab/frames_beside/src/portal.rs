//! The portal here.

use mstmm::prelude::*;

system! {
    /// A portal of a steel tube, 4 m high and 6 m wide, on clamped feet.
    #[derive(Debug)]
    pub struct Portal { ea: f64, ei: f64, m: f64 }

    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, 4.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (6.0, 4.0)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> fixed at (6.0, 0.0);
}

/// The portal of a steel tube with A = 6e-3 m², I = 2.5e-5 m⁴.
pub fn steel() -> Portal {
    Portal { ea: 1.26e9, ei: 5.25e6, m: 47.1 }
}

/// The first ten frequencies in hertz.
///
/// # Errors
/// Where a number of the model is out of its range, or the search fails.
pub fn hertz() -> Result<Vec<f64>, Box<dyn std::error::Error>> {
    let portal = steel().build()?;
    Ok(portal.first_frequencies::<10>()?.iter().map(|root| root.hertz()).collect())
}
