//! The five systems of Abbas, Zhou, Bestle and Rui (2017), sections 4.1 to 4.5, with the paper's parameters.
//!
//! Labels are those of the paper's figures. All beams are uniform: length l, bending stiffness EI, mass per length m.

use mstmm::prelude::*;

system! {
    /// Cantilever with an eccentric rigid body at its tip (section 4.1).
    #[derive(Clone, Copy, Debug)]
    pub struct TipBody {
        /// Beam length l [m]
        pub length: f64,
        /// Bending stiffness EI of the beam [N m²]
        pub bending_stiffness: f64,
        /// Mass per length m of the beam [kg/m]
        pub mass_per_length: f64,
        /// Mass of the body [kg]
        pub mass: f64,
        /// Moment of inertia of the body about its mass centre, J_c [kg m²]
        pub inertia: f64,
        /// Distance e of the body's mass centre from the end of the beam [m]
        pub eccentricity: f64,
        /// Distance d of the body's free end from the end of the beam [m]
        pub depth: f64,
    }

    let inertia_about_input = inertia + mass * eccentricity * eccentricity;

    fixed -> beam 1 { length, bending_stiffness, mass_per_length }
          -> body 2 { mass, inertia_about_input, output_x: depth, centre_x: eccentricity }
          -> free;
}

system! {
    /// Free-free beam whose ends are restrained by elastic hinges (section 4.2).
    #[derive(Clone, Copy, Debug)]
    pub struct RestrainedBeam {
        /// Beam length l [m]
        pub length: f64,
        /// Bending stiffness EI of the beam [N m²]
        pub bending_stiffness: f64,
        /// Mass per length m of the beam [kg/m]
        pub mass_per_length: f64,
        /// Translational stiffness K_y1 at the left end [N/m]
        pub left_stiffness: f64,
        /// Torsional stiffness K'_z1 at the left end [N m/rad]
        pub left_torsion: f64,
        /// Translational stiffness K_y2 at the right end [N/m]
        pub right_stiffness: f64,
        /// Torsional stiffness K'_z2 at the right end [N m/rad]
        pub right_torsion: f64,
    }

    free -> conn 2 -> beam 3 { length, bending_stiffness, mass_per_length } -> conn 4 -> free;
    conn 2 <- hinge 1 { stiffness_y: left_stiffness, stiffness_rz: left_torsion } <- fixed;
    conn 4 <- hinge 5 { stiffness_y: right_stiffness, stiffness_rz: right_torsion } <- fixed;
}

system! {
    /// Pinned-pinned beam with a grounded spring and a lumped mass (section 4.3).
    #[derive(Clone, Copy, Debug)]
    pub struct SpringAndMass {
        /// Beam length l [m]
        pub length: f64,
        /// Bending stiffness EI of the beam [N m²]
        pub bending_stiffness: f64,
        /// Mass per length m of the beam [kg/m]
        pub mass_per_length: f64,
        /// Position x_s of the spring [m]
        pub spring_position: f64,
        /// Position x_m of the mass [m]
        pub mass_position: f64,
        /// Stiffness K_y of the spring [N/m]
        pub stiffness: f64,
        /// Lumped mass [kg]
        pub mass: f64,
    }

    pinned -> beam 1 { length: spring_position, bending_stiffness, mass_per_length }
           -> conn 2 -> beam 4 { length: mass_position - spring_position, bending_stiffness, mass_per_length }
           -> conn 5 -> beam 7 { length: length - mass_position, bending_stiffness, mass_per_length }
           -> pinned;
    conn 2 <- spring 3 { stiffness } <- fixed;
    conn 5 <- mass 6 { mass } <- free;
}

system! {
    /// Two-span beam that carries a mass on a spring (section 4.4).
    #[derive(Clone, Copy, Debug)]
    pub struct TwoSpans {
        /// Beam length l [m]
        pub length: f64,
        /// Bending stiffness EI of the beam [N m²]
        pub bending_stiffness: f64,
        /// Mass per length m of the beam [kg/m]
        pub mass_per_length: f64,
        /// Position x_1 of the intermediate support [m]
        pub support_position: f64,
        /// Position x_2 of the spring [m]
        pub spring_position: f64,
        /// Stiffness K_y of the spring [N/m]
        pub stiffness: f64,
        /// Mass on the spring [kg]
        pub mass: f64,
    }

    pinned -> beam 1 { length: support_position, bending_stiffness, mass_per_length }
           -> conn 2 -> beam 3 { length: spring_position - support_position, bending_stiffness, mass_per_length }
           -> conn 4 -> beam 7 { length: length - spring_position, bending_stiffness, mass_per_length }
           -> pinned;
    conn 2 <- pinned;
    conn 4 <- spring 5 { stiffness } <- mass 6 { mass } <- free;
}

system! {
    /// Simply supported beam with a grounded spring, a damped oscillator and a grounded torsion spring (section 4.5).
    #[derive(Clone, Copy, Debug)]
    pub struct DampedOscillator {
        /// Beam length l [m]
        pub length: f64,
        /// Bending stiffness EI of the beam [N m²]
        pub bending_stiffness: f64,
        /// Mass per length m of the beam [kg/m]
        pub mass_per_length: f64,
        /// Position x_1 of the grounded spring [m]
        pub spring_position: f64,
        /// Position x_2 of the oscillator [m]
        pub oscillator_position: f64,
        /// Position x_3 of the torsion spring [m]
        pub torsion_position: f64,
        /// Stiffness K_y1 of the grounded spring [N/m]
        pub spring_stiffness: f64,
        /// Stiffness K_y2 of the oscillator [N/m]
        pub oscillator_stiffness: f64,
        /// Damping C of the oscillator [N s/m]
        pub damping: f64,
        /// Mass of the oscillator [kg]
        pub mass: f64,
        /// Stiffness K'_z of the torsion spring [N m/rad]
        pub torsion_stiffness: f64,
    }

    let second_span = oscillator_position - spring_position;
    let third_span = torsion_position - oscillator_position;
    let last_span = length - torsion_position;

    pinned -> beam 1 { length: spring_position, bending_stiffness, mass_per_length }
           -> conn 2 -> beam 4 { length: second_span, bending_stiffness, mass_per_length }
           -> conn 5 -> beam 8 { length: third_span, bending_stiffness, mass_per_length }
           -> conn 9 -> beam 11 { length: last_span, bending_stiffness, mass_per_length }
           -> pinned;
    conn 2 <- spring 3 { stiffness: spring_stiffness } <- fixed;
    conn 5 <- spring 6 { stiffness: oscillator_stiffness, damping } <- mass 7 { mass } <- free;
    conn 9 <- torsion_spring 10 { stiffness: torsion_stiffness } <- fixed;
}

/// Section 4.1, first parameter set: α = 1, β = 1, e = 0.4 l, d = 0.8 l.
pub fn light_tip_body() -> TipBody {
    tip_body(1.0, 1.0, 0.4, 0.8)
}

/// Section 4.1, second parameter set: α = 10, β = 0.5, e = 0.1 l, d = 0.3 l.
pub fn heavy_tip_body() -> TipBody {
    tip_body(10.0, 0.5, 0.1, 0.3)
}

/// Section 4.1 with the paper's ratios α = mass/(m l), β = J_c/(m l³), e/l and d/l.
fn tip_body(alpha: f64, beta: f64, eccentricity: f64, depth: f64) -> TipBody {
    let (length, mass_per_length) = (1.0, 0.212058);
    TipBody {
        length,
        bending_stiffness: 33.8703,
        mass_per_length,
        mass: alpha * mass_per_length * length,
        inertia: beta * mass_per_length * length.powi(3),
        eccentricity: eccentricity * length,
        depth: depth * length,
    }
}

/// Section 4.2: K_y = 100 EI/l³ and K'_z = EI/l at both ends.
pub fn restrained_beam() -> RestrainedBeam {
    let (length, bending_stiffness) = (1.0_f64, 63476.125);
    let stiffness = 100.0 * bending_stiffness / length.powi(3);
    let torsion = bending_stiffness / length;
    RestrainedBeam {
        length,
        bending_stiffness,
        mass_per_length: 15.31526,
        left_stiffness: stiffness,
        left_torsion: torsion,
        right_stiffness: stiffness,
        right_torsion: torsion,
    }
}

/// Section 4.3: square steel section, K_y = 10 EI/l³, mass = 0.1 m l.
pub fn spring_and_mass() -> SpringAndMass {
    let (length, width, height) = (1.0_f64, 0.01_f64, 0.01_f64);
    let (youngs_modulus, density) = (200e9, 7800.0);
    let bending_stiffness = youngs_modulus * width * height.powi(3) / 12.0;
    let mass_per_length = density * width * height;
    SpringAndMass {
        length,
        bending_stiffness,
        mass_per_length,
        spring_position: 0.3 * length,
        mass_position: 0.4 * length,
        stiffness: 10.0 * bending_stiffness / length.powi(3),
        mass: 0.1 * mass_per_length * length,
    }
}

/// Section 4.4; EI belongs to a circular section of radius 25 mm, the paper's I is rounded.
pub fn two_spans() -> TwoSpans {
    TwoSpans {
        length: 1.0,
        bending_stiffness: 63476.125,
        mass_per_length: 15.3875,
        support_position: 0.4,
        spring_position: 0.75,
        stiffness: 190428.375,
        mass: 3.0775,
    }
}

/// Section 4.5: K_y1 = 5 EI/l³, K_y2 = 4 EI/l³, K'_z = 10 EI/l, mass = 0.12 m l, C = sqrt(EI m)/l.
pub fn damped_oscillator() -> DampedOscillator {
    let length = 1.0_f64;
    let bending_stiffness: f64 = 2.069e11 * 3.06796e-7;
    let mass_per_length = 7800.0 * 1.96349e-3;
    DampedOscillator {
        length,
        bending_stiffness,
        mass_per_length,
        spring_position: 0.2 * length,
        oscillator_position: 0.6 * length,
        torsion_position: 0.75 * length,
        spring_stiffness: 5.0 * bending_stiffness / length.powi(3),
        oscillator_stiffness: 4.0 * bending_stiffness / length.powi(3),
        damping: (bending_stiffness * mass_per_length).sqrt() / length,
        mass: 0.12 * mass_per_length * length,
        torsion_stiffness: 10.0 * bending_stiffness / length,
    }
}
