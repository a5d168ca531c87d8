//! The text of plans, and that what it says of sizes and unknowns is what the core works out.

use super::*;
use crate::ast::Model;
use crate::diagnostics::Errors;
use crate::keywords::{SUPPORTS, State};
use crate::{check, parse, topology::Graph};
use expect_test::expect_file;
use mstmm_core::{Coordinate, Layout, Space, Step as CoreStep, Support};
use proc_macro2::{Delimiter, Group, TokenTree};
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

fn space(state: State) -> Space {
    match state {
        State::Translation => Space::Translation,
        State::Rotation => Space::Rotation,
        State::Bending => Space::Bending,
        State::Planar => Space::Planar,
    }
}

fn support(keyword: &str) -> Support {
    match keyword {
        "fixed" => Support::Fixed,
        "pinned" => Support::Pinned,
        "free" => Support::Free,
        "guided" => Support::Guided,
        other => {
            assert_eq!(other, "roller");
            Support::Roller
        }
    }
}

#[test]
fn unknowns_at_supports_are_those_of_the_core() {
    let name = |state: State, coordinate: &Coordinate| match coordinate {
        Coordinate::Theta => "Θ".to_owned(),
        Coordinate::Q if state == State::Planar => "Qy".to_owned(),
        other => format!("{other:?}"),
    };
    for state in [State::Translation, State::Rotation, State::Bending, State::Planar] {
        for (keyword, _) in SUPPORTS {
            let (support, space) = (support(keyword), space(state));
            let of_core = support.unknowns(space).map(|coordinate| name(state, &coordinate)).collect::<Vec<_>>();
            let of_core = support.exists_in(space).then_some(of_core);
            let of_text = state.unknowns(keyword).map(|list| list.into_iter().map(str::to_owned).collect());
            assert_eq!(of_core, of_text, "{keyword} {state:?}");
        }
    }
}

/// The size that the core resolves, for plans of the lengths that occur.
fn size_of_core(steps: &[CoreStep<'_>]) -> usize {
    macro_rules! by_length {
        ($($length:literal)*) => {
            match steps.len() {
                $($length => Layout::<'_, $length>::new(steps.try_into().unwrap()).size(),)*
                other => panic!("add {other} to the lengths"),
            }
        };
    }
    by_length!(3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39 40)
}

/// A plan as the core takes it.
fn for_core<'p>(plan: &'p Plan<'_>) -> Vec<CoreStep<'p>> {
    let steps = plan.steps.iter().map(|step| match step {
        Step::Tip(keyword) => CoreStep::Tip(support(&keyword.to_string())),
        Step::Element { element, input, .. } => CoreStep::Element(*input, space(element.kind.known().unwrap().state)),
        Step::Connection { inputs, .. } => CoreStep::Connection(inputs),
        Step::Root { support: keyword, input } => CoreStep::Root(*input, support(&keyword.to_string())),
    });
    steps.collect()
}

/// Forty-five trees, those of the examples and generated ones.
#[test]
fn sizes_are_those_that_the_core_resolves() {
    let models = [EXAMPLES, UNDAMPED, DAMPED].map(models).into_iter().flatten();
    let mut compared = 0;
    for model in models {
        with_plan(&model, |plan| {
            let text = plan.to_string();
            let size = size_of_core(&for_core(plan));
            let unknowns = text.lines().find_map(|line| line.strip_prefix("z_all = [")).unwrap();
            assert!(text.contains(&format!("U_all z_all = 0, {size} x {size}:")), "{size}\n{text}");
            assert_eq!(unknowns.split(", ").count(), size, "{text}");
            // as many equations as unknowns: none is missing, none said twice
            let block = text.lines().skip_while(|line| !line.starts_with("z_all")).skip(1);
            let equations = block.take_while(|line| *line != "```").filter(|line| !line.starts_with(['s', ' ']));
            let main = plan.states()[plan.steps.len() - 1].unwrap().size();
            assert_eq!(main + equations.count(), size, "{text}");
        });
        compared += 1;
    }
    assert_eq!(compared, 45);
}
