//! The five topologies of section 4 of the paper, labels as in its figures.

use mstmm::prelude::*;

system! {
    /// Cantilever with an eccentric tip body, section 4.1; `inertia` is about the mass centre.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct TipBody {
        pub(crate) length: f64, pub(crate) ei: f64, pub(crate) m: f64,
        pub(crate) mass: f64, pub(crate) inertia: f64, pub(crate) e: f64, pub(crate) d: f64,
    }

    fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m }
          -> body 2 { mass, inertia: inertia + mass * e * e, output_x: d, centre_x: e }
          -> free;
}

system! {
    /// Free beam with elastic restraints at both ends, section 4.2.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct ElasticEnds {
        pub(crate) length: f64, pub(crate) ei: f64, pub(crate) m: f64,
        pub(crate) ky1: f64, pub(crate) kt1: f64, pub(crate) ky2: f64, pub(crate) kt2: f64,
    }

    free -> conn 2 -> beam 3 { length, bending_stiffness: ei, mass_per_length: m } -> conn 4 -> free;
    fixed -> elastic_hinge 1 { stiffness_y: ky1, stiffness_theta: kt1 } -> conn 2;
    fixed -> elastic_hinge 5 { stiffness_y: ky2, stiffness_theta: kt2 } -> conn 4;
}

system! {
    /// Pinned beam with a spring at `xs` and a mass at `xm`, section 4.3.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct SpringAndMass {
        pub(crate) length: f64, pub(crate) xs: f64, pub(crate) xm: f64, pub(crate) ei: f64, pub(crate) m: f64,
        pub(crate) ky: f64, pub(crate) mass: f64,
    }

    pinned -> beam 1 { length: xs, bending_stiffness: ei, mass_per_length: m }
           -> conn 2 -> beam 4 { length: xm - xs, bending_stiffness: ei, mass_per_length: m }
           -> conn 5 -> beam 7 { length: length - xm, bending_stiffness: ei, mass_per_length: m }
           -> pinned;
    fixed -> spring 3 { stiffness: ky } -> conn 2;
    free -> mass 6 { mass } -> conn 5;
}

system! {
    /// Beam with an intermediate support at `x1` and a spring-mass at `x2`, section 4.4.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct TwoSpans {
        pub(crate) length: f64, pub(crate) x1: f64, pub(crate) x2: f64, pub(crate) ei: f64, pub(crate) m: f64,
        pub(crate) ky: f64, pub(crate) mass: f64,
    }

    pinned -> beam 1 { length: x1, bending_stiffness: ei, mass_per_length: m }
           -> conn 2 -> beam 3 { length: x2 - x1, bending_stiffness: ei, mass_per_length: m }
           -> conn 4 -> beam 7 { length: length - x2, bending_stiffness: ei, mass_per_length: m }
           -> pinned;
    pinned -> conn 2;
    free -> mass 6 { mass } -> spring 5 { stiffness: ky } -> conn 4;
}

system! {
    /// Simply supported beam with a damped oscillator, a spring and a torsion spring, section 4.5.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct DampedOscillator {
        pub(crate) length: f64, pub(crate) ei: f64, pub(crate) m: f64,
        pub(crate) ky1: f64, pub(crate) ky2: f64, pub(crate) c: f64, pub(crate) kt: f64, pub(crate) mass: f64,
    }

    pinned -> beam 1 { length: 0.2 * length, bending_stiffness: ei, mass_per_length: m }
           -> conn 2 -> beam 4 { length: 0.4 * length, bending_stiffness: ei, mass_per_length: m }
           -> conn 5 -> beam 8 { length: 0.15 * length, bending_stiffness: ei, mass_per_length: m }
           -> conn 9 -> beam 11 { length: 0.25 * length, bending_stiffness: ei, mass_per_length: m }
           -> pinned;
    fixed -> spring 3 { stiffness: ky1 } -> conn 2;
    free -> mass 7 { mass } -> spring_damper 6 { stiffness: ky2, damping: c } -> conn 5;
    fixed -> torsion_spring 10 { stiffness: kt } -> conn 9;
}
