//! Plane structures with all that has numbers: loops, releases, bodies with ports, skew supports, directions, paths with masses.

use super::Workshop;
use super::sampled::undamped;
use crate::portal::Portal;
use mstmm::prelude::*;

undamped!(Portal, {
    height: Even(1.0, 4.0), span: Even(2.0, 5.0), machine_x: Even(0.5, 1.5), ea: Decades(1e5, 1e9), ei: Decades(1e4, 1e7),
    m: Decades(5.0, 100.0), brace: Decades(1e4, 1e8), machine: Decades(10.0, 3000.0), inertia: Decades(1.0, 300.0),
});

undamped!(Workshop, {
    height: Even(2.0, 4.0), span: Even(3.0, 5.0), machine_x: Even(1.0, 2.5), ea: Decades(1e5, 1e9), ei: Decades(1e4, 1e7),
    m: Decades(5.0, 100.0), brace: Decades(1e4, 1e8), machine: Decades(10.0, 3000.0), inertia: Decades(1.0, 300.0),
    offset: Even(-0.6, -0.1), k: Decades(1e4, 1e8), slope: Even(0.2, 1.5), absorber: Decades(1.0, 300.0),
    k_absorber: Decades(1e4, 1e7), hinge: Decades(1e3, 1e7), k_turn: Decades(1e3, 1e7),
});

system! {
    /// Two leaning stiles with three rungs, one of them braced: four loops.
    pub(super) struct Ladder {
        width: f64, lean: f64, first: f64, second: f64, third: f64, ea: f64, ei: f64, m: f64, rung_ei: f64, rung_m: f64, brace: f64,
    }
    let half = 0.5 * lean;
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn a at (half, first)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (lean, second)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (lean, third);
    fixed at (width, 0.0)
        -> beam 4 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn d at (width + half, first)
        -> beam 5 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn e at (width + lean, second)
        -> beam 6 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn f at (width, third);
    conn a -> beam 7 { axial_stiffness: ea, bending_stiffness: rung_ei, mass_per_length: rung_m } -> conn d;
    conn b -> beam 8 { axial_stiffness: ea, bending_stiffness: rung_ei, mass_per_length: rung_m } -> conn e;
    conn c -> beam 9 { axial_stiffness: ea, bending_stiffness: rung_ei, mass_per_length: rung_m } -> conn f;
    conn a -> spring 10 { stiffness: brace } -> conn e;
}

undamped!(Ladder, {
    width: Even(0.5, 1.5), lean: Even(-0.5, -0.1), first: Even(0.5, 1.0), second: Even(1.2, 2.0), third: Even(2.3, 3.5),
    ea: Decades(1e4, 1e8), ei: Decades(1e2, 1e5), m: Decades(1.0, 30.0), rung_ei: Decades(1.0, 1e6), rung_m: Decades(0.3, 30.0),
    brace: Decades(1e2, 1e7),
});

system! {
    /// Bars between pins, one of them lighter, with a mass at the top and a support that rolls on a slope.
    pub(super) struct Truss {
        span: f64, sag: f64, top: f64, lead: f64, ea: f64, ei: f64, m: f64, light: f64, mass: f64, run: f64, rise: f64,
    }
    pinned at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> pin 2 {}
        -> conn b at (0.5 * span, sag) -> pin 3 {}
        -> beam 4 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m }
        -> conn c at (span, 0.0) <- roller along (run, rise);
    pinned at (-0.125, 0.0)
        -> beam 5 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> pin 6 {}
        -> conn d at (lead, top) -> pin 7 {}
        -> beam 8 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: light } -> pin 9 {} -> conn b;
    conn b -> pin 10 {} -> beam 11 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: light } -> pin 12 {}
        -> conn e at (span, top);
    conn e -> pin 13 {} -> beam 14 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> pin 15 {} -> conn c;
    conn d -> pin 16 {} -> beam 17 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> pin 18 {} -> conn e;
    conn d -> point_mass 19 { mass };
    conn b -> point_mass 20 { mass: 2.0 * mass };
}

undamped!(Truss, {
    span: Even(2.0, 6.0), sag: Even(-0.5, -0.1), top: Even(1.0, 3.0), lead: Even(0.3, 1.0), ea: Decades(1e5, 1e8),
    ei: Decades(1e2, 1e5), m: Decades(1.0, 30.0), light: Decades(0.1, 3.0), mass: Decades(1.0, 1e3), run: Even(0.5, 2.0),
    rise: Even(-0.9, -0.2),
});

system! {
    /// A body off the axes of three beams and of a spring, with its mass centre elsewhere, and a second one at a free end.
    pub(super) struct ThreePorts {
        reach: f64, arm: f64, drop: f64, centre_x: f64, centre_y: f64, tip_x: f64, tip_y: f64, overhang: f64, ea: f64, ei: f64, m: f64,
        mass: f64, inertia: f64, tip_mass: f64, tip_inertia: f64, k: f64, dx: f64, dy: f64,
    }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn a at (reach, 0.0)
        -> rigid_body 2 { mass, inertia, centre: (centre_x, centre_y) } -> conn b at (reach + arm, 0.25)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn tip at (tip_x, tip_y)
        -> rigid_body 4 { mass: tip_mass, inertia: tip_inertia, centre: (tip_x + overhang, tip_y - overhang) };
    rigid_body 2 <- conn c at (reach, drop) <- along (dx, dy) <- spring 5 { stiffness: k } <- fixed;
    rigid_body 2 -> conn d at (reach + 0.25, 0.125)
        -> beam 6 { axial_stiffness: ea, bending_stiffness: 0.5 * ei, mass_per_length: m } -> free at (0.5, 1.5);
}

undamped!(ThreePorts, {
    reach: Even(0.7, 1.5), arm: Even(0.2, 0.6), drop: Even(-0.5, -0.1), centre_x: Even(0.8, 1.5), centre_y: Even(-0.2, -0.05),
    tip_x: Even(2.3, 3.0), tip_y: Even(0.3, 1.0), overhang: Even(0.1, 0.4), ea: Decades(1e4, 1e8), ei: Decades(1e2, 1e5),
    m: Decades(0.5, 20.0), mass: Decades(1.0, 100.0), inertia: Decades(0.1, 30.0), tip_mass: Decades(1.0, 100.0),
    tip_inertia: Decades(0.1, 30.0), k: Decades(1e2, 1e6), dx: Even(0.2, 1.0), dy: Even(-1.0, -0.2),
});

system! {
    /// Supports that roll and are guided along slopes, springs and a mass along directions, a held rotation.
    pub(super) struct Incline {
        knee_x: f64, knee_y: f64, end_x: f64, end_y: f64, low_x: f64, low_y: f64, run: f64, rise: f64, guide: f64, side: f64, up: f64,
        ea: f64, ei: f64, m: f64, k: f64, mass: f64, inertia: f64, turn: f64,
    }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn knee at (knee_x, knee_y)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> roller at (end_x, end_y) along (run, rise);
    conn knee -> beam 3 { axial_stiffness: ea, bending_stiffness: 2.0 * ei, mass_per_length: m }
        -> guided at (low_x, low_y) along (guide, -0.5);
    conn knee -> point_mass 4 { mass, inertia };
    conn knee <- along (side, up) <- spring 5 { stiffness: k } <- fixed;
    conn knee <- along (up, -side) <- spring 6 { stiffness: 0.25 * k } <- mass 7 { mass: 0.5 * mass } <- free;
    conn knee -> beam 8 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> held(rz) at (-0.5, knee_y + 1.0);
    conn knee <- torsion_spring 9 { stiffness: turn } <- fixed;
}

undamped!(Incline, {
    knee_x: Even(0.5, 1.0), knee_y: Even(0.3, 1.2), end_x: Even(1.8, 3.0), end_y: Even(-0.4, -0.1), low_x: Even(-1.0, -0.5),
    low_y: Even(-1.0, -0.5), run: Even(0.5, 2.0), rise: Even(-1.5, -0.2), guide: Even(0.3, 2.0), side: Even(-1.0, -0.2),
    up: Even(0.2, 1.0), ea: Decades(1e4, 1e8), ei: Decades(1e2, 1e5), m: Decades(0.5, 20.0), k: Decades(1e2, 1e6),
    mass: Decades(0.3, 100.0), inertia: Decades(0.01, 10.0), turn: Decades(1e1, 1e5),
});

system! {
    /// A ring of two bays whose members meet in an elastic hinge, a slider, a pin and a weld.
    pub(super) struct Joints {
        height: f64, bay: f64, far: f64, ea: f64, ei: f64, m: f64, k_x: f64, k_y: f64, turn: f64, slide_x: f64, slide_y: f64, k: f64,
    }
    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn a at (0.25, height)
        -> hinge 2 { stiffness_x: k_x, stiffness_y: k_y, stiffness_rz: turn } -> conn b
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn c at (bay, 1.25 * height)
        -> slider 4 { along: (slide_x, slide_y) } -> conn d
        -> beam 5 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn e at (far, height)
        -> pin 6 {} -> beam 7 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> pinned at (far, 0.125);
    conn c -> beam 8 { axial_stiffness: ea, bending_stiffness: 0.5 * ei, mass_per_length: 2.0 * m } -> pinned at (bay, -0.25);
    conn a -> spring 9 { stiffness: k } -> conn e;
    conn a -> torsion_spring 10 { stiffness: 2.0 * turn } -> conn c;
}

undamped!(Joints, {
    height: Even(1.0, 3.0), bay: Even(1.0, 2.0), far: Even(2.5, 4.0), ea: Decades(1e4, 1e8), ei: Decades(1e2, 1e5),
    m: Decades(0.5, 20.0), k_x: Decades(1e2, 1e7), k_y: Decades(1e2, 1e7), turn: Decades(1e1, 1e5), slide_x: Even(0.3, 1.0),
    slide_y: Even(-0.8, -0.2), k: Decades(1e2, 1e6),
});

system! {
    /// An arm with paths of masses: between two places, along a direction, and of a rotation.
    pub(super) struct Absorbers {
        x: f64, y: f64, tip_x: f64, tip_y: f64, ground: f64, dx: f64, dy: f64, ea: f64, ei: f64, m: f64, k: f64, soft: f64, mass: f64,
        turn: f64, inertia: f64,
    }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn a at (x, y)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn tip at (tip_x, tip_y);
    conn a -> spring 3 { stiffness: k } -> mass 4 { mass } -> spring 5 { stiffness: soft } -> mass 6 { mass: 0.5 * mass }
        -> spring 7 { stiffness: k } -> conn g at (ground, -0.75) <- fixed;
    conn tip <- along (dx, dy) <- spring 8 { stiffness: soft } <- mass 9 { mass } <- spring 10 { stiffness: k } <- fixed;
    conn tip <- torsion_spring 11 { stiffness: turn } <- inertia 12 { inertia } <- free;
    conn a <- spring 13 { stiffness: k } <- conn post at (0.0, 1.5) <- fixed;
}

undamped!(Absorbers, {
    x: Even(0.5, 1.2), y: Even(0.2, 0.8), tip_x: Even(1.5, 2.5), tip_y: Even(-0.4, -0.1), ground: Even(1.5, 3.0), dx: Even(0.2, 1.0),
    dy: Even(-1.0, -0.2), ea: Decades(1e4, 1e8), ei: Decades(1e2, 1e5), m: Decades(0.5, 20.0), k: Decades(1e2, 1e6),
    soft: Decades(1e2, 1e6), mass: Decades(0.1, 100.0), turn: Decades(1e1, 1e5), inertia: Decades(0.01, 10.0),
});

system! {
    /// A closed ring without supports, with a tie and a body.
    pub(super) struct Raft {
        width: f64, height: f64, skew: f64, ea: f64, ei: f64, m: f64, tie: f64, mass: f64, inertia: f64, centre: f64,
    }
    conn a at (0.0, 0.0)
        -> beam 1 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn b at (width, 0.0)
        -> beam 2 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: 2.0 * m } -> conn c at (width + skew, height)
        -> beam 3 { axial_stiffness: ea, bending_stiffness: ei, mass_per_length: m } -> conn d at (skew, height)
        -> beam 4 { axial_stiffness: ea, bending_stiffness: 4.0 * ei, mass_per_length: m } -> conn a;
    conn a -> spring 5 { stiffness: tie } -> conn c;
    conn d -> rigid_body 6 { mass, inertia, centre: (centre, height) };
}

undamped!(Raft, {
    width: Even(0.8, 2.0), height: Even(0.7, 2.0), skew: Even(0.2, 0.6), ea: Decades(1e4, 1e8), ei: Decades(1e2, 1e5),
    m: Decades(0.5, 20.0), tie: Decades(1e2, 1e7), mass: Decades(0.3, 100.0), inertia: Decades(0.05, 10.0), centre: Even(-0.4, -0.1),
});
