//! Nodes with their places in space; in a plane structure z is zero, and what leads out of the plane is held.

use crate::model::{FrequencyEstimates, Skew, Tensor};
use crate::number::{Frequency, Parameter, Real, Truth};
use crate::pass::network::vector::{Six, difference};
use mstmm_plan::Freedoms;

/// The displacements.
pub(crate) const XYZ: Freedoms = Freedoms::X.union(Freedoms::Y).union(Freedoms::Z);

/// A node with its place, what holds it, and the body that moves with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedNode<T> {
    pub(crate) position: [T; 3],
    /// The freedoms that are held.
    pub(crate) held: Freedoms,
    /// How its displacements are, where they are not as `held` says.
    pub(crate) skew: Option<Skew<T>>,
    pub(crate) mass: T,
    pub(crate) inertia: Tensor<T>,
    pub(crate) centre: [T; 3],
}

impl<T: Parameter> PlacedNode<T> {
    /// A free point without mass.
    pub(crate) fn at(position: [T; 3]) -> Self {
        let zero = T::zero();
        PlacedNode { position, held: Freedoms::NONE, skew: None, mass: zero, inertia: [zero; 6], centre: position }
    }

    /// The node with freedoms held.
    #[cfg(feature = "std")]
    pub(crate) fn held(self, held: Freedoms) -> Self {
        PlacedNode { held, ..self }
    }

    /// Whether a body moves with the node.
    pub(crate) fn has_body(&self) -> bool {
        !(self.mass.vanishes().all() && self.has_no_inertia())
    }

    /// The moment of inertia about z.
    pub(crate) fn about_z(&self) -> T {
        self.inertia[2]
    }

    /// Whether its body has no moment of inertia.
    fn has_no_inertia(&self) -> bool {
        self.inertia.iter().all(|entry| entry.vanishes().all())
    }

    /// What a displacement of 1 of its support along an axis, or a rotation, moves the node by; `None` where it does not hold the node so.
    /// Where the node may move along a direction, its own motion takes back what is along that.
    pub(crate) fn moved<S: Frequency<T>>(&self, axis: usize) -> Option<Six<S>> {
        let freedom = Freedoms::EACH[axis];
        let mut moved = [S::zero(); 6];
        moved[axis] = S::one();
        let holds = match &self.skew {
            Some(skew) if XYZ.contains(freedom) => {
                let place = if freedom.is(Freedoms::Z) { 2 } else { axis };
                let others = skew.direction().iter().enumerate().filter(|(k, _)| *k != place);
                match skew {
                    Skew::Along(_) => others.into_iter().any(|(_, part)| !part.vanishes().all()),
                    Skew::Normal(direction) => !direction[place].vanishes().all(),
                }
            }
            _ => self.held.contains(freedom),
        };
        holds.then_some(moved)
    }

    /// The mass matrix of the body times displacements of the node.
    pub(crate) fn momentum<S: Frequency<T>>(&self, displacements: Six<S>) -> Six<S> {
        self.mass_matrix::<S>().map(|row| {
            let terms = row.into_iter().zip(displacements).filter(|(mass, _)| !mass.is_constant_zero());
            terms.fold(S::zero(), |sum, (mass, displacement)| sum + mass * displacement)
        })
    }

    /// The mass form `uᵀ M v` of the body in two motions of the node.
    pub(crate) fn mass_form<S: Frequency<T>>(&self, first: Six<S>, second: Six<S>) -> S {
        let terms = first.into_iter().zip(self.momentum(second)).map(|(one, other)| one * other);
        terms.fold(S::zero(), |sum, term| sum + term)
    }

    /// The mass matrix of the body over the displacements of the node.
    ///
    /// With the vector c to the mass centre, the mass m and the tensor J about that: `[[m, -m c×], [m c×, J + m(c² - c cᵀ)]]`.
    pub(crate) fn mass_matrix<S: Frequency<T>>(&self) -> [Six<S>; 6] {
        let number = S::from_parameter;
        let (m, zero) = (number(self.mass), S::zero());
        let [xx, yy, zz, xy, yz, zx] = self.inertia.map(number);
        let [x, y, z] = difference(self.position.map(number), self.centre.map(number));
        let [mx, my, mz] = [m * x, m * y, m * z];
        let (about_xy, about_yz, about_zx) = (xy - mx * y, yz - my * z, zx - mz * x);
        [
            [m, zero, -my, zero, zero, mz],
            [zero, m, mx, zero, -mz, zero],
            [-my, mx, zz + mx * x + my * y, zero, about_zx, about_yz],
            [zero, zero, zero, m, my, -mx],
            [zero, -mz, about_zx, my, xx + my * y + mz * z, about_xy],
            [mz, zero, about_yz, -mx, about_xy, yy + mx * x + mz * z],
        ]
    }
}

impl<T: Real> PlacedNode<T> {
    /// The node with a rigid body beside the one that it has: both are one body then.
    pub(crate) fn and_body(self, mass: T, inertia: Tensor<T>, centre: [T; 3]) -> Self {
        let total = self.mass + mass;
        if self.mass.vanishes() && self.has_no_inertia() {
            return PlacedNode { mass, inertia, centre, ..self };
        }
        let mut sum = self.inertia;
        sum.iter_mut().zip(inertia).for_each(|(entry, other)| *entry += other);
        if total.vanishes() {
            return PlacedNode { inertia: sum, ..self };
        }
        // about the common centre: parallel axes
        let [x, y, z] = difference(self.centre, centre);
        let part = mass / total;
        let apart = self.mass * part;
        let by = [y * y + z * z, x * x + z * z, x * x + y * y, -(x * y), -(y * z), -(z * x)];
        sum.iter_mut().zip(by).for_each(|(entry, square)| *entry += apart * square);
        let mut common = self.centre;
        common.iter_mut().zip([x, y, z]).for_each(|(own, part_of)| *own += part * part_of);
        PlacedNode { mass: total, inertia: sum, centre: common, ..self }
    }

    /// Adds the body to the estimates from which searches take their first steps.
    pub(crate) fn estimate(&self, estimates: &mut FrequencyEstimates) {
        estimates.mass(self.mass.to_f64());
        self.inertia[..3].iter().for_each(|moment| estimates.moment_of_inertia(moment.to_f64()));
        let offset = difference(self.position, self.centre);
        offset.into_iter().for_each(|lever| estimates.lever(lever.to_f64()));
    }
}
