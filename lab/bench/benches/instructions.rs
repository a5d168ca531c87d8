//! Instructions of each question to a built system, beside those of the standard library's sine, cosine and exponential of the
//! beams, and their growth with the number of elements and of roots, counted by Callgrind: the same in every run of the same code.
//!
//! `cargo bench --bench instructions`, with `valgrind` and `gungraun-runner` installed (see lab/README.md).
#![expect(missing_docs, reason = "the harness documents none of its items, and refuses documentation of benchmarks")]

use gungraun::{library_benchmark, library_benchmark_group, main};
use mstmm::prelude::*;

use mstmm::element::ParameterError;
use mstmm::motion::{ExtendedTree, FrequencyResponse, Root};
use mstmm::number::{Oscillation, Scaled};
use mstmm::search::{SearchError, System};
use paper::models::{self, DampedOscillator, RestrainedBeam, SpringAndMass, TipBody, TwoSpans};
use paper::models::{damped_oscillator, light_tip_body, restrained_beam, spring_and_mass, two_spans};
use std::hint::black_box;
use subjects::{BeamChain, PinnedBeam, PinnedBeamSystem, around, chain, kept, valid};

pub mod subjects;

/// An undamped system with its lowest root.
fn lowest<Y: Undamped + System<Parameter = f64>>(system: &'static Y) -> (&'static Y, NaturalFrequency) {
    (system, valid(system.first_frequencies::<5>())[0])
}

/// The damped example with its lowest eigenvalue.
fn lowest_damped() -> (&'static models::DampedOscillatorSystem, Eigenvalue) {
    let system = kept(damped_oscillator().build());
    (system, valid(system.first_eigenvalues::<5>())[0])
}

/// The response of a point of a model to a force there.
macro_rules! response_of {
    ($model:expr, $point:expr) => {
        valid(kept($model.build()).frequency_response($point.force(), $point.deflection()))
    };
}

/// The first so many roots of the beam.
fn first<const N: usize>(beam: &PinnedBeamSystem) -> usize {
    beam.first_frequencies::<N>().map_or(0, |found| found.len())
}

// Sine, cosine and exponential of so many distinct beams.
#[library_benchmark]
#[bench::one_beam([1.7].as_slice())]
#[bench::three_beams([1.7, 2.3, 3.1].as_slice())]
fn functions(arguments: &[f64]) -> f64 {
    black_box(arguments).iter().map(|z| z.sin() + z.cos() + z.exp()).sum()
}

// A model becomes a system.
#[library_benchmark]
#[bench::tip_body(light_tip_body(), TipBody::build)]
#[bench::restrained_beam(restrained_beam(), RestrainedBeam::build)]
#[bench::spring_and_mass(spring_and_mass(), SpringAndMass::build)]
#[bench::two_spans(two_spans(), TwoSpans::build)]
#[bench::damped_oscillator(damped_oscillator(), DampedOscillator::build)]
fn build<M, Y, F: Fn(&M) -> Result<Y, ParameterError>>(model: M, build: F) -> Result<Y, ParameterError> {
    build(black_box(&model))
}

// Δ(ω).
#[library_benchmark]
#[bench::tip_body(kept(light_tip_body().build()), 300.0)]
#[bench::restrained_beam(kept(restrained_beam().build()), 1000.0)]
#[bench::spring_and_mass(kept(spring_and_mass().build()), 2000.0)]
#[bench::two_spans(kept(two_spans().build()), 10_000.0)]
fn characteristic<Y: Characteristic<f64>>(system: &Y, omega: f64) -> Scaled<f64> {
    system.characteristic(black_box(omega))
}

// Δ(λ).
#[library_benchmark]
#[bench::damped_oscillator(kept(damped_oscillator().build()), Complex::new(-10.0, 12_000.0))]
fn characteristic_at_lambda(system: &models::DampedOscillatorSystem, lambda: Complex<f64>) -> Scaled<Complex<f64>> {
    system.characteristic(black_box(lambda))
}

// Roots below ω.
#[library_benchmark]
#[bench::tip_body(kept(light_tip_body().build()), 300.0)]
#[bench::restrained_beam(kept(restrained_beam().build()), 1000.0)]
#[bench::spring_and_mass(kept(spring_and_mass().build()), 2000.0)]
#[bench::two_spans(kept(two_spans().build()), 10_000.0)]
fn count_below<Y: Undamped + System<Parameter = f64>>(system: &Y, omega: f64) -> Result<u64, SearchError> {
    system.count_below(black_box(omega))
}

// Roots in the rectangle of Table 6.
#[library_benchmark]
#[bench::damped_oscillator(kept(damped_oscillator().build()))]
fn count_in(system: &models::DampedOscillatorSystem) -> u64 {
    black_box(system).count_in(Region { re: -300.0..=5.0, im: -10.0..=12_000.0 }).unwrap_or(0)
}

// The first five natural frequencies.
#[library_benchmark]
#[bench::tip_body(kept(light_tip_body().build()))]
#[bench::restrained_beam(kept(restrained_beam().build()))]
#[bench::spring_and_mass(kept(spring_and_mass().build()))]
#[bench::two_spans(kept(two_spans().build()))]
fn first_frequencies<Y: Undamped + System<Parameter = f64>>(system: &Y) -> usize {
    black_box(system).first_frequencies::<5>().map_or(0, |found| found.len())
}

// The first five eigenvalues.
#[library_benchmark]
#[bench::damped_oscillator(kept(damped_oscillator().build()))]
fn first_eigenvalues(system: &models::DampedOscillatorSystem) -> usize {
    black_box(system).first_eigenvalues::<5>().map_or(0, |found| found.len())
}

// The shape of the lowest root.
#[library_benchmark]
#[bench::tip_body(lowest(kept(light_tip_body().build())))]
#[bench::restrained_beam(lowest(kept(restrained_beam().build())))]
#[bench::spring_and_mass(lowest(kept(spring_and_mass().build())))]
#[bench::two_spans(lowest(kept(two_spans().build())))]
#[bench::damped_oscillator(lowest_damped())]
fn mode_shape<Y: ExtendedTree<R::Frequency> + System<Parameter = f64>, R: Root<f64>>(mode: (&Y, R)) -> bool {
    black_box(mode.0).mode_shape(black_box(&mode.1)).is_ok()
}

// The response of a point to a force there.
#[library_benchmark]
#[bench::tip_body(response_of!(light_tip_body(), TipBody::body_2.output()), 300.0)]
#[bench::restrained_beam(response_of!(restrained_beam(), RestrainedBeam::conn_4), 1000.0)]
#[bench::spring_and_mass(response_of!(spring_and_mass(), SpringAndMass::conn_5), 2000.0)]
#[bench::two_spans(response_of!(two_spans(), TwoSpans::conn_4), 10_000.0)]
#[bench::damped_oscillator(
    response_of!(damped_oscillator(), DampedOscillator::conn_5),
    Complex::new(0.0, 12_000.0)
)]
fn frequency_response<Y, S>(response: FrequencyResponse<'static, Y>, x: S) -> Option<S>
where
    Y: ExtendedTree<S> + System<Parameter = f64>,
    S: Oscillation<f64>,
{
    black_box(&response).at(black_box(x)).ok()
}

// Δ of a chain.
#[library_benchmark]
#[bench::elements_1(chain(1))]
#[bench::elements_10(chain(10))]
#[bench::elements_100(chain(100))]
#[bench::elements_1000(chain(1000))]
fn chain_characteristic(chain: BeamChain) -> Scaled<f64> {
    chain.characteristic(black_box(30.0))
}

// Roots of a chain below ω.
#[library_benchmark]
#[bench::elements_1(chain(1))]
#[bench::elements_10(chain(10))]
#[bench::elements_100(chain(100))]
#[bench::elements_1000(chain(1000))]
fn chain_count(chain: BeamChain) -> Result<u64, SearchError> {
    chain.count_below(black_box(30.0))
}

// The first so many roots of a beam.
#[library_benchmark]
#[bench::roots_1(kept(PinnedBeam {}.build()), first::<1>)]
#[bench::roots_10(kept(PinnedBeam {}.build()), first::<10>)]
#[bench::roots_100(kept(PinnedBeam {}.build()), first::<100>)]
#[bench::roots_1000(kept(PinnedBeam {}.build()), first::<1000>)]
fn first_roots<F: Fn(&PinnedBeamSystem) -> usize>(beam: &PinnedBeamSystem, search: F) -> usize {
    search(black_box(beam))
}

// One root of a beam, by its number.
#[library_benchmark]
#[bench::mode_1(kept(PinnedBeam {}.build()), 1)]
#[bench::mode_10(kept(PinnedBeam {}.build()), 10)]
#[bench::mode_100(kept(PinnedBeam {}.build()), 100)]
#[bench::mode_1000(kept(PinnedBeam {}.build()), 1000)]
fn root_of_mode(beam: &PinnedBeamSystem, mode: usize) -> usize {
    black_box(beam).natural_frequencies::<1>(around(black_box(mode))).map_or(0, |found| found.len())
}

library_benchmark_group!(
    name = examples,
    benchmarks = [
        functions,
        build,
        characteristic,
        characteristic_at_lambda,
        count_below,
        count_in,
        first_frequencies,
        first_eigenvalues,
        mode_shape,
        frequency_response
    ]
);
library_benchmark_group!(name = growth, benchmarks = [chain_characteristic, chain_count, first_roots, root_of_mode]);

main!(library_benchmark_groups = examples, growth);
