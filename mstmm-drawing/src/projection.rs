//! Puts a model in space on the paper.

use crate::anchors::Scale;
use crate::error::DrawingError;
use crate::figure::{Figure, Moves, Part};
use crate::path_places::place_paths;
use crate::scene::Scene;
use crate::vector::{Vector, direction, plus, turned};
use crate::vector3::Vector3;
use crate::view::{Sight, View};

/// The extent of a model on the paper is at least this part of that in space: one that is seen along its only member stays small.
const LEAST: f64 = 0.05;

/// Most units of the paper to which a model is drawn along an axis.
const ROOM: f64 = 520.0;

/// Part of its length of which a path is seen at least, and below which it has no direction on the paper.
const LEAST_WAY: f64 = 0.5;
const NO_WAY: f64 = 0.05;

/// Puts a model in space on the paper, as a view has it; a model of the plane stays.
///
/// # Errors
/// [`DrawingError::View`] for an angle that is not finite, [`DrawingError::Size`] for a model that no scale puts on the paper.
pub(crate) fn project<M>(figure: &mut Figure<M>, view: View) -> Result<(), DrawingError> {
    let sight = view.sight()?;
    let Some(mut scene) = figure.scene.take() else { return Ok(()) };
    let scale = scale(&scene, &sight)?;
    scene.view = view;
    (figure.sight, figure.scale, figure.origin) = (sight, scale.size, scale.place([0.0; 2]));
    for (anchor, place) in figure.anchors.iter_mut().zip(&scene.places) {
        if let Some(place) = place {
            anchor.at = plus(scale.place(sight.seen(place.metres)), sight.way(place.aside), 1.0);
        }
    }
    // the ground of paths is placed anew
    figure.supports.retain(|support| !support.name.starts_with("ground of"));
    let direction = |(part, along): (&Part<M>, &Option<Vector3>)| {
        let way = on_paper(sight.way((*along)?))?;
        // what turns about an axis stands aside of it
        Some(if part.kind.turns() { turned(way) } else { way })
    };
    let directions: Vec<Option<Vector>> = figure.parts.iter().zip(&scene.directions).map(direction).collect();
    place_paths(figure, &scene.loose, &directions);
    for (loose, way) in scene.loose.iter().zip(&scene.ways) {
        if let Moves::Path { node, .. } = figure.anchors[loose.anchor].moves {
            figure.anchors[loose.anchor].moves = Moves::Path { node, along: *way };
        }
    }
    scene.depths = depths(figure, &scene);
    figure.scene = Some(scene);
    Ok(())
}

/// The direction of a path on the paper, as long as it is seen; none where it leads to the reader.
fn on_paper(way: Vector) -> Option<Vector> {
    let length = way[0].hypot(way[1]);
    let long = || direction(way).map(|way| way.map(|part| LEAST_WAY * part));
    if length < NO_WAY {
        None
    } else if length < LEAST_WAY {
        long()
    } else {
        Some(way)
    }
}

/// The scale of a model as it is seen.
fn scale(scene: &Scene, sight: &Sight) -> Result<Scale, DrawingError> {
    let extent = |axis: usize| {
        let ends = scene.extent.iter().map(|(_, place)| place[axis]);
        ends.clone().fold(f64::NEG_INFINITY, f64::max) - ends.fold(f64::INFINITY, f64::min)
    };
    for (name, place) in &scene.extent {
        if let Some(value) = place.iter().find(|part| !part.is_finite()) {
            return Err(DrawingError::NotFinite { name: name.clone(), value: *value });
        }
    }
    let size = (0..3).map(extent).fold(0.0, f64::max);
    // seen from a side its places are sums
    let reach = scene.extent.iter().flat_map(|(_, place)| place).fold(0.0, |most: f64, part| most.max(part.abs()));
    if !(4.0 * size).is_finite() || !(4.0 * reach).is_finite() {
        return Err(DrawingError::Size { size: size.max(reach) });
    }
    let all = || scene.extent.iter().map(|(name, place)| (name.as_str(), sight.seen(*place)));
    if size == 0.0 {
        return Scale::of(all());
    }
    let scale = if scene.extent.iter().all(|(_, place)| is_at(scene, sight, *place, size)) {
        Scale::of(all().take(1))?.with_size(ROOM / size)
    } else {
        let seen = Scale::of(all())?;
        seen.with_size(seen.size.min(ROOM / (LEAST * size)))
    };
    let is_known = scale.size.is_normal() && (4.0 * reach * scale.size).is_finite();
    if is_known { Ok(scale) } else { Err(DrawingError::Size { size }) }
}

/// Whether a place is seen where the first one is.
fn is_at(scene: &Scene, sight: &Sight, place: [f64; 3], size: f64) -> bool {
    let Some((_, first)) = scene.extent.first() else { return true };
    let [x, y] = sight.seen([0, 1, 2].map(|k| (place[k] - first[k]) / size));
    x.hypot(y) < 1e-9
}

/// How near all anchors are; a loose one as what it hangs at.
fn depths<M>(figure: &Figure<M>, scene: &Scene) -> Vec<f64> {
    let sight = &figure.sight;
    let depth = |place: &crate::scene::Place| figure.scale * sight.depth(place.metres) + sight.depth(place.aside);
    let mut depths: Vec<Option<f64>> = scene.places.iter().map(|place| place.as_ref().map(depth)).collect();
    // as often as there are loose anchors, no path is longer
    for _ in 0..scene.loose.len() {
        for part in &figure.parts {
            let [from, to] = [part.ends[0], part.ends[1]];
            let known = depths[from].or(depths[to]);
            (depths[from], depths[to]) = (depths[from].or(known), depths[to].or(known));
        }
    }
    depths.into_iter().map(Option::unwrap_or_default).collect()
}
