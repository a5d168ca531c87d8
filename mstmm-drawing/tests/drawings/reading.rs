//! Reads what a picture shows.

use roxmltree::{Document, Node};

/// A picture as text.
pub(crate) struct Picture {
    text: String,
}

/// The corners of a path.
pub(crate) type Corners = Vec<[f64; 2]>;

/// A named part of a picture.
pub(crate) struct Shown {
    pub(crate) name: String,
    pub(crate) kind: String,
    /// The corners of each of its paths; of a disc its middle.
    pub(crate) paths: Vec<Vec<[f64; 2]>>,
    /// The class of each of its paths, and its width where it has one of its own.
    pub(crate) classes: Vec<String>,
    pub(crate) widths: Vec<Option<f64>>,
    /// Where a point or a support stands.
    pub(crate) at: Option<[f64; 2]>,
    /// The way from a support to the ground.
    pub(crate) ground: Option<[f64; 2]>,
}

/// A label: its text, the name behind it, its class, and the middle of its box.
pub(crate) struct Label {
    pub(crate) text: String,
    pub(crate) name: String,
    pub(crate) class: String,
    pub(crate) at: [f64; 2],
}

impl Picture {
    pub(crate) fn of(drawing: impl ToString) -> Self {
        Picture { text: drawing.to_string() }
    }

    fn read<R>(&self, read: impl FnOnce(Node<'_, '_>) -> R) -> R {
        let document = Document::parse(&self.text).unwrap();
        read(document.root_element())
    }

    /// A number of the whole picture.
    pub(crate) fn number(&self, attribute: &str) -> f64 {
        self.read(|root| root.attribute(attribute).unwrap().parse().unwrap())
    }

    /// A place on the paper in the model, whose y is upwards.
    pub(crate) fn in_model(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let scale = self.number("data-scale");
        let origin = self.read(|root| pair(root.attribute("data-origin").unwrap()));
        [(x - origin[0]) / scale, (origin[1] - y) / scale]
    }

    /// What has a name in groups of a class.
    pub(crate) fn shown(&self, class: &str) -> Vec<Shown> {
        self.read(|root| {
            let groups = root
                .children()
                .filter(|group| group.attribute("class").is_some_and(|own| own.split(' ').any(|own| own == class)));
            groups.flat_map(|group| group.children().filter(Node::is_element).map(shown).collect::<Vec<_>>()).collect()
        })
    }

    /// All labels.
    pub(crate) fn labels(&self) -> Vec<Label> {
        self.read(|root| {
            let is_label =
                |text: &Node<'_, '_>| text.has_tag_name("text") && text.children().any(|own| own.has_tag_name("title"));
            let texts = root.descendants().filter(is_label);
            texts
                .map(|text| Label {
                    text: text.text().unwrap().trim().to_owned(),
                    name: text.children().find(|child| child.has_tag_name("title")).unwrap().text().unwrap().to_owned(),
                    class: text.attribute("class").unwrap().to_owned(),
                    at: ["x", "y"].map(|name| text.attribute(name).unwrap().parse().unwrap()),
                })
                .collect()
        })
    }

    /// The paths of each load.
    pub(crate) fn loads(&self) -> Vec<Vec<Corners>> {
        self.read(|root| {
            let loads =
                root.descendants().filter(|node| node.has_tag_name("g") && node.attribute("class") == Some("load"));
            let paths =
                |load: Node<'_, '_>| load.children().filter_map(|path| path.attribute("d").map(points)).collect();
            loads.map(paths).collect()
        })
    }

    /// What is written above and below the picture, and where.
    pub(crate) fn captions(&self) -> Vec<(String, [f64; 2])> {
        self.read(|root| {
            let captions = root.descendants().filter(|node| matches!(node.attribute("class"), Some("title" | "unit")));
            let at = |text: Node<'_, '_>| ["x", "y"].map(|name| text.attribute(name).unwrap().parse().unwrap());
            captions.map(|text| (text.text().unwrap().trim_end_matches('\n').to_owned(), at(text))).collect()
        })
    }

    /// The lines that lead to labels, each from what the label names.
    pub(crate) fn leaders(&self) -> Vec<[[f64; 2]; 2]> {
        self.read(|root| {
            let paths = root.descendants().filter(|node| node.attribute("class") == Some("leader"));
            paths.map(|path| points(path.attribute("d").unwrap()).try_into().unwrap()).collect()
        })
    }

    /// The data of each moment of all animations, with the path that each one moves.
    pub(crate) fn animations(&self) -> Vec<(Corners, Vec<Corners>)> {
        self.read(|root| {
            let animations = root.descendants().filter(|node| node.has_tag_name("animate"));
            let read = |animation: Node<'_, '_>| {
                let own = animation.parent().unwrap().attribute("d").unwrap();
                (points(own), animation.attribute("values").unwrap().split(';').map(points).collect())
            };
            animations.map(read).collect()
        })
    }

    /// Left and upper end, width and height.
    pub(crate) fn view_box(&self) -> [f64; 4] {
        self.read(|root| {
            let numbers = root.attribute("viewBox").unwrap().split(' ').map(|number| number.parse().unwrap());
            numbers.collect::<Vec<f64>>().try_into().unwrap()
        })
    }

    /// The data of each moment of the animation of a part's first path.
    pub(crate) fn moments(&self, name: &str) -> Vec<Vec<[f64; 2]>> {
        self.read(|root| {
            let moving = root.children().find(|group| group.attribute("class") == Some("mode moving")).unwrap();
            let part = moving.children().find(|part| part.attribute("data-name") == Some(name)).unwrap();
            let animation = part.descendants().find(|node| node.has_tag_name("animate")).unwrap();
            animation.attribute("values").unwrap().split(';').map(points).collect()
        })
    }
}

impl Shown {
    /// Its paths, halos or all others.
    pub(crate) fn lines(&self, halos: bool) -> impl Iterator<Item = &Vec<[f64; 2]>> {
        let of_class = move |class: &str| class.starts_with("halo") == halos;
        self.paths.iter().zip(&self.classes).filter(move |(_, class)| of_class(class)).map(|(path, _)| path)
    }
}

fn shown(group: Node<'_, '_>) -> Shown {
    let own = |attribute: &str| group.attribute(attribute).unwrap().to_owned();
    Shown {
        name: own("data-name"),
        kind: own("data-kind"),
        paths: group
            .children()
            .filter(|child| child.has_tag_name("path"))
            .map(|path| points(path.attribute("d").unwrap()))
            .collect(),
        classes: group
            .children()
            .filter(|child| child.has_tag_name("path"))
            .map(|path| path.attribute("class").unwrap().to_owned())
            .collect(),
        widths: group.children().filter(|child| child.has_tag_name("path")).map(width).collect(),
        at: group.attribute("data-at").map(pair),
        ground: group.attribute("data-ground").map(pair),
    }
}

/// The width that a path has by its own style.
fn width(path: Node<'_, '_>) -> Option<f64> {
    path.attribute("style").map(|style| style.strip_prefix("stroke-width:").unwrap().parse().unwrap())
}

/// Two numbers.
fn pair(text: &str) -> [f64; 2] {
    let numbers: Vec<f64> = text.split(' ').map(|number| number.parse().unwrap()).collect();
    numbers.try_into().unwrap()
}

/// The corners of a path, of a disc its middle.
fn points(data: &str) -> Vec<[f64; 2]> {
    if let Some((start, arcs)) = data.split_once('a') {
        let [x, y] = pair(start.trim_start_matches('M'));
        let radius: f64 = arcs.split(' ').next().unwrap().parse().unwrap();
        return vec![[x + radius, y]];
    }
    data.trim_end_matches('Z').split(['M', 'L']).filter(|point| !point.is_empty()).map(pair).collect()
}
