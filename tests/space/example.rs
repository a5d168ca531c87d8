//! The examples in space, against what one knows without them.

#[expect(dead_code, unreachable_pub, reason = "an example of its own")]
#[path = "../../examples/crank.rs"]
mod crank;
#[expect(dead_code, unreachable_pub, reason = "an example of its own")]
#[path = "../../examples/space_portal.rs"]
mod space_portal;

use mstmm::prelude::*;
use space_portal::{SpacePortal, steel};

/// On a portal that does not give way the machine swings up and down, and about z, as on rigid ground.
#[test]
fn on_a_stiff_portal_the_machine_swings_alone() {
    let model = SpacePortal { e: 1e7 * steel().e, g: 1e7 * steel().g, ..steel() };
    let found = model.build().unwrap().first_frequencies::<6>().unwrap();
    for expected in model.on_rigid_ground() {
        let nearest = found.iter().map(|root| (root.omega / expected - 1.0).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-6, "{expected}: {nearest}");
    }
}

/// Under a force the machine goes down as the girder below it, and by what the bushing gives way.
#[test]
fn the_machine_goes_down_on_its_bushing() {
    let model = steel();
    let portal = model.build().unwrap();
    let load = SpacePortal::conn_machine.force_z();
    let [machine, girder] = [SpacePortal::conn_machine.displacement_z(), SpacePortal::conn_middle.displacement_z()]
        .map(|entry| portal.frequency_response(load, entry).unwrap().at(0.0).unwrap());
    assert!(((machine - girder) * model.along - 1.0).abs() < 1e-12, "{machine} {girder}");
}

/// At rest a force across the crank bends all of its parts, and twists the shaft and the arm.
#[test]
fn the_crank_gives_way_as_a_beam_that_bends_and_twists() {
    let model = crank::steel();
    let load = crank::Crank::conn_handle.force_y();
    let slow = Complex::new(0.0, 0.0);
    let moved = |model: crank::Crank| {
        let system = model.build().unwrap();
        system.frequency_response(load, crank::Crank::conn_handle.displacement_y()).unwrap().at(slow).unwrap().re
    };
    let (shaft, arm, pin) = (model.shaft, -model.arm_z, model.pin);
    let second_moment = std::f64::consts::PI * model.diameter.powi(4) / 64.0;
    let (bending, torsion) = (model.e * second_moment, 2.0 * model.g * second_moment);
    let bent = ((shaft + pin).powi(3) - pin.powi(3) + arm.powi(3) + pin.powi(3)) / 3.0;
    let twisted = arm * arm * shaft + pin * pin * arm;
    let expected = bent / bending + twisted / torsion;
    let own = moved(crank::Crank { loss: 0.0, ..model });
    assert!((own / expected - 1.0).abs() < 1e-13, "{own} {expected}");
}
