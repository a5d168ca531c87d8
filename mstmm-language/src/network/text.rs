//! The network as text, which snapshots of tests show.

use super::hand_over::{Direction, Holds, Network, PathContact, TransferPath};
use super::paths::PathMotion;
use crate::ast::Connection;
use crate::keywords::{ALONG, FREEDOMS};
use mstmm_plan::Freedoms;
use quote::ToTokens;
use std::fmt::{Display, Formatter, Result};
use syn::Expr;

impl Display for Network<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "{:?}", self.dimension)?;
        for (index, place) in self.places.iter().enumerate() {
            writeln!(f, "place {index}: {}", listed(&place.parts))?;
        }
        for (index, point) in self.points.iter().enumerate() {
            let (names, freedoms) = (named(&point.connections), names_of(point.freedoms.possible()));
            writeln!(f, "point {index}: {names}place {}, moves {freedoms}", point.place)?;
        }
        for support in &self.supports {
            writeln!(f, "{} of point {}: holds {}", support.support.keyword, support.point, support.holds)?;
        }
        for member in &self.members {
            let [from, to] = member.ends;
            writeln!(f, "{}: from point {from} to point {to}", member.element)?;
        }
        for joint in &self.joints {
            let ([from, to], along) = (joint.ends, listed(&joint.axis));
            writeln!(f, "{}: from point {from} to point {to} {along}", joint.element)?;
        }
        for body in &self.bodies {
            writeln!(f, "{}: centre {}, ties points {:?}", body.element, listed(&body.centre), body.points)?;
        }
        for mass in &self.masses {
            writeln!(f, "{}: at point {}", mass.element, mass.point)?;
        }
        self.paths.iter().try_for_each(|path| path.fmt(f))
    }
}

impl Display for TransferPath<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self.motion {
            PathMotion::Translation => writeln!(f, "path of translation")?,
            PathMotion::Rotation => writeln!(f, "path of rotation")?,
            PathMotion::Of(element) => writeln!(f, "path of {element}")?,
        }
        for (index, node) in self.nodes.iter().enumerate() {
            let held = if node.is_held { "held" } else { "moves" };
            writeln!(f, "  motion {index}: {}{held}", named(&node.connections))?;
        }
        for element in &self.elements {
            let [from, to] = element.ends;
            writeln!(f, "  {}: from motion {from} to motion {to}", element.element)?;
        }
        for PathContact { node, point, direction } in &self.contacts {
            writeln!(f, "  motion {node} is that of point {point} {direction}")?;
        }
        Ok(())
    }
}

impl Display for Direction<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Direction::Along(along) => write!(f, "{} {}", along.keyword, listed(&along.parts)),
            Direction::FromTo([from, to]) => write!(f, "from point {from} to point {to}"),
            Direction::Y => f.write_str("along y"),
            Direction::Z => f.write_str("about z"),
        }
    }
}

impl Display for Holds<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Holds::Freedoms(freedoms) => f.write_str(&names_of(*freedoms)),
            Holds::Skew(direction, freedoms) => {
                let how = if direction.keyword == ALONG { "across" } else { "along" };
                write!(f, "{how} {}, and {}", listed(&direction.parts), names_of(*freedoms))
            }
        }
    }
}

fn listed(parts: &[Expr]) -> String {
    let parts: Vec<String> = parts.iter().map(|part| part.to_token_stream().to_string()).collect();
    parts.join(", ")
}

fn named(connections: &[&Connection]) -> String {
    connections.iter().map(|connection| format!("{connection}, ")).collect()
}

fn names_of(freedoms: Freedoms) -> String {
    let names: Vec<&str> =
        FREEDOMS.iter().filter(|(_, freedom)| freedoms.contains(*freedom)).map(|(name, _)| *name).collect();
    if names.is_empty() { "nothing".to_owned() } else { names.join(" ") }
}
