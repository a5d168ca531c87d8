//! The overall determinants of sketches in space against Δ of the dynamic stiffness: one constant for all frequencies, so both have the same zeros.

use super::one_thing::{
    Ball, Bodied, Bracing, Cantilever, Cylindrical, Flexible, OnMount, Prismatic, Rolling, RollingAlong, Sprung,
    Turning, Universal, Upside,
};
use super::portal::PORTAL;
use super::workshop::WORKSHOP;
use mstmm::number::{DoubleDouble, Scalar};
use mstmm::prelude::*;

system! {
    /// A free ring of beams: a loop, and six rigid motions.
    struct Ring { ei: f64 }
    section side { axial_stiffness: 900.0, torsional_stiffness: 3.0, bending_stiffness: ei, mass_per_length: 1.5, polar_inertia_per_length: 0.25 }
    conn a at (0.0, 0.0, 0.0) -> beam 1 { ..side } -> conn b at (1.0, 0.25, 0.0) -> beam 2 { ..side } -> conn c at (1.0, 1.0, 0.5)
        -> beam 3 { ..side } -> conn a;
}

system! {
    /// A tripod of bars that carries a mass, braced at half its height, on balls.
    struct Tripod { ea: f64 }
    section leg { axial_stiffness: ea, bending_stiffness_y: 2.0, bending_stiffness_z: 5.0, mass_per_length: 0.7 }
    pinned at (1.0, 0.0, 0.0) -> bar 1 { ..leg } -> conn top at (0.0, 0.0, 2.0) <- point_mass 2 { mass: 0.3 };
    pinned at (-0.5, 0.8, 0.0) -> bar 3 { ..leg } -> conn top;
    pinned at (-0.5, -0.8, 0.0) -> bar 4 { ..leg } -> conn top -> bar 5 { ..leg } -> conn side at (2.0, 0.5, 2.5);
    conn side -> bar 6 { ..leg } -> pinned at (2.0, 1.5, 0.0);
    conn side -> bar 7 { ..leg } -> pinned at (2.5, -1.0, 0.0);
    conn side -> spring 8 { stiffness: 3.0 } -> conn top;
}

system! {
    /// Paths of one motion: between directions, of one motion that two points share, and about axes.
    struct Paths { mass: f64, k: f64 }
    section beam { axial_stiffness: 900.0, torsional_stiffness: 3.0, bending_stiffness: 2.0, mass_per_length: 1.5, polar_inertia_per_length: 0.25 }
    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..beam } -> conn a at (1.0, 0.0, 0.5) -> beam 2 { ..beam } -> conn b at (2.0, 0.5, 0.0);
    conn a <- along (1.0, 1.0, 2.0) <- mass 3 { mass } <- spring 4 { stiffness: k } <- fixed;
    conn a <- along (0.0, 1.0, 0.0) <- conn u -> along (1.0, 3.0, 0.0) -> conn b;
    conn u <- spring 5 { stiffness: 2.0 * k } <- mass 6 { mass } <- free;
    conn b <- about (0.0, 1.0, 1.0) <- torsion_spring 7 { stiffness: k } <- inertia 8 { inertia: 0.1 * mass } <- free;
    conn a <- about (1.0, 0.0, 0.0) <- torsion_spring 9 { stiffness: k } <- about (1.0, 1.0, 1.0) <- conn b;
}

/// The lowest frequencies, in parts of the first one, and how much the quotients may differ: 32 digits less those of waves and stiffness ratios.
const PARTS: [f64; 5] = [0.29, 0.73, 1.37, 2.19, 3.31];
const ROUNDING: f64 = 1e-20;

/// The largest difference of `det U_all / Δ` at some frequencies from that at the first, relative to that.
macro_rules! difference {
    ($model:expr) => {{
        let first = $model.build().unwrap().first_frequencies::<8>().unwrap();
        let first = first.iter().find(|root| root.lower > 0.0).unwrap().omega;
        let system = $model.build_as::<DoubleDouble>().unwrap();
        let quotients = PARTS.map(|part| {
            let omega = DoubleDouble::from(part * first);
            let (all, delta) = (system.overall_determinant(omega), system.characteristic(omega));
            let exponent = (all.exponent() - delta.exponent()).clamp(-900, 900);
            (all.mantissa() / delta.mantissa()).times_power_of_two(exponent as i32)
        });
        let apart = quotients.map(|own| (own / quotients[0] - DoubleDouble::from(1.0)).size());
        let worst = apart.into_iter().fold(0.0, |worst, one| if one <= worst { worst } else { one });
        println!(
            "{:60} {:3} unknowns, {worst:.1e}",
            stringify!($model),
            system.overall_matrix(DoubleDouble::from(1.0)).nrows()
        );
        worst
    }};
}

#[test]
fn overall_determinants_in_space_are_proportional_to_delta() {
    let differences = [
        difference!(Cantilever { l: 2.0 }),
        difference!(Rolling { l: 2.0 }),
        difference!(RollingAlong { l: 2.0 }),
        difference!(Upside { l: 2.0 }),
        difference!(Bodied { l: 2.0 }),
        difference!(OnMount { l: 2.0 }),
        difference!(Flexible { l: 2.0 }),
        difference!(Sprung { l: 2.0 }),
        difference!(Turning { l: 2.0 }),
        difference!(Ball { l: 2.0 }),
        difference!(Universal { l: 2.0 }),
        difference!(Prismatic { l: 2.0 }),
        difference!(Cylindrical { l: 2.0 }),
        difference!(Bracing { l: 2.0 }),
        difference!(Tripod { ea: 900.0 }),
        difference!(Ring { ei: 2.0 }),
        difference!(Paths { mass: 0.6, k: 40.0 }),
        difference!(PORTAL),
        difference!(WORKSHOP),
    ];
    assert!(differences.iter().all(|difference| *difference < ROUNDING));
}
