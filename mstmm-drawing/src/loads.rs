//! Loads as arrows.

use crate::figure::{Figure, Inside, Moves};
use crate::kind::Kind;
use crate::vector3::Vector3;
use mstmm_core::{Freedoms, Load, PlaneLoad, PlanePoint};

/// A load that can be drawn: one of a frame, [`PlaneLoad`], or of paths, [`Load`].
pub trait Loading<M>: private::Acts<M> {}

impl<M, L: private::Acts<M>> Loading<M> for L {}

/// A load of some amount on a drawing.
#[derive(Debug)]
pub(crate) struct Loaded {
    pub(crate) arrows: Vec<Arrow>,
    pub(crate) amount: f64,
    /// Whether it acts on masses.
    pub(crate) is_acceleration: bool,
}

/// Where an arrow is, and its direction in the model where the amount is positive, of length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Arrow {
    /// A force at an anchor.
    Force(usize, Vector3),
    /// A moment at an anchor about an axis.
    Moment(usize, Vector3),
    /// A load all along a part.
    Spread(usize, Vector3),
}

pub(crate) mod private {
    use super::{Arrow, Figure};

    /// A load that says where it acts.
    pub trait Acts<M> {
        /// Its arrows; none where it acts on nothing that is drawn.
        fn arrows(&self, figure: &Figure<M>) -> Vec<Arrow>;

        /// Whether it acts on masses.
        fn is_acceleration(&self) -> bool;
    }
}

impl Arrow {
    /// A force or a moment at an anchor in a freedom of the axes of the model.
    fn at(anchor: usize, freedom: Freedoms) -> Option<Arrow> {
        let (displacements, rotations) =
            ([Freedoms::X, Freedoms::Y, Freedoms::Z], [Freedoms::RX, Freedoms::RY, Freedoms::RZ]);
        let axis = |all: [Freedoms; 3]| all.iter().position(|own| own.is(freedom)).map(unit);
        let force = axis(displacements).map(|direction| Arrow::Force(anchor, direction));
        force.or_else(|| axis(rotations).map(|axis| Arrow::Moment(anchor, axis)))
    }

    /// A load along a part.
    fn along(part: usize, (freedom, sign): (Freedoms, f64)) -> Option<Arrow> {
        match Arrow::at(part, freedom) {
            Some(Arrow::Force(_, direction)) => Some(Arrow::Spread(part, direction.map(|part| sign * part))),
            _ => None,
        }
    }
}

/// An axis of the model.
fn unit(axis: usize) -> Vector3 {
    std::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 })
}

/// The arrows along parts, and before them those at the mass centres, on which an acceleration acts as it does along a part.
fn all_along<M>(figure: &Figure<M>, spread: Vec<Arrow>, is_acceleration: bool) -> Vec<Arrow> {
    let along = spread.first().copied().filter(|_| is_acceleration);
    let is_mass = |kind: Kind| kind.is_body() || matches!(kind, Kind::PointMass | Kind::Disc | Kind::Mass);
    let masses = figure.parts.iter().filter(|part| is_mass(part.kind));
    let on_masses = masses.filter_map(|part| match along {
        Some(Arrow::Spread(_, direction)) => Some(Arrow::Force(*part.ends.last()?, direction)),
        _ => None,
    });
    on_masses.chain(spread).collect()
}

impl<M> private::Acts<M> for PlaneLoad<M> {
    fn arrows(&self, figure: &Figure<M>) -> Vec<Arrow> {
        let at = |point: PlanePoint<M>, anchor| self.at_point(point).and_then(|freedom| Arrow::at(anchor, freedom));
        let points = figure.anchors.iter().enumerate().filter_map(|(anchor, own)| match own.moves {
            Moves::Point(point) => at(point, anchor),
            Moves::End(end) => at(end.into(), anchor),
            _ => None,
        });
        let members = || {
            let of_member = |part: &crate::figure::Part<M>| match part.inside {
                Some(Inside::Member(label, _)) => Some(label),
                _ => None,
            };
            figure.parts.iter().enumerate().filter_map(move |(index, part)| Some((index, of_member(part)?, &part.ends)))
        };
        let ends = members().flat_map(|(_, label, ends)| {
            [at(label.input().into(), ends[0]), at(label.output().into(), ends[1])].into_iter().flatten()
        });
        // a point is there once for each end that meets it
        if let Some(arrow) = points.chain(ends).next() {
            return vec![arrow];
        }
        let spread = members().filter_map(|(part, label, _)| Arrow::along(part, self.along_member(label)?));
        all_along(figure, spread.collect(), PlaneLoad::is_acceleration(*self))
    }

    fn is_acceleration(&self) -> bool {
        PlaneLoad::is_acceleration(*self)
    }
}

impl<M> private::Acts<M> for Load<M> {
    fn arrows(&self, figure: &Figure<M>) -> Vec<Arrow> {
        let spots = figure.spots.iter().filter_map(|(point, anchor)| {
            let Moves::Tree { along: [x, y], .. } = figure.anchors[*anchor].moves else { return None };
            match self.at_point(*point)? {
                Freedoms::RZ => Some(Arrow::Moment(*anchor, unit(2))),
                _ => Some(Arrow::Force(*anchor, [x, y, 0.0])),
            }
        });
        if let Some(arrow) = spots.into_iter().next() {
            return vec![arrow];
        }
        let spread = figure.parts.iter().enumerate().filter_map(|(index, part)| {
            let Some(Inside::Element { label, .. }) = part.inside else { return None };
            Arrow::along(index, self.along_element(label)?)
        });
        all_along(figure, spread.collect(), Load::is_acceleration(*self))
    }

    fn is_acceleration(&self) -> bool {
        Load::is_acceleration(*self)
    }
}
