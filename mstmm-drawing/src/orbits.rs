//! The orbits of a whirl: circles around the axis of a rotor.

use crate::figure::Figure;
use crate::ink::{Ink, Pen};
use crate::motion::Motion;
use crate::outline::Outline;
use crate::shape::Number;
use crate::vector::{Vector, between, plus};
use mstmm_core::Whirl;
use std::f64::consts::TAU;

/// Points of an orbit.
const POINTS: u32 = 48;

/// Orbits along each part.
const ALONG: usize = 4;

/// Where a displacement of 1 in y, and one in z, leads on the paper: z comes out of it, to the left and downwards.
const WAYS: [Vector; 2] = [[0.0, -1.0], [-0.5, 0.35]];

/// The part of a circle between an orbit's begin, where the shape is, and its arrow.
const ARROW: f64 = 0.13;

/// The orbits of a motion, and the line of the shape through their begins: each begins at a dot and goes round as the whirl does.
pub(crate) fn orbits<M>(figure: &Figure<M>, motion: &Motion, reach: Number, whirl: Whirl) -> Vec<Ink> {
    let mut inks = Vec::new();
    let sign = if whirl == Whirl::Forward { 1.0 } else { -1.0 };
    let mut draw = |at: Vector, [_, y, _]: [Number; 3]| {
        let radius = y * reach;
        // the second displacement follows the first one by a quarter of a turn
        let place = |part: f64| {
            let turned = radius * Number::from_polar(1.0, sign * TAU * part);
            plus(plus(at, WAYS[0], turned.re), WAYS[1], turned.im)
        };
        let circle = (0..POINTS).map(|k| place(f64::from(k) / f64::from(POINTS)));
        inks.push(Ink::new(Pen::Thin, Outline::Area(circle.collect())));
        let (tip, tail) = (place(ARROW), place(ARROW - 0.04));
        let back = plus(tail, tip, -1.0);
        let side = [-0.45 * back[1], 0.45 * back[0]];
        let [left, right] = [1.0, -1.0].map(|way| plus(plus(tip, back, 1.0), side, way));
        inks.push(Ink::new(Pen::Thin, Outline::line(vec![left, tip, right])));
        inks.push(Ink::new(Pen::Dot, Outline::Disc(place(0.0), 2.2)));
    };
    for (part, curve) in figure.parts.iter().zip(&motion.curves).filter(|(_, curve)| !curve.is_empty()) {
        let [from, to] = [part.ends[0], part.ends[1]].map(|end| figure.anchors[end].at);
        let step = (curve.len() - 1).div_ceil(ALONG).max(1);
        let places = (0..curve.len()).filter(|place| place % step == 0 || *place + 1 == curve.len());
        for (share, displacement) in places.map(|place| curve[place]) {
            draw(between(from, to, share), displacement);
        }
    }
    inks
}
