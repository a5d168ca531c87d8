//! The keywords of the language: one line per element, support and connection.

/// An element keyword and the type in `mstmm_core::elements` behind it.
pub(crate) const ELEMENTS: &[(&str, &str)] = &[
    ("spring", "Spring"),
    ("torsion_spring", "TorsionSpring"),
    ("damper", "Damper"),
    ("torsion_damper", "TorsionDamper"),
    ("spring_damper", "SpringDamper"),
    ("torsion_spring_damper", "TorsionSpringDamper"),
    ("mass", "Mass"),
    ("inertia", "Inertia"),
    ("point_mass", "PointMass"),
    ("elastic_hinge", "ElasticHinge"),
    ("body", "Body"),
    ("beam", "Beam"),
    ("planar_body", "PlanarBody"),
    ("planar_beam", "PlanarBeam"),
    ("planar_hinge", "PlanarHinge"),
];

/// A support keyword and the variant of `mstmm_core::Support` behind it.
pub(crate) const SUPPORTS: &[(&str, &str)] =
    &[("fixed", "Fixed"), ("pinned", "Pinned"), ("free", "Free"), ("guided", "Guided"), ("roller", "Roller")];

/// The keyword of connections.
pub(crate) const CONNECTION: &str = "conn";

/// What a keyword stands for, in one of the tables above.
pub(crate) fn look_up(table: &[(&str, &'static str)], keyword: &str) -> Option<&'static str> {
    table.iter().find(|(name, _)| *name == keyword).map(|(_, target)| *target)
}

/// The keyword most like a misspelt one, if any is like it at all.
pub(crate) fn nearest<'a>(candidates: impl Iterator<Item = &'a str>, wrong: &str) -> Option<&'a str> {
    candidates
        .map(|candidate| (strsim::jaro_winkler(candidate, wrong), candidate))
        .filter(|(likeness, _)| *likeness > 0.8)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_element_of_the_core_has_one_keyword() {
        let mut of_keywords: Vec<&str> = ELEMENTS.iter().map(|(_, name)| *name).collect();
        let mut of_core = mstmm_core::elements::NAMES.to_vec();
        of_keywords.sort_unstable();
        of_core.sort_unstable();
        assert_eq!(of_keywords, of_core);
    }

    #[test]
    fn a_slip_of_the_pen_finds_its_keyword() {
        let elements = || ELEMENTS.iter().map(|(name, _)| *name);
        assert_eq!(nearest(elements(), "baem"), Some("beam"));
        assert_eq!(nearest(elements(), "springdamper"), Some("spring_damper"));
        assert_eq!(nearest(elements(), "quux"), None);
    }
}
