//! A controller of a beam with a damped oscillator.

use vibrations::element::ParameterError;
use vibrations::prelude::*;
use vibrations::search::EigenvalueList;
use vibrations::search::SearchError;

system! {
    /// Simply supported beam with a grounded spring, a damped oscillator and a grounded torsion spring (Abbas et al.
    /// 2017, section 4.5), lengths in units of l, masses of m l, forces of EI/l².
    #[derive(Clone, Copy, Debug)]
    pub struct Absorber {
        /// Mass of the oscillator
        pub mass: f64,
        /// Its stiffness
        pub stiffness: f64,
        /// Its damping
        pub damping: f64,
    }

    pinned -> beam 1 { length: 0.2, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> conn 2 -> beam 4 { length: 0.4, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> conn 5 -> beam 8 { length: 0.15, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> conn 9 -> beam 11 { length: 0.25, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> pinned;
    conn 2 <- spring 3 { stiffness: 5.0 } <- fixed;
    conn 5 <- spring 6 { stiffness, damping } <- mass 7 { mass } <- free;
    conn 9 <- torsion_spring 10 { stiffness: 10.0 } <- fixed;
}

/// The built system in a struct that does not know how it was made.
#[derive(Clone, Debug)]
pub struct Controller {
    plant: AbsorberSystem,
}

impl Controller {
    /// # Errors
    /// A parameter outside its range.
    pub fn new(absorber: Absorber) -> Result<Self, ParameterError> {
        Ok(Self { plant: absorber.build()? })
    }

    /// The eigenvalues up to the fifth of the paper.
    ///
    /// # Errors
    /// Those of the search.
    pub fn modes(&self) -> Result<EigenvalueList<f64, 8>, SearchError> {
        self.plant.eigenvalues(Region { re: -5.0..=0.0, im: 1.0..=170.0 })
    }
}

/// The oscillator of section 4.5: K_y2 = 4 EI/l³, C = sqrt(EI m)/l, mass = 0.12 m l.
pub const PAPER: Absorber = Absorber { mass: 0.12, stiffness: 4.0, damping: 1.0 };
