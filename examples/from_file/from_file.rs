//! A structure from a file: points, members, supports and masses in JSON, its frequencies and its picture.
//!
//! `cargo run --release --example from_file -- examples/from_file/shed.json --svg shed.svg`

use mstmm::elements::Spring;
use mstmm::frame::{Frame, Plane, Point, PointMass, Section};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm_drawing::Drawing;
use serde::Deserialize;
use std::collections::HashMap;
use std::error::Error;

/// A structure as a file has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    /// The parameters of each section by their names.
    sections: HashMap<String, HashMap<String, f64>>,
    points: Vec<PointInFile>,
    members: Vec<MemberInFile>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PointInFile {
    name: String,
    at: [f64; 2],
    support: Option<String>,
    mass: Option<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MemberInFile {
    name: String,
    ends: [String; 2],
    /// The name of a section, or the stiffness of a spring.
    section: Option<String>,
    stiffness: Option<f64>,
}

/// The points of a frame by their names.
type Points = HashMap<String, Point<Plane>>;

/// The frame of a text, and its points.
pub fn read(text: &str) -> Result<(Frame<Plane>, Points), Box<dyn Error>> {
    let File { sections, points: listed, members } = serde_json::from_str(text)?;
    let (mut frame, mut points) = (Frame::new(), HashMap::new());
    for PointInFile { name, at, support, mass } in listed {
        let point = frame.point(at);
        if let Some(support) = support {
            frame.hold(point, self::support(&support).ok_or(format!("{name}: there is no support `{support}`"))?);
        }
        if let Some(mass) = mass {
            frame.body([point], PointMass { mass, inertia: 0.0 });
        }
        frame.name(point, &name);
        points.insert(name, point);
    }
    for MemberInFile { name, ends: [from, to], section, stiffness } in members {
        let end = |end: &String| points.get(end).copied().ok_or(format!("{name}: there is no point `{end}`"));
        let (from, to) = (end(&from)?, end(&to)?);
        match (section, stiffness) {
            (Some(section), None) => {
                let named = sections.get(&section).ok_or(format!("{name}: there is no section `{section}`"))?;
                let named = named.iter().try_fold(Section::new(), |section, (name, value)| section.with(name, *value));
                let member = frame.member(from, to, named.map_err(|error| format!("{section}: {error}"))?);
                frame.name(member, name);
            }
            (None, Some(stiffness)) => {
                let member = frame.member(from, to, Spring { stiffness });
                frame.name(member, name);
            }
            _ => return Err(format!("{name}: a member has a `section`, or the `stiffness` of a spring").into()),
        }
    }
    Ok((frame, points))
}

/// A support by its name.
fn support(name: &str) -> Option<Support> {
    let all = [
        ("fixed", Support::Fixed),
        ("pinned", Support::Pinned),
        ("roller", Support::Roller),
        ("guided", Support::Guided),
    ];
    all.into_iter().find(|(own, _)| *own == name).map(|(_, support)| support)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let file = arguments.first().map_or("examples/from_file/shed.json", String::as_str);
    let (frame, _) = read(&std::fs::read_to_string(file)?)?;
    let structure = frame.build()?;
    for root in structure.frequencies(5)? {
        println!("{:9.4} Hz{}", root.hertz(), if root.is_proven { ", proven" } else { "" });
    }
    if let [_, option, picture, ..] = arguments.as_slice()
        && option == "--svg"
    {
        std::fs::write(picture, Drawing::of(&structure)?.to_string())?;
    }
    Ok(())
}
