//! Units in which the sizes of entries compare: they decide which variables flip, and round nothing.

/// The largest and, negative, the smallest logarithm of a unit: products of two powers of such units stay in the range.
const LARGEST: i32 = 200;

/// Logarithms to base 2 of the units of displacements and of rotations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Units {
    pub(crate) displacement: i32,
    pub(crate) rotation: i32,
}

impl Units {
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
