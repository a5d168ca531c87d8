//! Rotors as sketches of some topologies, each beside its stations.
#![expect(clippy::expect_used, reason = "a rotor that is refused fails the test")]

use crate::numbers::Random;
use crate::polynomial_elements::{Disc, Member, Shafts};
use mstmm::element::ParameterError;
use mstmm::prelude::*;
use mstmm::search::Spinning;
use std::cell::Cell;

/// A part of a shaft.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part {
    pub(crate) length: f64,
    pub(crate) ei: f64,
    pub(crate) m: f64,
    pub(crate) kga: f64,
    pub(crate) r: f64,
    pub(crate) rp: f64,
}

/// A rigid disc.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rim {
    pub(crate) mass: f64,
    pub(crate) id: f64,
    pub(crate) ip: f64,
}

/// The numbers of a rotor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Numbers {
    pub(crate) parts: [Part; 5],
    pub(crate) rims: [Rim; 3],
    pub(crate) springs: [f64; 4],
    /// The speed of the second spool over that of the first one.
    pub(crate) ratio: f64,
}

impl Numbers {
    /// Steps by a factor of ten, discs of 0 <= I_p/I_d <= 2, springs over eight decades, with and without shear.
    pub(crate) fn random(random: &mut Random) -> Self {
        let has_shear = random.chance(0.6);
        let mut part = || {
            let (length, ei, m) = (0.2 + random.unit(), 10f64.powf(random.unit()), 10f64.powf(random.unit() - 0.5));
            let r = m * 10f64.powf(-3.0 + random.unit());
            let kga = if has_shear { ei * 10f64.powf(0.7 + 2.0 * random.unit()) } else { f64::INFINITY };
            Part { length, ei, m, kga, r, rp: 2.0 * r * random.unit() }
        };
        let parts = [part(), part(), part(), part(), part()];
        let mut rim = || {
            let (mass, id) = (10f64.powf(random.unit() - 0.3), 10f64.powf(-2.0 + 1.5 * random.unit()));
            Rim { mass, id, ip: if random.chance(0.1) { 0.0 } else { 2.0 * id * random.unit() } }
        };
        let rims = [rim(), rim(), rim()];
        let mut spring = || 10f64.powf(-2.0 + 8.0 * random.unit());
        let springs = [spring(), spring(), spring(), spring()];
        Numbers { parts, rims, springs, ratio: 3.0 * random.unit() - 1.5 }
    }

    fn member(&self, part: usize, ends: [usize; 2], speed: f64) -> Member {
        let Part { length, ei, m, kga, r, rp } = self.parts[part];
        Member {
            ends,
            length,
            bending_stiffness: ei,
            mass: m,
            shear_stiffness: kga,
            rotary_inertia: r,
            polar_inertia: rp,
            speed,
        }
    }

    fn disc(&self, rim: usize, station: usize, speed: f64) -> Disc {
        let Rim { mass, id, ip } = self.rims[rim];
        Disc { station, mass, inertia: id, polar_inertia: ip, speed }
    }
}

thread_local! {
    /// The numbers of the rotor that is built: a sketch has no other fields than its speed.
    static NUMBERS: Cell<Option<Numbers>> = const { Cell::new(None) };
}

fn part(index: usize) -> Part {
    NUMBERS.get().expect("numbers are set").parts[index]
}

fn rim(index: usize) -> Rim {
    NUMBERS.get().expect("numbers are set").rims[index]
}

fn spring(index: usize) -> f64 {
    NUMBERS.get().expect("numbers are set").springs[index]
}

fn ratio() -> f64 {
    NUMBERS.get().expect("numbers are set").ratio
}

system! {
    /// Two discs between bearings, with ends that overhang.
    pub(crate) struct Between { speed: f64 }
    section s0 { length: part(0).length, bending_stiffness: part(0).ei, mass_per_length: part(0).m, shear_stiffness: part(0).kga, rotary_inertia: part(0).r, polar_inertia_per_length: part(0).rp, speed }
    section s1 { length: part(1).length, bending_stiffness: part(1).ei, mass_per_length: part(1).m, shear_stiffness: part(1).kga, rotary_inertia: part(1).r, polar_inertia_per_length: part(1).rp, speed }
    section s2 { length: part(2).length, bending_stiffness: part(2).ei, mass_per_length: part(2).m, shear_stiffness: part(2).kga, rotary_inertia: part(2).r, polar_inertia_per_length: part(2).rp, speed }
    section s3 { length: part(3).length, bending_stiffness: part(3).ei, mass_per_length: part(3).m, shear_stiffness: part(3).kga, rotary_inertia: part(3).r, polar_inertia_per_length: part(3).rp, speed }

    free -> beam 0 { ..s0 } -> conn a;
    fixed -> spring s0 { stiffness: spring(0) } -> conn a;
    conn a -> beam 1 { ..s1 } -> disc d0 { mass: rim(0).mass, inertia: rim(0).id, polar_inertia: rim(0).ip, speed } -> beam 2 { ..s2 } -> conn b;
    fixed -> spring s1 { stiffness: spring(1) } -> conn b;
    conn b -> beam 3 { ..s3 } -> disc d1 { mass: rim(1).mass, inertia: rim(1).id, polar_inertia: rim(1).ip, speed } -> free;
}

system! {
    /// An overhung disc on a clamped shaft with a bearing, and a torsion spring about it.
    pub(crate) struct Overhung { speed: f64 }
    section s0 { length: part(0).length, bending_stiffness: part(0).ei, mass_per_length: part(0).m, shear_stiffness: part(0).kga, rotary_inertia: part(0).r, polar_inertia_per_length: part(0).rp, speed }
    section s1 { length: part(1).length, bending_stiffness: part(1).ei, mass_per_length: part(1).m, shear_stiffness: part(1).kga, rotary_inertia: part(1).r, polar_inertia_per_length: part(1).rp, speed }

    fixed -> beam 0 { ..s0 } -> conn a;
    fixed -> spring s0 { stiffness: spring(0) } -> conn a;
    fixed -> torsion_spring t1 { stiffness: spring(1) } -> conn a;
    conn a -> beam 1 { ..s1 } -> disc d0 { mass: rim(0).mass, inertia: rim(0).id, polar_inertia: rim(0).ip, speed } -> free;
}

system! {
    /// A shaft with discs that nothing holds.
    pub(crate) struct Loose { speed: f64 }
    section s0 { length: part(0).length, bending_stiffness: part(0).ei, mass_per_length: part(0).m, shear_stiffness: part(0).kga, rotary_inertia: part(0).r, polar_inertia_per_length: part(0).rp, speed }
    section s1 { length: part(1).length, bending_stiffness: part(1).ei, mass_per_length: part(1).m, shear_stiffness: part(1).kga, rotary_inertia: part(1).r, polar_inertia_per_length: part(1).rp, speed }

    free -> disc d0 { mass: rim(0).mass, inertia: rim(0).id, polar_inertia: rim(0).ip, speed } -> beam 0 { ..s0 }
         -> disc d1 { mass: rim(1).mass, inertia: rim(1).id, polar_inertia: rim(1).ip, speed } -> beam 1 { ..s1 } -> free;
}

system! {
    /// Two spools, the outer one on a bearing to the ground and one between both, at another speed.
    pub(crate) struct Spools { speed: f64 }
    section s0 { length: part(0).length, bending_stiffness: part(0).ei, mass_per_length: part(0).m, shear_stiffness: part(0).kga, rotary_inertia: part(0).r, polar_inertia_per_length: part(0).rp, speed }
    section s1 { length: part(1).length, bending_stiffness: part(1).ei, mass_per_length: part(1).m, shear_stiffness: part(1).kga, rotary_inertia: part(1).r, polar_inertia_per_length: part(1).rp, speed }
    section s2 { length: part(2).length, bending_stiffness: part(2).ei, mass_per_length: part(2).m, shear_stiffness: part(2).kga, rotary_inertia: part(2).r, polar_inertia_per_length: part(2).rp, speed: ratio() * speed }

    free -> conn a;
    fixed -> spring s0 { stiffness: spring(0) } -> conn a;
    free -> disc d2 { mass: rim(2).mass, inertia: rim(2).id, polar_inertia: rim(2).ip, speed: ratio() * speed } -> conn d;
    fixed -> spring s1 { stiffness: spring(1) } -> conn d;
    conn d -> beam 2 { ..s2 } -> conn e -> spring s2 { stiffness: spring(2) } -> conn c;
    conn a -> beam 0 { ..s0 } -> disc d0 { mass: rim(0).mass, inertia: rim(0).id, polar_inertia: rim(0).ip, speed } -> conn c;
    conn c -> beam 1 { ..s1 } -> disc d1 { mass: rim(1).mass, inertia: rim(1).id, polar_inertia: rim(1).ip, speed } -> conn b -> pinned;
}

/// A rotor at a speed, as both tell it.
pub(crate) trait Topology: Sized {
    type System: Undamped<Parameter = f64> + Spinning<BuildError = ParameterError>;

    fn rotor(numbers: Numbers, speed: f64) -> mstmm::search::Rotor<Self::System>;

    fn shafts(numbers: &Numbers, speed: f64) -> Shafts;
}

macro_rules! topologies {
    ($($name:ident is $system:ident: |$n:ident, $speed:ident| $shafts:expr;)*) => {$(
        impl Topology for $name {
            type System = $system;

            fn rotor(numbers: Numbers, speed: f64) -> mstmm::search::Rotor<$system> {
                NUMBERS.set(Some(numbers));
                $name { speed }.build().expect("numbers are in range")
            }

            fn shafts($n: &Numbers, $speed: f64) -> Shafts {
                $shafts
            }
        }
    )*};
}

topologies! {
    Between is BetweenSystem: |n, speed| Shafts {
        stations: 5,
        members: (0..4).map(|k| n.member(k, [k, k + 1], speed)).collect(),
        discs: vec![n.disc(0, 2, speed), n.disc(1, 4, speed)],
        springs: vec![(1, None, n.springs[0]), (3, None, n.springs[1])],
        ..Shafts::default()
    };
    Overhung is OverhungSystem: |n, speed| Shafts {
        stations: 3,
        members: (0..2).map(|k| n.member(k, [k, k + 1], speed)).collect(),
        discs: vec![n.disc(0, 2, speed)],
        springs: vec![(1, None, n.springs[0])],
        torsion_springs: vec![(1, n.springs[1])],
        held: vec![0, 1],
    };
    Loose is LooseSystem: |n, speed| Shafts {
        stations: 3,
        members: (0..2).map(|k| n.member(k, [k, k + 1], speed)).collect(),
        discs: vec![n.disc(0, 0, speed), n.disc(1, 1, speed)],
        ..Shafts::default()
    };
    Spools is SpoolsSystem: |n, speed| Shafts {
        stations: 5,
        members: vec![
            n.member(0, [0, 1], speed),
            n.member(1, [1, 2], speed),
            n.member(2, [3, 4], n.ratio * speed),
        ],
        discs: vec![n.disc(0, 1, speed), n.disc(1, 2, speed), n.disc(2, 3, n.ratio * speed)],
        springs: vec![(0, None, n.springs[0]), (3, None, n.springs[1]), (4, Some(1), n.springs[2])],
        held: vec![4],
        ..Shafts::default()
    };
}
