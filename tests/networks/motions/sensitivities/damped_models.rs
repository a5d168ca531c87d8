//! Structures with dashpots, in the plane and in a line.

use super::sampled::damped;
use mstmm::prelude::*;

system! {
    /// A portal with a damped brace, a damped absorber on its girder and friction in a hinge.
    pub(super) struct DampedFrame {
        height: f64, span: f64, place: f64, ea: f64, ei: f64, m: f64, brace: f64, c_brace: f64, k: f64, c: f64, mass: f64, friction: f64,
        dx: f64, dy: f64,
    }
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (0.0, height)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn girder at (place, height)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (span, height)
        -> pin 4 {} -> conn d
        -> beam 5 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn foot at (span, 0.0) <- pinned;
    conn b -> spring 6 { stiffness: brace, damping: c_brace } -> conn foot;
    conn girder <- along (dx, dy) <- spring 7 { stiffness: k, damping: c } <- mass 8 { mass } <- free;
    conn c -> torsion_damper 9 { damping: friction } -> conn d;
}

damped!(DampedFrame, {
    height: Even(1.0, 3.0), span: Even(2.0, 4.0), place: Even(0.5, 1.5), ea: Decades(1e5, 1e8), ei: Decades(1e3, 1e5),
    m: Decades(1.0, 30.0), brace: Decades(1e3, 1e6), c_brace: Decades(1.0, 300.0), k: Decades(1e3, 1e6), c: Decades(0.3, 100.0),
    mass: Decades(1.0, 100.0), friction: Decades(1.0, 300.0), dx: Even(0.2, 1.0), dy: Even(-1.0, -0.3),
});

system! {
    /// A body with an arm on struts along directions, one of which ends in a wheel, on a road that turns with friction.
    pub(super) struct Suspension {
        rear: f64, front: f64, sill: f64, mass: f64, inertia: f64, centre_x: f64, centre_y: f64, k: f64, c: f64, lean: f64, wheel: f64,
        tyre: f64, arm: f64, ea: f64, ei: f64, m: f64, turn: f64, friction: f64,
    }
    conn rear at (rear, sill) -> rigid_body 1 { mass, inertia, centre: (centre_x, centre_y) } -> conn front at (front, sill);
    conn rear <- along (lean, 1.0) <- spring 2 { stiffness: k, damping: c } <- fixed;
    conn front <- along (-0.25, 1.0) <- spring 3 { stiffness: k, damping: 0.5 * c } <- mass 4 { mass: wheel }
        <- spring 5 { stiffness: tyre } <- fixed;
    conn rear <- along (1.0, lean) <- spring 6 { stiffness: tyre } <- fixed;
    conn front -> beam 7 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn tip at (arm, sill + 0.25);
    conn tip <- along (lean, 1.0) <- damper 8 { damping: c } <- fixed;
    conn tip <- torsion_spring 9 { stiffness: turn, damping: friction } <- fixed;
}

damped!(Suspension, {
    rear: Even(-1.5, -0.5), front: Even(0.5, 1.5), sill: Even(0.2, 0.6), mass: Decades(10.0, 1e3), inertia: Decades(3.0, 300.0),
    centre_x: Even(0.1, 0.4), centre_y: Even(0.5, 1.0), k: Decades(1e3, 1e6), c: Decades(1.0, 300.0), lean: Even(0.1, 0.6),
    wheel: Decades(1.0, 30.0), tyre: Decades(1e4, 1e6), arm: Even(2.0, 3.0), ea: Decades(1e5, 1e8), ei: Decades(1e2, 1e5),
    m: Decades(1.0, 30.0), turn: Decades(1e2, 1e5), friction: Decades(0.1, 30.0),
});

system! {
    /// A line of beams on dampers, with a damped absorber.
    pub(super) struct DampedSpans {
        first: f64, second: f64, end: f64, ei: f64, m: f64, k: f64, c: f64, ground: f64, mass: f64, turn: f64, friction: f64,
    }
    pinned at 0.0 -> beam 1 { bending_stiffness: ei, mass_per_length: m } -> conn 2 at first
        -> beam 3 { bending_stiffness: ei, mass_per_length: 2.0 * m } -> conn 4 at second
        -> beam 5 { bending_stiffness: ei, mass_per_length: m } -> conn 6 at end;
    conn 2 <- damper 7 { damping: ground } <- fixed;
    conn 4 <- spring 8 { stiffness: k, damping: c } <- mass 9 { mass } <- free;
    conn 6 <- torsion_spring 10 { stiffness: turn, damping: friction } <- fixed;
    conn 6 <- spring 11 { stiffness: 2.0 * k } <- fixed;
}

damped!(DampedSpans, {
    first: Even(0.5, 1.0), second: Even(1.3, 2.0), end: Even(2.3, 3.5), ei: Decades(10.0, 1e4), m: Decades(0.3, 10.0),
    k: Decades(10.0, 1e4), c: Decades(0.01, 10.0), ground: Decades(0.01, 10.0), mass: Decades(0.1, 10.0), turn: Decades(1.0, 1e4),
    friction: Decades(0.01, 10.0),
});
