//! The text of plans.

use super::*;
use crate::ast::Model;
use crate::diagnostics::Errors;
use crate::{check, parse, topology::Graph};
use expect_test::expect_file;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;

#[path = "../../tests/support/models_in.rs"]
mod models_in;

const EXAMPLES: &str = include_str!("../../../examples/paper/src/models.rs");
const UNDAMPED: &str = include_str!("../../../tests/support/undamped_models.rs");
const DAMPED: &str = include_str!("../../../tests/support/damped_models.rs");

/// The models in a source file.
fn models(source: &str) -> Vec<Model> {
    models_in::models_in(source).unwrap().into_iter().map(model).collect()
}

fn model(tokens: TokenStream) -> Model {
    let braces = Group::new(Delimiter::Brace, quote!((mstmm) #tokens));
    parse::model(TokenTree::Group(braces).into(), &mut Errors::default()).unwrap()
}

/// Does something with the plan of a model.
fn with_plan<R>(model: &Model, look: impl FnOnce(&Plan<'_>) -> R) -> R {
    let mut errors = Errors::default();
    let graph = Graph::of(model, &mut errors);
    look(&Plan::of(&check::topology(model, &graph, errors).unwrap()))
}

/// Written anew by `UPDATE_EXPECT=1 cargo test -p mstmm-language`.
#[test]
fn plans_of_the_examples() {
    let files = [
        expect_file!["snapshots/tip_body.md"],
        expect_file!["snapshots/restrained_beam.md"],
        expect_file!["snapshots/spring_and_mass.md"],
        expect_file!["snapshots/two_spans.md"],
        expect_file!["snapshots/damped_oscillator.md"],
    ];
    let models = models(EXAMPLES);
    assert_eq!(models.len(), files.len());
    for (model, file) in models.iter().zip(files) {
        file.assert_eq(&format!("{}\n", with_plan(model, |plan| plan.to_string())));
    }
}

/// Three paths at a connection, of which the widest comes first; one goes on to fewer states, one comes back from them.
#[test]
fn the_plan_of_paths_that_narrow_and_widen() {
    let model = model(quote! {
        struct Branches { l: f64, ei: f64, m: f64, k: f64 }
        fixed -> spring 1 { stiffness: k } -> conn 2;
        free -> inertia 3 { inertia: m } -> conn 2;
        pinned -> beam 4 { length: l, bending_stiffness: ei, mass_per_length: m } -> conn 2;
        conn 2 -> spring 5 { stiffness: k } -> conn 6 -> beam upper { length: l, bending_stiffness: ei, mass_per_length: m } -> fixed;
        guided -> conn 6
    });
    expect_file!["snapshots/narrow_and_wide.md"]
        .assert_eq(&format!("{}\n", with_plan(&model, |plan| plan.to_string())));
}

/// What rustc alone knows is left to it: the size, and nothing else.
#[test]
fn the_plan_of_a_model_with_an_element_of_the_users_own() {
    let model = model(quote! {
        struct Hanging { length: f64 }
        fixed -> shop::Rope 1 { length } -> conn 2 -> shop::Rope 3 { length } -> fixed;
        free -> mass 4 { mass: 1.0 } -> conn 2
    });
    expect_file!["snapshots/element_of_ones_own.md"]
        .assert_eq(&format!("{}\n", with_plan(&model, |plan| plan.to_string())));
}

/// As many equations as unknowns, none missing and none said twice: in forty-five trees, those of the examples and generated ones.
#[test]
fn the_text_has_as_many_unknowns_and_equations_as_the_equation_is_wide() {
    let models = [EXAMPLES, UNDAMPED, DAMPED].map(models).into_iter().flatten();
    let mut looked_at = 0;
    for model in models {
        with_plan(&model, |plan| {
            let text = plan.to_string();
            let size = plan.size().unwrap();
            let unknowns = text.lines().find_map(|line| line.strip_prefix("z_all = [")).unwrap();
            assert!(text.contains(&format!("U_all z_all = 0, {size} x {size}:")), "{size}\n{text}");
            assert_eq!(unknowns.split(", ").count(), size, "{text}");
            let block = text.lines().skip_while(|line| !line.starts_with("z_all")).skip(1);
            let equations = block.take_while(|line| *line != "```").filter(|line| !line.starts_with(['s', ' ']));
            let main = plan.resolved(|scheme| scheme.space(scheme.len() - 1).size());
            assert_eq!(main + equations.count(), size, "{text}");
        });
        looked_at += 1;
    }
    assert_eq!(looked_at, 45);
}
