//! The model whose code is kept.

use mstmm::prelude::*;

system! {
    /// A mass between a spring and a damper.
    #[derive(Debug)]
    pub struct DampedMass {
        /// Stiffness [N/m].
        pub stiffness: f64,
        /// Damping [N s/m].
        pub damping: f64,
        /// Mass [kg].
        pub mass: f64,
    }

    fixed -> spring 1 { stiffness } -> conn 2;
    fixed -> damper 3 { damping } -> conn 2;
    conn 2 -> mass 4 { mass } -> free;
}
