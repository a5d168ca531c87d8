//! Members that are known by their charts alone: their stiffness for a count without a proof.

use crate::element::OwnPart;
use crate::number::{FrequencyPowers, Real, Scalar, Size, power_of_two};
use crate::pass::characteristic::System;
use crate::pass::network::placed::PlacedCharts;
use crate::structure::Chart;
use mstmm_plan::Freedoms;

/// A network whose members are known by their charts in extended precision.
#[doc(hidden)]
pub trait OwnMembers: System {
    /// The stiffness of a member of one motion at ω, which is the sum of two words; none of other members.
    fn own_member(&self, member: usize, omega: [f64; 2]) -> Option<OwnPart>;
}

impl<Y> OwnMembers for Y
where
    Y: System<Parameter: Real> + PlacedCharts<<<Y as System>::Parameter as Real>::Extended>,
{
    fn own_member(&self, member: usize, [hi, lo]: [f64; 2]) -> Option<OwnPart> {
        let number = <<Y as System>::Parameter as Real>::Extended::from_f64;
        let at = FrequencyPowers::new(number(hi) + number(lo), true);
        let chart = self.chart(member, &at, self.placement(member).length())?;
        (chart.freedoms.count() == 1).then(|| stiffness(chart))
    }
}

/// The stiffness over the displacements of both ends, or how the displacements are tied: where f is a force without flexibility the displacement is
/// `-b u`, with the entry b between both variables.
fn stiffness<S: Real>(mut chart: Chart<S>) -> OwnPart {
    let unit = power_of_two(-2 * chart.units.of(chart.freedoms.is(Freedoms::RZ)));
    for end in 0..2 {
        if !chart.is_force(end) {
            continue;
        }
        if chart.entry(end, end).vanishes() {
            let (between, other) = (-chart.entry(1, 0), chart.entry(1 - end, 1 - end));
            let ratio = if end == 0 { S::one() / between } else { between };
            let square = if end == 0 { ratio * ratio } else { S::one() };
            return OwnPart::Tie { ratio: ratio.words(), stiffness: (other * square).scaled(unit).words() };
        }
        chart.flip(end);
    }
    let stiffness = [(0, 0), (1, 0), (1, 1)].map(|(row, column)| chart.entry(row, column).scaled(unit).words());
    OwnPart::Stiffness { stiffness, held: chart.below.first() }
}
