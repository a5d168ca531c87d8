//! A list answers about motions and sensitivities with a plan only.

use mstmm::list::{AnyUndamped, ListStep, StepList};
use mstmm::prelude::*;

fn main() {
    let steps: [ListStep<AnyUndamped<f64>>; 0] = [];
    let list = StepList::new(&steps).unwrap();
    let root = list.first_frequencies::<1>().unwrap()[0];
    let _ = list.mode_shape(&root);
//               ^^^^^^^^^^ a `StepList` answers this with a plan: `.planned(&mut room)?`
//               ^^^^^^^^^^ the motions of
}
