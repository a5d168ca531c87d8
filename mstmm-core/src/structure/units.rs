//! Units in which the sizes of entries compare: they decide which variables flip, and round nothing.
//!
//! What flips adds its stiffness to that of its nodes, and a mode has no other stiffness there than its inertia. In units between both a
//! spring that is stiffer by far does not flip, and no more is added to its nodes than the unit has.

/// The largest and, negative, the smallest logarithm of a unit: products of two powers of such units stay in the range.
const LARGEST: i32 = 200;

/// Logarithms to base 2 of the units of displacements and of rotations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Units {
    pub(crate) displacement: i32,
    pub(crate) rotation: i32,
}

impl Units {
    /// Units that are finer than all others.
    pub(crate) const FINEST: Self = Units { displacement: -LARGEST, rotation: -LARGEST };

    /// The units of impedances whose binary exponents are given, or the finest ones.
    pub(crate) fn of_exponents(exponents: [Option<i32>; 2]) -> Self {
        let [displacement, rotation] = exponents.map(|exponent| exponent.map_or(-LARGEST, unit_of));
        Units { displacement, rotation }.in_range()
    }

    /// The coarser one of two units of each kind.
    pub(crate) fn coarser(self, other: Self) -> Self {
        let Units { displacement, rotation } = other;
        Units { displacement: self.displacement.max(displacement), rotation: self.rotation.max(rotation) }
    }

    /// The unit of a kind of motion.
    #[inline]
    pub(crate) fn of(&self, is_rotation: bool) -> i32 {
        if is_rotation { self.rotation } else { self.displacement }
    }

    /// Units whose powers of two stay in the range of numbers.
    pub(crate) fn in_range(self) -> Self {
        let [displacement, rotation] = [self.displacement, self.rotation].map(|unit| unit.clamp(-LARGEST, LARGEST));
        Units { displacement, rotation }
    }
}

/// The unit of a displacement whose stiffness or impedance has a binary exponent.
pub(crate) fn unit_of(exponent: i32) -> i32 {
    -(exponent.div_euclid(2) + 1)
}
