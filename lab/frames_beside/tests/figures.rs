//! The portal's figures: right here, sensible elsewhere, and shown in the guide as they are.

use frames_beside::{EXACT, Figures, hertz};

const PAGE: &str = include_str!("../../../docs/guide/finite_elements.md");

/// Exact stiffnesses with forty digits know the same ten.
#[test]
fn the_portal_has_the_exact_frequencies() {
    let found = hertz().unwrap();
    assert_eq!(found.len(), EXACT.len());
    for (found, exact) in found.iter().zip(EXACT) {
        assert!((found / exact - 1.0).abs() < 4.0 * f64::EPSILON, "{found} is not {exact}");
    }
}

/// Both programs have the same elements, so that they agree with each other mesh by mesh, and come closer by the square of the mesh.
#[test]
fn recorded_figures_are_those_of_one_portal() {
    let figures = Figures::recorded().unwrap();
    let [here, opensees, pynite] = figures.programs.as_slice() else { panic!("{figures:?}") };
    assert!(here.runs[0].error() < 4.0 * f64::EPSILON);
    for (one, other) in opensees.runs.iter().zip(&pynite.runs) {
        assert_eq!(one.elements, other.elements);
        for (one, other) in one.hertz.iter().zip(&other.hertz) {
            assert!((one / other - 1.0).abs() < 1e-8, "{one} is not {other}");
        }
    }
    for pair in opensees.runs.windows(2) {
        let order = (pair[0].error() / pair[1].error()).ln() / (pair[1].elements as f64 / pair[0].elements as f64).ln();
        assert!(1.8 < order, "{order}");
    }
}

/// Tables and listings of the documents are the recorded figures and the files that were measured.
#[test]
fn documents_show_what_was_measured() {
    let figures = Figures::recorded().unwrap();
    assert!(PAGE.contains(&figures.table()), "{}", figures.table());
    assert!(include_str!("../../../README.md").contains(&figures.summary()), "{}", figures.summary());
    let files = [
        ("rust", include_str!("../src/portal.rs")),
        ("python", include_str!("../portal_opensees.py")),
        ("python", include_str!("../portal_pynite.py")),
    ];
    for (language, file) in files {
        let (_, listing) = file.split_once("\n\n").unwrap();
        assert!(PAGE.contains(&format!("```{language}\n{listing}```")), "{listing}");
    }
}
