//! Mass, stiffness and damping forms of two recorded shapes by quadrature of what they say along the beams.

use crate::mode_shapes::recorded::{C, Ends, Recorded};
use crate::mode_shapes::residuals::section;
use crate::mode_shapes::sketch::{Node, Sketch};
use std::collections::BTreeMap;

/// Points of a panel: exact up to degree 23.
const POINTS: usize = 12;

/// `∫ m Y₁ Y₂`, `∫ M₁ M₂/EI` and the rest of both, and `Σ C Δ₁ Δ₂`.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Forms {
    pub(crate) mass: C,
    pub(crate) stiffness: C,
    pub(crate) damping: C,
}

/// Nodes and weights of Gauss and Legendre on `[0, 1]`, from the zeros of the Legendre polynomial.
fn gauss() -> Vec<(f64, f64)> {
    let n = POINTS as f64;
    let polynomial = |x: f64| {
        let (mut before, mut now) = (1.0, x);
        for k in 1..POINTS {
            let k = k as f64;
            (before, now) = (now, ((2.0 * k + 1.0) * x * now - k * before) / (k + 1.0));
        }
        (now, n * (before - x * now) / (1.0 - x * x))
    };
    let node = |k: usize| {
        let mut x = (core::f64::consts::PI * (k as f64 + 0.75) / (n + 0.5)).cos();
        for _ in 0..8 {
            let (value, slope) = polynomial(x);
            x -= value / slope;
        }
        let slope = polynomial(x).1;
        (0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope))
    };
    (0..POINTS).map(node).collect()
}

/// The forms of two shapes of one system.
pub(crate) fn forms(sketch: &Sketch, first: &Recorded<'_>, second: &Recorded<'_>) -> Forms {
    let rule = gauss();
    let mut sum = Forms::default();
    for node in &sketch.nodes {
        let Node::Element { kind, name, parameters } = node else { continue };
        let (a, b) = (&first.elements[name.as_str()], &second.elements[name.as_str()]);
        let part = match kind.as_str() {
            "beam" => {
                let wave = |shape: &Recorded<'_>| section(parameters, shape.lambda_squared).beta.norm();
                beam(parameters, a, b, wave(first).max(wave(second)), &rule)
            }
            _ => without_waves(parameters, a, b),
        };
        sum.mass += part.mass;
        sum.stiffness += part.stiffness;
        sum.damping += part.damping;
    }
    sum
}

fn beam(parameters: &BTreeMap<String, f64>, a: &Ends<'_>, b: &Ends<'_>, wave: f64, rule: &[(f64, f64)]) -> Forms {
    let length = parameters["length"];
    let panels = 1 + (wave * length / 2.0) as usize;
    let width = length / panels as f64;
    let mut forms = Forms::default();
    for panel in 0..panels {
        for (node, weight) in rule {
            let distance = width * (panel as f64 + node);
            let (a, b) = ((a.along)(distance), (b.along)(distance));
            forms.mass += a.y * b.y * (weight * width * parameters["mass_per_length"]);
            forms.stiffness += a.m * b.m * (weight * width / parameters["bending_stiffness"]);
        }
    }
    forms
}

/// Springs, dampers and hinges by their elongations; masses and bodies by the velocities of their centres.
fn without_waves(parameters: &BTreeMap<String, f64>, a: &Ends<'_>, b: &Ends<'_>) -> Forms {
    let of = |name: &str| parameters.get(name).copied().unwrap_or(0.0);
    let stretch = |ends: &Ends<'_>| ends.output.y - ends.input.y;
    let twist = |ends: &Ends<'_>| ends.output.theta - ends.input.theta;
    let (stretched, twisted) = (stretch(a) * stretch(b), twist(a) * twist(b));
    // a path carries one of them alone, a hinge both with a stiffness each
    let both = stretched + twisted;
    let (mass, centre) = (of("mass"), of("centre_x"));
    let at_centre = |ends: &Ends<'_>| ends.input.y + ends.input.theta * centre;
    let turning = a.input.theta * b.input.theta * (of("inertia") - mass * centre * centre);
    Forms {
        mass: at_centre(a) * at_centre(b) * mass + turning,
        stiffness: both * of("stiffness") + stretched * of("stiffness_y") + twisted * of("stiffness_rz"),
        damping: both * of("damping"),
    }
}

impl Forms {
    /// By how much `λ² T + λ D + V` misses zero, relative to its largest part, or to a usual λ² times T if
    /// that is larger.
    pub(crate) fn imbalance(&self, shape: &Recorded<'_>, usual: f64) -> f64 {
        let parts = [shape.lambda_squared * self.mass, shape.lambda * self.damping, self.stiffness];
        let largest = parts.iter().map(|part| part.norm()).fold(usual * self.mass.norm(), f64::max);
        parts.iter().sum::<C>().norm() / largest
    }

    /// The product of two shapes: `φ₁ᵀ M φ₂ + φ₁ᵀ C φ₂/(λ₁ + λ₂)`.
    pub(crate) fn product(&self, first: &Recorded<'_>, second: &Recorded<'_>) -> C {
        let sum = first.lambda + second.lambda;
        if sum.norm() == 0.0 { self.mass } else { self.mass + self.damping / sum }
    }
}
