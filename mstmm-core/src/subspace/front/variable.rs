//! The variables of fronts: displacements and forces of the ports.

/// A variable of a front: the displacement or the force of an end of a member in one freedom.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Variable {
    /// Index of the node of the end.
    pub(crate) node: u32,
    /// What its unit comes from.
    pub(crate) measure: Measure,
    /// Logarithm to base 2 of the unit of the displacement; the force has its inverse.
    pub(crate) unit: i32,
    /// Whether it is a force; else it is a displacement.
    pub(crate) is_force: bool,
    /// Whether it is a rotation or a moment.
    pub(crate) is_rotation: bool,
    /// Whether the end does not share the freedom with its node.
    pub(crate) is_released: bool,
}

/// What gives a variable its unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Measure {
    /// A member with inertia, given the logarithm to base 2 of its wave number.
    Member(i32),
    /// A spring or damper.
    Connector,
    /// Nothing: a rigid joint has no size.
    Nothing,
}

impl Measure {
    /// What the unit comes from behind a node, which lends its own to a rigid joint.
    pub(super) fn once_joined(self) -> Self {
        if self == Measure::Nothing { Measure::Connector } else { self }
    }
}

impl Variable {
    /// A displacement in the unit 1: all zeros, as memory is filled with.
    pub(crate) const DISPLACEMENT: Variable = Variable {
        node: 0,
        measure: Measure::Member(0),
        unit: 0,
        is_force: false,
        is_rotation: false,
        is_released: false,
    };

    /// Logarithm to base 2 of the factor of a row of this variable in another unit.
    #[inline]
    pub(crate) fn shift_to(&self, unit: i32) -> i32 {
        if self.is_force { self.unit - unit } else { unit - self.unit }
    }
}
