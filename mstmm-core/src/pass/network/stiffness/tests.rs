//! Stiffnesses beside charts: both give one Δ and one count.

extern crate std;

use crate::elements::{Rod, Spring, TautString, TorsionSpring};
use crate::number::{DoubleDouble, Scaled};
use crate::pass::characteristic::{System, counted_pass};
use crate::pass::network::stiffness::{StiffnessBlock, StiffnessModel};
use crate::pass::network::{End, Member, Network, Node};
use crate::subspace::WittrickWilliams;
use crate::{Joint, Section, UndampedMember};
use core::f64::consts::PI;
use mstmm_plan::{Freedoms, Support};
use std::vec::Vec;

type Any = UndampedMember<f64>;

/// A network at some frequencies.
fn evaluated<'a>(
    model: &StiffnessModel<'_>,
    omega: &'a [f64],
    [value, below]: [&'a mut [f64; 16]; 2],
    in_lanes: bool,
) -> StiffnessBlock<'a> {
    let (value, below) = (&mut value[..omega.len()], &mut below[..omega.len()]);
    let mut block = StiffnessBlock { omega, value, below, unknown: 0, exponent: None };
    block.evaluate(model, in_lanes);
    block
}

/// Compares Δ, but for a constant, and counts at some frequencies.
fn compare(nodes: &[Node<f64>], members: &[Member<Any>], frequencies: &[f64]) {
    compare_in_blocks(nodes, members, frequencies, 16);
}

/// The same in blocks of so many frequencies, in lanes if there are several.
fn compare_in_blocks(nodes: &[Node<f64>], members: &[Member<Any>], frequencies: &[f64], size: usize) {
    let network = Network::new(nodes, members).unwrap();
    let (mut value, mut below) = ([0.0; 16], [0.0; 16]);
    let mut ratio = None;
    for omega in frequencies.chunks(size) {
        let block = evaluated(&network.in_numbers().unwrap(), omega, [&mut value, &mut below], size > 1);
        assert_eq!(block.unknown, 0, "{:b}", block.unknown);
        let exponent = block.exponent.unwrap();
        for (k, &omega) in omega.iter().enumerate() {
            let (count, delta) = counted_pass(&network, omega, WittrickWilliams::<f64>::default());
            assert_eq!(block.below[k] as u64, count.below(), "at {omega}");
            let own = Scaled::new(block.value[k], exponent).over(delta);
            let first: Scaled<f64> = *ratio.get_or_insert(own);
            let change = own.over(first).over_power(0) - 1.0;
            assert!(change.abs() < 1e-10, "Δ at {omega} changes by {change:e}");
        }
    }
}

/// Frequencies between those of a structure.
fn frequencies(from: f64, factor: f64, count: i32) -> Vec<f64> {
    (0..count).map(|k| from * factor.powi(k)).collect()
}

fn section() -> Section<f64> {
    Section { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 }
}

#[test]
fn a_portal() {
    let nodes = [
        Node::at([0.0, 0.0]).held(Support::Fixed.holds()),
        Node::at([0.0, 2.0]),
        Node::at([2.5, 2.0]),
        Node::at([2.0, 0.0]).held(Support::Pinned.holds()),
    ];
    let members = [[0, 1], [2, 1], [3, 2]].map(|[from, to]| Member::<Any>::new(from, to, section()));
    compare(&nodes, &members, &frequencies(0.5, 1.137, 80));
}

/// Products of three pivots are beyond the range where stiffnesses are this large or small.
#[test]
fn a_bend_in_extreme_units() {
    let nodes = [Node::at([0.0, 0.0]).held(Support::Fixed.holds()), Node::at([0.0, 2.0]), Node::at([2.5, 2.0])];
    for factor in [1e-120, 1e110] {
        let Section { axial_stiffness, bending_stiffness, mass_per_length } = section();
        let [axial_stiffness, bending_stiffness, mass_per_length] =
            [axial_stiffness, bending_stiffness, mass_per_length].map(|number| number * factor);
        let scaled = Section { axial_stiffness, bending_stiffness, mass_per_length };
        let members = [[0, 1], [2, 1]].map(|[from, to]| Member::<Any>::new(from, to, scaled));
        compare(&nodes, &members, &frequencies(0.5, 1.137, 80));
    }
}

#[test]
fn joints_bodies_and_lines() {
    let holds = Support::Fixed.holds();
    let nodes = [
        Node::at([0.0, 0.0]).held(holds),
        Node::at([0.0, 3.0]),
        Node::at([2.0, 3.0]).with_body(500.0, 40.0, [2.0, 3.4]),
        Node::at([4.0, 3.0]),
        Node::at([4.0, 3.0]),
        Node::at([4.0, 0.0]).held(Freedoms::RZ).along([1.0, 0.3]),
        Node::at([6.0, 1.0]),
        Node::at([6.0, 1.0]).held(Support::Pinned.holds()),
    ];
    let pin = Joint::rigid(Freedoms::X.union(Freedoms::Y));
    let offset = End::of(2).at([2.3, 2.9]);
    let string = TautString { length: 3.0, tension: 4e4, mass_per_length: 2.0, foundation_stiffness: 1e3 };
    let members: [Member<Any>; 10] = [
        Member::new(0, 1, section()),
        Member::new(1, offset, section()),
        Member::new(2, 3, section()),
        Member::new(3, 4, pin),
        Member::new(4, 5, section()),
        Member::new(1, 5, Spring { stiffness: 2e6 }),
        Member::new(4, 6, section()),
        Member::new(6, 7, pin),
        Member::new(6, 7, TorsionSpring { stiffness: 1e5 }),
        Member::new(1, 5, string).along([0.2, 1.0]),
    ];
    compare(&nodes, &members, &frequencies(0.7, 1.0917, 80));
}

/// A braced bay whose members leave rotations, a displacement along and one across to themselves, at nodes that move and at rest.
#[test]
fn members_that_do_not_share_all_freedoms() {
    let holds = Support::Fixed.holds();
    let nodes = [
        Node::at([0.0, 0.0]).held(holds),
        Node::at([0.0, 3.0]),
        Node::at([2.0, 3.0]).with_body(500.0, 40.0, [2.0, 3.4]),
        Node::at([4.0, 3.0]),
        Node::at([4.0, 0.0]).held(holds),
    ];
    let turning = |node: usize| End::of(node).releasing(Freedoms::RZ);
    let members: [Member<Any>; 7] = [
        Member::new(turning(0), 1, section()),
        Member::new(1, turning(2), section()),
        Member::new(2, End::of(3).releasing(Freedoms::X), section()),
        Member::new(End::of(3).releasing(Freedoms::Y), 4, section()),
        Member::new(turning(1), turning(3), section()),
        Member::new(turning(4), turning(1).at([0.0, 2.7]), section()),
        Member::new(End::of(4).releasing(Freedoms::Y.union(Freedoms::RZ)), 2, section()),
    ];
    compare(&nodes, &members, &frequencies(0.7, 1.0917, 80));
}

#[test]
fn members_between_points_at_rest_and_rings() {
    let holds = Support::Fixed.holds();
    let nodes = [
        Node::at([0.0, 0.0]).held(holds),
        Node::at([2.0, 0.5]).held(holds),
        Node::at([1.0, 2.0]),
        Node::at([3.0, 2.0]),
        Node::at([3.0, 4.0]),
        Node::at([1.0, 4.0]),
    ];
    let pairs = [[0, 1], [0, 2], [2, 3], [3, 4], [4, 5], [5, 2], [3, 5], [1, 3]];
    let members = pairs.map(|[from, to]| Member::<Any>::new(from, to, section()));
    compare(&nodes, &members, &frequencies(3.0, 1.0771, 80));
}

/// Of waves that have to be scaled Δ is beyond the range, by powers of two that change from one frequency to the next.
#[test]
fn waves_that_are_scaled() {
    let nodes = [
        Node::at([0.0, 0.0]).held(Support::Fixed.holds()),
        Node::at([30.0, 40.0]),
        Node::at([90.0, 40.0]).held(Support::Pinned.holds()),
    ];
    let members = [[0, 1], [1, 2]].map(|[from, to]| Member::<Any>::new(from, to, section()));
    compare_in_blocks(&nodes, &members, &frequencies(1e4, 1.713, 12), 1);
}

/// A point that a spring holds along itself alone has pivots that are zero: of several motions Δ becomes no number, of one it is zero.
#[test]
fn what_nothing_holds_is_not_known() {
    let on_a_spring = |end: Node<f64>| {
        let nodes = [Node::at([0.0, 0.0]).held(Support::Fixed.holds()), end];
        let members = [Member::<Any>::new(0, 1, Spring { stiffness: 3.0 })];
        let network = Network::new(&nodes, &members).unwrap();
        let numbers = [&mut [0.0; 16], &mut [0.0; 16]];
        evaluated(&network.in_numbers().unwrap(), &[1.0, 2.0], numbers, true).unknown
    };
    assert_eq!(on_a_spring(Node::at([2.0, 0.5])), 0b11);
    assert_eq!(on_a_spring(Node::at([2.0, 0.0]).held(Freedoms::RZ).along([0.0, 1.0])), 0b11);
    assert_eq!(on_a_spring(Node::at([2.0, 0.0]).held(Freedoms::RZ).along([1.0, 1.0])), 0);
}

/// The width of the front of beams between free points, if it has room; the points stand on a parabola, where no two beams lie in line.
fn width<const POINTS: usize, const BEAMS: usize>(pairs: impl Iterator<Item = [usize; 2]>) -> Option<usize> {
    let nodes: Vec<_> = (0..POINTS).map(|k| Node::at([k as f64, 0.1 * (k * k) as f64])).collect();
    let members: Vec<_> = pairs.map(|[from, to]| Member::<Any>::new(from, to, section())).collect();
    let network = Network::new(&nodes, &members).unwrap();
    network.in_numbers().map(|model| model.width)
}

/// A place in the front is taken again once a node has left: chains need room for two nodes, rings for three, and ties of all points for all.
#[test]
fn fronts_are_as_wide_as_what_is_in_them_at_once() {
    assert_eq!(width::<40, 39>((1..40).map(|k| [k - 1, k])), Some(6));
    assert_eq!(width::<40, 40>((0..40).map(|k| [k, (k + 1) % 40])), Some(9));
    let all = |points: usize| (0..points).flat_map(|k| (0..k).map(move |l| [l, k]));
    assert_eq!(width::<16, 120>(all(16)), Some(48));
    assert_eq!(width::<17, 136>(all(17)), None);
}

/// Rods whose lengths differ in the last digit have held frequencies so close that rounding of a wave number cannot tell on which side of one a
/// frequency is: the sign of the minor does.
#[test]
fn frequencies_of_held_rods_are_told_apart_by_the_signs_of_their_minors() {
    let held = Freedoms::Y.union(Freedoms::RZ);
    let nodes = [Node::at([0.0, 0.0]).held(Support::Fixed.holds()), Node::at([1.0, 0.0]).held(held)];
    let rod = |length: f64| Rod { length, axial_stiffness: 1.0, mass_per_length: 1.0, foundation_stiffness: 0.0 };
    let members: [Member<Any>; 5] =
        core::array::from_fn(|k| Member::new(0, 1, rod(1.0 + k as f64 * f64::EPSILON)).along([1.0, 0.0]));
    let network = Network::new(&nodes, &members).unwrap();
    let (mut value, mut below) = ([0.0; 16], [0.0; 16]);
    for halves in 1..20 {
        for ulps in -8..8 {
            let omega = [f64::from(halves) * PI * (1.0 + f64::from(ulps) * f64::EPSILON)];
            let block = evaluated(&network.in_numbers().unwrap(), &omega, [&mut value, &mut below], false);
            let count = block.below[0];
            assert_eq!(block.value[0] < 0.0, count % 2.0 == 1.0, "{halves} half waves, {ulps} last digits");
            // `build` has rounded the wave numbers
            let exact = [-2.0, 2.0].map(|ulps| {
                let beside = DoubleDouble::from(omega[0] * (1.0 + ulps * f64::EPSILON));
                counted_pass(&network, beside, WittrickWilliams::<f64>::default()).0.below() as f64
            });
            assert!(exact[0] <= count && count <= exact[1], "{halves} half waves, {ulps} last digits");
        }
    }
}

/// A ladder with rungs so many times as stiff as its legs.
fn ladder(bays: usize, stiffer: f64) -> (Vec<Node<f64>>, Vec<Member<Any>>) {
    let holds = Support::Fixed.holds();
    let place = |k: usize| [(k % 2) as f64 * 1.3 + 0.01 * k as f64, (k / 2) as f64];
    let node = |k: usize| if k < 2 { Node::at(place(k)).held(holds) } else { Node::at(place(k)) };
    let rung = Section { axial_stiffness: 4e8 * stiffer, bending_stiffness: 1e6 * stiffer, ..section() };
    let bay = |k: usize| {
        let legs = [0, 1].map(|side| Member::<Any>::new(2 * k + side, 2 * k + side + 2, section()));
        [legs[0], legs[1], Member::new(2 * k + 2, 2 * k + 3, rung)]
    };
    ((0..2 * bays + 2).map(node).collect(), (0..bays).flat_map(bay).collect())
}

/// What is not known at one frequency leaves nothing behind at the next one.
#[test]
fn a_frequency_beyond_the_range_leaves_the_next_one_as_it_is() {
    let (nodes, members) = ladder(3, 1.0);
    let network = Network::new(&nodes, &members).unwrap();
    let (mut value, mut below) = ([0.0; 16], [0.0; 16]);
    let block = evaluated(&network.in_numbers().unwrap(), &[500.0, 1e300, 500.0], [&mut value, &mut below], false);
    assert_eq!(block.unknown, 0b010);
    assert_eq!((block.value[2], block.below[2]), (block.value[0], block.below[0]));
}
