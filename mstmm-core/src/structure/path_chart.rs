//! Charts of elements of one motion, made of their transfer matrices.

use crate::number::{Scalar, Scaled, Size, Truth, binary_exponent, power_of_two};
use crate::structure::chart::Chart;
use crate::structure::units::{Units, unit_of};
use mstmm_plan::Freedoms;

impl<S: Scalar> Chart<S> {
    /// The chart of an element of a translation path, with displacements along the member.
    ///
    /// `transfer` takes `[Y, Q]` of the input end to that of the output end; its determinant is one, and its entries are entire functions of
    /// the frequency. `held` are the number of natural frequencies with both ends held, and whether the flexibility `-transfer[0][1]` is
    /// negative by that number, as [`RootCounter::line`](crate::RootCounter::line) takes them. `unit` is a usual size of forces per
    /// displacement: with waves the stiffness times their number. A transfer matrix with a pole, as that of a dashpot, makes no chart.
    ///
    /// Variables are the displacement of the input end and the force at the output end, or where the flexibility is the larger entry both
    /// displacements, so that nothing is divided by a small number.
    pub fn translation(transfer: [[S; 2]; 2], held: (S::Size, S::Truth), unit: f64) -> Self {
        Chart::of_path(Freedoms::X, transfer, held, unit)
    }

    /// The chart of an element of a rotation path, from the transfer matrix over `[Θ, M]`; the rest is as for a
    /// [`translation`](Chart::translation), with the flexibility `transfer[0][1]`.
    pub fn rotation(transfer: [[S; 2]; 2], held: (S::Size, S::Truth), unit: f64) -> Self {
        let [[a, b], [c, d]] = transfer;
        Chart::of_path(Freedoms::RZ, [[a, -b], [-c, d]], held, unit)
    }

    /// The chart from `[[a, -φ], [c, d]]`: `[[-c, -1], [-1, -φ]] / d` over displacement and force, `[[a, -1], [-1, d]] / φ` over both
    /// displacements.
    fn of_path(
        freedom: Freedoms,
        [[a, b], [c, d]]: [[S; 2]; 2],
        (held, is_negative): (S::Size, S::Truth),
        unit: f64,
    ) -> Self {
        let flexibility = -b;
        // what has no force has no size, as a pendulum at its own frequency
        let size = if unit > 0.0 { unit_of(binary_exponent(unit)) } else { 0 };
        let mut chart = Chart::empty(freedom, Units { displacement: size, rotation: size });
        let exponent = chart.units.of(freedom.is(Freedoms::RZ));
        let is_flexible = (d + d).size().is_below((flexibility * S::from_f64(unit)).size()).any();
        let (divisor, entries, signs) = if is_flexible {
            (flexibility, [a, -S::one(), d], [1, 1])
        } else {
            chart.forces = 0b10;
            // a force that is free instead of a displacement that is held: one frequency less where the stiffness there is positive
            let freed = S::Size::one_if(d.is_negative() ^ is_negative) + S::Size::of(-1.0);
            chart.below = chart.below + freed;
            (d, [-c, -S::one(), -flexibility], [1, -1])
        };
        chart.below = chart.below + held;
        chart.product = Scaled::new(divisor, 0);
        for ((row, column), entry) in [(0, 0), (1, 0), (1, 1)].into_iter().zip(entries) {
            let power = power_of_two(exponent * (signs[row] + signs[column]));
            chart.set(row, column, (entry / divisor).scaled(power));
        }
        chart
    }
}
