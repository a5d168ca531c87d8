//! Rotors: exact values, closed forms, polynomial elements, laws.

mod answers;
mod closed_forms;
mod damped;
mod exact;
mod example;
mod false_claims;
mod frames;
#[expect(dead_code, reason = "some of what is random")]
#[path = "../support/random.rs"]
mod numbers;
mod polynomial_elements;
mod random;
mod shafts;
