//! The mass form of two motions of a plane structure.

use crate::model::EndMotion;
use crate::number::{Real, power_of_two};
use crate::pass::characteristic::System;
use crate::pass::network::frequency::{MovingNetwork, PlaneFrequency};
use crate::pass::network::motion::NetworkMotion;
use crate::pass::network::placed::PlacedCharts;
use crate::pass::network::vector::Six;
use crate::structure::{Chart, MOST_VARIABLES};
use mstmm_plan::Freedoms;

/// `φ₁ᵀ M φ₂`, with dampers `φ₁ᵀ M φ₂ + φ₁ᵀ C φ₂/(2λ)`: the derivative of the dynamic work with respect to λ² at the frequency of both.
///
/// A member's work is a quadratic form of the variables of its chart, and so is its derivative while these are held, whatever their
/// kinds.
pub(crate) fn mass_product<Y, S>(network: &Y, x: S, first: &NetworkMotion<Y, S>, second: &NetworkMotion<Y, S>) -> S
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    let at = x.powers_in_square();
    let mut sum = S::zero();
    let members = first.members.as_ref().iter().zip(second.members.as_ref());
    for (member, (first, second)) in members.enumerate().take(network.sizes()[1]) {
        let length = network.placement(member).length::<S>().constant();
        if let Some(chart) = PlacedCharts::<S::WithSlope>::chart(network, member, &at, length) {
            sum += of_member::<Y::Parameter, S>(&chart, first, second);
        }
    }
    sum + product_of_bodies(network, first, second)
}

/// `φ₁ᵀ M φ₂ + φ₁ᵀ C φ₂/(λ₁ + λ₂)` of motions at two frequencies: the work of the forces of one on the other less the reverse, over the
/// difference of λ², and that of bodies.
pub(crate) fn mass_product_of_two<Y, S>(
    network: &Y,
    (x, first): (S, &NetworkMotion<Y, S>),
    (other_x, second): (S, &NetworkMotion<Y, S>),
) -> S
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    if x == other_x {
        return mass_product(network, x, first, second);
    }
    let mut work = S::zero();
    let ends = first.members.as_ref().iter().zip(second.members.as_ref()).take(network.sizes()[1]);
    for (one, other) in ends.flat_map(|(one, other)| one.iter().zip(other)) {
        for freedom in 0..3 {
            work += one.forces[freedom] * other.displacements[freedom];
            work -= other.forces[freedom] * one.displacements[freedom];
        }
    }
    work / (x.lambda_squared() - other_x.lambda_squared()) + product_of_bodies(network, first, second)
}

/// The mass form of bodies.
fn product_of_bodies<Y, S>(network: &Y, first: &NetworkMotion<Y, S>, second: &NetworkMotion<Y, S>) -> S
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    let nodes = first.nodes.as_ref().iter().zip(second.nodes.as_ref());
    let of_node =
        |(node, (first, second)): (usize, (&Six<S>, &Six<S>))| network.node(node).0.mass_form(*first, *second);
    nodes.enumerate().take(network.sizes()[0]).map(of_node).fold(S::zero(), |sum, form| sum + form)
}

/// The form of a member, given its chart with slopes.
fn of_member<T: Real, S: PlaneFrequency<T>>(
    chart: &Chart<S::WithSlope>,
    first: &[EndMotion<S>; 2],
    second: &[EndMotion<S>; 2],
) -> S {
    let (one, count) = values::<T, S>(chart, first);
    let (other, _) = values::<T, S>(chart, second);
    let mut sum = S::zero();
    for (row, one) in one[..count].iter().enumerate() {
        for (column, other) in other[..count].iter().enumerate() {
            sum += *one * S::slope(chart.entry(row, column)) * *other;
        }
    }
    sum
}

/// The variables of a member's chart in a motion, in the units of the chart, and their number.
fn values<T: Real, S: PlaneFrequency<T>>(
    chart: &Chart<S::WithSlope>,
    ends: &[EndMotion<S>; 2],
) -> ([S; MOST_VARIABLES], usize) {
    let mut values = [S::zero(); MOST_VARIABLES];
    let mut count = 0;
    for end in ends {
        for (freedom, kind) in Freedoms::SINGLE.into_iter().enumerate() {
            if !chart.freedoms.contains(kind) {
                continue;
            }
            let unit = chart.units.of(kind.is(Freedoms::RZ));
            values[count] = if chart.is_force(count) {
                end.forces[freedom].scaled(power_of_two(unit))
            } else {
                end.displacements[freedom].scaled(power_of_two(-unit))
            };
            count += 1;
        }
    }
    (values, count)
}
