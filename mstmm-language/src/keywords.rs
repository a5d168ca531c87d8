//! The keywords of the language: one line per element, support and connection.

mod dimension;
mod elements;
mod in_space;
mod located;
mod old_words;
mod other_names;

pub(crate) use dimension::Dimension;
pub(crate) use elements::{
    AXIAL_STIFFNESS, BAR, CROSS, DAMPING, DISC, ELEMENTS, Keyword, SPEED, SPIN, STRING, TypeRow, element_of,
    elements_of_paths, has_somewhere, neutral,
};
pub(crate) use in_space::{PAIRS, in_space};
pub(crate) use located::{
    ABOUT, ALONG, AT, FREEDOMS, HELD, LOCATED, LocatedKeyword, NORMAL, RIGID_LINK, Role, STRING_BETWEEN_PLACES, Tuple,
    freedom_of, located_of, ties,
};
use mstmm_plan::Support;
#[cfg(test)]
pub(crate) use old_words::OLD_WORDS;
pub(crate) use old_words::{OldWord, old_word, renamed_in};
pub(crate) use other_names::{Meant, absent_element, meant_element, meant_parameter, meant_support};

/// The supports and their keywords.
pub(crate) const SUPPORTS: &[(&str, Support)] = &[
    ("fixed", Support::Fixed),
    ("pinned", Support::Pinned),
    ("free", Support::Free),
    ("guided", Support::Guided),
    ("roller", Support::Roller),
];

/// The word in front of parameters that elements share.
pub(crate) const SECTION: &str = "section";

/// The keyword of connections.
pub(crate) const CONNECTION: &str = "conn";

/// Whether a word is the keyword of an element, in models with locations or without.
pub(crate) fn is_element(keyword: &str) -> bool {
    ELEMENTS.iter().any(|element| element.name == keyword) || located_of(keyword).is_some()
}

/// The support behind a keyword.
pub(crate) fn support_of(keyword: &str) -> Option<Support> {
    SUPPORTS.iter().find(|(name, _)| *name == keyword).map(|(_, support)| *support)
}

/// A keyword and a label that were written as one word, `beam1`, apart.
pub(crate) fn apart(word: &str) -> Option<String> {
    let keyword = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let is_keyword = keyword == CONNECTION || is_element(keyword);
    (is_keyword && keyword != word).then(|| format!("{keyword} {}", &word[keyword.len()..]))
}

/// The word most like a misspelt one, if any is like it at all.
pub(crate) fn nearest<'a>(candidates: impl Iterator<Item = &'a str>, wrong: &str) -> Option<&'a str> {
    candidates
        .map(|candidate| (strsim::jaro_winkler(candidate, wrong), candidate))
        .filter(|(likeness, _)| *likeness > 0.8)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests;
