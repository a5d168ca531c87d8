//! The section of a beam or a string: parameters by name. A parameter that is not named is absent.

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
    /// Axial stiffness EA \[N\], positive: in the plane alone.
    axial_stiffness,
    /// Bending stiffness EI [N m²], positive.
    bending_stiffness,
    /// Mass per length m [kg/m], positive.
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
}

impl Section {
    /// A section that names nothing yet.
    pub const fn new() -> Self {
        Section { values: [None; NAMES.len()] }
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
#[derive(Clone, Debug, PartialEq, Eq)]
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

impl core::error::Error for UnknownParameter {}
