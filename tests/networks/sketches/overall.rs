//! The overall determinants of sketches against Δ of the dynamic stiffness: one constant for all frequencies.

use super::first;
use super::frames::{
    HingedFrame, InclinedRoller, LFrame, NafemsCross, NafemsSquare, NafemsSquareSystem, Portal, PortalSystem,
    ThreePorts,
};
use crate::overall::{LOW, Report, double, largest_difference, quotient};
use crate::portal;
use mstmm::number::{DoubleDouble, Dual};
use mstmm::prelude::*;

system! {
    /// A pinned truss whose bars cross: a loop of bars, whose ends turn.
    struct Truss { ea: f64, ei: f64, m: f64 }

    pinned at (0.0, 0.0) -> pin a {} -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        -> pin b {} -> conn top at (1.0, 1.0)
        <- pin c {} <- beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        <- pin d {} <- pinned at (2.0, 0.0);
    conn top -> pin e {} -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        -> pin f {} -> conn side at (2.5, 1.2) <- point_mass 4 { mass: 0.3 };
    conn side -> pin g {} -> beam 5 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        -> pin h {} -> pinned at (3.0, 0.0);
    conn side -> spring 6 { stiffness: ea } -> conn foot at (1.0, -0.5) <- pinned;
    conn top -> spring 7 { stiffness: 0.5 * ea } -> conn foot;
}

system! {
    /// Two beams side by side with a spring and a torsion spring between the same points.
    struct Parallel { ea: f64, ei: f64, m: f64, k: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn a at (1.0, 0.2)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (2.0, 1.0);
    conn b -> beam 3 { axial_stiffness: ea, bending_stiffness: 2.0 * ei, mass_per_length: m } -> conn a;
    conn a -> spring 4 { stiffness: k } -> conn b;
    conn b <- torsion_spring 5 { stiffness: k } <- conn a;
}

system! {
    /// Paths of masses between directions, of one motion that two points share, of rotation, and one to the ground.
    struct Paths { mass: f64, k: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn a at (1.0, 0.0)
        -> beam 2 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn b at (2.0, 0.5);
    conn a <- along (1.0, 1.0) <- mass 3 { mass } <- spring 4 { stiffness: k } <- fixed;
    conn a <- along (0.0, 1.0) <- conn u -> along (1.0, 3.0) -> conn b;
    conn u <- spring 5 { stiffness: 2.0 * k } <- mass 6 { mass } <- free;
    conn b <- torsion_spring 7 { stiffness: k } <- inertia 8 { inertia: 0.1 * mass } <- free;
    conn a <- along (1.0, -2.0) <- spring 9 { stiffness: k } <- mass 10 { mass } <- spring 11 { stiffness: k } <- along (1.0, 0.0) <- conn b;
}

system! {
    /// A body on three supports between beams, with joints in series, a hinge, a slider and a skew support.
    struct Bodies { mass: f64, k: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn a at (1.0, 0.0)
        -> rigid_body hub { mass, inertia: 0.2, centre: (1.5, 0.25) } -> conn b at (2.0, 0.5)
        -> hinge 2 { stiffness_x: k, stiffness_y: 2.0 * k, stiffness_rz: 0.1 * k }
        -> beam 3 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn c at (3.0, 1.0)
        -> slider 4 { along: (1.0, 2.0) } -> pin 5 {} -> beam 6 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 }
        -> roller at (4.0, 0.0) along (3.0, 1.0);
    rigid_body hub <- conn d at (1.5, -0.5) <- held(y);
    rigid_body hub <- conn e at (1.75, -0.25) <- roller along (1.0, 5.0);
    conn d -> spring 7 { stiffness: k } -> conn c;
    conn d <- along (0.0, 1.0) <- spring 8 { stiffness: k } <- along (1.0, 1.0) <- conn b;
}

system! {
    /// A damped frame: dashpots at an angle, about z, beside a spring, and in a path with a mass.
    struct Damped { c: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn a at (1.0, 0.0)
        -> beam 2 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> conn b at (2.0, 1.0)
        -> beam 3 { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 } -> pinned at (3.0, 0.0);
    fixed at (2.0, 0.0) -> damper 4 { damping: c } -> conn b;
    conn a -> torsion_damper 5 { damping: 0.1 * c } -> conn b;
    conn a -> spring 6 { stiffness: 30.0, damping: c } -> conn b;
    conn b <- along (0.0, 1.0) <- spring 7 { stiffness: 5.0, damping: c } <- mass 8 { mass: 0.4 } <- free;
}

system! {
    /// Two spans with one coordinate beside a third, which closes a loop through a pin, and a body on two supports.
    struct Line { ei: f64, k: f64 }

    pinned at 0.0 -> beam 1 { bending_stiffness: ei, mass_per_length: 1.0 } -> conn a at 1.0
        -> beam 2 { bending_stiffness: ei, mass_per_length: 1.0 } -> conn b at 2.5
        -> pin 3 {} -> beam 4 { bending_stiffness: 2.0 * ei, mass_per_length: 2.0 } -> conn a;
    conn b -> hinge 5 { stiffness_y: k, stiffness_rz: 0.2 * k } -> conn c
        -> rigid_body 6 { mass: 0.3, inertia: 0.1, centre: 2.7 } -> conn d at 3.0 <- guided;
    rigid_body 6 <- conn e at 3.2 <- pinned;
    conn a <- spring 7 { stiffness: k } <- mass 8 { mass: 0.2 } <- spring 9 { stiffness: k } <- conn b;
    conn a <- torsion_spring 10 { stiffness: k } <- inertia 11 { inertia: 0.1 } <- torsion_spring 12 { stiffness: k } <- fixed;
}

/// Adds an undamped model, with frequencies from below its first one on.
macro_rules! undamped {
    ($report:ident, $model:ident { $($fields:tt)* }) => {
        let model = $model { $($fields)* };
        let found = first(&model.build().unwrap());
        let omega = found.iter().find(|root| root.omega > 0.0).unwrap().omega;
        undamped!($report, stringify!($model), model, omega);
    };
    ($report:ident, $name:expr, $model:ident, $omega:ident) => {
        let system = $model.build_as::<DoubleDouble>().unwrap();
        let constants = LOW.map(|part| {
            let omega = double(part * $omega);
            quotient(system.overall_determinant(omega), system.characteristic(omega))
        });
        let unknowns = system.overall_matrix(double(1.0)).nrows();
        $report.add($name, LOW[0] * $omega, (unknowns, largest_difference(&constants)));
    };
}

#[test]
fn overall_determinants_of_sketches_are_proportional_to_delta() {
    let mut report = Report::default();
    undamped!(report, NafemsCross { length: 5.0, ea: 3.125e9, ei: 4069010.4166666665, m: 125.0 });
    undamped!(report, NafemsSquare { side: 10.0, ea: 1.25e10, ei: 65104166.666666664, m: 500.0 });
    undamped!(report, LFrame { height: 1.0, width: 1.5, ea: 1e6, ei: 100.0, m: 1.0 });
    undamped!(report, Portal { side: 2.0, ea: 4e8, ei: 1e6, m: 20.0 });
    undamped!(report, HingedFrame { height: 2.0, ea: 2e7, ei: 5000.0, m: 6.0 });
    undamped!(report, InclinedRoller { length: 2.0, ea: 3e6, ei: 500.0, m: 2.0 });
    undamped!(report, ThreePorts { ea: 1e6, ei: 150.0, m: 1.2, stiffness: 900.0 });
    undamped!(report, Truss { ea: 1e4, ei: 2.0, m: 0.7 });
    undamped!(report, Parallel { ea: 1e4, ei: 2.0, m: 0.7, k: 5.0 });
    undamped!(report, Paths { mass: 0.6, k: 40.0 });
    undamped!(report, Bodies { mass: 2.5, k: 40.0 });
    undamped!(report, Line { ei: 3.0, k: 20.0 });
    let (model, first) = (portal::steel(), first(&portal::steel().build().unwrap())[0].omega);
    undamped!(report, "the portal of the example", model, first);
    report.judge();
}

#[test]
fn the_overall_determinant_of_a_damped_sketch_is_proportional_to_delta() {
    let mut report = Report::default();
    let system = Damped { c: 0.8 }.build_as::<DoubleDouble>().unwrap();
    let constants = LOW.map(|part| {
        let lambda = Complex::new(double(0.5 - part), double(2.0 * part));
        quotient(system.overall_determinant(lambda), system.characteristic(lambda))
    });
    report.add("damped frame", 2.0 * LOW[0], (DampedSystem::N, largest_difference(&constants)));
    report.judge();
}

/// A path has half of a state at both of its ends; a cut adds a whole state, and a free root its displacements.
#[test]
fn the_number_of_unknowns_is_that_of_boundaries_and_cuts() {
    assert_eq!(PortalSystem::N, 3 + 3);
    assert_eq!(NafemsSquareSystem::N, 6 + 3);
    // the foot, and the cuts of a beam and of both springs; conn b has its displacements from the cut of the beam
    assert_eq!(ParallelSystem::N, 3 + 6 + 2 + 2);
}

/// Numbers with a slope, and complex ones, have the values of real ones.
#[test]
fn the_overall_determinant_has_a_slope_and_complex_frequencies() {
    let portal = Portal { side: 2.0, ea: 4e8, ei: 1e6, m: 20.0 }.build().unwrap();
    let at = |omega: f64| portal.overall_determinant(omega).value();
    let (omega, step) = (90.0, 1e-3);
    let dual = portal.overall_determinant(Dual::variable(omega)).value();
    let difference = (at(omega + step) - at(omega - step)) / (2.0 * step);
    assert!((dual.derivative / difference - 1.0).abs() < 1e-6, "{} and {difference}", dual.derivative);
    let complex = portal.overall_determinant(Complex::new(0.0, omega)).value();
    assert!((complex.re / at(omega) - 1.0).abs() < 1e-12 && complex.im.abs() < 1e-12 * complex.re.abs());
    assert_eq!(dual.value, at(omega));
}
