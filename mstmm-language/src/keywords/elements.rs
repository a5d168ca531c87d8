//! The elements of the language: which parameters each keyword has, and which type of the core it is.

use super::dimension::Dimension;
use mstmm_plan::Space;

/// What the language knows of an element of the core along a line, or in the plane: a test compares it with the core.
///
/// Naming a parameter selects the type: what is not named is neither in the mathematics nor in the code.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Keyword {
    pub(crate) name: &'static str,
    /// Space of the states at both ends.
    pub(crate) space: Space,
    /// The parameters that must be named.
    pub(crate) required: &'static [&'static str],
    /// The parameters that may be left out.
    pub(crate) optional: &'static [&'static str],
    /// Parameters that say the same in different ways: one of them is named.
    pub(crate) one_of: &'static [&'static str],
    /// What it may be, cheapest first: it is the first type that has all named parameters.
    pub(crate) types: &'static [TypeRow],
    /// The type that moves such a type across itself: an `InPlane` of it stretches as well and has the axial stiffness.
    pub(crate) wrapper: Option<&'static str>,
    /// Whether it stands between places alone.
    pub(super) needs_places: bool,
}

/// The wrapper of what stretches.
pub(super) const IN_PLANE: Option<&str> = Some("InPlane");

/// The parameter that what stretches has beside those of its type.
pub(crate) const AXIAL_STIFFNESS: &str = "axial_stiffness";

/// A type in `mstmm_core::elements`.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct TypeRow {
    pub(crate) name: &'static str,
    /// Its parameters beside those that the keyword requires, in the words of the language; what is not named of them is [`neutral`].
    pub(crate) parameters: &'static [&'static str],
    /// Parameters whose field in the type has another name: `(parameter, field)`.
    pub(crate) renamed: &'static [(&'static str, &'static str)],
}

/// The value of a parameter that is not there.
pub(crate) fn neutral(parameter: &str) -> f64 {
    match parameter {
        // what is not named is rigid
        "shear_stiffness" | "stiffness_x" | "stiffness_y" | "stiffness_rz" => f64::INFINITY,
        _ => 0.0,
    }
}

impl Keyword {
    /// Whether it stretches beside what its type is.
    pub(crate) fn stretches(&self) -> bool {
        self.wrapper == IN_PLANE
    }

    /// The parameters that must be named, and those that may be.
    pub(crate) fn parameters(&self) -> [Vec<&'static str>; 2] {
        [self.required.to_vec(), [self.optional, self.one_of].concat()]
    }

    /// The type that has all named parameters. A name that the keyword has not is an error elsewhere.
    pub(crate) fn type_with(&self, is_named: impl Fn(&str) -> bool) -> &'static TypeRow {
        let named = || self.optional.iter().chain(self.one_of).filter(|name| is_named(name));
        let has_all = |row: &&TypeRow| named().all(|name| row.parameters.contains(name));
        self.types.iter().find(has_all).unwrap_or(&self.types[self.types.len() - 1])
    }
}

impl TypeRow {
    /// The field of a parameter.
    pub(crate) fn field<'p>(&self, parameter: &'p str) -> &'p str {
        self.renamed.iter().find(|(name, _)| *name == parameter).map_or(parameter, |(_, field)| *field)
    }
}

/// The parameters of damping.
pub(crate) const DAMPING: &[&str] = &["loss_factor", "kelvin_voigt_time", "external_damping"];

const SPRING: &[&str] = &["damping", "loss_factor", "kelvin_voigt_time"];

/// The parameters of a spring beside a rotor.
pub(crate) const CROSS: &[&str] = &["cross_stiffness", "cross_damping"];
const OF_LINE_SPRING: &[&str] = &["damping", "loss_factor", "kelvin_voigt_time", "cross_stiffness", "cross_damping"];

/// The optional parameters of a beam, and those of them that are no damping.
pub(super) const OF_BEAM: &[&str] = &[
    "shear_stiffness",
    "rotary_inertia",
    "axial_force",
    "foundation_stiffness",
    "foundation_shear_stiffness",
    "loss_factor",
    "kelvin_voigt_time",
    "external_damping",
];
const UNDAMPED: &[&str] =
    &["shear_stiffness", "rotary_inertia", "axial_force", "foundation_stiffness", "foundation_shear_stiffness"];
/// The parameters of a beam that spins about its axis, beside its rotary inertia, and its speed, as that of a disc.
pub(crate) const SPEED: &str = "speed";
pub(crate) const SPIN: &[&str] = &["polar_inertia_per_length", SPEED];

/// The optional parameters of a beam along a line, and those of one that spins.
const OF_LINE_BEAM: &[&str] = &[
    "shear_stiffness",
    "rotary_inertia",
    "axial_force",
    "foundation_stiffness",
    "foundation_shear_stiffness",
    "loss_factor",
    "kelvin_voigt_time",
    "external_damping",
    "polar_inertia_per_length",
    SPEED,
];
const SPINNING: &[&str] = &[
    "shear_stiffness",
    "rotary_inertia",
    "axial_force",
    "foundation_stiffness",
    "foundation_shear_stiffness",
    "polar_inertia_per_length",
    SPEED,
];
const DAMPED_SPINNING: &[&str] = &[
    "shear_stiffness",
    "rotary_inertia",
    "axial_force",
    "foundation_stiffness",
    "foundation_shear_stiffness",
    "kelvin_voigt_time",
    "external_damping",
    "polar_inertia_per_length",
    SPEED,
];
const SHEAR: &[&str] = &["shear_stiffness", "rotary_inertia"];
const FOUNDATION: &[&str] = &["foundation_stiffness", "foundation_shear_stiffness"];

/// A string: a path of one motion, or a member between two places of the plane.
pub(crate) const STRING: &str = "string";

pub(super) const OF_STRING: &[&str] = &["foundation_stiffness", "external_damping"];

#[rustfmt::skip]
pub(super) const STRINGS: &[TypeRow] = &[
    row("TautString", &["foundation_stiffness"]),
    row("DampedString", OF_STRING),
];

const BENDING: &[&str] = &["length", "bending_stiffness", "mass_per_length"];
const STRETCHING: &[&str] = &["length", AXIAL_STIFFNESS, "bending_stiffness", "mass_per_length"];

const TAPERS: &[&str] = &[
    "width_taper",
    "height_taper",
    "rotary_inertia",
    "axial_force",
    "axial_load",
    "rotation_speed",
    "hub_radius",
    "setting_angle",
    "foundation_stiffness",
];

pub(super) const fn row(name: &'static str, parameters: &'static [&'static str]) -> TypeRow {
    TypeRow { name, parameters, renamed: &[] }
}

pub(super) const fn keyword(
    name: &'static str,
    space: Space,
    required: &'static [&'static str],
    optional: &'static [&'static str],
    types: &'static [TypeRow],
) -> Keyword {
    Keyword { name, space, required, optional, one_of: &[], types, wrapper: None, needs_places: false }
}

/// The inertia of a body: about its mass centre, or about its input end.
const INERTIAS: &[&str] = &["inertia", "inertia_about_input"];

/// A type of bodies by their inertia about the input end.
const fn about_input(name: &'static str, parameters: &'static [&'static str]) -> TypeRow {
    TypeRow { name, parameters, renamed: &[("inertia_about_input", "inertia")] }
}

/// A rigid disc on a shaft. It stands in paths alone.
pub(crate) const DISC: &str = "disc";

/// A beam of the plane with pins at its ends. It stands between places alone.
pub(crate) const BAR: &str = "bar";

#[rustfmt::skip]
const BEAMS: &[TypeRow] = &[
    row("Beam", &[]),
    row("RayleighBeam", &["rotary_inertia"]),
    row("BeamColumn", &["axial_force"]),
    row("FoundationBeam", FOUNDATION),
    row("TimoshenkoBeam", SHEAR),
    row("GeneralBeam", UNDAMPED),
    row("DampedBeam", OF_BEAM),
];

#[rustfmt::skip]
const LINE_BEAMS: &[TypeRow] = &[
    row("Beam", &[]),
    row("RayleighBeam", &["rotary_inertia"]),
    row("BeamColumn", &["axial_force"]),
    row("FoundationBeam", FOUNDATION),
    row("TimoshenkoBeam", SHEAR),
    row("GeneralBeam", UNDAMPED),
    row("DampedBeam", OF_BEAM),
    row("SpinningBeam", SPINNING),
    row("DampedSpinningBeam", DAMPED_SPINNING),
];

#[rustfmt::skip]
pub(crate) const ELEMENTS: &[Keyword] = &[
    keyword("beam", Space::Bending, BENDING, OF_LINE_BEAM, LINE_BEAMS),
    Keyword { wrapper: IN_PLANE, ..keyword("beam", Space::Planar, STRETCHING, OF_BEAM, BEAMS) },
    Keyword { wrapper: IN_PLANE, needs_places: true, ..keyword(BAR, Space::Planar, STRETCHING, OF_BEAM, BEAMS) },
    keyword("tapered_beam", Space::Bending, BENDING, TAPERS, &[row("TaperedBeam", TAPERS)]),
    keyword(STRING, Space::Translation, &["length", "tension", "mass_per_length"], OF_STRING, STRINGS),
    Keyword {
        wrapper: IN_PLANE,
        needs_places: true,
        ..keyword(STRING, Space::Planar, &["length", AXIAL_STIFFNESS, "tension", "mass_per_length"], OF_STRING, STRINGS)
    },
    keyword("rod", Space::Translation, &["length", "axial_stiffness", "mass_per_length"], &["foundation_stiffness", "loss_factor", "kelvin_voigt_time", "external_damping"], &[
        row("Rod", &["foundation_stiffness"]),
        row("DampedRod", &["foundation_stiffness", "loss_factor", "kelvin_voigt_time", "external_damping"]),
    ]),
    keyword("shaft", Space::Rotation, &["length", "torsional_stiffness", "inertia_per_length"], DAMPING, &[
        row("Shaft", &[]),
        row("DampedShaft", DAMPING),
    ]),
    keyword("spring", Space::Translation, &["stiffness"], OF_LINE_SPRING, &[
        row("Spring", &[]),
        row("SpringDamper", &["damping"]),
        row("DampedSpring", SPRING),
        row("CrossCoupledSpring", OF_LINE_SPRING),
    ]),
    keyword("torsion_spring", Space::Rotation, &["stiffness"], SPRING, &[
        row("TorsionSpring", &[]),
        row("TorsionSpringDamper", &["damping"]),
        row("DampedTorsionSpring", SPRING),
    ]),
    keyword("damper", Space::Translation, &["damping"], &[], &[row("Damper", &[])]),
    keyword("torsion_damper", Space::Rotation, &["damping"], &[], &[row("TorsionDamper", &[])]),
    keyword("mass", Space::Translation, &["mass"], &[], &[row("Mass", &[])]),
    keyword("inertia", Space::Rotation, &["inertia"], &[], &[row("Inertia", &[])]),
    keyword("point_mass", Space::Bending, &["mass"], &["inertia"], &[row("PointMass", &["inertia"])]),
    keyword(DISC, Space::Bending, &["mass", "inertia", "polar_inertia"], &[SPEED], &[row("Disc", &[SPEED])]),
    Keyword { one_of: INERTIAS, ..keyword("body", Space::Bending, &["mass", "output_x", "centre_x"], &["axial_force"], &[
        row("CentralBody", &["inertia"]),
        about_input("Body", &["inertia_about_input"]),
        row("CentralBodyColumn", &["inertia", "axial_force"]),
        about_input("BodyColumn", &["inertia_about_input", "axial_force"]),
    ]) },
    Keyword { one_of: INERTIAS, ..keyword("body", Space::Planar, &["mass", "output_x", "output_y", "centre_x", "centre_y"], &[], &[
        row("PlanarCentralBody", &["inertia"]),
        about_input("PlanarBody", &["inertia_about_input"]),
    ]) },
    keyword("rigid_link", Space::Bending, &["output_x"], &["axial_force"], &[
        row("Lever", &[]),
        row("LeverColumn", &["axial_force"]),
    ]),
    keyword("rigid_link", Space::Planar, &["output_x", "output_y"], &[], &[
        row("PlanarBody", &["mass", "inertia", "centre_x", "centre_y"]),
    ]),
    keyword("hinge", Space::Bending, &[], OF_HINGE, &[
        TypeRow { renamed: &[("stiffness_rz", "stiffness")], ..row("RotationalHinge", &["stiffness_rz"]) },
        TypeRow { renamed: &[("stiffness_y", "stiffness")], ..row("ShearHinge", &["stiffness_y"]) },
        TypeRow { renamed: TURNING, ..row("ElasticHinge", &["stiffness_y", "stiffness_rz"]) },
        TypeRow { renamed: TURNING, ..row("DampedHinge", OF_HINGE) },
    ]),
    keyword("hinge", Space::Planar, &[], OF_PLANAR_HINGE, &[
        TypeRow { renamed: TURNING, ..row("PlanarHinge", &["stiffness_x", "stiffness_y", "stiffness_rz"]) },
        TypeRow { renamed: TURNING, ..row("DampedPlanarHinge", OF_PLANAR_HINGE) },
    ]),
];

/// The rotation of a hinge, in the words of its type.
const TURNING: &[(&str, &str)] = &[("stiffness_rz", "stiffness_theta"), ("damping_rz", "damping_theta")];

const OF_HINGE: &[&str] =
    &["stiffness_y", "stiffness_rz", "damping_y", "damping_rz", "loss_factor", "kelvin_voigt_time"];
pub(super) const OF_PLANAR_HINGE: &[&str] = &[
    "stiffness_x",
    "stiffness_y",
    "stiffness_rz",
    "damping_x",
    "damping_y",
    "damping_rz",
    "loss_factor",
    "kelvin_voigt_time",
];

/// The elements of models without places.
pub(crate) fn elements_of_paths() -> impl Iterator<Item = &'static Keyword> {
    ELEMENTS.iter().filter(|row| !row.needs_places)
}

/// Whether an element of a keyword has a parameter, along a line or in the plane.
pub(crate) fn has_somewhere(keyword: &str, parameter: &str) -> bool {
    let mut rows = ELEMENTS.iter().filter(|row| row.name == keyword);
    rows.any(|row| row.parameters().concat().contains(&parameter))
}

/// The element behind a keyword: along a line or in the plane, where it differs.
pub(crate) fn element_of(keyword: &str, dimension: Dimension) -> Option<&'static Keyword> {
    let mut rows = ELEMENTS.iter().filter(|element| element.name == keyword);
    let is_in_plane = dimension != Dimension::Line;
    let mut fitting = rows.clone().filter(|element| element.space.is(Space::Planar) == is_in_plane);
    fitting.next().or_else(|| rows.next())
}
