//! The example of a portal in space, against what one knows without it.

#[expect(dead_code, unreachable_pub, reason = "an example of its own")]
#[path = "../../examples/space_portal.rs"]
mod space_portal;

use mstmm::motion::PlaneLoad;
use mstmm::prelude::*;
use space_portal::{SpacePortal, steel};

/// On a portal that does not give way the machine swings up and down, and about z, as on rigid ground.
#[test]
fn on_a_stiff_portal_the_machine_swings_alone() {
    let model = SpacePortal { stiffer: 1e7, ..steel() };
    let found = model.build().unwrap().structure.frequencies(6).unwrap();
    for expected in model.on_rigid_ground() {
        let nearest = found.iter().map(|root| (root.omega / expected - 1.0).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-6, "{expected}: {nearest}");
    }
}

/// Under its own weight the machine goes down by more than `m/k`, as it does on rigid ground, and by less than twice that.
#[test]
fn the_machine_goes_down_under_its_weight() {
    let model = steel();
    let portal = model.build().unwrap();
    let weight = PlaneLoad::self_weight_z();
    let moved = portal.structure.frequency_response(weight, portal.machine.displacement_z()).unwrap().at(0.0).unwrap();
    let alone = model.mass / model.stiffness[1];
    assert!((1.0..2.0).contains(&(moved.abs() / alone)), "{moved} and {alone}");
}
