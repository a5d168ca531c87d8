//! Diagrams of internal forces of members in space, in their own axes.

use crate::diagram::{Diagram, Force, HEIGHT, LINES, WRITTEN, largest_of, over, written};
use crate::error::DrawingError;
use crate::figure::Figure;
use crate::labels::{Subject, Wanted};
use crate::motion::sampled;
use crate::shape::{Number, Section, Shape};
use crate::vector::{Vector, between, plus};
use crate::vector3::{Vector3, plus3, times};

/// What is drawn of a force at a part of the length of a member: along its local y and z.
pub(crate) type Ordinate = (f64, [f64; 2]);

/// What of a section is drawn along y and z.
fn components(force: Force, section: &Section) -> [Number; 2] {
    let [axial, shear_y, moment_z, shear_z, moment_y, torque] = section.forces;
    match force {
        Force::Axial => [Number::default(), axial],
        Force::Shear => [shear_y, shear_z],
        // a moment about z stretches the side of -y, one about y that of z
        Force::Moment => [-moment_z, moment_y],
        Force::Torque => [Number::default(), torque],
    }
}

/// A force along each part, the real part of it times a number; empty of a part without one.
pub(crate) fn ordinates<M>(
    figure: &Figure<M>,
    shape: &impl Shape<M>,
    force: Force,
    turn: Number,
) -> Result<Vec<Vec<Ordinate>>, DrawingError> {
    let mut found = Vec::new();
    for part in &figure.parts {
        let sections = match part.inside.as_ref().filter(|inside| force.acts_in(part.kind, inside)) {
            Some(inside) => sampled(shape, inside, |section| components(force, section))?,
            None => Vec::new(),
        };
        let real = |section: &Section| components(force, section).map(|value| (value * turn).re);
        let values: Vec<Ordinate> = sections.iter().map(|(at, section)| (*at, real(section))).collect();
        if values.iter().any(|(_, value)| !value.iter().all(|part| part.is_finite())) {
            return Err(DrawingError::MotionNotFinite { name: part.name.clone() });
        }
        found.push(values);
    }
    Ok(found)
}

/// The diagrams of a force, and the size of one of its units on the paper; none where it is zero everywhere.
pub(crate) fn diagrams_in_space<M>(
    figure: &Figure<M>,
    force: Force,
    values: &[Vec<Ordinate>],
) -> Option<(Vec<Diagram>, f64)> {
    let size = |value: &[f64; 2]| value[0].hypot(value[1]);
    let largest = values.iter().flatten().map(|(_, value)| size(value)).fold(0.0, f64::max);
    let scale = HEIGHT / largest;
    let scene = figure.scene.as_ref().filter(|_| scale.is_normal())?;
    let mut found: Vec<(f64, Diagram)> = Vec::new();
    for (part, values) in values.iter().enumerate().filter(|(_, values)| !values.is_empty()) {
        let Some([y, z]) = scene.axes[part] else { continue };
        let ends = &figure.parts[part].ends;
        let [from, to] = [ends[0], ends[1]].map(|end| figure.anchors[end].at);
        let way = |[of_y, of_z]: [f64; 2]| -> Vector3 { plus3(times(y, scale * of_y), z, scale * of_z) };
        let foot = |at: f64| between(from, to, at);
        let tip = |(at, value): Ordinate| plus(foot(at), figure.sight.way(way(value)), 1.0);
        let mut area: Vec<Vector> = vec![from, to];
        area.extend(values.iter().rev().map(|value| tip(*value)));
        let every = (values.len() / LINES).max(1);
        let lines = values.iter().step_by(every).map(|value| vec![foot(value.0), tip(*value)]).collect();
        let value = |(_, value): &Ordinate| if force.has_sign_in_space() { value[1] } else { size(value) };
        let label = largest_of(values, value).filter(|(peak, _)| peak.abs() > WRITTEN * largest);
        let label = label.map(|(peak, alike)| Wanted {
            text: written(peak),
            class: "value",
            title: format!("{} of {}", force.name(), figure.parts[part].name),
            subject: Subject::Line(alike.map(|index| over(&foot, values[index].0, tip(values[index])))),
        });
        let depth = scene.depths[ends[0]] + scene.depths[ends[1]];
        found.push((depth, Diagram { part, area, lines, label }));
    }
    // what is far is below
    found.sort_by(|one, other| one.0.total_cmp(&other.0));
    Some((found.into_iter().map(|(_, diagram)| diagram).collect(), scale))
}
