//! The model with places whose code is kept.

use mstmm::prelude::*;

system! {
    /// A mast with a guy, and a lamp at its top.
    #[derive(Debug)]
    pub struct Mast {
        /// Height [m].
        pub height: f64,
        /// Stiffness of the guy [N/m].
        pub stiffness: f64,
        /// Mass of the lamp [kg].
        pub lamp: f64,
    }

    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: 1e6, bending_stiffness: 500.0, mass_per_length: 2.0 }
        -> conn top at (0.0, height);
    conn top -> spring guy { stiffness } -> conn anchor at (0.5 * height, 0.0) <- fixed;
    conn top <- point_mass 3 { mass: lamp };
}
