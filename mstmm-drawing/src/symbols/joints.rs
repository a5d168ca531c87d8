//! Joints of two points at one place.

use crate::ink::{Ink, Pen};
use crate::outline::Outline;
use crate::symbols::springs;
use crate::vector::{Vector, plus, turned};

/// A slider: two plates that slide along each other in a direction.
pub(super) fn slider(at: Vector, along: Vector) -> Vec<Ink> {
    let across = turned(along);
    let plate = |aside: f64| [-8.0, 8.0].map(|way| plus(plus(at, across, aside), along, way)).into();
    vec![Ink::new(Pen::Spring, Outline::Lines(vec![plate(-2.5), plate(2.5)]))]
}

/// An elastic hinge: a small spiral; between two places at some distance a spring beside a torsion spring.
pub(super) fn elastic(distance: f64, from: Vector, to: Vector) -> Vec<Ink> {
    if distance > 8.0 {
        let bars = [from, to].map(|end| [-8.0, 8.0].map(|aside| plus(end, [aside, 0.0], 1.0)));
        let [[spring, torsion], [spring_end, torsion_end]] = bars;
        let mut inks = springs::spring(spring, spring_end, 0.0);
        inks.extend(springs::torsion(torsion, torsion_end, true));
        inks.push(Ink::new(Pen::Rod, Outline::Lines(bars.map(Vec::from).into())));
        return inks;
    }
    let turns = 1.75 * std::f64::consts::TAU;
    let spiral = (0..=36).map(|k| f64::from(k) / 36.0).map(|part| {
        let (angle, radius) = (part * turns, 1.5 + 5.0 * part);
        plus(from, [radius * angle.cos(), radius * angle.sin()], 1.0)
    });
    vec![Ink::new(Pen::Hollow, Outline::Disc(from, 8.0)), Ink::new(Pen::Spring, Outline::line(spiral.collect()))]
}
