//! A controller of an undamped arm.

use vibrations::element::ParameterError;
use vibrations::prelude::*;
use vibrations::search::FrequencyList;
use vibrations::search::SearchError;

system! {
    /// Cantilever with an eccentric tip body (Abbas et al. 2017, section 4.1), lengths in units of l, masses of m l,
    /// forces of EI/l².
    #[derive(Clone, Copy, Debug)]
    pub struct Arm {
        /// Mass of the tip body
        pub mass: f64,
        /// Its moment of inertia about the mass centre
        pub inertia: f64,
        /// Distance e from the end of the beam to the mass centre
        pub eccentricity: f64,
        /// Depth d of the tip body
        pub depth: f64,
    }

    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
          -> body 2 {
                 mass,
                 inertia,
                 output_x: depth,
                 centre_x: eccentricity,
             }
          -> free;
}

/// The built system in a struct that does not know how it was made.
#[derive(Clone, Debug)]
pub struct Controller {
    plant: ArmSystem,
}

impl Controller {
    /// # Errors
    /// A parameter outside its range.
    pub fn new(arm: Arm) -> Result<Self, ParameterError> {
        Ok(Self { plant: arm.build()? })
    }

    /// The frequencies that an input shaper must avoid.
    ///
    /// # Errors
    /// Those of the search.
    pub fn modes(&self) -> Result<FrequencyList<f64, 5>, SearchError> {
        self.plant.first_frequencies()
    }
}

/// The light tip body of section 4.1: α = β = 1, e = 0.4 l, d = 0.8 l.
pub const LIGHT: Arm = Arm { mass: 1.0, inertia: 1.0, eccentricity: 0.4, depth: 0.8 };
