//! Frames that are drawn: those of the examples, and supports, joints and paths of all kinds.

use crate::double_beam::DoubleBeamSystem;
use crate::portal::PortalSystem;
use crate::truss_bridge::TrussBridgeSystem;
use crate::vehicle::VehicleSystem;
use crate::{double_beam, portal, truss_bridge, vehicle};
use mstmm::elements::Spring;
use mstmm::network::{End, Freedoms, Member, Node, Section, Support, UndampedMember};
use mstmm::prelude::*;

system! {
    /// A girder with a motor on it, whose end rolls on a slope.
    pub(crate) struct Girder { span: f64, motor: f64 }

    pinned at (0.0, 0.0) -> beam 1 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> conn m at (0.5 * span, 0.0)
        -> beam 2 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> roller at (span, 0.0) along (4.0, 3.0);
    conn m -> rigid_body 3 { mass: motor, inertia: 2.0, centre: (0.5 * span, 0.25) };
}

system! {
    /// A star of beams, on a support of each kind.
    pub(crate) struct Star { arm: f64, ei: f64 }

    let slant = 0.6 * arm;
    let rise = 0.8 * arm;

    conn hub at (0.0, 0.0) -> beam e { axial_stiffness: 4e8, bending_stiffness: ei, mass_per_length: 20.0 } -> guided at (arm, 0.0);
    conn hub -> beam ne { axial_stiffness: 4e8, bending_stiffness: ei, mass_per_length: 20.0 } -> guided at (slant, rise) along (3.0, 4.0);
    conn hub -> beam nw { axial_stiffness: 4e8, bending_stiffness: ei, mass_per_length: 20.0 } -> held(x) at (-slant, rise);
    conn hub -> beam w { axial_stiffness: 4e8, bending_stiffness: ei, mass_per_length: 20.0 } -> fixed at (-arm, 0.0);
    conn hub -> beam sw { axial_stiffness: 4e8, bending_stiffness: ei, mass_per_length: 20.0 } -> held(rz) at (-slant, -rise);
    conn hub -> beam se { axial_stiffness: 4e8, bending_stiffness: ei, mass_per_length: 20.0 } -> conn free_end at (slant, -rise);
}

system! {
    /// A cantilever with a slider, on which a mass hangs between springs, another stands, and a torsion spring holds.
    pub(crate) struct Attached { l: f64 }

    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> conn a at (l, 0.0)
        -> beam 2 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> conn b at (2.0 * l, 0.0)
        -> slider 3 { along: (0.0, 1.0) }
        -> beam 4 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> conn c at (3.0 * l, 0.5 * l);
    conn a -> spring 5 { stiffness: 1e5 } -> mass 6 { mass: 50.0 } -> spring 7 { stiffness: 1e5 } -> conn ground at (l, -l) <- fixed;
    conn b <- torsion_spring 8 { stiffness: 1e5 } <- fixed;
    conn c <- along (0.0, 1.0) <- spring 9 { stiffness: 1e4 } <- mass 10 { mass: 20.0 } <- free;
    conn c <- point_mass 11 { mass: 80.0 };
    pinned at (1.4 * l, -0.8 * l) -> rod 12 { length: 1.0, axial_stiffness: 1e8, mass_per_length: 5.0 } -> conn b;
}

system! {
    /// A beam on a foundation beside one on springs, with one coordinate.
    pub(crate) struct Rail { l: f64 }

    guided at 0.0 -> beam 1 { bending_stiffness: 1e6, mass_per_length: 60.0, foundation_stiffness: 1e5 } -> conn a at l
        -> beam 2 { bending_stiffness: 1e6, mass_per_length: 60.0 } -> conn b at 2.0 * l
        -> hinge 3 { stiffness_y: 1e7, stiffness_rz: 1e5 }
        -> beam 4 { bending_stiffness: 1e6, mass_per_length: 60.0 } -> fixed at 3.5 * l;
    conn a -> spring 5 { stiffness: 1e5 } -> fixed;
    conn b -> spring 6 { stiffness: 1e5 } -> mass 7 { mass: 100.0 } -> free;
}

system! {
    /// A ring of four beams without any support.
    pub(crate) struct Ring { a: f64 }

    conn p at (0.0, 0.0) -> beam 1 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> conn q at (a, 0.2 * a)
        -> beam 2 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> conn r at (a, a)
        -> beam 3 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0, shear_stiffness: 1e8, rotary_inertia: 0.1 }
        -> conn s at (-0.1 * a, 0.8 * a)
        -> beam 4 { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 } -> conn p;
}

pub(crate) fn girder() -> GirderSystem {
    Girder { span: 6.0, motor: 150.0 }.build().unwrap()
}

pub(crate) fn star() -> StarSystem {
    Star { arm: 2.0, ei: 1e6 }.build().unwrap()
}

pub(crate) fn attached() -> AttachedSystem {
    Attached { l: 1.5 }.build().unwrap()
}

pub(crate) fn rail() -> RailSystem {
    Rail { l: 2.0 }.build().unwrap()
}

pub(crate) fn ring() -> RingSystem {
    Ring { a: 3.0 }.build().unwrap()
}

pub(crate) fn portal() -> PortalSystem {
    portal::steel().build().unwrap()
}

pub(crate) fn truss() -> TrussBridgeSystem {
    truss_bridge::footbridge().build().unwrap()
}

pub(crate) fn vehicle() -> VehicleSystem {
    vehicle::saloon().build().unwrap()
}

pub(crate) fn double_beam() -> DoubleBeamSystem {
    double_beam::steel().build().unwrap()
}

/// The nodes and members of a list: a portal on a body, with a hinge, a release across and ends beside their nodes.
pub(crate) fn list() -> ([Node<f64>; 5], [Member<UndampedMember<f64>>; 5]) {
    let section = Section { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 };
    let nodes = [
        Node::at([0.0, 0.0]).held(Support::Fixed.holds()),
        Node::at([0.0, 3.0]),
        Node::at([2.0, 3.0]).with_body(500.0, 40.0, [2.0, 3.6]),
        Node::at([4.0, 3.0]),
        Node::at([4.0, 0.0]).along([2.0, 1.0]),
    ];
    let members = [
        Member::new(0, 1, section),
        Member::new(1, End::of(2).at([1.7, 3.2]), section),
        Member::new(End::of(2).at([2.3, 3.2]), 3, section),
        Member::new(4, End::of(3).releasing(Freedoms::RZ), section),
        Member::new(1, 4, Spring { stiffness: 2e6 }),
    ];
    (nodes, members)
}

/// Does something with each of the ten frames, by its name.
macro_rules! for_each_frame {
    (|$name:ident, $frame:ident| $body:expr) => {{
        $crate::frames::for_each_frame!($name, $frame, $body, girder star attached rail ring portal truss vehicle double_beam);
        let (nodes, members) = $crate::frames::list();
        let list = mstmm::network::Network::new(&nodes, &members).unwrap();
        let ($name, $frame) = ("list", &list);
        $body;
    }};
    ($name:ident, $frame:ident, $body:expr, $($function:ident)*) => {$(
        {
            let ($name, $frame) = (stringify!($function), &$crate::frames::$function());
            $body;
        }
    )*};
}
pub(crate) use for_each_frame;
