//! Models at extremes, with EI = m = l = 1 where nothing else is said.

use mstmm::prelude::*;

system! {
    /// One beam, free at its input end and clamped at the other.
    #[derive(Clone, Copy, Debug)]
    pub struct FreeFixed {}
    free -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> fixed
}

system! {
    /// Two cantilevers whose tips are joined by a spring.
    #[derive(Clone, Copy, Debug)]
    pub struct Twins {
        /// Stiffness of the spring
        pub stiffness: f64,
    }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2
          -> spring 3 { stiffness } -> conn 4 -> free;
    fixed -> beam 5 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 4
}

system! {
    /// Cantilever of four beams of length 1, soft and stiff in turn.
    #[derive(Clone, Copy, Debug)]
    pub struct SoftAndStiff {
        /// Bending stiffness of the second and fourth beam
        pub stiff: f64,
    }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
          -> beam 2 { length: 1.0, bending_stiffness: stiff, mass_per_length: 1.0 }
          -> beam 3 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
          -> beam 4 { length: 1.0, bending_stiffness: stiff, mass_per_length: 1.0 } -> free
}
