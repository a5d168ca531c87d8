//! A motion in the numbers of a drawing: displacements of all anchors and along all members.

use crate::diagram::Force;
use crate::error::DrawingError;
use crate::figure::{Figure, Inside, Moves};
use crate::shape::{Number, Section, Shape};
use mstmm_core::MotionError;

/// Number of samples from which the line of a member is refined, and up to which.
const SAMPLES: usize = 24;
const MOST_SAMPLES: usize = 768;

/// Part of the largest value of a member by which its line may be beside the curve.
const BESIDE: f64 = 1.0 / 250.0;

/// Part by which rounding may make one of two displacements larger than the other.
const ALIKE: f64 = 1e-6;

/// The displacements of a motion.
#[derive(Debug)]
pub(crate) struct Motion {
    /// Of each anchor, along x, y and z of the model.
    pub(crate) anchors: Vec<[Number; 3]>,
    /// The displacements along each part, at parts of its length; empty of a part without inside.
    pub(crate) curves: Vec<Vec<(f64, [Number; 3])>>,
    /// Whether parts move out of phase.
    pub(crate) is_complex: bool,
    /// Whether its sign, or its phase, says nothing.
    is_mode: bool,
}

impl Motion {
    /// The displacements of a shape.
    pub(crate) fn of<M, S: Shape<M>>(figure: &Figure<M>, shape: &S) -> Result<Self, DrawingError> {
        let mut anchors: Vec<[Number; 6]> = Vec::new();
        for anchor in &figure.anchors {
            let displacement = match anchor.moves {
                // anchors are tied to earlier ones
                Moves::Tied { anchor, arm } => tied(anchors[anchor], arm),
                _ => shape.at(&anchor.moves)?,
            };
            check(&displacement, || anchor.name.clone().unwrap_or_else(|| "a point".to_owned()))?;
            anchors.push(displacement);
        }
        let mut curves: Vec<Vec<(f64, [Number; 3])>> = Vec::new();
        for part in &figure.parts {
            let sections = match &part.inside {
                Some(inside) => sampled(shape, inside, |section| section.displacement)?,
                None => Vec::new(),
            };
            for (_, section) in &sections {
                check(&section.displacement, || part.name.clone())?;
            }
            curves.push(sections.into_iter().map(|(at, section)| (at, section.displacement)).collect());
        }
        let of_curves = curves.iter().flatten().flat_map(|(_, displacement): &(f64, [Number; 3])| displacement);
        let is_complex = anchors.iter().flatten().chain(of_curves).any(|number| number.im != 0.0);
        let anchors = anchors.into_iter().map(|[x, y, z, ..]| [x, y, z]).collect();
        Ok(Motion { anchors, curves, is_complex, is_mode: S::IS_MODE })
    }

    /// The largest displacement, the first of several, and the phase at which it is drawn: of a mode that in which its largest part is
    /// upwards, or to the right; of parts alike that along z, then that along y.
    pub(crate) fn largest(&self) -> (f64, f64) {
        let anchors = self.anchors.iter().copied();
        let curves = self.curves.iter().flatten().map(|(_, displacement)| *displacement);
        let size = |[x, y, z]: [Number; 3]| x.norm().hypot(y.norm()).hypot(z.norm());
        let larger = |best, next| if size(next) > (1.0 + ALIKE) * size(best) { next } else { best };
        let largest = anchors.chain(curves).fold([Number::default(); 3], larger);
        let larger = |best: Number, next: Number| if next.norm() > (1.0 + ALIKE) * best.norm() { next } else { best };
        let [x, y, z] = largest;
        (size(largest), if self.is_mode { larger(larger(z, y), x).arg() } else { 0.0 })
    }
}

/// The motion of a place that another one ties rigidly.
fn tied([x, y, z, about_x, about_y, about_z]: [Number; 6], [u, v, w]: [f64; 3]) -> [Number; 6] {
    let moved = [x + (about_y * w - about_z * v), y + (about_z * u - about_x * w), z + (about_x * v - about_y * u)];
    [moved[0], moved[1], moved[2], about_x, about_y, about_z]
}

fn check(numbers: &[Number], name: impl Fn() -> String) -> Result<(), DrawingError> {
    let is_finite = numbers.iter().all(|number| number.re.is_finite() && number.im.is_finite());
    if is_finite { Ok(()) } else { Err(DrawingError::MotionNotFinite { name: name() }) }
}

/// Cross sections along a member, so many that a line through them is a curve; none where it has no inside.
pub(crate) fn sampled<M, const N: usize>(
    shape: &impl Shape<M>,
    inside: &Inside<M>,
    values: impl Fn(&Section) -> [Number; N],
) -> Result<Vec<(f64, Section)>, DrawingError> {
    let at = |sample: usize, of: usize| {
        let part = sample as f64 / of as f64;
        shape.along(inside, part).map(|section| (part, section))
    };
    let first: Result<Vec<_>, MotionError> = (0..=SAMPLES).map(|sample| at(sample, SAMPLES)).collect();
    let mut sections = match first {
        Err(MotionError::NoInside) => return Ok(Vec::new()),
        sections => sections?,
    };
    while sections.len() <= MOST_SAMPLES {
        let count = 2 * (sections.len() - 1);
        let middles: Result<Vec<_>, MotionError> = (0..count / 2).map(|k| at(2 * k + 1, count)).collect();
        let middles = middles?;
        let size = |section: &Section| values(section).iter().map(|value| value.norm()).fold(0.0, f64::max);
        let largest = sections.iter().chain(&middles).map(|(_, section)| size(section)).fold(0.0, f64::max);
        let beside = |(pair, (_, middle)): (&[(f64, Section)], &(f64, Section))| {
            let [a, b, c] = [&pair[0].1, middle, &pair[1].1].map(&values);
            (0..N).map(|k| (b[k] - (a[k] + c[k]) * 0.5).norm()).fold(0.0, f64::max)
        };
        let worst = sections.windows(2).zip(&middles).map(beside).fold(0.0, f64::max);
        if worst <= BESIDE * largest {
            break;
        }
        let mut finer = Vec::with_capacity(count + 1);
        for (section, middle) in sections.iter().zip(&middles) {
            finer.extend([*section, *middle]);
        }
        finer.extend(sections.last().copied());
        sections = finer;
    }
    Ok(sections)
}

/// A force along each part, the real part of it times a number: at parts of its length; empty of a part without one.
pub(crate) fn forces<M>(
    figure: &Figure<M>,
    shape: &impl Shape<M>,
    force: Force,
    turn: Number,
) -> Result<Vec<Vec<[f64; 2]>>, DrawingError> {
    let mut found = Vec::new();
    for part in &figure.parts {
        let sections = match part.inside.as_ref().filter(|inside| force.acts_in(part.kind, inside)) {
            Some(inside) => sampled(shape, inside, |section| [section.forces[force.index()]])?,
            None => Vec::new(),
        };
        let values: Vec<[f64; 2]> =
            sections.iter().map(|(at, section)| [*at, (section.forces[force.index()] * turn).re]).collect();
        if values.iter().flatten().any(|value| !value.is_finite()) {
            return Err(DrawingError::MotionNotFinite { name: part.name.clone() });
        }
        found.push(values);
    }
    Ok(found)
}
