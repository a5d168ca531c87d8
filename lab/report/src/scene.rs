//! What the scenes are, in a few words and in a sentence.

/// A system, or a question to one, on which methods are compared.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene {
    /// Its name in the runs.
    pub(crate) id: &'static str,
    /// What it is, in a few words.
    pub(crate) note: &'static str,
    /// What it is, and why it is there.
    pub(crate) sentence: &'static str,
}

/// All of them, in the order in which they are introduced.
pub(crate) const SCENES: [Scene; 9] = [
    Scene {
        id: "4.1a",
        note: "cantilever with a tip body",
        sentence: "A rigid body as heavy as the beam sits at its tip, its mass centre far beyond the end of the beam. Five frequencies.",
    },
    Scene {
        id: "4.1b",
        note: "cantilever with a heavy tip body",
        sentence: "The same with a body of ten times the mass of the beam.",
    },
    Scene {
        id: "4.2",
        note: "beam on elastic restraints",
        sentence: "Both ends can move and turn, each held by a spring and a torsion spring. Three frequencies.",
    },
    Scene {
        id: "4.3",
        note: "beam with a spring and a mass",
        sentence: "A steel beam between two pins, on a spring to the ground, with a mass beside it. Three frequencies.",
    },
    Scene {
        id: "4.4",
        note: "two spans with an oscillator",
        sentence: "A beam over three supports carries a mass on a spring. Five frequencies.",
    },
    Scene {
        id: "4.5",
        note: "beam with a damped oscillator",
        sentence: "A spring, a torsion spring, and a mass on a spring and a dashpot: the roots are complex. Five eigenvalues.",
    },
    Scene {
        id: "mode 100",
        note: "of one cantilever",
        sentence: "One beam, and only its hundredth frequency is asked for: exp(βl) is 10¹³⁵ there.",
    },
    Scene {
        id: "close pair",
        note: "twin cantilevers, weakly joined",
        sentence: "Two equal beams whose tips a spring of 10⁻⁸ EI/l³ joins: their first two frequencies differ in the ninth digit.",
    },
    Scene {
        id: "stiff",
        note: "soft and stiff beams, 1 to 10¹²",
        sentence: "Four beams in a row, every other one 10¹² times as stiff. Three frequencies.",
    },
];

/// A few words on a scene; none on one that the report does not know.
pub(crate) fn note(scene: &str) -> &'static str {
    let of_scene = SCENES.iter().find(|known| known.id == scene).map(|known| known.note);
    of_scene.unwrap_or(if scene == "portal" { "first modes" } else { "" })
}
