//! Mutations of a model's tokens.

use crate::choices::Choices;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// Tokens with brackets as tokens of their own: a mutation may leave them unbalanced.
#[derive(Clone)]
pub(crate) enum Flat {
    Token(TokenTree),
    Open(Delimiter),
    Close,
}

const DELIMITERS: [&Delimiter; 4] = [&Delimiter::None, &Delimiter::Brace, &Delimiter::Parenthesis, &Delimiter::Bracket];

/// Most tokens of a mutated model: the fuzzer shall try many small ones.
const MOST: usize = 2000;

/// Mutates a model as long as there are choices left. `others` are models to take tokens from, flat and none empty.
pub(crate) fn mutated(
    model: TokenStream,
    others: &[Vec<Flat>],
    words: &[Vec<TokenTree>],
    choices: &mut Choices<'_>,
) -> TokenStream {
    let mut row = flat(model);
    while !choices.is_empty() && !row.is_empty() && row.len() <= MOST {
        mutate(&mut row, others, words, choices);
    }
    balanced(row)
}

fn mutate(row: &mut Vec<Flat>, others: &[Vec<Flat>], words: &[Vec<TokenTree>], choices: &mut Choices<'_>) {
    let action = choices.below(9);
    let at = choices.below(row.len());
    let word = |choices: &mut Choices<'_>| words[choices.below(words.len())].iter().cloned().map(Flat::Token);
    match action {
        0 => drop(row.remove(at)),
        1 => row.insert(at, row[at].clone()),
        2 => {
            let other = choices.below(row.len());
            row.swap(at, other);
        }
        3 => drop(row.splice(at..=at, word(choices))),
        4 => drop(row.splice(at..at, word(choices))),
        5 => {
            let end = at + choices.below(row.len() - at) + 1;
            drop(row.drain(at..end));
        }
        6 => {
            let end = at + choices.below(16.min(row.len() - at)) + 1;
            let copy = row[at..end].to_vec();
            drop(row.splice(end..end, copy));
        }
        7 => {
            let end = at + choices.below(16.min(row.len() - at)) + 1;
            row.insert(end, Flat::Close);
            row.insert(at, Flat::Open(*choices.pick(&DELIMITERS)));
        }
        _ => {
            let donor = &others[choices.below(others.len())];
            let from = choices.below(donor.len());
            let to = from + choices.below(64.min(donor.len() - from)) + 1;
            drop(row.splice(at..at, donor[from..to].iter().cloned()));
        }
    }
}

/// Tokens with brackets as tokens of their own.
pub(crate) fn flat(tokens: TokenStream) -> Vec<Flat> {
    let mut row = Vec::new();
    for token in tokens {
        match token {
            TokenTree::Group(group) => {
                row.push(Flat::Open(group.delimiter()));
                row.extend(flat(group.stream()));
                row.push(Flat::Close);
            }
            other => row.push(Flat::Token(other)),
        }
    }
    row
}

/// Tokens again: what closes nothing is left out, what is open is closed at the end.
fn balanced(row: Vec<Flat>) -> TokenStream {
    let mut open = Vec::new();
    let mut tokens = TokenStream::new();
    for flat in row {
        match flat {
            Flat::Token(token) => tokens.extend([token]),
            Flat::Open(delimiter) => open.push((delimiter, std::mem::take(&mut tokens))),
            Flat::Close => close(&mut open, &mut tokens),
        }
    }
    while !open.is_empty() {
        close(&mut open, &mut tokens);
    }
    tokens
}

fn close(open: &mut Vec<(Delimiter, TokenStream)>, tokens: &mut TokenStream) {
    if let Some((delimiter, outer)) = open.pop() {
        let group = Group::new(delimiter, std::mem::replace(tokens, outer));
        tokens.extend([TokenTree::from(group)]);
    }
}
