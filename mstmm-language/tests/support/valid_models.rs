//! Writes random valid models: every keyword, both directions, branches, narrowing and widening, held points, elements of
//! the user's own.

use crate::choices::Choices;
use mstmm_language::Space;
use std::collections::BTreeSet;

/// Keyword and parameters of the elements of a space: those that it must have, those that it may have, and those of which it has one.
fn elements(space: Space) -> Vec<(&'static str, [&'static [&'static str]; 3])> {
    let own = ("crate::parts::Rope", Space::Bending, [&["tension", "mass_per_length"][..], &[], &[]]);
    let all = mstmm_language::elements().chain([own]);
    all.filter(|(_, of, _)| *of == space).map(|(keyword, _, parameters)| (keyword, parameters)).collect()
}

fn supports(space: Space) -> &'static [&'static str] {
    match space {
        Space::Bending => &["fixed", "pinned", "free", "guided"],
        Space::Planar => &["fixed", "pinned", "free", "guided", "roller"],
        _ => &["fixed", "free"],
    }
}

/// Every parameter is a field, so that each can be written in short.
fn fields() -> String {
    let parameters = mstmm_language::elements().flat_map(|(_, _, parameters)| parameters.concat());
    let names: BTreeSet<&str> = parameters.chain(["r#type", "tension"]).collect();
    let field = |name: &str| match name {
        "bending_stiffness" => format!("pub {name}: f64, "),
        "inertia" => format!("/// Moment of inertia\n {name}: f64, "),
        _ => format!("{name}: f64, "),
    };
    names.into_iter().map(field).collect::<String>() + "#[no_sensitivity] width: f64"
}

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
    text += &format!(" {{ {} }}\nlet half = 0.5 * length;\n", fields());
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
        let elements = elements(space);
        let (keyword, [required, optional, one_of]) = elements[self.choices.below(elements.len())];
        let label = self.label(keyword);
        let mut named = required.to_vec();
        let optional: Vec<&str> = optional.iter().copied().filter(|_| self.choices.below(3) == 1).collect();
        named.extend(optional);
        if !one_of.is_empty() {
            named.push(self.choices.pick(one_of));
        }
        // a shaft that spins says all of its spin, and has no loss factor
        if keyword == "beam" && ["speed", "polar_inertia_per_length"].iter().any(|name| named.contains(name)) {
            named.retain(|name| *name != "loss_factor");
            let missing = ["rotary_inertia", "polar_inertia_per_length", "speed"];
            named.extend(missing.into_iter().filter(|name| !named.contains(name)).collect::<Vec<_>>());
        }
        // a hinge gives way, and in the plane it says so
        let gives_way = if space == Space::Planar { "stiffness_x" } else { "stiffness_y" };
        if keyword == "hinge" && !named.contains(&gives_way) {
            named.push(gives_way);
        }
        let parameters: Vec<String> = named.iter().map(|name| self.parameter(name)).collect();
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
