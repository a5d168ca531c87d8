//! Which symbol stands for what a member or a support does in space.

use crate::kind::Kind;
use crate::solid::{Grip, Held, Solid};
use crate::vector3::{Vector3, cross, direction3, dot3, length3, plus3, times};
use mstmm_core::{Freedoms, Skew};

const DISPLACEMENTS: [Freedoms; 3] = [Freedoms::X, Freedoms::Y, Freedoms::Z];
const ROTATIONS: [Freedoms; 3] = [Freedoms::RX, Freedoms::RY, Freedoms::RZ];

/// The axes of space, x, y and z.
const AXES: [Vector3; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
const DOWN: Vector3 = [0.0, 0.0, -1.0];

/// How much of a way leads along an axis of space that stands in its place, and how much of all ways has one side.
const ALONG_AXIS: f64 = 0.75;
const ONE_SIDE: f64 = 0.5;

/// The symbol of a member, by the name of its type, what it shares and its axes.
pub(crate) fn kind_of(word: &str, shared: Freedoms, along: Option<Vector3>, axes: Option<[Vector3; 3]>) -> Kind {
    match Kind::of(word) {
        Kind::Beam { width, .. } => Kind::Beam { on_foundation: false, width },
        Kind::Pin | Kind::Slider(_) | Kind::ElasticHinge => Kind::Solid(joint(shared, along, axes)),
        Kind::Other if word.to_lowercase().contains("joint") => Kind::Solid(joint(shared, along, axes)),
        kind => kind,
    }
}

/// The symbol of a joint that shares some freedoms, in its axes.
fn joint(shared: Freedoms, along: Option<Vector3>, axes: Option<[Vector3; 3]>) -> Solid {
    let x = axes.map(|[x, ..]| x).or(along).unwrap_or(AXES[0]);
    let lets_go = Freedoms::SPACE.without(shared);
    if lets_go.is_empty() {
        Solid::Mount
    } else if lets_go.is(Freedoms::RX) {
        Solid::Revolute(x)
    } else if lets_go.is(Freedoms::X) {
        Solid::Prismatic(x)
    } else if lets_go.is(Freedoms::X.union(Freedoms::RX)) {
        Solid::Cylindrical(x)
    } else if lets_go.is(Freedoms::RY.union(Freedoms::RZ)) {
        axes.map_or(Solid::Joint, |[_, y, z]| Solid::Universal([y, z]))
    } else if DISPLACEMENTS.iter().all(|freedom| shared.contains(*freedom)) {
        Solid::Ball
    } else {
        Solid::Joint
    }
}

/// Whether a beam has ball joints at both ends.
pub(crate) fn is_bar(kind: Kind, shared: Freedoms, released: [&Freedoms; 2]) -> bool {
    let bends = Freedoms::RY.union(Freedoms::RZ);
    let is_joined =
        released.iter().all(|released| released.intersection(Freedoms::SPACE.without(Freedoms::RX)).is(bends));
    matches!(kind, Kind::Beam { .. }) && !shared.contains(Freedoms::RX) && is_joined
}

/// The symbol of what the end of a member does not share with its point, in its axes; none where it shares all.
pub(crate) fn release(released: Freedoms, axes: [Vector3; 3]) -> Option<Solid> {
    let [turns, slides] = [ROTATIONS, DISPLACEMENTS]
        .map(|kinds| kinds.into_iter().zip(axes).filter(|(kind, _)| released.contains(*kind)).collect::<Vec<_>>());
    match (slides.first(), turns.as_slice()) {
        (Some((_, axis)), _) => Some(Solid::Prismatic(*axis)),
        (None, []) => None,
        (None, [(_, axis)]) => Some(Solid::Revolute(*axis)),
        (None, _) => Some(Solid::Ball),
    }
}

/// The symbol of a support, given the side on which its point has no members; none where it holds nothing.
pub(crate) fn grip(held: Freedoms, skew: Option<Skew<f64>>, away: Vector3) -> Option<Grip> {
    let rotations = ROTATIONS.iter().all(|freedom| held.contains(*freedom));
    let side = if length3(away) > ONE_SIDE { direction3(away).map_or(DOWN, on_axis) } else { DOWN };
    let across = |normal: Vector3| {
        let lean = dot3(normal, side);
        // across its side it stands on what is below
        let is_back = if lean.abs() > 0.1 { lean < 0.0 } else { below(times(normal, -1.0)) > below(normal) };
        Grip { held: Held::Across { rotations }, ground: times(normal, if is_back { -1.0 } else { 1.0 }) }
    };
    let along = |direction: Vector3| {
        let made_normal = |way: Vector3| direction3(plus3(way, direction, -dot3(way, direction)));
        let ground = [side, DOWN].into_iter().filter(|way| length3(cross(*way, direction)) > 0.3).find_map(made_normal);
        Grip { held: Held::Along { direction, rotations }, ground: ground.unwrap_or([0.0, 1.0, 0.0]) }
    };
    if let Some(skew) = skew {
        return match skew {
            Skew::Normal(normal) => direction3(normal).map(across),
            Skew::Along(way) => direction3(way).map(along),
        };
    }
    let holds: Vec<bool> = DISPLACEMENTS.iter().map(|freedom| held.contains(*freedom)).collect();
    let axis_that = |is_held: bool| holds.iter().position(|holds| *holds == is_held).map_or(AXES[2], |axis| AXES[axis]);
    match holds.iter().filter(|holds| **holds).count() {
        3 => Some(Grip { held: if rotations { Held::All } else { Held::Displacements }, ground: side }),
        2 => Some(along(axis_that(false))),
        1 => Some(across(axis_that(true))),
        _ if held.is_empty() => None,
        _ => Some(Grip { held: Held::Rotations, ground: side }),
    }
}

/// How far below, and then to the front, a way leads.
fn below([x, y, z]: Vector3) -> (f64, f64, f64) {
    (-z, -y, -x)
}

/// A direction, or the axis of space near it.
fn on_axis(way: Vector3) -> Vector3 {
    let near = AXES.into_iter().flat_map(|axis| [axis, times(axis, -1.0)]).find(|axis| dot3(*axis, way) > ALONG_AXIS);
    near.unwrap_or(way)
}
