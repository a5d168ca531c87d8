//! Models whose shapes are checked.

use crate::mode_shapes::recorded::recordable;
use mstmm::prelude::*;

system! {
    /// Two unequal spans on three pins.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Spans { pub(crate) l1: f64, pub(crate) l2: f64, pub(crate) ei: f64, pub(crate) m: f64 }

    pinned -> beam 1 { length: l1, bending_stiffness: ei, mass_per_length: m } -> conn 2
           -> beam 3 { length: l2, bending_stiffness: ei, mass_per_length: m } -> pinned;
    pinned -> conn 2;
}

system! {
    /// A star of three arms, clamped outside; the third may differ from the others.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Star3 { pub(crate) l1: f64, pub(crate) l2: f64, pub(crate) l3: f64 }

    fixed -> beam 1 { length: l1, bending_stiffness: 2.0, mass_per_length: 3.0 } -> conn 4;
    fixed -> beam 2 { length: l2, bending_stiffness: 2.0, mass_per_length: 3.0 } -> conn 4;
    fixed -> beam 3 { length: l3, bending_stiffness: 2.0, mass_per_length: 3.0 } -> conn 4 -> free;
}

system! {
    /// Arms of a star whose middle is fixed: nothing couples them.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Uncoupled { pub(crate) l1: f64, pub(crate) l2: f64 }

    fixed -> beam 1 { length: l1, bending_stiffness: 2.0, mass_per_length: 3.0 } -> conn 3;
    fixed -> conn 3;
    conn 3 -> beam 2 { length: l2, bending_stiffness: 2.0, mass_per_length: 3.0 } -> free;
}

system! {
    /// Two spans with a weak spring between their free ends.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct WeaklyCoupled { pub(crate) k: f64, pub(crate) l1: f64, pub(crate) l2: f64 }

    fixed -> beam 1 { length: l1, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2 -> spring 3 { stiffness: k } -> conn 4;
    free -> conn 4 -> beam 5 { length: l2, bending_stiffness: 1.0, mass_per_length: 1.0 } -> fixed;
}

system! {
    /// A stiff heavy beam and a soft light one, with masses.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Mixture {
        pub(crate) stiff: f64, pub(crate) soft: f64, pub(crate) heavy: f64, pub(crate) light: f64, pub(crate) k: f64,
    }

    fixed -> beam 1 { length: 0.8, bending_stiffness: stiff, mass_per_length: 1.3 } -> conn 2
          -> beam 3 { length: 1.1, bending_stiffness: soft, mass_per_length: 0.7 } -> conn 4 -> free;
    free -> mass 5 { mass: heavy } -> conn 2;
    free -> mass 6 { mass: light } -> spring 7 { stiffness: k } -> conn 4;
}

system! {
    /// Paths that narrow to a deflection, to a rotation, and widen again.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Narrowing { pub(crate) a: f64, pub(crate) b: f64, pub(crate) k: f64, pub(crate) kt: f64 }

    pinned -> beam 1 { length: a, bending_stiffness: 1.7, mass_per_length: 0.6 } -> conn 2 -> spring 3 { stiffness: k }
           -> mass 4 { mass: 0.3 } -> spring 5 { stiffness: k } -> conn 6;
    free -> conn 6 -> beam 7 { length: b, bending_stiffness: 0.9, mass_per_length: 1.1 } -> conn 8
         -> torsion_spring 9 { stiffness: kt } -> inertia 10 { inertia: 0.2 } -> conn 11;
    guided -> conn 8;
    free -> conn 11 -> beam 12 { length: a, bending_stiffness: 0.4, mass_per_length: 0.5 } -> fixed;
    free -> mass 13 { mass: 0.1 } -> conn 11;
}

system! {
    /// Connections that lead to connections, and a hinge.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Behind { pub(crate) a: f64, pub(crate) b: f64, pub(crate) ky: f64, pub(crate) kt: f64 }

    fixed -> beam 1 { length: a, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2 -> conn 3
          -> hinge 4 { stiffness_y: ky, stiffness_rz: kt } -> conn 5
          -> beam 6 { length: b, bending_stiffness: 2.0, mass_per_length: 0.5 } -> guided;
    free -> beam 7 { length: b, bending_stiffness: 1.5, mass_per_length: 0.8 } -> conn 2;
    free -> inertia 8 { inertia: 0.1 } -> torsion_spring 9 { stiffness: kt } -> conn 3;
    free -> mass 10 { mass: 0.4 } -> spring 11 { stiffness: ky } -> conn 12 -> conn 5;
    fixed -> spring 13 { stiffness: ky } -> conn 12;
}

system! {
    /// Sixteen arms at one connection: beams, springs, masses, torsion lines, bodies.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Hub { pub(crate) l: f64, pub(crate) k: f64, pub(crate) kt: f64, pub(crate) m: f64 }

    fixed -> beam 1 { length: l, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 0;
    pinned -> beam 2 { length: 1.1 * l, bending_stiffness: 1.2, mass_per_length: 0.9 } -> conn 0;
    guided -> beam 3 { length: 1.3 * l, bending_stiffness: 0.7, mass_per_length: 1.4 } -> conn 0;
    free -> beam 4 { length: 0.6 * l, bending_stiffness: 0.5, mass_per_length: 0.3 } -> conn 0;
    fixed -> spring 5 { stiffness: k } -> conn 0;
    free -> mass 6 { mass: m } -> spring 7 { stiffness: 2.0 * k } -> conn 0;
    free -> mass 8 { mass: 0.7 * m } -> spring 9 { stiffness: 0.5 * k } -> conn 0;
    free -> mass 10 { mass: 0.2 * m } -> conn 0;
    fixed -> torsion_spring 11 { stiffness: kt } -> conn 0;
    free -> inertia 12 { inertia: 0.3 * m } -> torsion_spring 13 { stiffness: 0.8 * kt } -> conn 0;
    free -> inertia 14 { inertia: 0.1 * m } -> conn 0;
    free -> body 15 { mass: m, inertia_about_input: m, output_x: 0.3, centre_x: -0.2 } -> conn 0;
    free -> point_mass 16 { mass: 0.1 * m, inertia: 0.1 * m } -> conn 0;
    fixed -> hinge 17 { stiffness_y: k, stiffness_rz: kt } -> conn 0;
    fixed -> spring 18 { stiffness: k } -> mass 19 { mass: m } -> spring 20 { stiffness: 3.0 * k } -> conn 0;
    fixed -> torsion_spring 21 { stiffness: kt } -> inertia 22 { inertia: m } -> torsion_spring 23 { stiffness: kt } -> conn 0;
    conn 0 -> beam 24 { length: 0.9 * l, bending_stiffness: 0.6, mass_per_length: 0.6 } -> free;
}

system! {
    /// Bodies with offsets in a row, between beams.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Bodies { pub(crate) b: f64, pub(crate) c: f64, pub(crate) m: f64, pub(crate) l: f64 }

    free -> body 1 { mass: m, inertia_about_input: m + m * c * c, output_x: b, centre_x: c }
         -> beam 2 { length: l, bending_stiffness: 1.0, mass_per_length: 0.4 }
         -> body 3 { mass: 2.0 * m, inertia_about_input: m + 2.0 * m * c * c, output_x: -b, centre_x: 0.5 * c }
         -> hinge 4 { stiffness_y: 7.0, stiffness_rz: 2.0 }
         -> body 5 { mass: m, inertia_about_input: m * c * c, output_x: 0.4, centre_x: -c }
         -> point_mass 6 { mass: m, inertia: 0.1 }
         -> beam 7 { length: 0.5 * l, bending_stiffness: 1.0, mass_per_length: 0.4 } -> pinned;
}

system! {
    /// A translation line that forks.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct MassLine { pub(crate) k1: f64, pub(crate) k2: f64, pub(crate) m1: f64, pub(crate) m2: f64 }

    free -> mass 1 { mass: m1 } -> spring 2 { stiffness: k1 } -> mass 3 { mass: m2 } -> conn 4;
    free -> mass 5 { mass: m2 } -> spring 6 { stiffness: k2 } -> conn 4;
    fixed -> spring 7 { stiffness: k1 } -> conn 4;
    conn 4 -> spring 8 { stiffness: k2 } -> mass 9 { mass: m1 } -> spring 10 { stiffness: k1 } -> fixed;
}

system! {
    /// A rotation line that forks, free at its ends.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct TorsionLine { pub(crate) k1: f64, pub(crate) k2: f64, pub(crate) j1: f64, pub(crate) j2: f64 }

    free -> inertia 1 { inertia: j1 } -> torsion_spring 2 { stiffness: k1 } -> inertia 3 { inertia: j2 } -> conn 4;
    free -> inertia 5 { inertia: j2 } -> torsion_spring 6 { stiffness: k2 } -> conn 4;
    conn 4 -> torsion_spring 7 { stiffness: k1 } -> inertia 8 { inertia: j1 } -> free;
}

system! {
    /// A frame of beams with dampers of all kinds.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Dampers { pub(crate) c: f64, pub(crate) ct: f64, pub(crate) k: f64, pub(crate) l: f64 }

    fixed -> beam 1 { length: l, bending_stiffness: 3.0, mass_per_length: 1.0 } -> conn 2
          -> beam 3 { length: 0.7 * l, bending_stiffness: 3.0, mass_per_length: 1.0 } -> conn 4 -> free;
    fixed -> damper 5 { damping: c } -> conn 2;
    free -> mass 6 { mass: 0.3 } -> spring 7 { stiffness: k, damping: c } -> conn 4;
    fixed -> torsion_damper 8 { damping: ct } -> conn 4;
    free -> inertia 9 { inertia: 0.2 } -> torsion_spring 10 { stiffness: k, damping: ct } -> conn 2;
    free -> mass 11 { mass: 0.2 } -> spring 12 { stiffness: k } -> damper 13 { damping: c } -> conn 2;
}

system! {
    /// Mass on a spring and a damper.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Oscillator { pub(crate) k: f64, pub(crate) c: f64, pub(crate) m: f64 }

    fixed -> spring 1 { stiffness: k, damping: c } -> mass 2 { mass: m } -> free;
}

recordable! { in include_str!("models.rs");
    Spans SpansSystem [beam_1 beam_3] [conn_2];
    Star3 Star3System [beam_1 beam_2 beam_3] [conn_4];
    Uncoupled UncoupledSystem [beam_1 beam_2] [conn_3];
    WeaklyCoupled WeaklyCoupledSystem [beam_1 spring_3 beam_5] [conn_2 conn_4];
    Mixture MixtureSystem [beam_1 beam_3 mass_5 mass_6 spring_7] [conn_2 conn_4];
    Narrowing NarrowingSystem [beam_1 spring_3 mass_4 spring_5 beam_7 torsion_spring_9 inertia_10 beam_12 mass_13]
        [conn_2 conn_6 conn_8 conn_11];
    Behind BehindSystem [beam_1 hinge_4 beam_6 beam_7 inertia_8 torsion_spring_9 mass_10 spring_11 spring_13]
        [conn_2 conn_3 conn_5 conn_12];
    Hub HubSystem [beam_1 beam_2 beam_3 beam_4 spring_5 mass_6 spring_7 mass_8 spring_9 mass_10 torsion_spring_11
        inertia_12 torsion_spring_13 inertia_14 body_15 point_mass_16 hinge_17 spring_18 mass_19 spring_20
        torsion_spring_21 inertia_22 torsion_spring_23 beam_24] [conn_0];
    Bodies BodiesSystem [body_1 beam_2 body_3 hinge_4 body_5 point_mass_6 beam_7] [];
    MassLine MassLineSystem [mass_1 spring_2 mass_3 mass_5 spring_6 spring_7 spring_8 mass_9 spring_10] [conn_4];
    TorsionLine TorsionLineSystem [inertia_1 torsion_spring_2 inertia_3 inertia_5 torsion_spring_6 torsion_spring_7
        inertia_8] [conn_4];
    Dampers DampersSystem [beam_1 beam_3 damper_5 mass_6 spring_7 torsion_damper_8 inertia_9
        torsion_spring_10 mass_11 spring_12 damper_13] [conn_2 conn_4];
    Oscillator OscillatorSystem [spring_1 mass_2] [];
}
