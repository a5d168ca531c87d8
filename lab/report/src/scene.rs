//! What the scenes are, in a few words.

/// A few words on a scene; none on one that the report does not know.
pub(crate) fn note(scene: &str) -> &'static str {
    match scene {
        "4.1a" => "cantilever with a tip body",
        "4.1b" => "cantilever with a heavy tip body",
        "4.2" => "beam on elastic restraints",
        "4.3" => "beam with a spring and a mass",
        "4.4" => "two spans with an oscillator",
        "4.5" => "beam with a damped oscillator",
        "mode 100" => "of one cantilever",
        "close pair" => "twin cantilevers, weakly joined",
        "stiff" => "soft and stiff beams, 1 to 10¹²",
        _ => "",
    }
}
