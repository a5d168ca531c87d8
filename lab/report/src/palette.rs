//! Colours: those of Okabe and Ito, which colour-blind readers tell apart, each with its counterpart on a dark page.

use plotters::style::RGBColor;
use std::fmt::Write;

/// A colour of a drawing. Drawings hold the light one; a rule of the page's style replaces it on dark pages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Hue {
    light: [u8; 3],
    dark: [u8; 3],
}

impl Hue {
    const fn new(light: u32, dark: u32) -> Self {
        Hue { light: bytes(light), dark: bytes(dark) }
    }

    /// The colour to draw with.
    pub(crate) const fn colour(self) -> RGBColor {
        let [r, g, b] = self.light;
        RGBColor(r, g, b)
    }
}

/// The bytes of 0xRRGGBB.
const fn bytes(colour: u32) -> [u8; 3] {
    let [_, r, g, b] = colour.to_be_bytes();
    [r, g, b]
}

/// Text and frames.
pub(crate) const INK: Hue = Hue::new(0x1F2328, 0xE6E8EA);
/// Text that stands back.
pub(crate) const QUIET: Hue = Hue::new(0x59616B, 0xA2AAB3);
/// Lines of a grid.
pub(crate) const GRID: Hue = Hue::new(0xE3E6E9, 0x30363D);
/// The page itself.
pub(crate) const PAPER: Hue = Hue::new(0xFEFEFE, 0x16191D);
/// Okabe and Ito's blue.
pub(crate) const BLUE: Hue = Hue::new(0x0072B2, 0x4FA8E0);
/// Their orange.
pub(crate) const ORANGE: Hue = Hue::new(0xE69F00, 0xE8A92A);
/// Their vermilion.
pub(crate) const VERMILION: Hue = Hue::new(0xD55E00, 0xF0803C);
/// Their bluish green.
pub(crate) const GREEN: Hue = Hue::new(0x009E73, 0x2BBF95);
/// Their reddish purple.
pub(crate) const PURPLE: Hue = Hue::new(0xCC79A7, 0xDE9AC2);
/// Their sky blue.
pub(crate) const SKY: Hue = Hue::new(0x56B4E9, 0x8ACBF2);

const ALL: [Hue; 10] = [INK, QUIET, GRID, PAPER, BLUE, ORANGE, VERMILION, GREEN, PURPLE, SKY];

/// Style rules that give drawings their dark colours.
pub(crate) fn dark_rules() -> String {
    let mut rules = String::new();
    for Hue { light, dark } in ALL {
        let [light, dark] = [light, dark].map(|[r, g, b]| format!("#{r:02X}{g:02X}{b:02X}"));
        for property in ["fill", "stroke"] {
            // writing to a string cannot fail
            let _ = write!(rules, "svg [{property}=\"{light}\"]{{{property}:{dark}}}");
        }
    }
    rules
}
