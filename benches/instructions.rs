//! Instructions of one evaluation of Δ and of a whole certified search, beside those of the standard library's sine, cosine
//! and exponential of the beams, counted by Callgrind: the same in every run of the same code.
//!
//! `cargo bench --bench instructions`, with `valgrind` and `gungraun-runner` installed (see CONTRIBUTING.md).
#![expect(missing_docs, reason = "the harness documents none of its items, and refuses documentation of benchmarks")]

use gungraun::{library_benchmark, library_benchmark_group, main};
use mstmm::prelude::*;
use mstmm::{ParameterError, Scaled, System};
use std::hint::black_box;

#[path = "../examples/paper/models.rs"]
pub mod models;

/// A built system that costs its benchmark no copy.
fn kept<Y>(system: Result<Y, ParameterError>) -> &'static Y {
    let Ok(system) = system else { unreachable!("the parameters of the examples are valid") };
    Box::leak(Box::new(system))
}

// Sine, cosine and exponential of so many distinct beams.
#[library_benchmark]
#[bench::one_beam([1.7].as_slice())]
#[bench::three_beams([1.7, 2.3, 3.1].as_slice())]
fn functions(arguments: &[f64]) -> f64 {
    black_box(arguments).iter().map(|z| z.sin() + z.cos() + z.exp()).sum()
}

// Δ(ω).
#[library_benchmark]
#[bench::tip_body(kept(models::light_tip_body().build()), 300.0)]
#[bench::restrained_beam(kept(models::restrained_beam().build()), 1000.0)]
#[bench::spring_and_mass(kept(models::spring_and_mass().build()), 2000.0)]
#[bench::two_spans(kept(models::two_spans().build()), 10_000.0)]
fn characteristic<Y: Characteristic<f64>>(system: &Y, omega: f64) -> Scaled<f64> {
    system.characteristic(black_box(omega))
}

// Δ(λ).
#[library_benchmark]
#[bench::damped_oscillator(kept(models::damped_oscillator().build()), Complex::new(-10.0, 12_000.0))]
fn characteristic_at_lambda(system: &models::DampedOscillatorSystem, lambda: Complex<f64>) -> Scaled<Complex<f64>> {
    system.characteristic(black_box(lambda))
}

// The first five natural frequencies.
#[library_benchmark]
#[bench::tip_body(kept(models::light_tip_body().build()))]
#[bench::restrained_beam(kept(models::restrained_beam().build()))]
#[bench::spring_and_mass(kept(models::spring_and_mass().build()))]
#[bench::two_spans(kept(models::two_spans().build()))]
fn first_frequencies<Y: Undamped + System<Parameter = f64>>(system: &Y) -> usize {
    black_box(system).first_frequencies::<5>().map_or(0, |found| found.len())
}

// The first five eigenvalues.
#[library_benchmark]
#[bench::damped_oscillator(kept(models::damped_oscillator().build()))]
fn first_eigenvalues(system: &models::DampedOscillatorSystem) -> usize {
    black_box(system).first_eigenvalues::<5>().map_or(0, |found| found.len())
}

library_benchmark_group!(
    name = examples,
    benchmarks = [functions, characteristic, characteristic_at_lambda, first_frequencies, first_eigenvalues]
);

main!(library_benchmark_groups = examples);
