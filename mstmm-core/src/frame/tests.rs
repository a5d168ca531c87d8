//! Structures in space by stiffnesses beside charts: both give one Δ and one count.

use crate::elements::{Spring, TorsionSpring};
use crate::frame::{Bar, Frame, Ground, Hinge, Pin, RigidBody, Roller, Section, Space, Tensor, Tie};
use crate::number::Scaled;
use crate::pass::characteristic::{System, counted_pass};
use crate::subspace::WittrickWilliams;
use mstmm_plan::{Freedoms, Support};
use std::vec;
use std::vec::Vec;

const STEEL: Section = Section::new()
    .axial_stiffness(4e6)
    .bending_stiffness_y(3e4)
    .bending_stiffness_z(1e4)
    .torsional_stiffness(2e4)
    .mass_per_length(20.0)
    .polar_inertia_per_length(0.5);

/// Compares counts, and Δ but for a constant, at frequencies between those of a structure, all at once and one by one.
fn compare(frame: &Frame<Space>, from: f64, factor: f64) {
    let structure = frame.build().unwrap();
    let omega: Vec<f64> = (0..30).map(|k| from * factor.powi(k)).collect();
    let (mut values, mut below) = (vec![0.0; omega.len()], vec![0.0; omega.len()]);
    structure.in_numbers().unwrap().evaluate(&omega, &mut values, &mut below);
    let mut ratio = None;
    for (k, &omega) in omega.iter().enumerate() {
        let (count, delta) = counted_pass(&structure, omega, WittrickWilliams::<f64>::default());
        assert_eq!(below[k] as u64, count.below(), "at {omega}");
        let (mut alone, mut count) = ([0.0], [0.0]);
        structure.in_numbers().unwrap().evaluate(&[omega], &mut alone, &mut count);
        assert_eq!(count[0], below[k]);
        let own = Scaled::new(values[k], 0).over(delta);
        let first: Scaled<f64> = *ratio.get_or_insert(own);
        let change = own.over(first).over_power(0) - 1.0;
        assert!(change.abs() < 1e-9, "Δ at {omega} changes by {change:e}");
    }
}

#[test]
fn a_ring_on_columns_has_one_count() {
    let mut frame = Frame::new();
    let plan = [[0.0, 0.0], [3.0, 0.2], [2.7, 2.0], [0.1, 2.2]];
    let feet = plan.map(|[x, y]| frame.point([x, y, 0.0]));
    let heads = plan.map(|[x, y]| frame.point([0.9 * x, 0.95 * y, 2.5]));
    for k in 0..4 {
        frame.hold(feet[k], if k == 0 { Support::Fixed.into() } else { crate::frame::Hold::from(Support::Pinned) });
        frame.member(feet[k], heads[k], STEEL.up([1.0, 0.0, 0.0]));
        frame.member(heads[k], heads[(k + 1) % 4], STEEL.bending_stiffness_z(2e4));
    }
    compare(&frame, 1.3, 1.13);
}

#[test]
fn joints_bodies_bars_and_rollers_have_one_count() {
    let mut frame = Frame::new();
    let [foot, knee, beyond, far] =
        [[0.0; 3], [1.0, 0.4, 2.0], [1.0, 0.4, 2.0], [3.0, 1.0, 2.2]].map(|place| frame.point(place));
    let [arm, ball, tip] = [[3.2, 1.0, 2.7], [3.0, 1.0, 2.2], [4.0, 0.0, 0.3]].map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    frame.hold(tip, Roller::normal([0.3, -0.2, 0.9]));
    frame.member(foot, knee, STEEL);
    frame.member(knee.along([0.2, 1.0, 0.1]), beyond.along([0.2, 1.0, 0.1]), Tie::revolute());
    frame.member(beyond, far.releasing(Freedoms::RY), STEEL);
    frame.member(far, ball, Pin);
    frame.member(ball, tip, STEEL);
    let tie = Section::new().axial_stiffness(1e5).bending_stiffness(30.0).mass_per_length(0.7);
    frame.member(foot, far, Bar(tie));
    let inertia = Tensor::new([0.3, 0.4, 0.5, 0.05, -0.02, 0.1]);
    frame.body([far, arm], RigidBody { mass: 12.0, inertia, centre: [3.1, 1.1, 2.4] });
    frame.member(arm.along([0.6, 0.0, 0.8]), Ground, Spring { stiffness: 3e3 });
    frame.member(arm.about([1.0, 1.0, 0.0]), Ground, TorsionSpring { stiffness: 40.0 });
    compare(&frame, 0.9, 1.12);
}

#[test]
fn a_mount_with_six_stiffnesses_has_one_count() {
    let mut frame = Frame::new();
    let [foot, one, two] = [[0.0; 3], [0.0, 1.0, 1.0], [0.0, 1.0, 1.0]].map(|place| frame.point(place));
    frame.hold(foot, Support::Fixed);
    frame.member(foot, one, STEEL);
    let mount = Hinge::new().stiffness_x(2e3).stiffness_y(4e3).stiffness_z(6e3);
    frame.member(one, two, mount.stiffness_rx(90.0).stiffness_ry(70.0).stiffness_rz(40.0));
    let inertia = Tensor::principal([1.0, 2.0, 2.5]);
    frame.body([two], RigidBody { mass: 30.0, inertia, centre: [0.1, 1.1, 1.3] });
    compare(&frame, 0.6, 1.13);
}
