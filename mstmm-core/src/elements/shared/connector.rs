//! The charts of springs and dampers between two points.

use crate::element::{Element, space_of};
use crate::number::{Scalar, Scaled, Size, binary_exponent};
use crate::subspace::{Chart, MOST_VARIABLES, Units, unit_of};
use mstmm_plan::{Freedoms, Space};

/// The freedom that the ends of a translation or rotation element have in the axes of a member: along it or about z.
pub(crate) fn along_member<E: Element>() -> Freedoms {
    if space_of::<E>().is(Space::Translation) { Freedoms::X } else { Freedoms::RZ }
}

/// The chart of a dynamic stiffness κ between the displacements of two points, over the displacement of the first one and the force
/// at the second: `[[0, -1], [-1, -1/κ]]`. A stiff one loses nothing, as it would among stiffnesses.
pub(crate) fn connector<S: Scalar>(kappa: S, freedoms: Freedoms) -> Chart<S> {
    let size = kappa.size().first();
    let mut entries = [[S::zero(); MOST_VARIABLES]; MOST_VARIABLES];
    let mut chart = Chart {
        freedoms,
        entries,
        forces: 0,
        units: Units { displacement: 0, rotation: 0 },
        wave: None,
        product: Scaled::new(S::one(), 0),
        below: S::Size::of(0.0),
    };
    if size == 0.0 {
        return chart;
    }
    let unit = unit_of(binary_exponent(size));
    entries[0][1] = -S::one();
    entries[1][0] = -S::one();
    entries[1][1] = -(S::one() / kappa.times_power_of_two(2 * unit));
    chart.entries = entries;
    chart.forces = 0b10;
    chart.units = Units { displacement: unit, rotation: unit };
    chart.product = Scaled::new(kappa, 0);
    chart.below = S::Size::of(-1.0);
    chart
}
