//! The section of a beam or a string: parameters by name. A parameter that is not named is absent.

use crate::model::error;
use core::fmt;

/// Declares the parameters of a section.
macro_rules! parameters {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        /// A parameter of a section, as an index.
        #[allow(non_camel_case_types)]
        #[derive(Clone, Copy)]
        pub(crate) enum Parameter {
            $($name,)*
        }

        /// The names of all parameters.
        const NAMES: &[&str] = &[$(stringify!($name)),*];

        impl Section {
            $(
                $(#[$doc])*
                #[must_use]
                pub const fn $name(mut self, value: f64) -> Self {
                    self.values[Parameter::$name as usize] = Some(value);
                    self
                }
            )*
        }
    };
}

parameters! {
    /// Axial stiffness EA \[N\], positive: in the plane and in space.
    axial_stiffness,
    /// Bending stiffness EI [N m²], positive; in space about both axes.
    bending_stiffness,
    /// Mass per length m [kg/m], zero or positive.
    mass_per_length,
    /// Tension H of a string \[N\], positive.
    tension,
    /// Shear stiffness kGA \[N\], positive; infinite is rigid, as if not named.
    shear_stiffness,
    /// Rotary inertia per length ρI [kg m], zero or positive.
    rotary_inertia,
    /// Axial force N \[N\], positive in tension.
    axial_force,
    /// Stiffness k of the foundation per length [N/m²], zero or positive.
    foundation_stiffness,
    /// Stiffness G of the shear layer of the foundation \[N\], zero or positive.
    foundation_shear_stiffness,
    /// Loss factor η, zero or positive.
    loss_factor,
    /// Time c of Kelvin and Voigt \[s\], zero or positive.
    kelvin_voigt_time,
    /// Damping per length against displacements [N s/m²], zero or positive.
    external_damping,
    /// Torsional stiffness GJ [N m²], positive: in space alone.
    torsional_stiffness,
    /// Polar inertia per length ρI_p [kg m], positive: in space, and of a shaft that spins.
    polar_inertia_per_length,
    /// Speed Ω [rad/s] of a shaft that spins, of either sign: along a line alone, beside rotary inertia and polar inertia.
    speed,
    /// Bending stiffness about y of a member in space.
    bending_stiffness_y,
    /// Bending stiffness about z of a member in space.
    bending_stiffness_z,
    /// Shear stiffness along y of a member in space.
    shear_stiffness_y,
    /// Shear stiffness along z of a member in space.
    shear_stiffness_z,
    /// Rotary inertia per length about y of a member in space.
    rotary_inertia_y,
    /// Rotary inertia per length about z of a member in space.
    rotary_inertia_z,
    /// Stiffness of the foundation per length along y of a member in space.
    foundation_stiffness_y,
    /// Stiffness of the foundation per length along z of a member in space.
    foundation_stiffness_z,
    /// Stiffness of the shear layer of the foundation along y of a member in space.
    foundation_shear_stiffness_y,
    /// Stiffness of the shear layer of the foundation along z of a member in space.
    foundation_shear_stiffness_z,
}

/// The section of a beam, a bar or a string. What it names selects the beam: with bending stiffness and mass it is that of Euler and Bernoulli, with more it has
/// shear, rotary inertia, an axial force, a foundation, or damping.
///
/// ```
/// use mstmm_core::frame::Section;
///
/// let steel = Section::new().axial_stiffness(4e8).bending_stiffness(1e6).mass_per_length(20.0);
/// // a value for each name, as a file has them
/// let same = Section::new().with("axial_stiffness", 4e8)?.with("bending_stiffness", 1e6)?.with("mass_per_length", 20.0)?;
/// assert_eq!(steel, same);
/// let error = Section::new().with("bending_stifness", 1e6).unwrap_err();
/// assert_eq!(error.to_string(), "a section has no parameter `bending_stifness`: did you mean `bending_stiffness`?");
/// # Ok::<(), mstmm_core::frame::UnknownParameter>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Section {
    values: [Option<f64>; NAMES.len()],
    up: Option<[f64; 3]>,
}

impl Section {
    /// A section that names nothing yet.
    pub const fn new() -> Self {
        Section { values: [None; NAMES.len()], up: None }
    }

    /// The vector that is made normal to a member in space and is its z axis then; without it z of space. A vertical member whose planes are alike
    /// has x of space instead.
    #[must_use]
    pub const fn up(self, up: [f64; 3]) -> Self {
        Section { up: Some(up), ..self }
    }

    /// The vector that is made its z axis, if it is named.
    pub(crate) fn z_axis(&self) -> Option<[f64; 3]> {
        self.up
    }

    /// The section with a value for a parameter by name.
    ///
    /// # Errors
    /// [`UnknownParameter`] for a name that no parameter has.
    pub fn with(mut self, name: &str, value: f64) -> Result<Self, UnknownParameter> {
        match NAMES.iter().position(|own| *own == name) {
            Some(place) => {
                self.values[place] = Some(value);
                Ok(self)
            }
            None => Err(UnknownParameter { name: name.into() }),
        }
    }

    /// The first parameter that is named and none of some.
    pub(crate) fn named_beside(&self, parameters: &[Parameter]) -> Option<&'static str> {
        let is_known = |place: usize| parameters.iter().any(|parameter| *parameter as usize == place);
        (0..NAMES.len()).find(|place| self.values[*place].is_some() && !is_known(*place)).map(|place| NAMES[place])
    }

    /// A bit for each parameter that is named.
    pub(crate) fn named(&self) -> u32 {
        (0..NAMES.len()).filter(|place| self.values[*place].is_some()).fold(0, |named, place| named | 1 << place)
    }

    /// Names a parameter.
    pub(crate) fn set(&mut self, parameter: Parameter, value: f64) {
        self.values[parameter as usize] = Some(value);
    }

    /// The value of a parameter, if it is named.
    pub(crate) fn get(&self, parameter: Parameter) -> Option<f64> {
        self.values[parameter as usize]
    }
}

/// The name of a parameter.
pub(crate) fn name_of(parameter: Parameter) -> &'static str {
    NAMES[parameter as usize]
}

/// A name that no parameter of a section has.
#[derive(Clone, PartialEq, Eq)]
pub struct UnknownParameter {
    /// The name.
    pub name: std::string::String,
}

impl fmt::Display for UnknownParameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a section has no parameter `{}`: ", self.name)?;
        let distances = NAMES.iter().map(|own| (strsim::levenshtein(own, &self.name), own));
        match distances.min_by_key(|(distance, _)| *distance) {
            Some((distance, near)) if 3 * distance <= near.len() => write!(f, "did you mean `{near}`?"),
            _ => write!(f, "it has `{}`", NAMES.join("`, `")),
        }
    }
}

error! { UnknownParameter }
