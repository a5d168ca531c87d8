//! Units in which the sizes of entries compare: they decide which pivots are taken, and round nothing.

use crate::number::{Scalar, Size, binary_exponent};
use crate::subspace::front::matrix::Front;
use crate::subspace::front::triangle::row;
use crate::subspace::front::variable::{Measure, Variable};

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

/// Finds the units of a node from those of the variables of its ports.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NodeUnits {
    /// The smallest and the largest unit of members, of displacements and of rotations.
    members: [Option<[i32; 2]>; 2],
    /// The largest unit of connectors, likewise.
    connectors: [Option<i32>; 2],
    /// The smallest wave number of members.
    wave: Option<i32>,
}

impl NodeUnits {
    pub(crate) fn new() -> Self {
        NodeUnits { members: [None; 2], connectors: [None; 2], wave: None }
    }

    /// Looks at a variable of a port.
    pub(crate) fn include(&mut self, variable: &Variable) {
        let (kind, unit) = (usize::from(variable.is_rotation), variable.unit);
        let wave = match variable.measure {
            Measure::Member(wave) => wave,
            Measure::Connector => {
                self.connectors[kind] = Some(self.connectors[kind].map_or(unit, |largest| largest.max(unit)));
                return;
            }
            Measure::Nothing => return,
        };
        let [least, greatest] = self.members[kind].unwrap_or([unit; 2]);
        self.members[kind] = Some([least.min(unit), greatest.max(unit)]);
        self.wave = Some(self.wave.map_or(wave, |least| least.min(wave)));
    }

    /// The units: in the middle between the stiffest and the softest member, where rotations are no stiffer than displacements are by the
    /// lever of a wave. Displacements are not tied to rotations likewise: in portals that left half as many roots again to be judged, and
    /// in no family fewer. Without members units lie between that of the softest connector and that of the inertia, whose size is given,
    /// like those of a member.
    pub(crate) fn units(&self, inertias: [f64; 2]) -> Units {
        let of = |kind: usize| {
            let inertia = (inertias[kind] > 0.0).then(|| unit_of(binary_exponent(inertias[kind])));
            match (self.members[kind], self.connectors[kind], inertia) {
                (Some([least, greatest]), ..) => Some((least + greatest).div_euclid(2)),
                (None, Some(connector), Some(inertia)) => Some((connector + inertia.max(connector)).div_euclid(2)),
                (None, connector, inertia) => connector.or(inertia),
            }
        };
        let own = [of(0), of(1)];
        let displacement = own[0].or(own[1]).unwrap_or(0);
        let rotation = own[1].unwrap_or(displacement);
        let rotation = self.wave.map_or(rotation, |wave| rotation.max(displacement + wave));
        Units { displacement, rotation }.in_range()
    }
}

/// The unit of a displacement whose stiffness or impedance has a binary exponent.
pub(crate) fn unit_of(exponent: i32) -> i32 {
    -(exponent.div_euclid(2) + 1)
}

impl<S: Scalar> Front<'_, S> {
    /// Logarithm to base 2 of the factor on the units of the boundary by which its largest stiffness and its largest flexibility agree.
    pub(super) fn balance(&self) -> i32 {
        let mut largest = [0.0_f64; 2];
        let (mut least, mut greatest) = (0, 0);
        for (place, variable) in self.variables[..self.boundary].iter().enumerate() {
            let kind = usize::from(variable.is_force);
            let size = self.entries[row(place) + place].size().first();
            // an entry that is rounding alone, as across a bar between two pins at rest, has no size: it would become the unit
            if size > S::EPSILON * self.errors[place] {
                largest[kind] = largest[kind].max(size);
            }
            (least, greatest) = (variable.unit.min(least), variable.unit.max(greatest));
        }
        let exponent = |size: f64| (size > 0.0 && size < f64::INFINITY).then(|| binary_exponent(size));
        let shift = match largest.map(exponent) {
            [Some(stiffness), Some(flexibility)] => (flexibility - stiffness).div_euclid(4),
            [Some(stiffness), None] => -stiffness.div_euclid(2),
            [None, Some(flexibility)] => flexibility.div_euclid(2),
            [None, None] => 0,
        };
        shift.clamp(-LARGEST - least, LARGEST - greatest)
    }
}
