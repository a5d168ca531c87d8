//! Prints what this machine finds at values of sliders, a line of JSON for each, beside which the module is compared.

use explorer::model::MODELS;
use explorer::shown::Shown;
use std::error::Error;

/// Models with values of their sliders: as they stand at first, the symmetric portal of the reference cases, and others.
const ASKED: [(usize, &[f64]); 6] = [
    (0, &[760.0, 55.2, 360.0, 50.0, 24.0, 0.5]),
    (0, &[300.0, 90.0, 900.0, 31.5, 20.0, 2.0]),
    (0, &[5000.0, 140.0, 1500.0, 70.0, 34.0, 0.1]),
    (1, &[4.0, 44.0, 3.0, 200.0, 1.0]),
    (1, &[2.0, 35.0, 2.0, 0.0, 1.0]),
    (1, &[2.5, 80.0, 5.5, 900.0, 7.5]),
];

fn main() -> Result<(), Box<dyn Error>> {
    let shown = Shown::new();
    for (model, values) in ASKED {
        MODELS[model].show(values, &shown)?;
        let tables = shown.tables().map(|(name, _, table)| {
            let mut numbers = Vec::new();
            table.each(&mut |number| numbers.push(number));
            format!("{name:?}:{numbers:?}")
        });
        println!(r#"{{"model":{model},"values":{values:?},"tables":{{{}}}}}"#, tables.join(","));
    }
    Ok(())
}
