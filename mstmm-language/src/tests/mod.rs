//! Every message of the macro: its text, its place, and that none comes without need.
//!
//! A test shows a wrong model with its messages under the tokens they are about, as the compiler does.

mod depth;
mod derivatives;
mod editors;
mod grammar;
mod graph;
mod meant;
mod network;
mod new_words;
mod rotors;
mod sections;
mod types;
mod undamped;
mod words;

use crate::expand::expand_checked;
use proc_macro2::{TokenStream, TokenTree};
use std::ops::Range;

/// Longest line of a message.
const WIDTH: usize = 110;

/// The model is refused with the messages that stand in it, and with no others.
#[track_caller]
fn assert_refused(model: &str) {
    let is_message = |line: &&str| line.trim_start().starts_with(['^', '|']);
    let source: Vec<&str> = model.trim_matches('\n').lines().filter(|line| !is_message(line)).collect();
    let errors = match expand_checked(input(&source.join("\n"))) {
        Ok(_) => panic!("this model is accepted:\n{model}"),
        Err(errors) => errors,
    };
    let messages: Vec<_> = errors.into_iter().map(|error| (place(&error), error.to_string())).collect();
    let mut shown = String::new();
    for (index, line) in source.iter().enumerate() {
        shown += &format!("{line}\n");
        for ((line, columns), message) in &messages {
            if *line == index + 1 {
                shown += &under(columns, message);
            }
        }
    }
    assert_eq!(shown.trim_end(), model.trim_matches('\n').trim_end(), "\nshown:\n{shown}");
}

/// What is wrong with a model, in one text.
fn messages(model: &str) -> String {
    let errors = expand_checked(input(model)).err().into_iter().flatten();
    errors.map(|error| error.to_string()).collect()
}

/// The model is accepted; its code.
#[track_caller]
fn expanded(model: &str) -> String {
    match expand_checked(input(model)) {
        Ok(code) => code.to_string(),
        Err(error) => panic!("line {}: {error}", place(&error).0),
    }
}

/// What the facade's macro passes on.
fn input(model: &str) -> TokenStream {
    let parse = |text: &str| text.parse::<TokenStream>().unwrap();
    parse("(mstmm)").into_iter().chain::<Vec<TokenTree>>(parse(model).into_iter().collect()).collect()
}

/// Line and columns of an error, which is about one line.
fn place(error: &syn::Error) -> (usize, Range<usize>) {
    let (start, end) = (error.span().start(), error.span().end());
    assert_eq!(start.line, end.line, "{error}: over several lines");
    (start.line, start.column..end.column)
}

/// Carets and a message, broken into lines.
fn under(columns: &Range<usize>, message: &str) -> String {
    let mut text = String::new();
    let mut line = format!("{}{}", " ".repeat(columns.start), "^".repeat(columns.len()));
    for word in message.split(' ') {
        if line.chars().count() + 1 + word.chars().count() > WIDTH {
            text += &format!("{line}\n");
            line = format!("{}|", " ".repeat(columns.start));
        }
        line += &format!(" {word}");
    }
    text + &line + "\n"
}
