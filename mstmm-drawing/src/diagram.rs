//! Diagrams of internal forces.

use crate::figure::{Figure, Inside};
use crate::kind::Kind;
use crate::labels::{Subject, Wanted};
use crate::vector::{Vector, between, direction, plus};

/// An internal force of beams.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Force {
    /// The axial force, tension positive, drawn to the side of the local y, in space of the local z.
    Axial,
    /// The shear force `Q = M'`, drawn to the side of the local y where it is positive; in space both together, to their side.
    Shear,
    /// The bending moment `M = EI Θ'`, drawn on the side on which the beam is stretched. In space that is the side on which both moments together
    /// stretch it.
    Moment,
    /// The torque of members in space, drawn to the side of the local z.
    Torque,
}

/// The largest ordinate on the paper.
pub(crate) const HEIGHT: f64 = 44.0;

/// Part of the largest value of all below which a largest value of a member is not written.
pub(crate) const WRITTEN: f64 = 0.02;

/// Distance of a written value from the end of its member, as a part of that.
pub(crate) const BESIDE: f64 = 0.08;

/// Number of lines across the diagram of a member.
pub(crate) const LINES: usize = 12;

impl Force {
    /// Its place among the forces of a section.
    pub(crate) fn index(self) -> usize {
        match self {
            Force::Axial => 0,
            Force::Shear => 1,
            Force::Moment => 2,
            Force::Torque => 5,
        }
    }

    pub(crate) fn name(self) -> &'static str {
        match self {
            Force::Axial => "axial force",
            Force::Shear => "shear force",
            Force::Moment => "moment",
            Force::Torque => "torque",
        }
    }

    /// Whether its values in space have a sign: two of them together have a direction.
    pub(crate) fn has_sign_in_space(self) -> bool {
        matches!(self, Force::Axial | Force::Torque)
    }

    /// Whether a part has it.
    pub(crate) fn acts_in<M>(self, kind: Kind, inside: &Inside<M>) -> bool {
        let is_beam = matches!(kind, Kind::Beam { .. } | Kind::Bar);
        match inside {
            // a string between two places has no moment
            Inside::Member(..) => is_beam || matches!(kind, Kind::Line) && matches!(self, Force::Axial | Force::Shear),
            Inside::Element { .. } => is_beam && self != Force::Axial,
        }
    }

    /// The way on the paper in which its positive values are drawn, along an element in some direction.
    fn way(self, along: Vector) -> Vector {
        // local y, a quarter of a turn on from local x; the paper has y downwards
        let [x, y] = [along[1], -along[0]];
        match self {
            Force::Axial | Force::Shear | Force::Torque => [x, y],
            Force::Moment => [-x, -y],
        }
    }
}

/// The diagram of a part.
pub(crate) struct Diagram {
    pub(crate) part: usize,
    /// Corners of its area: along the part, and back along the ordinates.
    pub(crate) area: Vec<Vector>,
    /// Lines across.
    pub(crate) lines: Vec<Vec<Vector>>,
    /// Its largest value.
    pub(crate) label: Option<Wanted>,
}

/// The diagrams of a force, and the size of one of its units on the paper; none where it is zero everywhere.
pub(crate) fn diagrams<M>(figure: &Figure<M>, force: Force, values: &[Vec<[f64; 2]>]) -> Option<(Vec<Diagram>, f64)> {
    let largest = values.iter().flatten().map(|[_, value]| value.abs()).fold(0.0, f64::max);
    let scale = HEIGHT / largest;
    if !scale.is_normal() {
        return None;
    }
    let mut found = Vec::new();
    for (part, values) in values.iter().enumerate().filter(|(_, values)| !values.is_empty()) {
        let [from, to] = [figure.parts[part].ends[0], figure.parts[part].ends[1]].map(|end| figure.anchors[end].at);
        let Some(along) = direction(plus(to, from, -1.0)) else { continue };
        let way = force.way(along);
        let foot = |at: f64| between(from, to, at);
        let tip = |[at, value]: [f64; 2]| plus(foot(at), way, scale * value);
        let mut area: Vec<Vector> = vec![from, to];
        area.extend(values.iter().rev().map(|value| tip(*value)));
        let every = (values.len() / LINES).max(1);
        let lines = values.iter().step_by(every).map(|value| vec![foot(value[0]), tip(*value)]).collect();
        let label = largest_of(values, |value| value[1]).filter(|(peak, _)| peak.abs() > WRITTEN * largest);
        let label = label.map(|(peak, alike)| Wanted {
            text: written(peak),
            class: "value",
            title: format!("{} of {}", force.name(), figure.parts[part].name),
            subject: Subject::Line(alike.map(|index| over(&foot, values[index][0], tip(values[index])))),
        });
        found.push(Diagram { part, area, lines, label });
    }
    Some((found, scale))
}

/// The largest of values, by their sizes, and from where to where it is written alike: the longest run, of a single one its place.
pub(crate) fn largest_of<V>(values: &[V], number: impl Fn(&V) -> f64) -> Option<(f64, [usize; 2])> {
    let larger = |best: f64, next: f64| if next.abs() > best.abs() { next } else { best };
    let peak = values.iter().map(&number).reduce(larger)?;
    let text = written(peak);
    let is_alike = |value: &V| written(number(value)) == text;
    let mut ends = 0;
    let runs = values.chunk_by(|one, next| is_alike(one) == is_alike(next)).map(|run| {
        ends += run.len();
        (is_alike(&run[0]), [ends - run.len(), ends - 1])
    });
    // of runs as long as each other the first
    let longer = |best: [usize; 2], next: [usize; 2]| if next[1] - next[0] > best[1] - best[0] { next } else { best };
    let longest = runs.filter(|(is_alike, _)| *is_alike).map(|(_, run)| run).reduce(longer)?;
    Some((peak, longest))
}

/// The tip of an ordinate, moved over the member that it belongs to, where two meet.
pub(crate) fn over(foot: &impl Fn(f64) -> Vector, at: f64, tip: Vector) -> Vector {
    plus(tip, plus(foot(at.clamp(BESIDE, 1.0 - BESIDE)), foot(at), -1.0), 1.0)
}

/// A number with three digits.
pub(crate) fn written(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return String::from("0");
    }
    let digits = 2 - size.log10().floor() as i32;
    let text = if (-3..=6).contains(&digits) {
        let power = 10.0_f64.powi(digits);
        format!("{:.*}", digits.max(0) as usize, (value * power).round() / power)
    } else {
        format!("{value:.2e}")
    };
    text.replace('-', "−")
}
