//! The plane structures of tests/data/frames.json with their exact frequencies.
//!
//! Of the keys that the file explains in `_schema` these are read which undamped plane frames of Euler-Bernoulli beams have.
#![expect(clippy::unwrap_used, clippy::panic, reason = "a file that is not as it should be fails the test")]

use crate::structure::{End, Freedoms, Node, Section, Structure};
use mstmm::number::DoubleDouble;
use serde_json::Value;
use std::collections::BTreeMap;

/// The cases that are read.
pub(crate) const CASES: [&str; 7] =
    ["nafems_fv1", "nafems_fv3", "l_frame", "portal", "hinged_frame", "inclined_roller", "body_three_ports"];

/// A frequency of the file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ExactFrequency {
    /// Number of the mode, from one on; of several at one frequency the first.
    pub(crate) mode: u64,
    pub(crate) multiplicity: u64,
    /// To 24 digits; zero for rigid motions.
    pub(crate) omega: DoubleDouble,
    /// Sum of the relative changes of the frequency with each parameter; none at zero.
    pub(crate) condition: Option<f64>,
}

/// A structure of the file.
#[derive(Debug)]
pub(crate) struct ReferenceCase {
    pub(crate) name: &'static str,
    pub(crate) structure: Structure,
    /// The first frequencies without gaps, then single ones far above.
    pub(crate) frequencies: Vec<ExactFrequency>,
}

/// All cases.
pub(crate) fn reference_cases() -> Vec<ReferenceCase> {
    let file = file();
    let case = |name: &'static str| ReferenceCase {
        name,
        structure: structure(&file[name]["model"]),
        frequencies: frequencies(&file[name]["wanted"]),
    };
    CASES.map(case).into()
}

fn file() -> Value {
    serde_json::from_str(include_str!("../data/frames.json")).unwrap()
}

/// The frequencies of a case, of whatever elements.
pub(crate) fn exact_frequencies(name: &str) -> Vec<ExactFrequency> {
    frequencies(&file()[name]["wanted"])
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn entries(value: &Value) -> impl Iterator<Item = (&String, &Value)> {
    value.as_object().into_iter().flatten()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn pair(value: &Value) -> [f64; 2] {
    [number(&value[0]), number(&value[1])]
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_else(|| panic!("{value} is no text"))
}

/// A set of displacements; rotations are `th`.
fn freedoms(value: &Value, words: [&str; 3]) -> Freedoms {
    let place = |word: &Value| words.iter().position(|other| *other == text(word)).unwrap();
    let single = [Freedoms::X, Freedoms::Y, Freedoms::RZ];
    list(value).iter().fold(Freedoms::NONE, |set, word| set.union(single[place(word)]))
}

/// Numerator and denominator of an exact expression `f(5)/13`, with or without a sign.
fn fraction(expression: &str) -> [f64; 2] {
    let (sign, size) = expression.strip_prefix('-').map_or((1.0, expression), |size| (-1.0, size));
    let (numerator, denominator) = size.strip_prefix("f(").and_then(|rest| rest.split_once(")/")).unwrap();
    [sign * numerator.parse::<f64>().unwrap(), denominator.parse().unwrap()]
}

/// The direction across one whose components are fractions, in whole numbers.
fn across(direction: &Value) -> [f64; 2] {
    let [[x, x_part], [y, y_part]] = [0, 1].map(|index| fraction(text(&direction[index])));
    [y * x_part, -x * y_part]
}

/// Reads the nodes and bodies, and knows where each name is.
struct Reader {
    structure: Structure,
    /// The end of a member at a point with a name.
    points: BTreeMap<String, End>,
}

impl Reader {
    fn of(model: &Value) -> Self {
        let mut reader = Reader { structure: Structure::default(), points: BTreeMap::new() };
        for body in list(&model["bodies"]) {
            let centre = pair(&body["centre"]);
            let node = Node::at(centre).body(number(&body["mass"]), number(&body["inertia"]), centre);
            let index = reader.structure.node(node);
            for name in list(&body["points"]).iter().map(text) {
                reader.points.insert(name.to_owned(), End::from(index).at(pair(&model["nodes"][name])));
            }
        }
        for (name, position) in entries(&model["nodes"]) {
            if !reader.points.contains_key(name) {
                let index = reader.structure.node(Node::at(pair(position)));
                reader.points.insert(name.clone(), index.into());
            }
        }
        reader
    }

    fn point(&self, name: &Value) -> End {
        self.points[text(name)]
    }

    fn support(&mut self, support: &Value) {
        let end = self.point(&support["node"]);
        assert_eq!(end.position, None, "{support} holds a point of a body");
        let node = &mut self.structure.nodes[end.node];
        *node = match &support["dir"] {
            Value::Null => node.held(freedoms(&support["fix"], ["x", "y", "th"])),
            direction => node.along(across(direction)),
        };
    }

    fn beam(&mut self, member: &Value, sections: &Value) {
        let section = &sections[text(&member["section"])];
        let known = |(key, _): (&String, &Value)| ["EA", "EI", "m"].contains(&key.as_str());
        assert!(entries(section).all(known), "{section} has more than a beam takes");
        let section = Section {
            axial_stiffness: number(&section["EA"]),
            bending_stiffness: number(&section["EI"]),
            mass_per_length: number(&section["m"]),
        };
        let [from, to] = ["from", "to"]
            .map(|side| self.point(&member[side]).releasing(freedoms(&member["release"][side], ["u", "v", "th"])));
        self.structure.beam(from, to, section);
    }

    /// A spring to the ground, along a direction.
    fn spring(&mut self, spring: &Value) {
        assert!(spring["to"].is_null(), "{spring} leads to no ground");
        let from = self.point(&spring["from"]);
        let ground = self.structure.clamp(self.structure.position(&from));
        self.structure.spring_along(from, ground, pair(&spring["dir"]), number(&spring["k"]));
    }
}

fn structure(model: &Value) -> Structure {
    assert_eq!(model["dim"], 2, "a structure in space");
    let known = ["dim", "nodes", "sections", "members", "bodies", "springs", "supports"];
    assert!(entries(model).all(|(key, _)| known.contains(&key.as_str())), "a key of {model} is not read");
    let mut reader = Reader::of(model);
    list(&model["supports"]).iter().for_each(|support| reader.support(support));
    list(&model["members"]).iter().for_each(|member| reader.beam(member, &model["sections"]));
    list(&model["springs"]).iter().for_each(|spring| reader.spring(spring));
    reader.structure
}

fn frequencies(wanted: &Value) -> Vec<ExactFrequency> {
    let omega = |value: &Value| text(value).parse::<DoubleDouble>().unwrap();
    let count = |value: &Value| value.as_u64().unwrap();
    let first = list(&wanted["multiplicity"]).iter().zip(list(&wanted["condition"])).map(|(entry, condition)| {
        let (mode, multiplicity) = (count(&entry[0]), count(&entry[1]));
        let text = &wanted["omega"][mode as usize - 1];
        ExactFrequency { mode, multiplicity, omega: omega(text), condition: condition.as_f64() }
    });
    let above = list(&wanted["modes"]).iter().map(|entry| ExactFrequency {
        mode: count(&entry["first"]),
        multiplicity: count(&entry["multiplicity"]),
        omega: omega(&entry["omega"]),
        condition: entry["condition"].as_f64(),
    });
    first.chain(above).collect()
}

#[test]
fn expressions_of_the_file_are_directions() {
    let direction = serde_json::json!(["-f(5)/13", "f(12)/13"]);
    assert_eq!(across(&direction), [156.0, 65.0]);
}

/// The names of nodes in the order of the structure, of a case without bodies.
pub(crate) fn node_names(model: &Value) -> Vec<String> {
    entries(&model["nodes"]).map(|(name, _)| name.clone()).collect()
}
