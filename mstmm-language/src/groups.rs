//! Groups of tokens: makes invisible ones visible, and puts tokens into braces.
//!
//! A fragment that a `macro_rules!` passes on, `$e` in `{ stiffness: $e * 2.0 }`, arrives in a group without delimiters.
//! rustc forgets such a group when it is emitted again, and `1.0 + 1.0` times 2 would be 3.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use syn::Expr;

/// Puts invisible groups that need it into parentheses, at any depth; dissolves the others.
pub(crate) fn made_visible(tokens: TokenStream) -> TokenStream {
    let mut after_pound = false;
    tokens
        .into_iter()
        .flat_map(|tree| {
            // the content of an attribute is no expression, though `derive(Debug)` looks like one
            let in_attribute = after_pound;
            after_pound = matches!(&tree, TokenTree::Punct(punct) if punct.as_char() == '#');
            visible_tree(tree, in_attribute)
        })
        .collect()
}

fn visible_tree(tree: TokenTree, in_attribute: bool) -> TokenStream {
    let TokenTree::Group(group) = tree else { return tree.into() };
    if in_attribute {
        return TokenTree::Group(group).into();
    }
    let content = made_visible(group.stream());
    let delimiter = match group.delimiter() {
        Delimiter::None if !is_compound(&content) => return content,
        Delimiter::None => Delimiter::Parenthesis,
        visible => visible,
    };
    let mut visible = Group::new(delimiter, content);
    visible.set_span(group.span());
    TokenTree::Group(visible).into()
}

/// Whether the tokens are an expression of several parts; a name, a path, a number, a label or a tuple is not.
fn is_compound(content: &TokenStream) -> bool {
    match syn::parse2::<Expr>(content.clone()) {
        Ok(expression) => !matches!(expression, Expr::Path(_) | Expr::Lit(_) | Expr::Paren(_) | Expr::Tuple(_)),
        Err(_) => false,
    }
}

/// Puts tokens into braces that stand at the last of them: there, and not at the whole macro, belongs what is missing at
/// the end.
pub(crate) fn in_braces(input: TokenStream) -> TokenStream {
    let last = input.clone().into_iter().last();
    let mut braces = Group::new(Delimiter::Brace, input);
    if let Some(last) = last {
        braces.set_span(match &last {
            TokenTree::Group(group) => group.span_close(),
            other => other.span(),
        });
    }
    TokenTree::Group(braces).into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use quote::quote;

    fn invisible(content: TokenStream) -> TokenTree {
        TokenTree::Group(Group::new(Delimiter::None, content))
    }

    #[test]
    fn sums_are_parenthesised_and_names_are_not() {
        let (sum, name) = (invisible(quote!(1.0 + k)), invisible(quote!(k)));
        let visible = made_visible(quote!(max!(#sum * 2.0, #name)));
        assert_eq!(visible.to_string(), quote!(max!((1.0 + k) * 2.0, k)).to_string());
    }
}
