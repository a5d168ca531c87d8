//! Chains that are hard: slender and stocky beams, loads beside buckling, stiff foundations, cut-on and cut-off.

use super::chain::{Chain, Link};
use crate::support::random_tree::Random;
use mstmm::element::Support;
use mstmm::elements::GeneralBeam;
use std::f64::consts::PI;

const SUPPORTS: [Support; 4] = [Support::Fixed, Support::Pinned, Support::Guided, Support::Free];

/// A beam with unit bending stiffness, mass and length, and nothing else.
pub(crate) const PLAIN: GeneralBeam<f64> = GeneralBeam {
    length: 1.0,
    bending_stiffness: 1.0,
    mass_per_length: 1.0,
    shear_stiffness: f64::INFINITY,
    rotary_inertia: 0.0,
    axial_force: 0.0,
    foundation_stiffness: 0.0,
    foundation_shear_stiffness: 0.0,
};

/// A model and frequencies at which it is counted and searched besides.
#[derive(Clone, Debug)]
pub(crate) struct Named {
    pub(crate) chain: Chain,
    pub(crate) at: Vec<f64>,
}

impl Named {
    fn of(tip: Support, links: Vec<Link>, root: Support) -> Self {
        Named { chain: Chain { tip, links, root }, at: Vec::new() }
    }
}

pub(crate) fn decade(random: &mut Random, from: f64, to: f64) -> f64 {
    10f64.powf(from + (to - from) * random.unit())
}

/// A number with few bits.
fn short(random: &mut Random, from: f64, to: f64) -> f64 {
    ((from + (to - from) * random.unit()) * 64.0).round() / 64.0
}

/// A beam with shear and rotary inertia of a slenderness.
fn slender(random: &mut Random, slenderness: f64) -> GeneralBeam<f64> {
    let [length, bending_stiffness, mass_per_length] = [0, 1, 2].map(|_| short(random, 0.5, 2.0));
    let square = slenderness * slenderness / (length * length);
    GeneralBeam {
        length,
        bending_stiffness,
        mass_per_length,
        shear_stiffness: bending_stiffness * square * (0.2 + 0.2 * random.unit()),
        rotary_inertia: mass_per_length / square,
        ..PLAIN
    }
}

/// A beam of one of some slendernesses.
fn slender_as<const N: usize>(random: &mut Random, slenderness: [f64; N]) -> GeneralBeam<f64> {
    let slenderness = random.pick(slenderness);
    slender(random, slenderness)
}

/// A beam between stocky and slender.
fn any_slender(random: &mut Random) -> GeneralBeam<f64> {
    let slenderness = decade(random, 0.0, 5.0);
    slender(random, slenderness)
}

/// A beam of any kind, with little compression.
fn any(random: &mut Random) -> GeneralBeam<f64> {
    let mut beam = any_slender(random);
    let scale = beam.bending_stiffness / (beam.length * beam.length);
    if random.chance(0.3) {
        beam.shear_stiffness = f64::INFINITY;
    }
    if random.chance(0.3) {
        beam.rotary_inertia = 0.0;
    }
    if random.chance(0.5) {
        beam.axial_force = scale * if random.chance(0.6) { -random.unit() } else { decade(random, -2.0, 4.0) };
        if beam.shear_stiffness < f64::INFINITY {
            beam.axial_force = beam.axial_force.max(-0.3 * beam.shear_stiffness);
        }
    }
    if random.chance(0.4) {
        beam.foundation_stiffness = scale / (beam.length * beam.length) * decade(random, -2.0, 6.0);
    }
    if random.chance(0.2) {
        beam.foundation_shear_stiffness = scale * decade(random, -2.0, 3.0);
    }
    beam
}

fn between(random: &mut Random) -> Link {
    match random.below(8) {
        0 => Link::Spring(decade(random, -2.0, 6.0)),
        1 => Link::TorsionSpring(decade(random, -2.0, 6.0)),
        2 => Link::Mass { mass: decade(random, -2.0, 2.0), inertia: decade(random, -3.0, 1.0) },
        3 => Link::Body {
            mass: short(random, 0.25, 4.0),
            central: short(random, 0.0625, 1.0),
            centre_x: short(random, -0.5, 0.5),
            output_x: short(random, -0.5, 0.5),
        },
        4 => Link::RotationalHinge(if random.chance(0.3) { 0.0 } else { decade(random, -3.0, 6.0) }),
        5 => Link::ShearHinge(decade(random, -3.0, 6.0)),
        6 => Link::Lever(short(random, -0.5, 0.5)),
        _ => Link::Mass { mass: decade(random, -2.0, 2.0), inertia: 0.0 },
    }
}

/// Chains of two to six beams with links between them, now and then beams side by side.
pub(crate) fn chains(random: &mut Random) -> Named {
    let mut links = vec![Link::Beam(any(random))];
    for _ in 0..1 + random.below(5) {
        if random.chance(0.7) {
            links.push(between(random));
        }
        if random.chance(0.15) {
            links.push(Link::Side(random.pick(SUPPORTS), any(random)));
        }
        links.push(Link::Beam(any(random)));
    }
    Named::of(random.pick(SUPPORTS), links, random.pick(SUPPORTS))
}

/// Slender and stocky beams in a row.
pub(crate) fn slender_and_stocky(random: &mut Random) -> Named {
    let mut links = Vec::new();
    for _ in 0..1 + random.below(3) {
        let slenderness = random.pick([1.0, 1.0, 3.0, 1e3, 1e5]);
        links.push(Link::Beam(slender(random, slenderness)));
    }
    Named::of(random.pick(SUPPORTS), links, random.pick(SUPPORTS))
}

/// Pinned columns within `10^-3..10^-15` of a critical load, stiff in shear or not, whole or in pieces.
pub(crate) fn beside_buckling(random: &mut Random) -> Named {
    let mut beam = slender_as(random, [1.0, 5.0, 1e3]);
    if random.chance(0.4) {
        beam.shear_stiffness = f64::INFINITY;
    }
    if random.chance(0.4) {
        beam.foundation_stiffness = decade(random, -1.0, 7.0) * beam.bending_stiffness / beam.length.powi(4);
    }
    let (ei, f, k) = (beam.bending_stiffness, 1.0 / beam.shear_stiffness, beam.foundation_stiffness);
    let load = |n: f64| {
        let wave = (n * PI / beam.length).powi(2);
        let bending = ei * wave;
        bending / (1.0 + bending * f) + k / wave
    };
    let critical = (1..200).map(|n| load(f64::from(n))).fold(f64::INFINITY, f64::min);
    let side = random.pick([-1.0, 1.0]);
    beam.axial_force = -critical * (1.0 + side * 10f64.powi(-3 - random.below(13) as i32));
    if f > 0.0 && beam.axial_force <= -1.0 / f {
        beam.axial_force = -0.5 / f;
    }
    let pieces = random.pick([1, 1, 2, 7]);
    Named::of(Support::Pinned, split(&beam, pieces), Support::Pinned)
}

/// A beam in pieces of equal length, whose number is one at which the lengths have few bits.
pub(crate) fn split(beam: &GeneralBeam<f64>, pieces: usize) -> Vec<Link> {
    let piece = GeneralBeam { length: beam.length / pieces as f64, ..*beam };
    vec![Link::Beam(piece); pieces]
}

/// Foundations of up to 1e12 EI/l⁴ beside soft ones.
pub(crate) fn stiff_foundations(random: &mut Random) -> Named {
    let mut links = Vec::new();
    for _ in 0..1 + random.below(3) {
        let mut beam = slender_as(random, [1.0, 30.0, 1e5]);
        let unit = beam.bending_stiffness / beam.length.powi(4);
        beam.foundation_stiffness = unit * random.pick([0.0, 1e-3, 1.0, 1e4, 1e8, 1e12]);
        if random.chance(0.5) {
            beam.shear_stiffness = f64::INFINITY;
        }
        if random.chance(0.3) {
            beam.axial_force = -1.9 * random.unit() * (beam.foundation_stiffness * beam.bending_stiffness).sqrt();
            if beam.shear_stiffness < f64::INFINITY {
                beam.axial_force = beam.axial_force.max(-0.5 * beam.shear_stiffness);
            }
        }
        links.push(Link::Beam(beam));
    }
    let mut named = Named::of(random.pick(SUPPORTS), links, random.pick(SUPPORTS));
    for link in &named.chain.links {
        if let Link::Beam(beam) = link
            && beam.foundation_stiffness > 0.0
        {
            named.at.push((beam.foundation_stiffness / beam.mass_per_length).sqrt());
        }
    }
    named
}

/// Beams at their cut-off of thickness shear and at their cut-on.
pub(crate) fn at_cut_off(random: &mut Random) -> Named {
    let mut beam = slender_as(random, [1.0, 3.0, 10.0, 100.0]);
    if random.chance(0.4) {
        beam.foundation_stiffness = decade(random, -1.0, 4.0);
    }
    if random.chance(0.4) {
        beam.axial_force = random.unit() * 0.5 * beam.shear_stiffness;
    }
    let mut at = vec![(beam.shear_stiffness / beam.rotary_inertia).sqrt()];
    if beam.foundation_stiffness > 0.0 {
        at.push((beam.foundation_stiffness / beam.mass_per_length).sqrt());
    }
    let pieces = random.pick([1, 1, 2, 4]);
    let mut named = Named::of(random.pick(SUPPORTS), split(&beam, pieces), random.pick(SUPPORTS));
    at.extend([at[0] * (1.0 + 1e-12), at[0] * (1.0 - 1e-12)]);
    named.at = at;
    named
}

/// Compression next to where a section has no stiffness left, on a foundation that holds it.
pub(crate) fn next_to_no_shear(random: &mut Random) -> Named {
    let mut beam = slender_as(random, [1.0, 2.0]);
    let ga = beam.shear_stiffness;
    beam.axial_force = -ga * (1.0 - 10f64.powi(-1 - random.below(12) as i32));
    beam.foundation_stiffness = ga * ga / beam.bending_stiffness * decade(random, 0.1, 2.0);
    Named::of(random.pick(SUPPORTS), vec![Link::Beam(beam)], random.pick(SUPPORTS))
}

/// Free beams, with all but bending zero in turn, whole and in pieces.
pub(crate) fn free_beams(random: &mut Random) -> Named {
    let mut beam = any_slender(random);
    if random.chance(0.5) {
        beam.shear_stiffness = f64::INFINITY;
    }
    if random.chance(0.5) {
        beam.rotary_inertia = 0.0;
    }
    if random.chance(0.3) {
        beam.axial_force = decade(random, -3.0, 3.0);
    }
    let ends = [Support::Free, Support::Guided];
    let pieces = random.pick([1, 2, 7, 30]);
    Named::of(random.pick(ends), split(&beam, pieces), random.pick(ends))
}

/// Equal beams from supports of their own to one point.
pub(crate) fn side_by_side(random: &mut Random) -> Named {
    let beam = any(random);
    let support = random.pick([Support::Fixed, Support::Pinned]);
    let mut links = vec![Link::Beam(beam)];
    for _ in 0..1 + random.below(3) {
        links.push(Link::Side(support, beam));
    }
    links.push(Link::Beam(any(random)));
    Named::of(support, links, random.pick(SUPPORTS))
}

/// A family by its name.
pub(crate) type Family = (&'static str, fn(&mut Random) -> Named);

pub(crate) const FAMILIES: [Family; 8] = [
    ("chains", chains),
    ("slender and stocky", slender_and_stocky),
    ("beside buckling", beside_buckling),
    ("stiff foundations", stiff_foundations),
    ("at the cut-off", at_cut_off),
    ("next to no shear", next_to_no_shear),
    ("free beams", free_beams),
    ("side by side", side_by_side),
];
