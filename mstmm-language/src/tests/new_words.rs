//! The script that writes models in new words, from the table of old ones that messages have, too.
//!
//! It goes over all files of the repository:
//! `cargo test -p mstmm-language --lib models_are_written_in_new_words -- --ignored`.

use super::assert_refused;
use crate::keywords::{OLD_WORDS, OldWord};
use std::fs;
use std::path::{Path, PathBuf};

/// A text with all elements of old words in new ones, and the labels of these: `Model::lever_2`, `"lever 2"`.
fn rewritten(text: &str) -> String {
    let mut words: Vec<&OldWord> = OLD_WORDS.iter().collect();
    // `planar_beam_column_1` before `planar_beam_column`, a beam of that label
    words.sort_by_key(|word| core::cmp::Reverse(word.name.len()));
    words.into_iter().fold(text.to_owned(), |text, word| in_labels(&in_elements(&text, word), word))
}

/// Where a word stands alone in a text.
fn places<'t>(text: &'t str, word: &str) -> impl Iterator<Item = usize> + 't {
    let is_part = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    let length = word.len();
    text.match_indices(word).map(|(place, _)| place).collect::<Vec<_>>().into_iter().filter(move |&place| {
        !is_part(text[..place].chars().next_back()) && !is_part(text[place + length..].chars().next())
    })
}

/// The text with the elements of one word, `word label { .. }`, in the new form.
fn in_elements(text: &str, word: &OldWord) -> String {
    let (mut all, mut end) = (String::new(), 0);
    for place in places(text, word.name) {
        let behind = &text[place + word.name.len()..];
        let label = behind.trim_start().split([' ', '\n']).next().unwrap_or_default();
        let is_label =
            !label.is_empty() && label.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '$' || c == '#');
        let Some(open) = behind.find('{').filter(|_| is_label && place >= end) else { continue };
        let is_next = behind[..open].trim() == label;
        let Some(close) = closing(&behind[open..]).filter(|_| is_next) else { continue };
        let parameters = split(&behind[open + 1..open + close]);
        let parameters: Vec<String> = parameters.iter().filter_map(|parameter| in_new_form(parameter, word)).collect();
        all += &text[end..place];
        all += &format!("{}{}{{{}}}", word.new, &behind[..open], parameters.join(","));
        end = place + word.name.len() + open + close + 1;
    }
    all + &text[end..]
}

/// Where the brace at the beginning closes.
fn closing(text: &str) -> Option<usize> {
    let mut depth = 0;
    text.char_indices().find_map(|(place, c)| {
        depth += i32::from("{([".contains(c)) - i32::from("})]".contains(c));
        (depth == 0).then_some(place)
    })
}

/// Parameters between commas, with the spaces around them.
fn split(parameters: &str) -> Vec<&str> {
    let (mut parts, mut from, mut depth) = (Vec::new(), 0, 0);
    for (place, c) in parameters.char_indices() {
        depth += i32::from("{([".contains(c)) - i32::from("})]".contains(c));
        if c == ',' && depth == 0 {
            parts.push(&parameters[from..place]);
            from = place + 1;
        }
    }
    parts.push(&parameters[from..]);
    parts
}

/// One parameter, with its spaces; what stands behind the last comma is none.
fn in_new_form(parameter: &str, word: &OldWord) -> Option<String> {
    let content = parameter.trim();
    let (name, expression) = content.split_once(':').map_or((content, content), |(name, value)| (name, value.trim()));
    let written = if content.is_empty() || content.starts_with("..") {
        content.to_owned()
    } else {
        word.parameter(name, expression)?
    };
    Some(if content.is_empty() { parameter.to_owned() } else { parameter.replace(content, &written) })
}

/// The text with the labels of one word: constants of the model, names with a number as macros list them, and names in quotes.
fn in_labels(text: &str, word: &OldWord) -> String {
    let constants = text.replace(&format!("::{}_", word.name), &format!("::{}_", word.new));
    let quoted = constants.replace(&format!("\"{} ", word.name), &format!("\"{} ", word.new));
    let (old, mut all, mut end) = (format!("{}_", word.name), String::new(), 0);
    for (place, _) in quoted.match_indices(&old) {
        let is_part = |c: char| c.is_alphanumeric() || c == '_';
        let label: String = quoted[place + old.len()..].chars().take_while(|&c| is_part(c)).collect();
        let is_number = !label.is_empty() && label.chars().all(|c| c.is_ascii_digit());
        if is_number && !quoted[..place].ends_with(is_part) {
            all += &quoted[end..place];
            all += &format!("{}_", word.new);
            end = place + old.len();
        }
    }
    all + &quoted[end..]
}

#[test]
fn elements_and_their_labels_are_written_in_new_words() {
    for (old, new) in [
        (
            "-> planar_beam 1 { axial_stiffness: ea, mass_per_length: m } ->",
            "-> beam 1 { axial_stiffness: ea, mass_per_length: m } ->",
        ),
        (
            "general_beam a {\n    length, shear_flexibility: 2.0 * f(x, y),\n}",
            "beam a {\n    length, shear_stiffness: 1.0 / (2.0 * f(x, y)),\n}",
        ),
        ("general_beam 1 { shear_flexibility: 0.0, rotary_inertia: 0.0, length }", "beam 1 { length }"),
        ("rotational_hinge 2 { stiffness: 0.0 }", "hinge 2 { stiffness_rz: 0.0 }"),
        ("shear_hinge 2 { stiffness }", "hinge 2 { stiffness_y: stiffness }"),
        (
            "planar_hinge 3 { stiffness_x: k, stiffness_theta }",
            "hinge 3 { stiffness_x: k, stiffness_rz: stiffness_theta }",
        ),
        ("planar_body 3 { mass, inertia, output_y: b }", "body 3 { mass, inertia_about_input: inertia, output_y: b }"),
        (
            "spring_damper s { stiffness: k, damping: c } -> lever 4 { output_x: b }",
            "spring s { stiffness: k, damping: c } -> rigid_link 4 { output_x: b }",
        ),
        (
            "shape.state(Model::rotational_hinge_2.input()), \"lever 4\"",
            "shape.state(Model::hinge_2.input()), \"rigid_link 4\"",
        ),
        ("Behind [beam_1 elastic_hinge_4 lever_arm]", "Behind [beam_1 hinge_4 lever_arm]"),
        (
            "Model::planar_beam_column_1, Model::planar_beam_column, Model::beam_column_2",
            "Model::beam_1, Model::beam_column, Model::beam_2",
        ),
        ("mod general_beam; // a planar_beam { of no label }", "mod general_beam; // a planar_beam { of no label }"),
    ] {
        assert_eq!(rewritten(old), new);
        assert_eq!(rewritten(new), new, "twice");
    }
}

#[test]
fn old_words_are_answered_with_the_new_form() {
    assert_refused(
        "
        struct M { l: f64, k: f64 }
        fixed at 0.0 -> planar_beam 1 { axial_stiffness: l, bending_stiffness: 2.0 * k.sqrt(), mass_per_length } -> conn a at l
                        ^^^^^^^^^^^ `planar_beam` is `beam` now: write `beam 1 { bending_stiffness: 2.0 *
                        | k.sqrt(), mass_per_length }`
            -> planar_hinge 2 { stiffness_x: l, stiffness_y: l, stiffness_theta: l } -> fixed;
               ^^^^^^^^^^^^ `planar_hinge` is `hinge` now: write `hinge 2 { stiffness_y: l, stiffness_rz: l }`
        ",
    );
}

/// A new form is accepted, or says by `..` what it lacks: sections stay, what an old word needed is asked for, and a slip stays one.
#[test]
fn new_forms_keep_what_was_meant() {
    assert_refused(
        "
        struct M { l: f64, k: f64 }
        section steel { axial_stiffness: k, bending_stiffness: k, mass_per_length: k }
        fixed -> planar_beam 1 { length: l, ..steel } -> conn a;
                 ^^^^^^^^^^^ `planar_beam` is `beam` now: write `beam 1 { length: l, ..steel }`
        conn a -> timoshenko_beam 2 { length: l, bending_stiffness: k, mass_per_length: k } -> conn b;
                  ^^^^^^^^^^^^^^^ `timoshenko_beam` is `beam` now: write `beam 2 { length: l,
                  | bending_stiffness: k, mass_per_length: k, axial_stiffness: .., shear_stiffness: ..,
                  | rotary_inertia: .. }`
        conn b -> elastic_hinge 3 {} -> conn c;
                  ^^^^^^^^^^^^^ `elastic_hinge` is `hinge` now: write `hinge 3 { stiffness_y: ..,
                  | stiffness_rz: .. }`
        conn c -> rotational_hinge 4 { stifness: k } -> conn d;
                  ^^^^^^^^^^^^^^^^ `rotational_hinge` is `hinge` now: write `hinge 4 { stifness: k,
                  | stiffness_rz: .. }`
        conn d -> planar_body 5 { mass: k, output_x: l, centre_x: -0.5 * l } -> conn e;
                  ^^^^^^^^^^^ `planar_body` is `body` now: write `body 5 { mass: k, output_x: l, centre_x:
                  | -0.5 * l, output_y: .., centre_y: .., inertia_about_input: .. }`
        conn e -> general_beam 6 { length: l, shear_flexibility: f64::max(k, 1.0), shear_stiffness: k, rotary_inertia: -0.0 } -> free;
                  ^^^^^^^^^^^^ `general_beam` is `beam` now: write `beam 6 { length: l, shear_stiffness: 1.0 /
                  | (f64::max(k, 1.0)), axial_stiffness: .., bending_stiffness: .., mass_per_length: .. }`
        conn e <- hinge 7 { stiffness_theta: k } <- fixed;
                            ^^^^^^^^^^^^^^^ `hinge` has no parameter `stiffness_theta`: write `stiffness_rz:
                            | k`
        conn e <- beam 8 { length: l, axial_stiffness: k, bending_stiffness: k, mass_per_length: k, shear_flexibility: 0.1 } <- fixed;
                                                                                                    ^^^^^^^^^^^^^^^^^
                                                                                                    | `beam`
                                                                                                    | has no
                                                                                                    | parameter
                                                                                                    | `shear_flexibility`:
                                                                                                    | write
                                                                                                    | `shear_stiffness:
                                                                                                    | 1.0 /
                                                                                                    | (0.1)`
        ",
    );
}

/// All sources and documents of the repository.
fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let (path, name) = (entry.path(), entry.file_name().to_string_lossy().into_owned());
        if path.is_dir() && name != "target" && !name.starts_with('.') {
            files(&path, found);
        } else if name.ends_with(".rs") || name.ends_with(".md") {
            found.push(path);
        }
    }
}

#[test]
#[ignore = "writes files"]
fn models_are_written_in_new_words() {
    let mut found = Vec::new();
    files(&Path::new(env!("CARGO_MANIFEST_DIR")).join(".."), &mut found);
    // these files speak of old words
    let kept = ["new_words.rs", "old_words.rs", "CHANGELOG.md"];
    for path in found.into_iter().filter(|path| !kept.iter().any(|name| path.ends_with(name))) {
        let text = fs::read_to_string(&path).unwrap();
        let new = rewritten(&text);
        if new != text {
            fs::write(&path, new).unwrap();
        }
    }
}
