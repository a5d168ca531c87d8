//! The symbols of supports, turned to where nothing else is.

use crate::figure::{Figure, Holds};
use crate::ink::{Ink, Pen};
use crate::kind::Kind;
use crate::outline::Outline;
use crate::vector::{Vector, direction, distance, dot, plus, turned};

/// Where a support stands, and the way from its point to the ground.
pub(crate) struct Standing {
    pub(crate) at: Vector,
    pub(crate) ground: Vector,
}

/// Distance within which parts meet at one place.
const HERE: f64 = 1e-3;

/// Ways to the ground, the usual one first.
const WAYS: [Vector; 4] = [[0.0, 1.0], [-1.0, 0.0], [1.0, 0.0], [0.0, -1.0]];

impl Standing {
    /// How a support stands.
    pub(crate) fn of<M>(figure: &Figure<M>, anchor: usize, holds: Holds) -> Self {
        let at = figure.anchors[anchor].at;
        let parts = directions_at(figure, at);
        let crowd = |way: Vector| parts.iter().map(|part| dot(*part, way)).fold(-1.0, f64::max);
        let ground = match holds {
            Holds::All | Holds::Rotation | Holds::InSpace(_) => {
                let sum = parts.iter().fold([0.0; 2], |sum, part| plus(sum, *part, -1.0));
                // a beam that goes on is held from below
                let away = direction(sum).filter(|_| sum[0].hypot(sum[1]) > 0.5);
                away.unwrap_or_else(|| freest(&WAYS, &crowd))
            }
            Holds::Displacements => freest(&WAYS, &crowd),
            Holds::Across(along) | Holds::AcrossAndRotation(along) => {
                let across = turned(along);
                let back = [-across[0], -across[1]];
                // of two ways alike that downwards, or to the left
                let usual = if (across[1], -across[0]) > (back[1], -back[0]) { [across, back] } else { [back, across] };
                freest(&usual, &crowd)
            }
        };
        Standing { at, ground }
    }

    /// A place of the symbol: a way along the ground, and one towards it.
    fn place(&self, [along, towards]: Vector) -> Vector {
        let tangent = [self.ground[1], -self.ground[0]];
        plus(plus(self.at, tangent, along), self.ground, towards)
    }

    fn line(&self, points: &[Vector]) -> Vec<Vector> {
        points.iter().map(|point| self.place(*point)).collect()
    }

    /// The ground at a distance from the point.
    fn hatched(&self, towards: f64) -> [Ink; 2] {
        let hatch = |k: i32| {
            let along = -10.0 + 6.0 * f64::from(k);
            self.line(&[[along, towards], [along - 5.0, towards + 6.0]])
        };
        [
            Ink::new(Pen::Hatch, Outline::Lines((0..5).map(hatch).collect())),
            Ink::new(Pen::Ground, Outline::line(self.line(&[[-15.0, towards], [15.0, towards]]))),
        ]
    }

    /// Two rollers at a distance from the point.
    fn rollers(&self, towards: f64) -> [Ink; 2] {
        [-6.5, 6.5].map(|along| Ink::new(Pen::Hollow, Outline::Disc(self.place([along, towards]), 2.8)))
    }

    /// What is drawn of the support.
    pub(crate) fn inks(&self, holds: Holds) -> Vec<Ink> {
        let triangle = |height: f64| {
            let corners = self.line(&[[0.0, 0.0], [-9.0, height], [9.0, height]]);
            Ink::new(Pen::Hollow, Outline::Area(corners))
        };
        let pin = || Ink::new(Pen::Hollow, Outline::Disc(self.at, 3.2));
        let mut inks = Vec::new();
        match holds {
            Holds::All => inks.extend(self.hatched(0.0)),
            Holds::Displacements => {
                inks.extend(self.hatched(15.0));
                inks.extend([triangle(15.0), pin()]);
            }
            Holds::Across(_) => {
                inks.extend(self.hatched(19.6));
                inks.extend([triangle(14.0), pin()]);
                inks.extend(self.rollers(16.8));
            }
            Holds::AcrossAndRotation(_) => {
                inks.extend(self.hatched(7.0));
                inks.push(Ink::new(Pen::Ground, Outline::line(self.line(&[[-11.0, 1.4], [11.0, 1.4]]))));
                inks.extend(self.rollers(4.2));
            }
            Holds::Rotation => {
                let corners = self.line(&[[-8.0, -8.0], [8.0, -8.0], [8.0, 8.0], [-8.0, 8.0]]);
                inks.push(Ink::new(Pen::Hollow, Outline::Area(corners)));
                inks.extend(self.hatched(8.0));
            }
            // drawn with its directions in space
            Holds::InSpace(_) => {}
        }
        inks
    }
}

/// The first way of those on which nothing else is.
fn freest(ways: &[Vector], crowd: &dyn Fn(Vector) -> f64) -> Vector {
    let is_free = |way: &&Vector| crowd(**way) < 0.6;
    let least = || ways.iter().copied().reduce(|best, way| if crowd(way) < crowd(best) { way } else { best });
    ways.iter().find(is_free).copied().or_else(least).unwrap_or([0.0, 1.0])
}

/// The directions in which parts leave a place.
pub(crate) fn directions_at<M>(figure: &Figure<M>, at: Vector) -> Vec<Vector> {
    let mut found = Vec::new();
    for part in figure.parts.iter().filter(|part| part.kind != Kind::Tie) {
        let places: Vec<Vector> = part.ends.iter().map(|end| figure.anchors[*end].at).collect();
        if places.iter().any(|place| distance(*place, at) < HERE) {
            found.extend(
                places
                    .iter()
                    .filter_map(|place| direction(plus(*place, at, -1.0)).filter(|_| distance(*place, at) > HERE)),
            );
        }
    }
    found
}
