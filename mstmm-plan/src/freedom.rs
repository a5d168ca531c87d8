//! Sets of freedoms: the displacements that a point has, a state tells, or a support holds.

/// A set of displacements of a point.
///
/// ```
/// use mstmm_plan::Freedoms;
/// let pin = Freedoms::X.union(Freedoms::Y);
/// assert!(pin.contains(Freedoms::Y) && !pin.contains(Freedoms::RZ));
/// assert_eq!(pin.without(Freedoms::X), Freedoms::Y);
/// assert_eq!(pin.count(), 2);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Freedoms(u8);

impl Freedoms {
    /// No freedom.
    pub const NONE: Freedoms = Freedoms(0);
    /// Displacement along x.
    pub const X: Freedoms = Freedoms(1);
    /// Displacement along y.
    pub const Y: Freedoms = Freedoms(1 << 1);
    /// Rotation about z.
    pub const RZ: Freedoms = Freedoms(1 << 2);
    /// Displacement along z.
    pub const Z: Freedoms = Freedoms(1 << 3);
    /// Rotation about x.
    pub const RX: Freedoms = Freedoms(1 << 4);
    /// Rotation about y.
    pub const RY: Freedoms = Freedoms(1 << 5);
    /// All freedoms of the plane.
    pub const PLANE: Freedoms = Freedoms(0b111);
    /// All freedoms of space.
    pub const SPACE: Freedoms = Freedoms(0b11_1111);
    /// The displacements along x, y and z.
    pub const DISPLACEMENTS: Freedoms = Freedoms::X.union(Freedoms::Y).union(Freedoms::Z);
    /// The rotations about x, y and z.
    pub const ROTATIONS: Freedoms = Freedoms::RX.union(Freedoms::RY).union(Freedoms::RZ);
    /// Each freedom of the plane alone, in their order.
    pub const SINGLE: [Freedoms; 3] = [Freedoms::X, Freedoms::Y, Freedoms::RZ];
    /// Each freedom of space alone: those of the plane first.
    pub const EACH: [Freedoms; 6] = [Freedoms::X, Freedoms::Y, Freedoms::RZ, Freedoms::Z, Freedoms::RX, Freedoms::RY];

    /// The freedoms of either set.
    #[inline]
    pub const fn union(self, other: Freedoms) -> Freedoms {
        Freedoms(self.0 | other.0)
    }

    /// The freedoms of both sets.
    #[inline]
    pub const fn intersection(self, other: Freedoms) -> Freedoms {
        Freedoms(self.0 & other.0)
    }

    /// The freedoms of this set that another has not.
    #[inline]
    pub const fn without(self, other: Freedoms) -> Freedoms {
        Freedoms(self.0 & !other.0)
    }

    /// Whether all freedoms of another set are in this one.
    #[inline]
    pub const fn contains(self, other: Freedoms) -> bool {
        other.without(self).is_empty()
    }

    /// Whether the set is empty.
    #[inline]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether two sets are the same; `==` is not available in constants.
    #[inline]
    pub const fn is(self, other: Freedoms) -> bool {
        self.0 == other.0
    }

    /// The freedoms of space that axes of other directions may have where these have some: all displacements for one, and all rotations for one.
    pub const fn in_any_axes(self) -> Freedoms {
        let [moves, turns] = [Freedoms::DISPLACEMENTS, Freedoms::ROTATIONS];
        let moved = if self.intersection(moves).is_empty() { Freedoms::NONE } else { moves };
        let turned = if self.intersection(turns).is_empty() { Freedoms::NONE } else { turns };
        moved.union(turned)
    }

    /// Number of freedoms.
    #[inline]
    pub const fn count(self) -> usize {
        self.0.count_ones() as usize
    }

    /// Place of the set among all sets.
    #[inline]
    pub(crate) const fn index(self) -> usize {
        self.0 as usize
    }

    /// The set at a place among all sets.
    pub(crate) const fn at(index: usize) -> Freedoms {
        Freedoms(index as u8)
    }
}
