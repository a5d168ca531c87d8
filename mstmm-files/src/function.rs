//! What a frequency response function is of: its points, directions and quantities.

/// A direction at a node, in the axes of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// None: a scalar.
    Scalar,
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Along z.
    Z,
    /// About x.
    RotationX,
    /// About y.
    RotationY,
    /// About z.
    RotationZ,
}

impl Direction {
    /// Its number in the format.
    pub(crate) fn code(self) -> i8 {
        match self {
            Direction::Scalar => 0,
            Direction::X => 1,
            Direction::Y => 2,
            Direction::Z => 3,
            Direction::RotationX => 4,
            Direction::RotationY => 5,
            Direction::RotationZ => 6,
        }
    }
}

/// A degree of freedom: a node and a direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dof {
    /// Number of the node.
    pub node: u32,
    /// Direction there.
    pub direction: Direction,
}

/// What is on an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Nothing that the format has a number for.
    Unknown,
    /// Displacements, or rotations where the direction is one.
    Displacement,
    /// Reaction forces or moments.
    ReactionForce,
    /// Velocities.
    Velocity,
    /// Accelerations.
    Acceleration,
    /// Exciting forces or moments.
    ExcitationForce,
    /// Frequencies.
    Frequency,
}

impl Quantity {
    /// Its number in the format.
    pub(crate) fn code(self) -> u8 {
        match self {
            Quantity::Unknown => 0,
            Quantity::Displacement => 8,
            Quantity::ReactionForce => 9,
            Quantity::Velocity => 11,
            Quantity::Acceleration => 12,
            Quantity::ExcitationForce => 13,
            Quantity::Frequency => 18,
        }
    }
}

/// An axis: a quantity, its label and its unit, each of up to 20 printable ASCII characters; empty ones are `NONE`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axis<'a> {
    /// What is on it.
    pub quantity: Quantity,
    /// Its label.
    pub label: &'a str,
    /// Its unit.
    pub unit: &'a str,
}

/// The head of a frequency response function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Function<'a> {
    /// A description of up to 80 printable ASCII characters; an empty one is `NONE`.
    pub description: &'a str,
    /// Where and in which direction the response is.
    pub response: Dof,
    /// Where and in which direction the load is.
    pub reference: Dof,
    /// What responds.
    pub ordinate: Axis<'a>,
    /// What excites: the ordinate is divided by it.
    pub denominator: Axis<'a>,
}

impl<'a> Function<'a> {
    /// A displacement in m per force in N.
    pub fn receptance(description: &'a str, response: Dof, reference: Dof) -> Self {
        let ordinate = Axis { quantity: Quantity::Displacement, label: "Displacement", unit: "m" };
        let denominator = Axis { quantity: Quantity::ExcitationForce, label: "Force", unit: "N" };
        Function { description, response, reference, ordinate, denominator }
    }
}
