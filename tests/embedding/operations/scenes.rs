//! Small scenes with parameters of size 1: `z = sqrt(ω)` for all beams but those of other lengths.

use mstmm::prelude::*;

macro_rules! beam_from_fixed_to {
    ($($name:ident: $root:ident),*) => {$(system! {
        pub(crate) struct $name;
        fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> $root;
    })*};
}

beam_from_fixed_to! { ToFixed: fixed, ToPinned: pinned, ToGuided: guided, ToFree: free }

system! {
    pub(crate) struct Oscillator;
    fixed -> spring 1 { stiffness: 2.0 } -> mass 2 { mass: 1.0 } -> free;
}

system! {
    pub(crate) struct DampedOscillator;
    fixed -> spring 1 { stiffness: 2.0, damping: 0.1 } -> mass 2 { mass: 1.0 } -> free;
}

system! {
    pub(crate) struct TwoMasses;
    fixed -> spring 1 { stiffness: 2.0 } -> mass 2 { mass: 1.0 }
          -> spring 3 { stiffness: 3.0 } -> mass 4 { mass: 1.5 } -> free;
}

system! {
    pub(crate) struct TorsionOscillator;
    fixed -> torsion_spring 1 { stiffness: 2.0 } -> inertia 2 { inertia: 1.0 } -> free;
}

system! {
    pub(crate) struct MassAtRoot;
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2 -> free;
    conn 2 <- mass 3 { mass: 0.5 } <- free;
}

system! {
    pub(crate) struct MassAtTip;
    free -> conn 1 -> beam 2 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> fixed;
    conn 1 <- mass 3 { mass: 0.5 } <- free;
}

system! {
    pub(crate) struct TwoBeams;
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
          -> beam 2 { length: 1.5, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

system! {
    pub(crate) struct TwoEqualBeams;
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
          -> beam 2 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

system! {
    pub(crate) struct BetweenPins;
    pinned -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> beam 2 { length: 1.5, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned;
}

/// The beams between pins, with something at their connection.
macro_rules! between_pins_with {
    ($($name:ident { $($branch:tt)* })*) => {$(system! {
        pub(crate) struct $name;
        pinned -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2
               -> beam 3 { length: 1.5, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned;
        conn 2 $($branch)*;
    })*};
}

between_pins_with! {
    WithSpring { <- spring 4 { stiffness: 2.0 } <- fixed }
    WithTorsionSpring { <- torsion_spring 4 { stiffness: 2.0 } <- fixed }
    WithMass { <- mass 4 { mass: 0.5 } <- free }
    WithSprungMass { <- spring 4 { stiffness: 2.0 } <- mass 5 { mass: 0.5 } <- free }
    WithSupport { <- pinned }
}

system! {
    pub(crate) struct HingeAtTip;
    fixed -> hinge 1 { stiffness_y: 2.0, stiffness_rz: 3.0 }
          -> beam 2 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

system! {
    pub(crate) struct HingeAtRoot;
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
          -> hinge 2 { stiffness_y: 2.0, stiffness_rz: 3.0 } -> fixed;
}

system! {
    pub(crate) struct Narrowing;
    pinned -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> conn 2 -> spring 3 { stiffness: 2.0 } -> fixed;
}
