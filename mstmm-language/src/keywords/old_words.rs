//! Words of one type each, and the words that say the same by their parameters.

/// A word, and what stands for it.
#[derive(Debug)]
pub(crate) struct OldWord {
    pub(crate) name: &'static str,
    /// The word that stands for it.
    pub(crate) new: &'static str,
    /// The parameters that it has always, beside those that the new word has.
    pub(crate) needs: &'static [&'static str],
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

const fn word(
    name: &'static str,
    new: &'static str,
    needs: &'static [&'static str],
    renamed: &'static [(&'static str, Renamed)],
) -> OldWord {
    OldWord { name, new, needs, renamed }
}

const FLEXIBLE: &[(&str, Renamed)] = &[("shear_flexibility", Reciprocal("shear_stiffness"))];
const TURNING: &[(&str, Renamed)] = &[("stiffness_theta", To("stiffness_rz"))];

pub(crate) const OLD_WORDS: &[OldWord] = &[
    word("rayleigh_beam", "beam", &["rotary_inertia"], &[]),
    word("timoshenko_beam", "beam", &["shear_stiffness", "rotary_inertia"], &[]),
    word("beam_column", "beam", &["axial_force"], &[]),
    word("foundation_beam", "beam", &["foundation_stiffness"], &[]),
    word("general_beam", "beam", &[], FLEXIBLE),
    word("planar_beam", "beam", &["axial_stiffness"], &[]),
    word("planar_rayleigh_beam", "beam", &["axial_stiffness", "rotary_inertia"], &[]),
    word("planar_timoshenko_beam", "beam", &["axial_stiffness", "shear_stiffness", "rotary_inertia"], &[]),
    word("planar_beam_column", "beam", &["axial_stiffness", "axial_force"], &[]),
    word("planar_foundation_beam", "beam", &["axial_stiffness", "foundation_stiffness"], &[]),
    word("planar_general_beam", "beam", &["axial_stiffness"], FLEXIBLE),
    word("spring_damper", "spring", &["damping"], &[]),
    word("torsion_spring_damper", "torsion_spring", &["damping"], &[]),
    word("elastic_hinge", "hinge", &["stiffness_y", "stiffness_rz"], TURNING),
    word("planar_hinge", "hinge", &["stiffness_x", "stiffness_y", "stiffness_rz"], TURNING),
    word("rotational_hinge", "hinge", &["stiffness_rz"], &[("stiffness", To("stiffness_rz"))]),
    word("shear_hinge", "hinge", &["stiffness_y"], &[("stiffness", To("stiffness_y"))]),
    word("lever", "rigid_link", &[], &[]),
    word(
        "planar_body",
        "body",
        &["output_y", "centre_y", "inertia_about_input"],
        &[("inertia", To("inertia_about_input"))],
    ),
];

/// The row of an old word.
pub(crate) fn old_word(keyword: &str) -> Option<&'static OldWord> {
    OLD_WORDS.iter().find(|word| word.name == keyword)
}

/// What stands in a word for parameters that old words had in its place, each once, given their name there and their expression.
pub(crate) fn renamed_in(new: &str, parameter: &str, expression: &str) -> Vec<String> {
    let words = OLD_WORDS.iter().filter(|word| word.new == new && word.new_name(parameter) != parameter);
    let mut all: Vec<String> = words.filter_map(|word| word.parameter(parameter, expression)).collect();
    all.sort_unstable();
    all.dedup();
    all
}

impl OldWord {
    /// The name of a parameter in the new word.
    pub(crate) fn new_name<'p>(&self, name: &'p str) -> &'p str {
        match self.renamed.iter().find(|(old, _)| *old == name) {
            Some((_, To(new) | Reciprocal(new))) => new,
            None => name,
        }
    }

    /// A parameter in the new form, `name: expression` or the name alone where the expression is the variable of that name; nothing for one
    /// that says by its zero that it is not there.
    pub(crate) fn parameter(&self, name: &str, expression: &str) -> Option<String> {
        let number = expression.trim_end_matches("f64").trim_end_matches('_').replace(['-', '_', ' '], "");
        let is_zero = number.parse().is_ok_and(|value: f64| value == 0.0);
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
