//! Two beams with a hinge of one freedom between.

use mstmm::prelude::*;

system! {
    /// Two beams, clamped at their outer ends, with a rotational hinge between.
    pub(crate) struct Gerber { pub(crate) stiffness: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
          -> hinge 2 { stiffness_rz: stiffness }
          -> beam 3 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> fixed;
}

system! {
    /// The same with a shear hinge.
    pub(crate) struct Sliding { pub(crate) stiffness: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
          -> hinge 2 { stiffness_y: stiffness }
          -> beam 3 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> fixed;
}
