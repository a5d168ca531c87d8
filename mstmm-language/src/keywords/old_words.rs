//! Words of one type each, and the words that say the same by their parameters.

/// A word, and what stands for it.
#[derive(Debug)]
pub(crate) struct OldWord {
    pub(crate) name: &'static str,
    /// The word that stands for it.
    pub(crate) new: &'static str,
    /// Its parameters that have another name there.
    pub(super) renamed: &'static [(&'static str, Renamed)],
}

/// What becomes of a parameter.
#[derive(Clone, Copy, Debug)]
pub(super) enum Renamed {
    /// It has another name.
    To(&'static str),
    /// Its reciprocal has another name; a zero is left out, which is rigid.
    Reciprocal(&'static str),
}
use Renamed::{Reciprocal, To};

/// Parameters whose zero is left out: it says that there is none.
const ABSENT_IF_ZERO: &[&str] =
    &["rotary_inertia", "axial_force", "foundation_stiffness", "foundation_shear_stiffness", "shear_flexibility"];

const fn word(name: &'static str, new: &'static str, renamed: &'static [(&'static str, Renamed)]) -> OldWord {
    OldWord { name, new, renamed }
}

const FLEXIBLE: &[(&str, Renamed)] = &[("shear_flexibility", Reciprocal("shear_stiffness"))];
const TURNING: &[(&str, Renamed)] = &[("stiffness_theta", To("stiffness_rz"))];

pub(crate) const OLD_WORDS: &[OldWord] = &[
    word("rayleigh_beam", "beam", &[]),
    word("timoshenko_beam", "beam", &[]),
    word("beam_column", "beam", &[]),
    word("foundation_beam", "beam", &[]),
    word("general_beam", "beam", FLEXIBLE),
    word("planar_beam", "beam", &[]),
    word("planar_rayleigh_beam", "beam", &[]),
    word("planar_timoshenko_beam", "beam", &[]),
    word("planar_beam_column", "beam", &[]),
    word("planar_foundation_beam", "beam", &[]),
    word("planar_general_beam", "beam", FLEXIBLE),
    word("spring_damper", "spring", &[]),
    word("torsion_spring_damper", "torsion_spring", &[]),
    word("elastic_hinge", "hinge", TURNING),
    word("planar_hinge", "hinge", TURNING),
    word("rotational_hinge", "hinge", &[("stiffness", To("stiffness_rz"))]),
    word("shear_hinge", "hinge", &[("stiffness", To("stiffness_y"))]),
    word("lever", "rigid_link", &[]),
    word("planar_body", "body", &[("inertia", To("inertia_about_input"))]),
];

/// The row of an old word.
pub(crate) fn old_word(keyword: &str) -> Option<&'static OldWord> {
    OLD_WORDS.iter().find(|word| word.name == keyword)
}

impl OldWord {
    /// A parameter in the new form, `name: expression` or the name alone where the expression is the variable of that name; nothing for one
    /// that says by its zero that it is not there.
    pub(crate) fn parameter(&self, name: &str, expression: &str) -> Option<String> {
        let is_zero = expression.parse().is_ok_and(|value: f64| value == 0.0);
        if is_zero && ABSENT_IF_ZERO.contains(&name) {
            return None;
        }
        let renamed = self.renamed.iter().find(|(old, _)| *old == name).map(|(_, renamed)| *renamed);
        let (new, expression) = match renamed {
            None => (name, expression.to_owned()),
            Some(To(new)) => (new, expression.to_owned()),
            Some(Reciprocal(new)) => (new, format!("1.0 / ({expression})")),
        };
        Some(if new == expression { new.to_owned() } else { format!("{new}: {expression}") })
    }
}
