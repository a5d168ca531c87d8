//! The answers of models, on all cores.

use crate::model::{FREQUENCIES, SpringAndMass};
use mstmm::prelude::*;
use mstmm::search::SweepError;
use rayon::prelude::*;
use std::{array, iter};

/// Models that a thread solves in a row. Sweeps are divided between such tasks, so that models which are searched together are so in
/// any division.
pub(crate) const TASK: u64 = 256;

/// A model and its answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Values of its parameters.
    pub parameters: [f64; 4],
    /// Its first frequencies, certified, each as often as its multiplicity; or why there is no certified list.
    pub omegas: Result<[f64; FREQUENCIES], String>,
}

/// The rows of models, in their order.
pub fn rows(models: &[SpringAndMass]) -> Vec<Row> {
    models.par_chunks(TASK as usize).flat_map_iter(task).collect()
}

fn task(models: &[SpringAndMass]) -> impl Iterator<Item = Row> {
    models.iter().first_frequencies::<FREQUENCIES>().zip(models).map(|(roots, model)| {
        let omegas = roots.map_err(kind_and_message).map(|roots| {
            let mut omegas = roots.iter().flat_map(|root| iter::repeat_n(root.omega, root.multiplicity as usize));
            // a list of so many first frequencies has as many, counted by multiplicity
            array::from_fn(|_| omegas.next().unwrap_or(f64::NAN))
        });
        Row { parameters: model.values(), omegas }
    })
}

/// The kind of an error in front of its message, so that rows can be grouped by it.
fn kind_and_message(error: SweepError) -> String {
    match error {
        SweepError::Parameter(error) => format!("parameter: {error}"),
        SweepError::Search(error) => format!("search: {error}"),
    }
}
