//! Trusses at rest, whose bars have a pin at each end: across a bar nothing holds it but its neighbours, and stiffnesses cancel.
#![expect(clippy::unwrap_used, reason = "a truss that does not answer fails the test")]

use mstmm::motion::{MemberLabel, PlanePoint};
use mstmm::network::{Freedoms, InNetwork, Joint, Member, Network, Node, Section, UndampedMember};
use mstmm::prelude::*;

type Frame = Member<UndampedMember<f64>>;

/// The freedoms that a pin ties.
const PIN: Freedoms = Freedoms::X.union(Freedoms::Y);

/// Two panels on a pin and a roller, and the bars between the joints.
const JOINTS: [[f64; 2]; 5] = [[0.0, 0.0], [6.0, 0.0], [3.0, 4.0], [9.0, 4.0], [12.0, 0.0]];
const BARS: [[usize; 2]; 7] = [[0, 1], [1, 4], [2, 3], [0, 2], [2, 1], [1, 3], [3, 4]];

/// The nodes of the joints, then two for each bar.
fn nodes() -> Vec<Node<f64>> {
    let joints = JOINTS.iter().enumerate().map(|(joint, place)| match joint {
        0 => Node::at(*place).held(Freedoms::PLANE),
        4 => Node::at(*place).held(Freedoms::Y.union(Freedoms::RZ)),
        _ => Node::at(*place).held(Freedoms::RZ),
    });
    joints.chain(BARS.iter().flatten().map(|&joint| Node::at(JOINTS[joint]))).collect()
}

/// The axial forces of all bars under a force of 1 upwards on a joint.
fn forces(section: Section<f64>, loaded: usize) -> Vec<f64> {
    let nodes = nodes();
    let pin = || Joint::rigid(PIN);
    let with_pins = |(bar, [from, to]): (usize, &[usize; 2])| {
        let [input, output] = [0, 1].map(|end| JOINTS.len() + 2 * bar + end);
        [Frame::new(input, output, section), Frame::new(*from, input, pin()), Frame::new(output, *to, pin())]
    };
    let members: Vec<Frame> = BARS.iter().enumerate().flat_map(with_pins).collect();
    let truss = Network::new(&nodes, &members).unwrap();
    let force = |bar: usize| {
        let end = MemberLabel::<InNetwork, ()>::member(3 * bar).input();
        let response = truss.frequency_response(PlanePoint::node(loaded).force_y(), end.axial_force()).unwrap();
        response.at(0.0).unwrap()
    };
    (0..BARS.len()).map(force).collect()
}

/// Oracle: at each joint forces of bars, the load and reactions from moments are in balance, however bars bend.
#[test]
fn bars_between_pins_are_in_balance_at_rest() {
    for power in 0..40 {
        let bending_stiffness = 100.0 * 1.5_f64.powi(power);
        let section = Section { axial_stiffness: 2.1e9, bending_stiffness, mass_per_length: 78.5 };
        for (loaded, place) in JOINTS.iter().enumerate().take(4).skip(1) {
            let mut sums = [[0.0; 2]; 5];
            sums[loaded][1] += 1.0;
            sums[4][1] -= place[0] / 12.0;
            sums[0][1] -= 1.0 - place[0] / 12.0;
            for ([from, to], force) in BARS.iter().zip(forces(section, loaded)) {
                let [x, y] = [0, 1].map(|k| JOINTS[*to][k] - JOINTS[*from][k]);
                for (k, part) in [x, y].into_iter().enumerate() {
                    sums[*from][k] += force * part / x.hypot(y);
                    sums[*to][k] -= force * part / x.hypot(y);
                }
            }
            assert!(sums.iter().flatten().all(|sum| sum.abs() < 1e-14), "EI {bending_stiffness:e}: {sums:?}");
        }
    }
}
