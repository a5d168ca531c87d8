//! What supports, elements and parameters are called elsewhere.

use super::CONNECTION;
use super::elements::{AXIAL_STIFFNESS, BAR, SPEED, STRING};

/// What supports are called elsewhere.
const SUPPORTS: &[(&str, &str)] = &[
    ("clamped", "fixed"),
    ("clamp", "fixed"),
    ("encastre", "fixed"),
    ("built_in", "fixed"),
    ("hinged", "pinned"),
    ("hinge", "pinned"),
    ("simply_supported", "pinned"),
    ("simple", "pinned"),
    ("sliding", "guided"),
    ("slider", "guided"),
];

/// The support that a word means elsewhere.
pub(crate) fn meant_support(word: &str) -> Option<&'static str> {
    SUPPORTS.iter().find(|(name, _)| *name == word).map(|(_, support)| *support)
}

/// What elements are called elsewhere, and the keywords that are meant: of a model those that it has.
const ELEMENTS: &[(&str, &[&str])] = &[
    ("bearing", &["spring"]),
    ("bernoulli_beam", &["beam"]),
    ("bushing", &["hinge"]),
    ("cable", &[STRING, "beam"]),
    ("cardan", &["universal_joint"]),
    ("column", &["beam"]),
    ("corner", &[CONNECTION]),
    ("dashpot", &["damper"]),
    ("disk", &["disc"]),
    ("elasticbeamcolumn", &["beam"]),
    ("euler_beam", &["beam"]),
    ("flywheel", &["disc"]),
    ("frame", &["beam"]),
    ("hooke_joint", &["universal_joint"]),
    ("joint", &[CONNECTION]),
    ("link", &["rigid_link"]),
    ("member", &["beam"]),
    ("node", &[CONNECTION]),
    ("offset", &["rigid_link"]),
    ("rope", &[STRING]),
    ("rotor", &["disc", "beam"]),
    ("shock_absorber", &["damper"]),
    ("spherical_joint", &["ball_joint"]),
    ("truss", &[BAR, "rod"]),
    ("wire", &[STRING]),
    ("zerolength", &["hinge"]),
];

/// The keyword, among some, that a word means elsewhere, whose capitals and dimension do not matter.
pub(crate) fn meant_element(word: &str, keywords: &[&str]) -> Option<&'static str> {
    let word = word.to_lowercase();
    let plain = word.trim_end_matches("3d").trim_end_matches("2d").trim_end_matches('_');
    let (_, meant) = ELEMENTS.iter().find(|(name, _)| *name == word || *name == plain)?;
    meant.iter().copied().find(|name| *name == CONNECTION || keywords.contains(name))
}

/// What there is not, and what stands for it.
const ABSENT: &[(&[&str], &str)] = &[
    (
        &["plate", "shell", "membrane", "slab", "solid", "brick"],
        "there are lines and rigid bodies, and no plates, shells and solids",
    ),
    (&["gear", "gearbox", "belt", "pulley"], "there are no gears: two shafts turn at one rate, or are two models"),
    (
        &["arch", "arc", "curved_beam", "curvedbeam"],
        "there are no curved members: take straight pieces, `beam`s between places on the curve",
    ),
    (
        &["pipe", "tube", "cone", "rectangle", "i_beam", "ibeam"],
        "a cross section is a number of a `beam`: `let (area, i, ..) = sections::tube(outer, inner);`",
    ),
    (
        &["motor", "actuator", "sensor", "force", "load"],
        "loads are no part of a model: ask a built system, `frequency_response(load, entry)`",
    ),
];

/// What stands for an element that there is not.
pub(crate) fn absent_element(word: &str) -> Option<&'static str> {
    let word = word.to_lowercase();
    ABSENT.iter().find(|(words, _)| words.contains(&word.as_str())).map(|(_, advice)| *advice)
}

/// What a parameter is called elsewhere.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Meant {
    /// The same number: the first of these names that an element has.
    Same(&'static [&'static str]),
    /// A factor: the parameters that are products with it, each with the product.
    Factor(&'static [(&'static str, &'static str)]),
}

use Meant::{Factor, Same};

const BENDING: &str = "bending_stiffness";
const MASS: &str = "mass_per_length";
const TORSION: &str = "torsional_stiffness";
const OF_AREA: &[(&str, &str)] = &[(AXIAL_STIFFNESS, "e * area"), (MASS, "rho * area")];
const OF_DENSITY: &[(&str, &str)] = &[(MASS, "rho * area"), ("polar_inertia_per_length", "rho * (i_y + i_z)")];
const OF_MODULUS: &[(&str, &str)] = &[(AXIAL_STIFFNESS, "e * area"), (BENDING, "e * i")];
const OF_TORSION: &[(&str, &str)] = &[(TORSION, "g * j")];

/// Words in small letters without `_`; the first row of which an element has a parameter is meant.
const PARAMETERS: &[(&[&str], Meant)] = &[
    (&["ea"], Same(&[AXIAL_STIFFNESS])),
    (&["ei"], Same(&[BENDING])),
    (&["eiy", "eiyy"], Same(&["bending_stiffness_y", BENDING])),
    (&["eiz", "eizz"], Same(&["bending_stiffness_z", BENDING])),
    (&["gj"], Same(&[TORSION])),
    (&["gay", "kgay"], Same(&["shear_stiffness_y", "shear_stiffness"])),
    (&["gaz", "kgaz"], Same(&["shear_stiffness_z", "shear_stiffness"])),
    (&["ga", "kga"], Same(&["shear_stiffness"])),
    (&["m", "mu", "rhoa"], Same(&["mass", MASS])),
    (&["ip", "polarinertia"], Same(&["polar_inertia", "polar_inertia_per_length"])),
    (&["kxx", "kyy"], Same(&["stiffness"])),
    (&["kxy", "kyx"], Same(&["cross_stiffness"])),
    (&["cxx", "cyy"], Same(&["damping"])),
    (&["cxy", "cyx"], Same(&["cross_damping"])),
    (&["id", "diametralinertia"], Same(&["inertia"])),
    (&["omega", "spin", "spinspeed", "rotationspeed", "rpm"], Same(&["rotation_speed", SPEED])),
    (&["inertiax", "inertiay", "inertiaz", "ixx", "iyy", "izz", "ixy", "iyz", "izx"], Same(&["inertia"])),
    (&["center", "cog", "com", "cg"], Same(&["centre"])),
    (&["vecxz", "orientation", "roll", "rollangle", "localz", "referencevector"], Same(&["up"])),
    (&["along", "direction"], Same(&["axis"])),
    (&["kx"], Same(&["stiffness_x"])),
    (&["ky"], Same(&["stiffness_y"])),
    (&["kz"], Same(&["stiffness_z"])),
    (&["krx"], Same(&["stiffness_rx"])),
    (&["kry"], Same(&["stiffness_ry"])),
    (&["krz"], Same(&["stiffness_rz"])),
    (&["a", "area"], Factor(OF_AREA)),
    (&["e", "youngsmodulus", "modulus"], Factor(OF_MODULUS)),
    (&["g", "shearmodulus", "j", "torsionconstant"], Factor(OF_TORSION)),
    (&["iy", "iyy"], Factor(&[("bending_stiffness_y", "e * i_y")])),
    (&["iz", "izz"], Factor(&[("bending_stiffness_z", "e * i_z")])),
    (&["i", "iy", "iyy", "iz", "izz"], Factor(&[(BENDING, "e * i")])),
    (&["rho", "density"], Factor(OF_DENSITY)),
];

/// What a parameter means elsewhere, of those that an element has.
pub(crate) fn meant_parameter(name: &str, known: &[&str]) -> Option<Meant> {
    let plain = name.to_lowercase().replace('_', "");
    let fitting = PARAMETERS.iter().filter(|(words, _)| words.contains(&plain.as_str())).map(|(_, meant)| *meant);
    fitting.into_iter().find(|meant| match meant {
        Same(names) => names.iter().any(|name| known.contains(name)),
        Factor(products) => products.iter().any(|(name, _)| known.contains(name)),
    })
}
