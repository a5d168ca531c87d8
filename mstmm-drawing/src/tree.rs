//! A tree on the paper.

use crate::anchors::Scale;
use crate::error::DrawingError;
use crate::figure::{Anchor, Figure, Holds, Inside, Moves, Part, Support, label_of};
use crate::kind::Kind;
use crate::symbols::beams::scale_beams;
use crate::symbols::rotors::{factor, radius_of_disc};
use crate::tree_places::{Beside, Edge, TreePlaces, places, way_of};
use crate::vector::{Vector, plus};
use crate::view::Sight;
use mstmm_core::{DrawnPart, DrawnStep, DrawnTree, Freedoms, Space, TreeSketch};

/// How deflections are drawn: along a direction, and whether rotations are drawn as such.
#[derive(Clone, Copy)]
struct Deflection {
    along: Vector,
    is_rotation: bool,
}

/// Puts a sketch on the paper.
pub(crate) fn figure<Y: DrawnTree>(sketch: &TreeSketch<'_, Y>) -> Result<Figure<Y::Model>, DrawingError> {
    let steps: Vec<DrawnStep<'_, Y::Model>> = sketch.steps().collect();
    let is_in_line = is_in_line(&steps);
    let place_of = places_of(&steps);
    let held = held(&steps, &place_of);
    let edges = edges(&steps, &place_of, is_in_line);
    let between: Vec<Edge> = edges.iter().map(|(_, edge)| *edge).collect();
    // metres do not depend on lanes, but whether paths lie side by side depends on the scale
    let unscaled = places(&between, &held, 1.0);
    let named = edges.iter().flat_map(|(step, edge)| edge.ends.map(|end| (*step, unscaled.places[end].metres)));
    let names: Vec<(String, Vector)> = named.map(|(step, metres)| (steps[step].name.to_string(), metres)).collect();
    let scale = Scale::of(names.iter().map(|(name, metres)| (name.as_str(), *metres)))?;
    let found = places(&between, &held, scale.size);
    let deflection = deflection(&steps, is_in_line);
    let mut figure = Figure {
        anchors: Vec::new(),
        parts: Vec::new(),
        supports: Vec::new(),
        spots: steps.iter().map(|step| step.point).zip(place_of.iter().copied()).collect(),
        scale: scale.size,
        origin: scale.place([0.0; 2]),
        sight: Sight::PLANE,
        scene: None,
    };
    add_anchors(&mut figure, &steps, &place_of, &found, (scale, deflection));
    for (index, (step, edge)) in edges.iter().enumerate() {
        let ends = beside(&mut figure, edge.ends, found.beside[index], &steps[*step]);
        add_element(&mut figure, &steps[*step], ends, deflection);
    }
    add_supports(&mut figure, &steps, &place_of);
    scale_shafts(&mut figure);
    scale_beams(&mut figure);
    Ok(figure)
}

/// Scales all radii of shafts alike, so that they are seen.
fn scale_shafts<M>(figure: &mut Figure<M>) {
    let radii =
        figure.parts.iter().filter_map(|part| if let Kind::Spinning(radius) = part.kind { Some(radius) } else { None });
    let factor = factor(radii);
    for part in &mut figure.parts {
        if let Kind::Spinning(radius) = &mut part.kind {
            *radius *= factor;
        }
    }
}

/// Whether the state of a path has displacements across x, on which others hang.
fn is_in_line<M>(steps: &[DrawnStep<'_, M>]) -> bool {
    steps.iter().all(|step| {
        let is_string = matches!(step.part, DrawnPart::Element { kind, .. } if Kind::of(kind) == Kind::Line);
        step.space.count() < 2 && !is_string
    })
}

/// How deflections are drawn: of a path in line along it, but for rotations, across x else.
fn deflection<M>(steps: &[DrawnStep<'_, M>], is_in_line: bool) -> Deflection {
    let is_rotation = steps.iter().all(|step| step.space.is(Space::Rotation));
    Deflection { along: if is_in_line && !is_rotation { [1.0, 0.0] } else { [0.0, 1.0] }, is_rotation }
}

/// The place of each step, by its number: a connection and a root are where their inputs end.
fn places_of<M>(steps: &[DrawnStep<'_, M>]) -> Vec<usize> {
    let mut place_of: Vec<usize> = (0..steps.len()).collect();
    for (index, step) in steps.iter().enumerate() {
        if matches!(step.part, DrawnPart::Element { .. }) {
            continue;
        }
        for &input in step.inputs {
            let [one, other] = [place_of[input], place_of[index]];
            place_of.iter_mut().filter(|place| **place == other).for_each(|place| *place = one);
        }
    }
    let mut numbers: Vec<usize> = place_of.clone();
    numbers.sort_unstable();
    numbers.dedup();
    place_of.iter().map(|place| numbers.binary_search(place).unwrap_or(0)).collect()
}

/// Whether each place has a support.
fn held<M>(steps: &[DrawnStep<'_, M>], place_of: &[usize]) -> Vec<bool> {
    let mut held = vec![false; place_of.iter().max().map_or(0, |last| last + 1)];
    for (index, step) in steps.iter().enumerate() {
        held[place_of[index]] |= holds(step).is_some();
    }
    held
}

/// The elements between their places, each with its step.
fn edges<M>(steps: &[DrawnStep<'_, M>], place_of: &[usize], is_in_line: bool) -> Vec<(usize, Edge)> {
    let element = |(index, step): (usize, &DrawnStep<'_, M>)| {
        let DrawnPart::Element { kind, extent } = step.part else { return None };
        let input = *step.inputs.first()?;
        let joins =
            |next: &DrawnStep<'_, M>| matches!(next.part, DrawnPart::Connection) && next.inputs.contains(&index);
        let joins_ground = holds(&steps[input]).is_some() && steps.iter().any(joins);
        let way = way_of(Kind::of(kind), extent.output, is_in_line, joins_ground);
        Some((index, Edge { ends: [place_of[input], place_of[index]], way }))
    };
    steps.iter().enumerate().filter_map(element).collect()
}

/// An anchor for each place.
fn add_anchors<M>(
    figure: &mut Figure<M>,
    steps: &[DrawnStep<'_, M>],
    place_of: &[usize],
    found: &TreePlaces,
    (scale, Deflection { along, is_rotation }): (Scale, Deflection),
) {
    for (place, spot) in found.places.iter().enumerate() {
        let here = || steps.iter().zip(place_of).filter(|(_, own)| **own == place).map(|(step, _)| step);
        let name = here().find(|step| matches!(step.part, DrawnPart::Connection)).map(|step| step.name.to_string());
        let widest = here().max_by_key(|step| step.space.count());
        let moves = widest.map_or(Moves::Rest, |step| Moves::Tree { point: step.point, along, is_rotation });
        let [x, y] = scale.place(spot.metres);
        let at = [x + spot.shift[0], y + spot.shift[1]];
        figure.anchors.push(Anchor { at, moves, name: name.filter(|name| label_of(name).is_some()) });
    }
}

/// The anchors of an element, of one that begins beside its place with a rigid link to it.
fn beside<M>(figure: &mut Figure<M>, ends: [usize; 2], beside: Option<Beside>, step: &DrawnStep<'_, M>) -> [usize; 2] {
    let Some(Beside { end, shift }) = beside else { return ends };
    let place = &figure.anchors[ends[end]];
    let anchor = Anchor { at: plus(place.at, shift, 1.0), moves: place.moves.copy(), name: None };
    let mut moved = ends;
    moved[end] = figure.anchors.len();
    figure.anchors.push(anchor);
    let (name, link) = (format!("link of {}", step.name), vec![ends[end], moved[end]]);
    figure.parts.push(Part { name, word: "link", kind: Kind::Lever, ends: link, inside: None });
    moved
}

fn add_element<M>(figure: &mut Figure<M>, step: &DrawnStep<'_, M>, ends: [usize; 2], deflection: Deflection) {
    let (DrawnPart::Element { kind: word, extent }, Some(label)) = (step.part, step.label) else { return };
    let (mut kind, Deflection { along, is_rotation }) =
        (Kind::of(word).of_stiffness(extent.bending_stiffness), deflection);
    let radius = extent.radius * figure.scale;
    let mut ends = Vec::from(ends);
    if let Some(centre) = extent.centre {
        let at = figure.anchors[ends[0]].at;
        let at = [at[0] + figure.scale * centre[0], at[1] - figure.scale * centre[1]];
        ends.push(figure.anchors.len());
        figure.anchors.push(Anchor {
            at,
            moves: Moves::Tied { anchor: ends[0], arm: [centre[0], centre[1], 0.0] },
            name: None,
        });
    }
    match &mut kind {
        Kind::Spinning(own) => *own = radius,
        Kind::Disc => {
            let (at, radius) = (figure.anchors[ends[0]].at, radius_of_disc(radius));
            let moves = Moves::Tied { anchor: ends[0], arm: [0.0, radius / figure.scale, 0.0] };
            ends.push(figure.anchors.len());
            figure.anchors.push(Anchor { at: [at[0], at[1] - radius], moves, name: None });
        }
        _ => {}
    }
    let length = extent.output[0];
    let is_long = length > 0.0 && !matches!(kind, Kind::Body | Kind::Lever) && !step.space.contains(Freedoms::X);
    let inside = is_long.then_some(Inside::Element { label, length, along, is_rotation });
    figure.parts.push(Part { name: step.name.to_string(), word, kind, ends, inside });
}

fn add_supports<M>(figure: &mut Figure<M>, steps: &[DrawnStep<'_, M>], place_of: &[usize]) {
    for (index, step) in steps.iter().enumerate() {
        if let Some(holds) = holds(step) {
            let name = step.name.to_string();
            figure.supports.push(Support { name, anchor: place_of[index], holds });
        }
    }
}

/// What a step holds; none where it is no support, or a free one.
fn holds<M>(step: &DrawnStep<'_, M>) -> Option<Holds> {
    let DrawnPart::Support(support) = step.part else { return None };
    match support {
        mstmm_core::Support::Fixed => Some(Holds::All),
        mstmm_core::Support::Pinned => Some(Holds::Displacements),
        mstmm_core::Support::Guided => Some(Holds::AcrossAndRotation([0.0, 1.0])),
        mstmm_core::Support::Roller => Some(Holds::Across([1.0, 0.0])),
        mstmm_core::Support::Free => None,
    }
}
