//! Valid models are accepted; whatever a slip makes of one is refused with errors or gives code.

#[path = "support/cases.rs"]
mod cases;
#[path = "support/choices.rs"]
mod choices;
#[path = "support/located_models.rs"]
mod located_models;
#[path = "support/mutations.rs"]
mod mutations;
#[path = "support/properties.rs"]
mod properties;
#[path = "support/valid_models.rs"]
mod valid_models;
#[path = "support/words.rs"]
mod words;
#[path = "support/written_models.rs"]
mod written_models;

use cases::cases;
use choices::Choices;
use located_models::located_models;
use mutations::{flat, mutated};
use proc_macro2::TokenStream;
use properties::expanded;
use proptest::collection::vec;
use proptest::prelude::*;
use valid_models::valid_model;
use words::words;
use written_models::written_models;

#[track_caller]
fn assert_accepted(model: TokenStream) {
    let text = model.to_string();
    let errors = expanded(model);
    assert!(errors.is_empty(), "{errors:?} in\n{text}");
}

#[test]
fn written_models_are_accepted() {
    let models = written_models();
    assert!(models.len() > 5, "only {} models", models.len());
    models.into_iter().for_each(assert_accepted);
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn valid_models_are_accepted(bytes in vec(any::<u8>(), 0..120)) {
        assert_accepted(valid_model(&mut Choices(&bytes)).parse().unwrap());
    }

    #[test]
    fn mutations_of_a_random_model_are_survived(bytes in vec(any::<u8>(), 0..80), slips in vec(any::<u8>(), 3..40)) {
        let model: TokenStream = valid_model(&mut Choices(&bytes)).parse().unwrap();
        expanded(mutated(model.clone(), &[flat(model)], &words(), &mut Choices(&slips)));
    }
}

/// The models are parsed once: they are many.
#[test]
fn mutations_of_written_models_are_survived() {
    let (models, words) = (written_models(), words());
    let flat: Vec<_> = models.iter().cloned().map(flat).collect();
    proptest!(cases(), |(which in 0..models.len(), slips in vec(any::<u8>(), 3..40))| {
        expanded(mutated(models[which].clone(), &flat, &words, &mut Choices(&slips)));
    });
}

#[test]
fn models_with_locations_are_accepted() {
    located_models().into_iter().for_each(assert_accepted);
}

#[test]
fn mutations_of_models_with_locations_are_survived() {
    let (models, words) = (located_models(), words());
    let flat: Vec<_> = models.iter().chain(&written_models()).cloned().map(flat).collect();
    proptest!(cases(), |(which in 0..models.len(), slips in vec(any::<u8>(), 3..40))| {
        expanded(mutated(models[which].clone(), &flat, &words, &mut Choices(&slips)));
    });
}
