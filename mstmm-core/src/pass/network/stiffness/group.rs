//! Variables of a front that enter it together and leave together.

/// Most variables of a front, each of which is a bit of a [`Set`].
pub(super) const MOST: usize = 48;

/// A set of variables of a front.
pub(super) type Set = u64;

/// Variables that leave together: the motions of a node, or the forces of a rigid joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Group {
    /// Where they begin in the front, and how many they are: small numbers, since each member of a model has some.
    first: u8,
    count: u8,
    /// The variables to which they are coupled when they leave.
    pub(super) beside: Set,
}

impl Group {
    /// No variables.
    pub(super) const NONE: Group = Group { first: 0, count: 0, beside: 0 };

    /// So many variables from one on, coupled to none.
    pub(super) const fn new(first: usize, count: usize) -> Self {
        Group { first: first as u8, count: count as u8, beside: 0 }
    }

    /// Where they begin in the front, and how many they are.
    #[inline(always)]
    pub(super) const fn places(&self) -> [usize; 2] {
        [self.first as usize, self.count as usize]
    }

    /// Its variables.
    pub(super) const fn own(&self) -> Set {
        ((1 << self.count) - 1) << self.first
    }
}

/// The variables of a set, in their order.
#[inline(always)]
pub(super) fn members_of(mut set: Set) -> impl Iterator<Item = usize> {
    core::iter::from_fn(move || {
        let next = (set != 0).then(|| set.trailing_zeros() as usize);
        set &= set.wrapping_sub(1);
        next
    })
}
