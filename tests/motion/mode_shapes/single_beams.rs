//! Beams between two supports, chains of springs, and rows of spans.

use crate::mode_shapes::recorded::recordable;
use mstmm::prelude::*;

/// Declares a uniform beam of length `l`, bending stiffness `ei` and mass per length `m` between two supports.
macro_rules! single_beam {
    ($($model:ident: $tip:ident $root:ident;)*) => {$(
        system! {
            #[derive(Clone, Copy, Debug)]
            pub(crate) struct $model { pub(crate) l: f64, pub(crate) ei: f64, pub(crate) m: f64 }

            $tip -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m } -> $root;
        }
    )*};
}

single_beam! {
    Cantilever: fixed free;
    PinnedPinned: pinned pinned;
    FreeFree: free free;
    FreePinned: free pinned;
}

system! {
    /// A cantilever of two different parts.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Stepped { pub(crate) l1: f64, pub(crate) ei1: f64, pub(crate) l2: f64, pub(crate) ei2: f64 }

    fixed -> beam 1 { length: l1, bending_stiffness: ei1, mass_per_length: 1.0 }
          -> beam 2 { length: l2, bending_stiffness: ei2, mass_per_length: 2.0 } -> free;
}

system! {
    /// Five equal masses between two walls.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct FiveMasses { pub(crate) k: f64, pub(crate) m: f64 }

    fixed -> spring 1 { stiffness: k } -> mass m1 { mass: m } -> spring 2 { stiffness: k } -> mass m2 { mass: m }
          -> spring 3 { stiffness: k } -> mass m3 { mass: m } -> spring 4 { stiffness: k } -> mass m4 { mass: m }
          -> spring 5 { stiffness: k } -> mass m5 { mass: m } -> spring 6 { stiffness: k } -> fixed;
}

system! {
    /// Four equal discs on a free shaft.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct FourDiscs { pub(crate) k: f64, pub(crate) j: f64 }

    free -> inertia 1 { inertia: j } -> torsion_spring 12 { stiffness: k } -> inertia 2 { inertia: j }
         -> torsion_spring 23 { stiffness: k } -> inertia 3 { inertia: j }
         -> torsion_spring 34 { stiffness: k } -> inertia 4 { inertia: j } -> free;
}

system! {
    /// Three spans whose ends are all clamped.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct ClampedRow { pub(crate) l1: f64, pub(crate) l2: f64, pub(crate) l3: f64 }

    fixed -> beam 1 { length: l1, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2;
    fixed -> conn 2;
    conn 2 -> beam 3 { length: l2, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 4;
    fixed -> conn 4;
    conn 4 -> beam 5 { length: l3, bending_stiffness: 1.0, mass_per_length: 1.0 } -> fixed;
}

system! {
    /// Four equal arms, clamped outside, free in the middle.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Star4 { pub(crate) l: f64, pub(crate) ei: f64 }

    fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: 1.0 } -> conn 5;
    fixed -> beam 2 { length: l, bending_stiffness: ei, mass_per_length: 1.0 } -> conn 5;
    fixed -> beam 3 { length: l, bending_stiffness: ei, mass_per_length: 1.0 } -> conn 5;
    fixed -> beam 4 { length: l, bending_stiffness: ei, mass_per_length: 1.0 } -> conn 5 -> free;
}

system! {
    /// Four equal arms, clamped outside and in the middle.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct HeldStar4 { pub(crate) l: f64, pub(crate) ei: f64 }

    fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: 1.0 } -> conn 5;
    fixed -> beam 2 { length: l, bending_stiffness: ei, mass_per_length: 1.0 } -> conn 5;
    fixed -> beam 3 { length: l, bending_stiffness: ei, mass_per_length: 1.0 } -> conn 5;
    fixed -> beam 4 { length: l, bending_stiffness: ei, mass_per_length: 1.0 } -> conn 5 -> fixed;
}

system! {
    /// Two oscillators on both sides of a wall.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct TwoOscillators { pub(crate) k1: f64, pub(crate) m1: f64, pub(crate) k2: f64, pub(crate) m2: f64 }

    free -> mass 1 { mass: m1 } -> spring 2 { stiffness: k1 } -> conn 3;
    fixed -> conn 3;
    conn 3 -> spring 4 { stiffness: k2 } -> mass 5 { mass: m2 } -> free;
}

recordable! { in include_str!("single_beams.rs");
    Stepped SteppedSystem [beam_1 beam_2] [];
    FiveMasses FiveMassesSystem [spring_1 mass_m1 spring_2 mass_m2 spring_3 mass_m3 spring_4 mass_m4 spring_5 mass_m5
        spring_6] [];
    FourDiscs FourDiscsSystem [inertia_1 torsion_spring_12 inertia_2 torsion_spring_23 inertia_3 torsion_spring_34
        inertia_4] [];
    ClampedRow ClampedRowSystem [beam_1 beam_3 beam_5] [conn_2 conn_4];
    Star4 Star4System [beam_1 beam_2 beam_3 beam_4] [conn_5];
    HeldStar4 HeldStar4System [beam_1 beam_2 beam_3 beam_4] [conn_5];
    TwoOscillators TwoOscillatorsSystem [mass_1 spring_2 spring_4 mass_5] [conn_3];
}
