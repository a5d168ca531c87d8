//! A model without a certified list is a row like the others.

use crate::{folder, rows_of};
use indicatif::ProgressBar;
use parquet::record::Field;
use sweep::model::{SpringAndMass, model};
use sweep::{Label, Shard, table};

/// Every third one has a mass that cannot be.
fn some_wrong(index: u64) -> SpringAndMass {
    let model = model(index);
    SpringAndMass { mass: if index % 3 == 1 { -2.0 } else { model.mass }, ..model }
}

#[test]
fn models_without_frequencies_are_rows_with_their_error() {
    const MODELS: u64 = 700;
    let folder = folder();
    let [mixed, right] = ["mixed", "right"].map(|name| folder.path().join(name));
    let (label, hidden) = (Label::new(MODELS, 1), ProgressBar::hidden());
    assert_eq!(table::write(&mixed, &label, Shard::WHOLE, some_wrong, &hidden).unwrap(), 233);
    assert_eq!(table::write(&right, &label, Shard::WHOLE, model, &hidden).unwrap(), 0);
    let (mixed, right) = (rows_of(&mixed), rows_of(&right));
    assert_eq!(mixed.len() as u64, MODELS);
    for (index, (mixed, right)) in mixed.iter().zip(&right).enumerate() {
        assert_eq!(right[7], Field::Null);
        if index % 3 != 1 {
            // neighbours that fail may send a model to the search alone, whose last digits are its own
            for (mixed, right) in mixed.iter().zip(right) {
                let (Field::Double(mixed), Field::Double(right)) = (mixed, right) else { continue };
                assert!((mixed - right).abs() <= 1e-14 * right, "{index}: {mixed} and {right}");
            }
            assert_eq!(mixed[7], Field::Null);
            continue;
        }
        assert_eq!(mixed[..3], right[..3]);
        assert_eq!(mixed[3], Field::Double(-2.0));
        assert_eq!(mixed[4..7], [Field::Null, Field::Null, Field::Null]);
        let error = "parameter: mass 6: mass is -2, but must be zero or positive, and finite";
        assert_eq!(mixed[7], Field::Str(error.to_owned()));
    }
}
