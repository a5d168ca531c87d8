//! Structures in a line.

use super::sampled::undamped;
use mstmm::prelude::*;

system! {
    /// Three spans with an oscillator between them, an elastic hinge, and a body at the end.
    pub(super) struct Spans {
        first: f64, second: f64, third: f64, centre: f64, ei: f64, m: f64, k: f64, turn: f64, mass: f64, inertia: f64,
    }
    fixed at 0.0 -> beam 1 { bending_stiffness: ei, mass_per_length: m } -> conn 2 at first
        -> beam 3 { bending_stiffness: ei, mass_per_length: 2.0 * m } -> conn h at second
        -> hinge 4 { stiffness_y: k, stiffness_rz: turn }
        -> beam 5 { bending_stiffness: ei, mass_per_length: m } -> conn e at third
        -> rigid_body 6 { mass, inertia, centre } -> conn 7 at third + 0.5;
    conn 2 <- spring 8 { stiffness: k } <- mass 9 { mass } <- spring 10 { stiffness: 0.5 * k } <- fixed;
    conn 2 <- torsion_spring 11 { stiffness: turn } <- inertia 12 { inertia: 0.25 * inertia } <- free;
    conn 7 <- spring 13 { stiffness: k } <- fixed;
}

undamped!(Spans, {
    first: Even(0.5, 1.5), second: Even(2.0, 3.0), third: Even(3.5, 5.0), centre: Even(3.5, 5.5), ei: Decades(1.0, 1e4),
    m: Decades(0.1, 10.0), k: Decades(1.0, 1e5), turn: Decades(1.0, 1e5), mass: Decades(0.1, 30.0), inertia: Decades(0.01, 10.0),
});

system! {
    /// A cantilever with point masses, springs to the ground and between its points.
    pub(super) struct PointMasses {
        a: f64, b: f64, tip: f64, ei: f64, m: f64, k: f64, tie: f64, turn: f64, mass: f64, inertia: f64, last: f64,
    }
    fixed at 0.0 -> beam 1 { bending_stiffness: ei, mass_per_length: m } -> conn a at a
        -> beam 2 { bending_stiffness: 0.5 * ei, mass_per_length: m } -> conn b at b
        -> beam 3 { bending_stiffness: 0.25 * ei, mass_per_length: 0.5 * m } -> conn tip at tip;
    conn a -> point_mass 4 { mass, inertia };
    conn b -> point_mass 5 { mass: 2.0 * mass };
    conn tip -> point_mass 6 { mass: last, inertia: 0.5 * inertia };
    conn b <- spring 7 { stiffness: k } <- fixed;
    conn a <- spring 8 { stiffness: tie } <- mass 9 { mass: last } <- spring 10 { stiffness: tie } <- conn tip;
    conn tip <- torsion_spring 11 { stiffness: turn } <- conn a;
}

undamped!(PointMasses, {
    a: Even(0.4, 1.0), b: Even(1.2, 2.0), tip: Even(2.2, 3.5), ei: Decades(1.0, 1e4), m: Decades(0.1, 10.0), k: Decades(1.0, 1e5),
    tie: Decades(1.0, 1e5), turn: Decades(1.0, 1e5), mass: Decades(0.1, 30.0), inertia: Decades(0.01, 10.0), last: Decades(0.1, 30.0),
});

system! {
    /// A girder of Gerber over supports, with a pin in its second span and a guided end.
    pub(super) struct Girder { pier: f64, joint: f64, quay: f64, end: f64, ei: f64, m: f64, load: f64, turn: f64, k: f64 }
    pinned at -0.5 -> beam 1 { bending_stiffness: ei, mass_per_length: m } -> conn pier at pier <- pinned;
    conn pier -> beam 2 { bending_stiffness: ei, mass_per_length: m } -> conn joint at joint
        -> pin 3 {} -> beam 4 { bending_stiffness: 2.0 * ei, mass_per_length: m } -> conn quay at quay <- pinned;
    conn quay -> beam 5 { bending_stiffness: ei, mass_per_length: 3.0 * m } -> guided at end;
    conn joint -> point_mass 6 { mass: load };
    conn pier <- torsion_spring 7 { stiffness: turn } <- fixed;
    conn joint <- spring 8 { stiffness: k } <- fixed;
}

undamped!(Girder, {
    pier: Even(0.5, 1.0), joint: Even(1.3, 2.0), quay: Even(2.5, 3.5), end: Even(4.0, 5.0), ei: Decades(1.0, 1e4),
    m: Decades(0.1, 10.0), load: Decades(0.1, 100.0), turn: Decades(1.0, 1e5), k: Decades(1.0, 1e5),
});

system! {
    /// A beam that hangs on a string, with a rod in soil to a mass, and shafts to a flywheel and between its points.
    pub(super) struct Hung {
        first: f64, second: f64, ei: f64, m: f64, length: f64, tension: f64, line: f64, k: f64, ea: f64, soil: f64, mass: f64, gj: f64,
        j: f64, disk: f64,
    }
    fixed at 0.0 -> beam 1 { bending_stiffness: ei, mass_per_length: m } -> conn a at first
        -> beam 2 { bending_stiffness: ei, mass_per_length: 2.0 * m } -> conn b at second;
    conn a <- string 3 { length, tension, mass_per_length: line, foundation_stiffness: k } <- fixed;
    conn b <- rod 4 { length: 0.5 * length, axial_stiffness: ea, mass_per_length: line, foundation_stiffness: soil } <- mass 5 { mass } <- free;
    conn b <- shaft 6 { length, torsional_stiffness: gj, inertia_per_length: j } <- inertia 7 { inertia: disk } <- free;
    conn a -> shaft 8 { length, torsional_stiffness: 0.5 * gj, inertia_per_length: j } -> conn b;
}

undamped!(Hung, {
    first: Even(0.5, 1.0), second: Even(1.5, 2.5), ei: Decades(1.0, 1e4), m: Decades(0.1, 10.0), length: Decades(0.3, 3.0),
    tension: Decades(1.0, 1e4), line: Decades(0.1, 10.0), k: Decades(0.1, 1e4), ea: Decades(1.0, 1e4), soil: Decades(0.1, 1e4),
    mass: Decades(0.1, 30.0), gj: Decades(1.0, 1e4), j: Decades(0.01, 10.0), disk: Decades(0.01, 10.0),
});
