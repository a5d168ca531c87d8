//! Buildings of equal storeys, as lists whose size is known when the program runs: what their first ten frequencies cost.

use crate::clock::least_seconds;
use crate::error::ReportError;
use crate::growth::{OverElements, Point};
use mstmm::network::{Member, Network, Node, Section, Support, UndampedMember};
use mstmm::prelude::*;
use std::hint::black_box;

type Frame = Member<UndampedMember<f64>>;

/// Storeys of a bay, 6 m wide and 4 m high, of one steel tube, on clamped feet; one storey is the portal.
fn building(storeys: usize) -> (Vec<Node<f64>>, Vec<Frame>) {
    let section = Section { axial_stiffness: 1.26e9, bending_stiffness: 5.25e6, mass_per_length: 47.1 };
    let feet = [0.0, 6.0].map(|x| Node::at([x, 0.0]).held(Support::Fixed.holds()));
    let floors = (1..=storeys).flat_map(|storey| [0.0, 6.0].map(|x| Node::at([x, 4.0 * storey as f64])));
    // from below to the girder, and down again
    let members = (0..storeys).flat_map(|below| {
        let [left, right] = [2 * below, 2 * below + 1];
        [[left, left + 2], [left + 2, right + 2], [right + 2, right]].map(|[from, to]| Frame::new(from, to, section))
    });
    (feet.into_iter().chain(floors).collect(), members.collect())
}

/// Measures a building for each number of storeys.
pub(crate) fn over_storeys(storeys: &[usize]) -> Result<OverElements, ReportError> {
    let mut costs = OverElements::default();
    for &size in storeys {
        let (nodes, members) = building(size);
        let network = Network::new(&nodes, &members)?;
        let first = network.first_frequencies::<10>()?;
        // between two frequencies
        let omega = f64::midpoint(first[0].omega, first[1].omega);
        let seconds = least_seconds(|| network.count_below(black_box(omega)));
        costs.evaluation.push(Point { size, seconds });
        let seconds = least_seconds(|| black_box(&network).first_frequencies::<10>());
        costs.search.push(Point { size, seconds });
    }
    Ok(costs)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Oracle: the portal's frequencies by exact stiffnesses in forty digits.
    #[test]
    fn one_storey_is_the_portal() {
        let (nodes, members) = building(1);
        let network = Network::new(&nodes, &members).unwrap();
        let found = network.first_frequencies::<10>().unwrap();
        for (root, exact) in found.iter().zip(frames_beside::EXACT) {
            assert!((root.hertz() / exact - 1.0).abs() < 4e-15, "{} is not {exact}", root.hertz());
        }
    }
}
