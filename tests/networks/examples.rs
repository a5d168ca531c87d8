//! What the examples of frames compute, against results that share nothing with it.

#[expect(dead_code, reason = "the example's main")]
#[path = "../../examples/double_beam.rs"]
pub mod double_beam;
#[expect(dead_code, reason = "the example's main")]
#[path = "../../examples/truss_bridge.rs"]
pub mod truss_bridge;

use crate::checks::check_frequencies;
use crate::sketches::first;
use crate::structure::{End, Freedoms, Node, Section, Structure};
use crate::support::example::{assert_close, printed, rows_of};
use double_beam::{DoubleBeam, Motion, of_one_beam};
use mstmm::prelude::*;
use std::f64::consts::PI;
use truss_bridge::{TrussBridge, method_of_joints};

/// The joints at both ends of a bar, and its cross section.
type Bar = ([usize; 2], f64);

/// The joints of the truss, and its bars in the order of the sketch.
fn bars(bridge: &TrussBridge) -> ([[f64; 2]; 7], [Bar; 11]) {
    let TrussBridge { panel, height, lower, upper, posts, webs, .. } = *bridge;
    let joints = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [0.5, 1.0], [1.5, 1.0], [2.5, 1.0]];
    let bars = [
        ([0, 1], lower),
        ([1, 2], lower),
        ([2, 3], lower),
        ([4, 5], upper),
        ([5, 6], upper),
        ([0, 4], posts),
        ([4, 1], webs),
        ([1, 5], webs),
        ([5, 2], webs),
        ([2, 6], webs),
        ([6, 3], posts),
    ];
    (joints.map(|[x, y]| [x * panel, y * height]), bars)
}

/// The truss with hinges at all ends of bars.
fn hinged(bridge: &TrussBridge) -> Structure {
    let (joints, bars) = bars(bridge);
    let mut structure = Structure::default();
    for (joint, place) in joints.into_iter().enumerate() {
        let node = Node::at(place).held(Freedoms::RZ);
        structure.node(match joint {
            0 => node.held(Freedoms::PIN),
            1 | 2 => node.body(bridge.deck, 0.0, place),
            3 => node.held(Freedoms::Y),
            _ => node,
        });
    }
    for (ends, area) in bars {
        let section = Section {
            axial_stiffness: bridge.modulus * area,
            bending_stiffness: bridge.modulus * area * bridge.gyration * bridge.gyration,
            mass_per_length: bridge.density * area,
        };
        let [from, to] = ends.map(|joint| End::from(joint).releasing(Freedoms::RZ));
        structure.beam(from, to, section);
    }
    structure
}

/// Oracle: counts of a stiffness matrix, with a hinge at every end.
#[test]
fn the_truss_has_the_frequencies_of_hinged_bars() {
    let bridge = truss_bridge::footbridge();
    let found = first(&bridge.build().unwrap());
    assert!(found.len() > 5);
    assert_eq!(check_frequencies(&hinged(&bridge), &found), 0);
}

/// Oracles: at each joint the forces of bars, the load and reactions from moments are in balance; the method of joints.
#[test]
fn forces_in_the_truss_balance_at_every_joint() {
    let steel = truss_bridge::footbridge();
    let skew = TrussBridge { panel: 3.7, height: 5.3, lower: 0.02, gyration: 0.03, ..steel };
    for bridge in [steel, skew, TrussBridge { webs: 1e-3, upper: 0.1, ..steel }] {
        let system = bridge.build().unwrap();
        let forces: Vec<f64> = system
            .sketch()
            .members()
            .filter(|member| member.kind == "Beam")
            .map(|bar| {
                let force = bar.ends[0].label.axial_force();
                -system.frequency_response(TrussBridge::conn_l1.force_y(), force).unwrap().at(0.0).unwrap()
            })
            .collect();
        for (force, expected) in forces.iter().zip(method_of_joints(&bridge)) {
            assert!((force - expected).abs() < 1e-14, "{force} is not {expected}");
        }
        let (joints, bars) = bars(&bridge);
        let mut sums = [[0.0; 2]; 7];
        (sums[0][1], sums[1][1], sums[3][1]) = (2.0 / 3.0, -1.0, 1.0 / 3.0);
        for (([from, to], _), force) in bars.iter().zip(&forces) {
            let [x, y] = [0, 1].map(|k| joints[*to][k] - joints[*from][k]);
            for (k, part) in [x, y].into_iter().enumerate() {
                sums[*from][k] += force * part / x.hypot(y);
                sums[*to][k] -= force * part / x.hypot(y);
            }
        }
        assert!(sums.iter().flatten().all(|sum| sum.abs() < 1e-14), "{sums:?}");
    }
}

/// `1 + 2k N/(m L) Σ 1/(ω_q² - ω²)` over all q that differ from ±n by a multiple of 2N, on springs at `jL/N`: zero where the beams move
/// apart in a shape that is `sin(πnj/N)` at the springs. Half waves of other q do not take part.
fn apart(model: &DoubleBeam, n: u32, omega: f64) -> f64 {
    let sum: f64 = (0..20_000)
        .flat_map(|turn| [8 * turn + n, 8 * turn + 8 - n])
        .map(|q| 1.0 / (of_one_beam(model, q).powi(2) - omega * omega))
        .sum();
    1.0 + 2.0 * model.stiffness * 4.0 / (model.m * model.length) * sum
}

/// Oracles: the beam alone, and the series above, which changes its sign within a part of 1e-12 of a frequency.
#[test]
fn double_beams_move_together_as_one_and_apart_as_a_series_says() {
    for stiffness in [1e2, 5e4, 1e6] {
        let model = DoubleBeam { stiffness, ..double_beam::steel() };
        let system = model.build().unwrap();
        let found = system.first_frequencies::<8>().unwrap();
        let (mut together, mut in_apart) = (Vec::new(), 0);
        for root in &found {
            match double_beam::motion(&system, root).unwrap() {
                Motion::Together => together.push(root),
                Motion::Both => {
                    assert_eq!(root.multiplicity, 2);
                    together.push(root);
                }
                Motion::Apart => {
                    let beside = |n: u32| [1.0 - 1e-12, 1.0 + 1e-12].map(|part| apart(&model, n, part * root.omega));
                    let is_root = |n: &u32| matches!(beside(*n), [below, above] if below * above < 0.0);
                    assert!([1, 2, 3].iter().any(is_root), "{stiffness}: {root:?} {:?}", [1, 2, 3].map(beside));
                    in_apart += 1;
                }
            }
        }
        assert!(together.len() >= 4 && in_apart >= 2, "{stiffness}: {found:?}");
        for (root, n) in together.into_iter().zip(1..) {
            assert_close(root.omega, (f64::from(n) * PI / 4.0).powi(2) * 2000.0_f64.sqrt(), 1e-14);
        }
    }
}

/// Oracle: the printed columns beside each other.
#[test]
#[ignore = "long: .ci/long"]
fn examples_of_frames_print_what_they_check() {
    let truss = printed("truss_bridge");
    let forces = rows_of(&truss, "bar  ");
    assert_eq!(forces.len(), 11);
    assert!(forces.iter().all(|row| row[0] == row[1] && row[2] < 1e-14), "{forces:?}");
    for row in rows_of(&truss, "bars  ") {
        assert!((row[0] - row[1]).abs() < 0.01 * row[0].abs() + 1e-3, "{row:?}");
    }
    let modes = rows_of(&printed("double_beam"), "half waves");
    assert!(modes.len() > 5);
    for row in modes.iter().filter(|row| row.len() == 5) {
        assert_close(row[1], row[3], 1e-12);
    }
}
