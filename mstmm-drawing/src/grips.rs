//! The symbols of supports in space: blocks, pyramids, rollers.

use crate::ink::{Ink, Pen};
use crate::outline::Outline;
use crate::solid::{Grip, Held};
use crate::symbols::convex::Convex;
use crate::vector::{Vector, plus};
use crate::vector3::{Vector3, across, cross, plus3, times};
use crate::view::Sight;

/// Half of the side of the block of a clamp, and half of its height.
const CLAMP: [f64; 2] = [11.0, 3.5];

/// Height of the pyramid of a hinge, and half of the side of its base.
const PYRAMID: [f64; 2] = [14.0, 7.0];

/// Half of the height of the ground below a symbol.
const GROUND: f64 = 1.6;

/// Radius of a roller.
const ROLLER: f64 = 2.6;

/// What is drawn of a support below the members that it holds.
pub(crate) fn below(Grip { held, ground }: Grip, sight: &Sight, at: Vector) -> Vec<Ink> {
    match held {
        Held::All => {
            let [half, height] = CLAMP;
            block(ground, across(ground), ([half, half, height], height)).inks(sight, at, Pen::Base)
        }
        Held::Displacements => {
            let [height, _] = PYRAMID;
            let sides = across(ground);
            let base = block(ground, sides, ([11.0, 11.0, GROUND], height + GROUND)).inks(sight, at, Pen::Base);
            let tip = Convex::pyramid(ground, sides, PYRAMID).inks(sight, at, Pen::Hollow);
            ordered(ground, sight, vec![base, tip])
        }
        Held::Across { rotations } => on_rollers(ground, across(ground), [11.0, 11.0], rotations, (sight, at)),
        Held::Along { direction, rotations } => {
            on_rollers(ground, [direction, cross(ground, direction)], [17.0, 8.0], rotations, (sight, at))
        }
        Held::Rotations => {
            let [one, other] = across(ground);
            let frame = Convex::block([0.0; 3], [one, other, ground], [8.0, 8.0, 8.0]);
            frame.inks(sight, at, Pen::Hollow)
        }
    }
}

/// What is drawn of a support above the members that it holds: the pin of those that let them turn.
pub(crate) fn above(Grip { held, .. }: Grip, at: Vector) -> Vec<Ink> {
    let turns = match held {
        Held::Displacements => true,
        Held::Across { rotations } | Held::Along { rotations, .. } => !rotations,
        Held::All | Held::Rotations => false,
    };
    let pin = || Ink::new(Pen::Hollow, Outline::Disc(at, 3.2));
    turns.then(pin).into_iter().collect()
}

/// A block across the way to the ground, with half of its sides, at a distance of its middle.
fn block(ground: Vector3, [one, other]: [Vector3; 2], (half, distance): (Vector3, f64)) -> Convex {
    Convex::block(times(ground, distance), [one, other, ground], half)
}

/// A pyramid, or a block that does not turn, on rollers on the ground.
fn on_rollers(
    ground: Vector3,
    sides: [Vector3; 2],
    half: [f64; 2],
    holds_rotations: bool,
    (sight, at): (&Sight, Vector),
) -> Vec<Ink> {
    let (foot, height) = if holds_rotations {
        (block(ground, sides, ([7.0, 7.0, 3.0], 3.0)), 6.0)
    } else {
        (Convex::pyramid(ground, sides, [12.0, 6.0]), 12.0)
    };
    let foot = foot.inks(sight, at, Pen::Hollow);
    let roller = |[one, other]: [f64; 2]| {
        let way = plus3(plus3(times(ground, height + ROLLER), sides[0], one), sides[1], other);
        (sight.depth(way), Ink::new(Pen::Hollow, Outline::Disc(plus(at, sight.way(way), 1.0), ROLLER)))
    };
    let mut rollers = [[-4.5, -4.0], [4.5, -4.0], [4.5, 4.0], [-4.5, 4.0]].map(roller);
    rollers.sort_by(|one, other| one.0.total_cmp(&other.0));
    let below = ([half[0], half[1], GROUND], height + 2.0 * ROLLER + GROUND);
    let base = block(ground, sides, below).inks(sight, at, Pen::Base);
    ordered(ground, sight, vec![base, rollers.map(|(_, ink)| ink).into(), foot])
}

/// Layers from the ground up, those that are nearer to the reader last.
fn ordered(ground: Vector3, sight: &Sight, mut layers: Vec<Vec<Ink>>) -> Vec<Ink> {
    if sight.depth(ground) > 0.0 {
        layers.reverse();
    }
    layers.concat()
}
