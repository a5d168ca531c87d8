//! Sensitivities of random models to all fields, places among them, beside derivatives of the determinant of the overall matrix.

use super::Workshop;
use super::damped_models::{DampedFrame, DampedSpans, Suspension};
use super::implicit::derivatives;
use super::line_models::{Girder, Hung, PointMasses, Spans};
use super::plane_models::{Absorbers, Incline, Joints, Ladder, Raft, ThreePorts, Truss};
use super::sampled::{Answer, Sampled, fields};
use crate::portal::Portal;
use mstmm::Complex;
use mstmm::number::{Oscillation, Parameter};

/// Part of the root for a relative change of the field, or of the derivative where that is larger, by which derivatives may differ.
const PART: f64 = 1e-10;

/// Part by which roots of Δ and of the determinant may differ.
const ROOT: f64 = 1e-12;

/// What was compared.
#[derive(Default)]
struct Tally {
    models: u64,
    modes: u64,
    derivatives: u64,
    refused: u64,
    worst: f64,
    /// The model, its seed, the field and the root of the worst one.
    at: String,
}

impl Tally {
    /// Models of one kind, of consecutive seeds.
    fn with<M: Sampled>(mut self, seeds: u64) -> Self {
        for seed in 0..seeds {
            self.compare::<M>(seed);
        }
        self
    }

    /// A model at a lower and at a higher mode, other ones for other seeds.
    fn compare<M: Sampled>(&mut self, seed: u64) {
        let fields = fields::<M>(seed);
        let name = format!("{} {seed}", core::any::type_name::<M>());
        let answers = M::answers(&fields);
        assert!(answers.len() > 2, "{name}: {} modes that vibrate", answers.len());
        let last = answers.len() - 1;
        for mode in [seed as usize % (last - 1), last - seed as usize % 2] {
            self.compare_mode::<M>(&name, &fields, &answers[mode]);
        }
        self.models += 1;
    }

    fn compare_mode<M: Sampled>(&mut self, name: &str, fields: &[f64], answer: &Answer) {
        let Ok(slopes) = &answer.slopes else {
            self.refused += 1;
            return;
        };
        let root = M::Frequency::from_complex(Complex::new(answer.root.re.into(), answer.root.im.into()));
        let (expected, polished) = derivatives(M::determinant, fields, root);
        let size = polished.modulus();
        assert!((polished - root).modulus() < ROOT * size, "{name}: {} and {polished:?}", answer.root);
        assert_eq!(slopes.len(), M::FIELDS.len(), "{name}");
        for (k, (field, _)) in M::FIELDS.iter().enumerate() {
            let expected = expected[k].to_complex();
            let expected = Complex::new(expected.re.to_f64(), expected.im.to_f64());
            let relative = fields[k].abs() / size;
            let error = (slopes[k] - expected).norm() * relative / (expected.norm() * relative).max(1.0);
            let at = format!("{name}, {field} at {}", answer.root);
            assert!(error < PART, "{at}: {} beside {expected}, {error:e}", slopes[k]);
            self.derivatives += 1;
            if error > self.worst {
                (self.worst, self.at) = (error, at);
            }
        }
        self.modes += 1;
    }

    /// Prints what was compared, of which none was refused.
    fn close(&self, what: &str) {
        let Tally { models, modes, derivatives, refused, worst, at } = self;
        println!("{models} {what}: {derivatives} sensitivities of {modes} modes, worst {worst:.1e} of ω/p: {at}");
        assert_eq!(*refused, 0);
    }
}

fn compare_planes(seeds: u64) {
    let planes =
        Tally::default().with::<Portal>(seeds).with::<Workshop>(seeds).with::<Ladder>(seeds).with::<Truss>(seeds);
    let planes = planes.with::<ThreePorts>(seeds).with::<Incline>(seeds).with::<Joints>(seeds);
    planes.with::<Absorbers>(seeds).with::<Raft>(seeds).close("structures of the plane");
}

fn compare_lines(seeds: u64) {
    let lines = Tally::default().with::<Spans>(seeds).with::<PointMasses>(seeds);
    lines.with::<Girder>(seeds).with::<Hung>(seeds).close("structures in a line");
}

fn compare_damped(seeds: u64) {
    let damped = Tally::default().with::<DampedFrame>(seeds).with::<Suspension>(seeds).with::<DampedSpans>(seeds);
    damped.close("damped structures");
}

#[test]
fn sensitivities_are_derivatives_of_the_determinant() {
    compare_planes(1);
    compare_lines(1);
    compare_damped(1);
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn sensitivities_of_hundreds_of_structures_are_derivatives_of_the_determinant() {
    compare_planes(36);
    compare_lines(36);
    compare_damped(24);
}
