//! Sketches of `system!` read from the source once more, without the macro: what is where, and what leads where.

use std::collections::BTreeMap;

/// What stands in a sketch.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Node {
    Support(String),
    Connection(String),
    /// Keyword, and `keyword_label`, its name as a constant of the model.
    Element {
        kind: String,
        name: String,
        parameters: BTreeMap<String, f64>,
    },
}

/// Nodes, and arrows between them in transfer direction.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sketch {
    pub(crate) nodes: Vec<Node>,
    pub(crate) arrows: Vec<(usize, usize)>,
}

type Values = BTreeMap<String, f64>;

/// Words, numbers, arrows and signs of one character.
fn tokens(text: &str) -> Vec<String> {
    let code: String = text.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n");
    let mut rest = code.trim_start();
    let mut tokens = Vec::new();
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("->") || rest.starts_with("<-") {
            2
        } else if first.is_alphanumeric() || first == '_' {
            let mut before = ' ';
            let is_number = first.is_ascii_digit();
            let inside = |c: char| {
                let sign_of_exponent = "+-".contains(c) && is_number && before == 'e';
                let is_inside = c.is_alphanumeric() || c == '_' || (c == '.' && is_number) || sign_of_exponent;
                before = c;
                is_inside
            };
            rest.find({
                let mut inside = inside;
                move |c| !inside(c)
            })
            .unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        tokens.push(rest[..length].to_owned());
        rest = rest[length..].trim_start();
    }
    tokens
}

/// Tokens that are still to be read, and the names that are known.
struct Reader<'a> {
    tokens: &'a [String],
    values: Values,
}

impl Reader<'_> {
    fn peek(&self) -> &str {
        self.tokens.first().map_or("", |token| token.as_str())
    }

    fn next(&mut self) -> String {
        let token = self.peek().to_owned();
        self.tokens = &self.tokens[1..];
        token
    }

    fn takes(&mut self, token: &str) -> bool {
        let is_next = self.peek() == token;
        if is_next {
            self.tokens = &self.tokens[1..];
        }
        is_next
    }

    fn sum(&mut self) -> f64 {
        let mut sum = self.product();
        loop {
            if self.takes("+") {
                sum += self.product();
            } else if self.takes("-") {
                sum -= self.product();
            } else {
                return sum;
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut product = self.factor();
        while self.takes("*") {
            product *= self.factor();
        }
        product
    }

    fn factor(&mut self) -> f64 {
        if self.takes("-") {
            return -self.factor();
        }
        let token = self.next();
        token.parse().unwrap_or_else(|_| self.value(&token))
    }

    fn value(&self, name: &str) -> f64 {
        *self.values.get(name).unwrap_or_else(|| panic!("{name} is no number, no field and no `let`"))
    }

    /// `{ name, name: expression, .. }`
    fn parameters(&mut self) -> BTreeMap<String, f64> {
        let mut parameters = BTreeMap::new();
        assert!(self.takes("{"));
        while !self.takes("}") {
            let name = self.next();
            let value = if self.takes(":") { self.sum() } else { self.value(&name) };
            // the laws of bodies are about their input ends
            let name = if name == "inertia_about_input" { "inertia".to_owned() } else { name };
            parameters.insert(name, value);
            self.takes(",");
        }
        parameters
    }

    fn node(&mut self, sketch: &mut Sketch) -> usize {
        let kind = self.next();
        let node = match kind.as_str() {
            "fixed" | "free" | "pinned" | "guided" => Node::Support(kind),
            "conn" => {
                let node = Node::Connection(format!("conn_{}", self.next()));
                if let Some(known) = sketch.nodes.iter().position(|other| *other == node) {
                    return known;
                }
                node
            }
            _ => {
                let name = format!("{kind}_{}", self.next());
                Node::Element { kind, name, parameters: self.parameters() }
            }
        };
        sketch.nodes.push(node);
        sketch.nodes.len() - 1
    }

    fn path(&mut self, sketch: &mut Sketch) {
        let mut from = self.node(sketch);
        loop {
            let forwards = self.takes("->");
            if !forwards && !self.takes("<-") {
                return;
            }
            let to = self.node(sketch);
            sketch.arrows.push(if forwards { (from, to) } else { (to, from) });
            from = to;
        }
    }
}

/// Values of the fields of a struct, from how it is printed: `Name { field: value, .. }`.
fn fields(printed: &str) -> Values {
    let tokens = tokens(printed);
    let pairs = tokens.windows(4).filter(|window| window[1] == ":");
    pairs
        .map(|window| {
            let text = if window[2] == "-" { window[2..].concat() } else { window[2].clone() };
            (window[0].clone(), text.parse().unwrap())
        })
        .collect()
}

impl Sketch {
    /// The sketch of a model in a source file, with the model's values as `{:?}` prints them.
    pub(crate) fn of(source: &str, model: &str, printed: &str) -> Sketch {
        let tokens = tokens(source);
        let start = tokens.windows(2).position(|pair| pair[0] == "struct" && pair[1] == model).unwrap() + 2;
        let is_unit = tokens[start] == ";";
        let end_of_fields = tokens[start..].iter().position(|token| token == if is_unit { ";" } else { "}" }).unwrap();
        let mut reader = Reader { tokens: &tokens[start + end_of_fields + 1..], values: fields(printed) };
        let mut sketch = Sketch::default();
        while !reader.takes("}") {
            if reader.takes("let") {
                let name = reader.next();
                assert!(reader.takes("="));
                let value = reader.sum();
                reader.values.insert(name, value);
            } else {
                reader.path(&mut sketch);
            }
            reader.takes(";");
        }
        sketch
    }

    /// Indices of the nodes from which arrows lead to one.
    pub(crate) fn before(&self, node: usize) -> impl Iterator<Item = usize> {
        self.arrows.iter().filter(move |(_, to)| *to == node).map(|(from, _)| *from)
    }

    /// Index of the node to which the arrow of one leads.
    pub(crate) fn after(&self, node: usize) -> Option<usize> {
        self.arrows.iter().find(|(from, _)| *from == node).map(|(_, to)| *to)
    }
}
