//! The structures of tests/data/space.json as frames; `_schema` there explains its keys.
#![expect(clippy::unwrap_used, clippy::panic, reason = "a file that is not as it should be fails the test")]

use mstmm::elements::{Spring, SpringDamper, TorsionSpring, TorsionSpringDamper};
use mstmm::frame::{
    Bar, End, Frame, Ground, Point, PointMass, RigidBody, RigidLink, Roller, Section, Space, TautString, Tensor, Tie,
};
use mstmm::network::Freedoms;
use mstmm::number::DoubleDouble;
use serde_json::Value;
use std::collections::BTreeMap;

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
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) frame: Frame<Space>,
    pub(crate) points: BTreeMap<String, Point<Space>>,
    pub(crate) wanted: Value,
}

/// All structures.
pub(crate) fn cases() -> Vec<Case> {
    let file: Value = serde_json::from_str(include_str!("../data/space.json")).unwrap();
    let structures = file.as_object().unwrap().iter().filter(|(name, _)| !name.starts_with('_'));
    structures.map(|(name, case)| Case::new(name, &case["model"], &case["wanted"])).collect()
}

impl Case {
    /// Its first frequencies without gaps, then single ones far above.
    pub(crate) fn frequencies(&self) -> Vec<ExactFrequency> {
        let (omega, conditions) = (list(&self.wanted["omega"]), list(&self.wanted["condition"]));
        let first =
            list(&self.wanted["multiplicity"]).iter().zip(conditions).map(|(entry, condition)| ExactFrequency {
                mode: entry[0].as_u64().unwrap(),
                multiplicity: entry[1].as_u64().unwrap(),
                omega: precise(&omega[entry[0].as_u64().unwrap() as usize - 1]),
                condition: condition.as_f64(),
            });
        let above = list(&self.wanted["modes"]).iter().map(|mode| ExactFrequency {
            mode: mode["first"].as_u64().unwrap(),
            multiplicity: mode["multiplicity"].as_u64().unwrap(),
            omega: precise(&mode["omega"]),
            condition: mode["condition"].as_f64(),
        });
        first.chain(above).collect()
    }

    fn new(name: &str, model: &Value, wanted: &Value) -> Self {
        let mut frame = Frame::new();
        let points: BTreeMap<_, _> =
            entries(&model["nodes"]).map(|(name, place)| (name.clone(), frame.point(triple(place)))).collect();
        let at = |name: &Value| points[text(name)];
        let has_no_plane = model["sections"].as_object().is_some_and(|own| own.values().any(|own| own["EA"].is_null()));
        let besides = if has_no_plane { Freedoms::X.union(Freedoms::Y).union(Freedoms::RZ) } else { Freedoms::NONE };
        for support in list(&model["supports"]) {
            if support["dir"].is_null() {
                frame.hold(at(&support["node"]), freedoms(&support["fix"]).union(besides));
            } else {
                frame.hold(at(&support["node"]), Roller::normal(triple(&support["dir"])));
            }
        }
        for member in list(&model["members"]) {
            let section = &model["sections"][text(&member["section"])];
            let [from, to] = ["from", "to"].map(|end| {
                let released = freedoms(&member["release"][end]);
                End::from(at(&member[end])).releasing(released)
            });
            add(&mut frame, [from, to], section, &member["up"]);
        }
        // where nothing happens along members, and nothing in their plane, they are stiff there, and all points are held
        let is_held = |name: &str| list(&model["supports"]).iter().any(|support| text(&support["node"]) == name);
        for (_, point) in points.iter().filter(|(name, _)| has_no_plane && !is_held(name)) {
            frame.hold(*point, besides);
        }
        for body in list(&model["bodies"]) {
            let tied: Vec<_> = list(&body["points"]).iter().map(at).collect();
            let (mass, inertia) = (number(&body["mass"]), tensor(&body["inertia"]));
            if mass == 0.0 && inertia == Tensor::default() {
                frame.body(tied, RigidLink);
            } else {
                frame.body(tied, RigidBody { mass, inertia, centre: triple(&body["centre"]) });
            }
        }
        for mass in list(&model["masses"]) {
            frame.body(
                [at(&mass["node"])],
                PointMass { mass: number(&mass["mass"]), inertia: tensor(&mass["inertia"]) },
            );
        }
        for spring in list(&model["springs"]) {
            add_spring(&mut frame, &points, spring);
        }
        for joint in list(&model["joints"]) {
            frame.member(at(&joint["a"]), at(&joint["b"]), Tie::of(freedoms(&joint["tie"])));
        }
        Case { name: name.into(), frame, points, wanted: wanted.clone() }
    }
}

/// Adds a member of a section.
fn add(frame: &mut Frame<Space>, [from, to]: [End<Space>; 2], section: &Value, up: &Value) {
    let named = |name: &str| section[name].as_f64();
    let mass = named("m").unwrap();
    let mut own = Section::new().axial_stiffness(named("EA").unwrap_or(1e9)).mass_per_length(mass);
    if !up.is_null() {
        own = own.up(triple(up));
    }
    if named("EIz").or(named("EIy")) == Some(0.0) {
        frame.member(from, to, TautString(own.tension(named("P").unwrap())));
        return;
    }
    let optional = [
        ("GAy", "shear_stiffness_y"),
        ("GAz", "shear_stiffness_z"),
        ("rIy", "rotary_inertia_y"),
        ("rIz", "rotary_inertia_z"),
        ("P", "axial_force"),
        ("kwy", "foundation_stiffness_y"),
        ("kwz", "foundation_stiffness_z"),
        ("loss", "loss_factor"),
    ];
    own = own.bending_stiffness_y(named("EIy").unwrap()).bending_stiffness_z(named("EIz").unwrap_or(1e12));
    for (name, parameter) in optional {
        own = named(name).map_or(own, |value| own.with(parameter, value).unwrap());
    }
    match named("GJ") {
        Some(stiffness) => {
            let own = own.torsional_stiffness(stiffness).polar_inertia_per_length(named("rJ").unwrap());
            frame.member(from, to, own);
        }
        None => {
            frame.member(from, to, Bar(own));
        }
    }
}

/// Adds a spring.
fn add_spring(frame: &mut Frame<Space>, points: &BTreeMap<String, Point<Space>>, spring: &Value) {
    let (from, stiffness) = (points[text(&spring["from"])], number(&spring["k"]));
    let damping = spring["c"].as_f64();
    if spring["type"] == "rot" {
        let axis = triple(&spring["axis"]);
        match damping {
            None => frame.member(from.about(axis), Ground, TorsionSpring { stiffness }),
            Some(damping) => frame.member(from.about(axis), Ground, TorsionSpringDamper { stiffness, damping }),
        };
        return;
    }
    let direction = triple(&spring["dir"]);
    let to = if spring["to"].is_null() { Ground.into() } else { points[text(&spring["to"])].along(direction) };
    match damping {
        None => frame.member(from.along(direction), to, Spring { stiffness }),
        Some(damping) => frame.member(from.along(direction), to, SpringDamper { stiffness, damping }),
    };
}

pub(crate) fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

pub(crate) fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_else(|| panic!("{value} is no text"))
}

fn entries(value: &Value) -> impl Iterator<Item = (&String, &Value)> {
    value.as_object().into_iter().flatten()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// A vector; of one whose parts are `f(2)/7` and `-f(3)/7` the numerators, since a direction has any length.
fn triple(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|k| {
        value[k].as_f64().unwrap_or_else(|| {
            let numerator = text(&value[k]).strip_suffix("/7").unwrap().replace("f(", "").replace(')', "");
            numerator.parse().unwrap()
        })
    })
}

/// A tensor: a number, three moments, or all entries.
fn tensor(value: &Value) -> Tensor {
    match list(value) {
        [] => Tensor::of_sphere(value.as_f64().unwrap_or(0.0)),
        moments @ [_, _, _] => Tensor::principal([0, 1, 2].map(|k| number(&moments[k]))),
        entries => Tensor::new([0, 1, 2, 3, 4, 5].map(|k| number(&entries[k]))),
    }
}

/// A set of displacements and rotations.
fn freedoms(value: &Value) -> Freedoms {
    let names = ["x", "y", "rz", "z", "rx", "ry"];
    let single = |word: &Value| Freedoms::EACH[names.iter().position(|name| *name == text(word)).unwrap()];
    list(value).iter().map(single).fold(Freedoms::NONE, Freedoms::union)
}

/// A number of 24 digits.
pub(crate) fn precise(value: &Value) -> DoubleDouble {
    text(value).parse().unwrap()
}
