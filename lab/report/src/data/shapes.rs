//! The first mode shapes of the examples.

use crate::error::ReportError;
use mstmm::prelude::*;
use paper::models::*;

/// Points along a beam.
const POINTS: u32 = 40;

/// The modes of an example that the paper lists.
#[derive(Clone, Debug)]
pub(crate) struct Shapes {
    pub(crate) id: &'static str,
    pub(crate) modes: Vec<Mode>,
}

/// A mode, its largest deflection 1.
#[derive(Clone, Debug)]
pub(crate) struct Mode {
    /// Its frequency or eigenvalue.
    pub(crate) name: String,
    /// Places [m] and deflections along the line of beams and bodies.
    pub(crate) outline: Vec<(f64, Complex<f64>)>,
    /// Places and deflections of point masses.
    pub(crate) masses: Vec<(f64, Complex<f64>)>,
}

impl Mode {
    /// Whether its points move in different phases.
    pub(crate) fn is_complex(&self) -> bool {
        self.outline.iter().chain(&self.masses).any(|(_, deflection)| deflection.im != 0.0)
    }
}

/// The modes of a model: a macro, since each model is a type of its own.
macro_rules! modes {
    (
        $system:ident, $roots:expr, $name:expr, $model:ident,
        beams [$($beam:ident $start:expr => $end:expr),*], bodies [$($body:ident $far:expr),*],
        masses [$($mass:ident $place:expr),*]
    ) => {{
        let mut modes = Vec::new();
        for root in $roots.iter() {
            let shape = $system.mode_shape(root)?;
            let Some(shape) = shape.with_unit_deflection() else { continue };
            let (mut outline, mut masses) = (Vec::new(), Vec::new());
            $(for n in 0..=POINTS {
                let distance = ($end - $start) * (f64::from(n) / f64::from(POINTS));
                outline.push(($start + distance, shape.along($model::$beam, distance)?.y.into()));
            })*
            $(outline.push(($far, shape.state($model::$body.output()).y.into()));)*
            $(masses.push(($place, shape.state($model::$mass.input()).y.into()));)*
            masses.shrink_to_fit();
            modes.push(Mode { name: $name(root), outline, masses });
        }
        modes
    }};
}

fn frequency(root: &NaturalFrequency) -> String {
    format!("{:.2} rad/s", root.omega)
}

fn eigenvalue(root: &Eigenvalue) -> String {
    format!("{:.1} + {:.1}i 1/s", root.lambda.re, root.lambda.im).replace('-', "−")
}

/// All of them.
pub(crate) fn shapes() -> Result<Vec<Shapes>, ReportError> {
    Ok(vec![
        Shapes { id: "4.1a", modes: tip_body(light_tip_body())? },
        Shapes { id: "4.1b", modes: tip_body(heavy_tip_body())? },
        Shapes { id: "4.2", modes: restrained()? },
        Shapes { id: "4.3", modes: with_spring_and_mass()? },
        Shapes { id: "4.4", modes: over_two_spans()? },
        Shapes { id: "4.5", modes: damped()? },
    ])
}

fn tip_body(model: TipBody) -> Result<Vec<Mode>, ReportError> {
    let (system, length) = (model.build()?, model.length);
    let roots = system.first_frequencies::<5>()?;
    Ok(
        modes!(system, roots, frequency, TipBody, beams [beam_1 0.0 => length], bodies [body_2 length + model.depth], masses []),
    )
}

fn restrained() -> Result<Vec<Mode>, ReportError> {
    let model = restrained_beam();
    let system = model.build()?;
    let roots = system.first_frequencies::<3>()?;
    Ok(modes!(system, roots, frequency, RestrainedBeam, beams [beam_3 0.0 => model.length], bodies [], masses []))
}

fn with_spring_and_mass() -> Result<Vec<Mode>, ReportError> {
    let model = spring_and_mass();
    let (system, [spring, mass]) = (model.build()?, [model.spring_position, model.mass_position]);
    let roots = system.first_frequencies::<3>()?;
    Ok(modes!(
        system, roots, frequency, SpringAndMass,
        beams [beam_1 0.0 => spring, beam_4 spring => mass, beam_7 mass => model.length],
        bodies [], masses [mass_6 mass]
    ))
}

fn over_two_spans() -> Result<Vec<Mode>, ReportError> {
    let model = two_spans();
    let (system, [support, spring]) = (model.build()?, [model.support_position, model.spring_position]);
    let roots = system.first_frequencies::<5>()?;
    Ok(modes!(
        system, roots, frequency, TwoSpans,
        beams [beam_1 0.0 => support, beam_3 support => spring, beam_7 spring => model.length],
        bodies [], masses [mass_6 spring]
    ))
}

fn damped() -> Result<Vec<Mode>, ReportError> {
    let model = damped_oscillator();
    let system = model.build()?;
    let [spring, oscillator, torsion] = [model.spring_position, model.oscillator_position, model.torsion_position];
    let roots = system.first_eigenvalues::<5>()?;
    Ok(modes!(
        system, roots, eigenvalue, DampedOscillator,
        beams [
            beam_1 0.0 => spring, beam_4 spring => oscillator, beam_8 oscillator => torsion, beam_11 torsion => model.length
        ],
        bodies [], masses [mass_7 oscillator]
    ))
}
