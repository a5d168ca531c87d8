//! Writes random valid models: every keyword, both directions, branches, narrowing and widening, held points, elements of
//! the user's own.

use crate::choices::Choices;

/// The states that a path may have.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Space {
    Bending,
    Translation,
    Rotation,
    Planar,
}

/// Keyword and parameters of the elements of a space.
fn elements(space: Space) -> &'static [(&'static str, &'static [&'static str])] {
    match space {
        Space::Bending => &[
            ("beam", &["length", "bending_stiffness", "mass_per_length"]),
            ("body", &["mass", "inertia", "output_x", "centre_x"]),
            ("elastic_hinge", &["stiffness_y", "stiffness_theta"]),
            ("point_mass", &["mass", "inertia"]),
            ("crate::parts::Rope", &["tension", "mass_per_length"]),
        ],
        Space::Translation => &[
            ("spring", &["stiffness"]),
            ("damper", &["damping"]),
            ("spring_damper", &["stiffness", "damping"]),
            ("mass", &["mass"]),
        ],
        Space::Rotation => &[
            ("torsion_spring", &["stiffness"]),
            ("torsion_damper", &["damping"]),
            ("torsion_spring_damper", &["stiffness", "damping"]),
            ("inertia", &["inertia"]),
        ],
        Space::Planar => &[
            ("planar_beam", &["length", "axial_stiffness", "bending_stiffness", "mass_per_length"]),
            ("planar_body", &["mass", "inertia", "output_x", "output_y", "centre_x", "centre_y"]),
            ("planar_hinge", &["stiffness_x", "stiffness_y", "stiffness_theta"]),
        ],
    }
}

fn supports(space: Space) -> &'static [&'static str] {
    match space {
        Space::Bending => &["fixed", "pinned", "free", "guided"],
        Space::Translation | Space::Rotation => &["fixed", "free"],
        Space::Planar => &["fixed", "pinned", "free", "guided", "roller"],
    }
}

/// Every parameter is a field, so that each can be written in short.
const FIELDS: &str = "length: f64, pub bending_stiffness: f64, axial_stiffness: f64, mass_per_length: f64, mass: f64, \
     /// Moment of inertia\n inertia: f64, output_x: f64, output_y: f64, centre_x: f64, centre_y: f64, \
     stiffness: f64, stiffness_x: f64, stiffness_y: f64, stiffness_theta: f64, damping: f64, r#type: f64, tension: f64, \
     #[no_sensitivity] width: f64";

const HEADERS: [&str; 4] = [
    "struct Model",
    "/// Documented\n pub struct M",
    "#[derive(Clone, Debug)] pub(crate) struct T",
    "struct r#Système",
];

const VALUES: [&str; 9] = [
    "1.0",
    "2.0 * length",
    "-(mass + r#type) / 3e-2",
    "half",
    "f64::sqrt(length)",
    "{ let k = mass; k * k }",
    "if half > 1.0 { half } else { mass }",
    "maximum!(width, 1.0)",
    "match half { k if k < 2.0 => k, k => f64::max(k, 3.0) }",
];

/// A valid model as text; it grows with the number of choices.
pub(crate) fn valid_model(choices: &mut Choices<'_>) -> String {
    let mut writer = Writer { choices, paths: Vec::new(), labels: 0 };
    let kinds = [Space::Bending, Space::Bending, Space::Translation, Space::Rotation, Space::Planar];
    let space = kinds[writer.choices.below(kinds.len())];
    let mut last = writer.path(space, 0);
    last.push(writer.choices.pick(supports(space)).to_owned());
    writer.end(last);
    let (mut paths, mut text) = (writer.paths, String::new());
    // in any order, except that the first mention of labels in it is the writer's
    let turn = choices.below(paths.len());
    paths.rotate_left(turn);
    text += choices.pick(&HEADERS);
    text += &format!(" {{ {FIELDS} }}\nlet half = 0.5 * length;\n");
    text += &paths.join(";\n");
    text += choices.pick(&[";", ""]);
    text
}

struct Writer<'c, 'b> {
    choices: &'c mut Choices<'b>,
    paths: Vec<String>,
    labels: usize,
}

impl Writer<'_, '_> {
    /// Nodes from a start on, the last an element of the space.
    fn path(&mut self, space: Space, depth: usize) -> Vec<String> {
        let mut nodes = match self.choices.below(3) {
            1 if depth < 2 => vec![self.junction(space, depth)],
            2 if depth < 2 && matches!(space, Space::Translation | Space::Rotation) => vec![self.narrowing(depth)],
            _ => vec![self.choices.pick(supports(space)).to_owned()],
        };
        for _ in 0..=self.choices.below(2) {
            let element = self.element(space);
            nodes.push(element);
        }
        nodes
    }

    /// A connection that goes on in the space of its first input.
    fn junction(&mut self, space: Space, depth: usize) -> String {
        let label = self.label("conn");
        let first = self.path(space, depth + 1);
        self.arm(first, &label);
        for _ in 0..=self.choices.below(2) {
            let input = match (space, self.choices.below(3)) {
                (Space::Bending, 1) => Space::Translation,
                (Space::Bending, 2) => Space::Rotation,
                _ => space,
            };
            let nodes = self.path(input, depth + 1);
            self.arm(nodes, &label);
        }
        if self.choices.below(4) == 1 {
            let held = self.choices.pick(if space == Space::Bending { &["pinned", "free"] } else { &["free"] });
            self.arm(vec![held.to_owned()], &label);
        }
        label
    }

    /// A connection from bending to a line of it.
    fn narrowing(&mut self, depth: usize) -> String {
        let label = self.label("conn");
        let nodes = self.path(Space::Bending, depth + 1);
        self.arm(nodes, &label);
        label
    }

    fn arm(&mut self, mut nodes: Vec<String>, connection: &str) {
        nodes.push(connection.to_owned());
        self.end(nodes);
    }

    fn end(&mut self, mut nodes: Vec<String>) {
        let path = if self.choices.below(3) == 1 {
            nodes.reverse();
            nodes.join(" <- ")
        } else {
            nodes.join(" -> ")
        };
        self.paths.push(path);
    }

    fn element(&mut self, space: Space) -> String {
        let (keyword, parameters) = elements(space)[self.choices.below(elements(space).len())];
        let label = self.label(keyword);
        let parameters: Vec<String> = parameters.iter().map(|name| self.parameter(name)).collect();
        format!("{label} {{ {} }}", parameters.join(", "))
    }

    fn parameter(&mut self, name: &str) -> String {
        match self.choices.below(3) {
            0 => name.to_owned(),
            _ => format!("{name}: {}", self.choices.pick(&VALUES)),
        }
    }

    /// `keyword label`, the label a number or a name.
    fn label(&mut self, keyword: &str) -> String {
        self.labels += 1;
        match self.choices.below(4) {
            1 => format!("{keyword} arm{}", self.labels),
            _ => format!("{keyword} {}", self.labels),
        }
    }
}
