//! What is swept: to sweep something else, change this file.

use mstmm::prelude::*;
use std::hash::Hasher;
use twox_hash::XxHash64;

system! {
    /// Beam on two supports with a spring to the ground and a mass (section 4.3 of the paper); ω in units of sqrt(EI/(m l⁴)).
    #[derive(Clone, Copy, Debug)]
    pub struct SpringAndMass {
        /// Place of the spring, in lengths of the beam l.
        pub spring_at: f64,
        /// Place of the mass, beyond the spring, in l.
        pub mass_at: f64,
        /// Stiffness of the spring, in EI/l³.
        pub stiffness: f64,
        /// The mass, in that of the beam m l.
        pub mass: f64,
    }

    pinned -> beam 1 { length: spring_at, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> conn 2 -> beam 4 { length: mass_at - spring_at, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> conn 5 -> beam 7 { length: 1.0 - mass_at, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> pinned;
    conn 2 <- spring 3 { stiffness } <- fixed;
    conn 5 <- mass 6 { mass } <- free;
}

/// How many frequencies are asked of each model.
pub const FREQUENCIES: usize = 3;

/// Names of the parameters of a model, in the order in which [`SpringAndMass::values`] gives them.
pub const PARAMETERS: [&str; 4] = ["spring_at", "mass_at", "stiffness", "mass"];

impl SpringAndMass {
    /// The parameters, in the order of [`PARAMETERS`].
    pub fn values(&self) -> [f64; 4] {
        [self.spring_at, self.mass_at, self.stiffness, self.mass]
    }
}

/// A model of the sweep: points that fill the ranges evenly, by steps of irrational numbers.
pub fn model(index: u64) -> SpringAndMass {
    let part = |step: f64| (index as f64 * step).fract();
    let (spring_at, mass_at) = (0.05 + 0.40 * part(2_f64.sqrt()), 0.55 + 0.40 * part(3_f64.sqrt()));
    SpringAndMass { spring_at, mass_at, stiffness: 1.0 + 99.0 * part(5_f64.sqrt()), mass: part(7_f64.sqrt()) }
}

/// A hash of this file, and so of the sketch, its fields and their ranges: the same on every machine, whatever its line ends.
pub fn hash() -> u64 {
    let mut hasher = XxHash64::with_seed(0);
    include_str!("model.rs").lines().for_each(|line| hasher.write(line.as_bytes()));
    hasher.finish()
}
