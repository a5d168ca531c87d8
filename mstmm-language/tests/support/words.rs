//! Words as tokens: those of the fuzzer's dictionary, elements and their parameters.
#![expect(clippy::panic, reason = "a wrong dictionary is shown")]

use proc_macro2::{TokenStream, TokenTree};

/// Words of models with locations, and sections.
const OTHERS: [&str; 15] = [
    "at",
    "at 1.0",
    "at (0.0, 1.0)",
    "along",
    "along (1.0, 0.0)",
    "held",
    "held(x, rz)",
    "rigid_body",
    "rigid_body 1",
    "pin",
    "slider",
    "rz",
    "section",
    "section a { mass: 1.0 }",
    "..a",
];

/// The tokens of each word.
///
/// # Panics
/// If a line is not written as libFuzzer wants it or does not lex.
pub(crate) fn words() -> Vec<Vec<TokenTree>> {
    let lines = include_str!("../../../lab/fuzz/words.dict").lines();
    let words = lines.filter(|line| !line.is_empty() && !line.starts_with('#')).map(word);
    let of_elements = mstmm_language::elements()
        .flat_map(|(keyword, _, parameters)| [keyword].into_iter().chain(parameters.concat()));
    words
        .chain(OTHERS.iter().map(|name| word(&format!("\"{name}\""))))
        .chain(of_elements.map(|name| word(&format!("\"{name}\""))))
        .collect()
}

fn word(line: &str) -> Vec<TokenTree> {
    let text = line.strip_prefix('"').and_then(|line| line.strip_suffix('"'));
    let text = text.map(|text| text.replace("\\\"", "\"").replace("\\\\", "\\"));
    match text.as_deref().map(str::parse::<TokenStream>) {
        Some(Ok(tokens)) => tokens.into_iter().collect(),
        _ => panic!("not a word: {line}"),
    }
}
