//! The charts of what joins freedoms one by one: springs, dampers, hinges, rigid joints.

use crate::number::{Scalar, Scaled, Size, binary_exponent};
use crate::structure::{Chart, Units, unit_of};
use mstmm_plan::Freedoms;

/// What joins the two ends in one freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Tie<S> {
    /// A dynamic stiffness.
    Elastic(S),
    /// Both displacements are one.
    Rigid,
}

impl<S: Scalar> Chart<S> {
    /// The chart of what acts between its ends by a dynamic stiffness κ alone, along the member: a spring, a dashpot with `κ = Cλ`.
    pub fn spring(kappa: S) -> Self {
        connector(kappa, Freedoms::X)
    }

    /// The chart of a dynamic stiffness κ between the rotations of its ends.
    pub fn torsion_spring(kappa: S) -> Self {
        connector(kappa, Freedoms::RZ)
    }
}

/// The chart of a dynamic stiffness κ between the displacements of two points.
pub(crate) fn connector<S: Scalar>(kappa: S, freedoms: Freedoms) -> Chart<S> {
    chart_of_ties(core::iter::once((freedoms, Tie::Elastic(kappa))))
}

/// The freedoms in which something is given.
pub(crate) fn freedoms_of<P>(parts: &[Option<P>; 3]) -> Freedoms {
    let given = Freedoms::SINGLE.into_iter().zip(parts).filter(|(_, part)| part.is_some());
    given.fold(Freedoms::NONE, |sum, (freedom, _)| sum.union(freedom))
}

/// The chart of a joint: of a dynamic stiffness in each freedom that has one, rigid in others.
pub(crate) fn chart_of_joint<S: Scalar>(rigid: Freedoms, stiffness: [Option<S>; 3]) -> Chart<S> {
    let ties = Freedoms::SINGLE.into_iter().zip(stiffness).filter_map(|(freedom, kappa)| {
        let tie = kappa.map(Tie::Elastic).or(rigid.contains(freedom).then_some(Tie::Rigid));
        Some((freedom, tie?))
    });
    chart_of_ties(ties)
}

/// The chart of ties of single freedoms, which stand in the order x, y, rz: of each over the displacement of the first end and the force
/// at the second, `[[0, -1], [-1, -1/κ]]`. A stiff one loses nothing, as it would among stiffnesses.
fn chart_of_ties<S: Scalar>(ties: impl Iterator<Item = (Freedoms, Tie<S>)> + Clone) -> Chart<S> {
    let freedoms = ties.clone().fold(Freedoms::NONE, |sum, (freedom, _)| sum.union(freedom));
    let softest = |is_rotation: bool| {
        let exponents = ties.clone().filter_map(|(freedom, tie)| match tie {
            Tie::Elastic(kappa) if freedom.is(Freedoms::RZ) == is_rotation => {
                let size = kappa.size().first();
                (size > 0.0).then(|| binary_exponent(size))
            }
            _ => None,
        });
        exponents.min().map(unit_of)
    };
    let [displacement, rotation] = [false, true].map(softest);
    let one = displacement.or(rotation);
    let one = one.unwrap_or(0);
    let units = Units { displacement: displacement.unwrap_or(one), rotation: rotation.unwrap_or(one) };
    let mut chart = Chart::empty(freedoms, units);
    let units = chart.units;
    for (input, (freedom, tie)) in ties.enumerate() {
        let output = freedoms.count() + input;
        let flexibility = match tie {
            Tie::Rigid => S::zero(),
            Tie::Elastic(kappa) if kappa.size().first() == 0.0 => continue,
            Tie::Elastic(kappa) => {
                chart.product = chart.product.product(Scaled::new(kappa, 0));
                S::one() / kappa.times_power_of_two(2 * units.of(freedom.is(Freedoms::RZ)))
            }
        };
        chart.set(output, input, -S::one());
        chart.set(output, output, -flexibility);
        chart.forces |= 1 << output;
        chart.below = chart.below + S::Size::of(-1.0);
    }
    chart
}
