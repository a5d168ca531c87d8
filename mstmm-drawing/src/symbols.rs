//! The symbols of elements.

pub(crate) mod beams;
pub(crate) mod bodies;
pub(crate) mod convex;
mod joints;
pub(crate) mod rotors;
mod solids;
mod springs;

use crate::ink::{Ink, Pen};
use crate::kind::Kind;
use crate::outline::Outline;
use crate::vector::{Vector, distance};
use crate::view::Sight;

/// What is drawn of an element, between its ends or along its curve: as many lines and corners at any moment as at rest.
pub(crate) fn inks(kind: Kind, sight: &Sight, rest: &[Vector], (ends, curve): (&[Vector], &[Vector])) -> Vec<Ink> {
    let (from, to) = (ends[0], ends[1]);
    let line = || Outline::line(if curve.is_empty() { vec![from, to] } else { curve.to_vec() });
    match kind {
        Kind::Beam { on_foundation, width } => {
            let mut inks = vec![beams::line(line(), width)];
            if on_foundation && curve.is_empty() {
                inks.extend(springs::foundation(from, to));
            }
            inks
        }
        Kind::Spinning(radius) => rotors::shaft(radius, line().line_at(0)),
        Kind::Disc => rotors::disc(from, ends[2]),
        Kind::Rod | Kind::Shaft | Kind::Bar => vec![Ink::new(Pen::Rod, line())],
        Kind::Line => vec![Ink::new(Pen::Thin, line())],
        Kind::Lever => vec![Ink::new(Pen::Rod, line())],
        Kind::Tie => vec![Ink::new(Pen::Thin, line())],
        Kind::Body => bodies::body(rest, ends),
        Kind::PointMass => vec![Ink::new(Pen::Dot, Outline::Disc(from, 6.5))],
        Kind::Mass => vec![bodies::block(from)],
        Kind::Inertia => bodies::disc(from),
        Kind::Spring => springs::spring(from, to, 0.0),
        Kind::Damper => springs::damper(from, to, 0.0),
        Kind::SpringDamper => springs::spring_damper(from, to),
        Kind::TorsionSpring => springs::torsion(from, to, true),
        Kind::TorsionDamper => springs::torsion(from, to, false),
        Kind::Pin => vec![Ink::new(Pen::Hollow, Outline::Disc(from, 4.5))],
        Kind::Slider(along) => joints::slider(from, along),
        Kind::ElasticHinge => joints::elastic(distance(rest[0], rest[1]), from, to),
        Kind::Solid(solid) => solids::inks(solid, sight, ends),
        Kind::Other => bodies::other(from, to, curve),
    }
}
