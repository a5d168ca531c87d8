//! What a wrong model shows to its author, as far as the compiler itself must say it; the messages of the macro have
//! their tests there. And, beside what is refused, what must not be.

#![cfg(test)]

mod accepted;
mod marks;

#[test]
fn the_compiler_points_at_the_token_that_is_wrong() {
    trybuild::TestCases::new().compile_fail("refused/*.rs");
}

/// The README shows what the compiler shows.
#[test]
fn the_readme_shows_a_real_message() {
    let shown = std::fs::read_to_string("refused/unknown_element.stderr").unwrap();
    let shown = shown.replace("refused/unknown_element.rs", "src/main.rs");
    assert!(include_str!("../../../README.md").contains(shown.trim_end()), "{shown}");
}

/// Nothing is wrong with a whole model: the invocation of the macro begins in the first column, as nothing else in it.
#[test]
fn no_message_underlines_the_whole_macro() {
    for file in std::fs::read_dir("refused").unwrap() {
        let path = file.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "stderr") {
            let shown = std::fs::read_to_string(&path).unwrap();
            let whole = shown.lines().find(|line| line.contains("system! {"));
            assert_eq!(whole, None, "{}", path.display());
        }
    }
}
