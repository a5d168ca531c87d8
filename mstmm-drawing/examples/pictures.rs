//! Writes the pictures of the documents: the systems of the paper, the portal with its first mode, one in space, and diagrams of modes.

#[path = "../../examples/portal.rs"]
#[allow(dead_code, unreachable_pub, reason = "an example of its own")]
pub(crate) mod portal;

#[path = "../../examples/space_portal.rs"]
#[allow(dead_code, unreachable_pub, reason = "an example of its own")]
pub(crate) mod space_portal;

#[path = "../../examples/earthquake.rs"]
#[allow(dead_code, unreachable_pub, reason = "an example of its own")]
mod earthquake;

#[path = "../../examples/tolerances.rs"]
#[allow(dead_code, unreachable_pub, reason = "an example of its own")]
mod tolerances;

use mstmm::Complex;
use mstmm::prelude::*;
use mstmm::search::ToleranceBox;
use mstmm_drawing::{Drawing, Force, ModeDiagram};
use paper::models;
use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;

system! {
    /// The machine on a damped mount of the page on responses.
    struct Mount { k: f64, c: f64 }
    fixed -> spring 1 { stiffness: 9e6, damping: 2e3 } -> mass 2 { mass: 300.0 } -> conn floor -> spring 3 { stiffness: k, damping: c } -> mass 4 { mass: 20.0 } -> free;
}

/// The largest deflection of the floor under a force on the machine, on its curve.
fn peak() -> Result<ModeDiagram, Box<dyn Error>> {
    let model = Mount { k: 4e4, c: 60.0 }.build()?;
    let roots = model.first_eigenvalues::<2>()?;
    let response = model.frequency_response(Mount::mass_4.output().force(), Mount::conn_floor.deflection())?;
    let peak = response.peak(1.0..=300.0, &roots, 1e-6)?;
    let hertz = (1..=1200).map(|k| 0.01 * f64::from(k));
    let samples = hertz.map(|hertz| Ok([hertz, response.at(Complex::new(0.0, TAU * hertz))?.norm()]));
    Ok(ModeDiagram::peak(&samples.collect::<Result<Vec<_>, Box<dyn Error>>>()?, &peak)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/pictures");
    for (name, picture) in pictures()? {
        let path = folder.join(format!("{name}.svg"));
        std::fs::write(&path, picture)?;
        println!("docs/pictures/{name}.svg");
    }
    Ok(())
}

/// The names of the pictures, and what they show.
pub(crate) fn pictures() -> Result<Vec<(&'static str, String)>, Box<dyn Error>> {
    let system = portal::steel().build()?;
    let first = system.mode_shape(&system.first_frequencies::<1>()?[0])?;
    let load = portal::Portal::conn_b.force_x();
    let at_rest = system.frequency_response(load, portal::Portal::conn_b.displacement_x())?.states(0.0)?;
    let moments = Drawing::of(&system)?.forces(&at_rest, Force::Moment)?.load(load, 1.0)?.titled("Moments under 1 N");
    let tip_body = models::light_tip_body().build()?;
    let restrained_beam = models::restrained_beam().build()?;
    let spring_and_mass = models::spring_and_mass().build()?;
    let two_spans = models::two_spans().build()?;
    let damped_oscillator = models::damped_oscillator().build()?;
    let in_space = space_portal::steel().build()?;
    let third = in_space.mode_shape(&in_space.first_frequencies::<3>()?[2])?;
    let house = earthquake::house().build()?;
    let modes = house.first_frequencies::<{ earthquake::MODES }>()?;
    let masses = house.participation::<{ earthquake::MODES }, _>(&modes, Direction::x())?;
    let spectrum = (earthquake::code, earthquake::AT_ONCE);
    let lot = ToleranceBox::between(tolerances::portal(-1.0).build()?, tolerances::portal(1.0).build()?)?;
    let ranges = ModeDiagram::ranges(&lot.first_frequencies::<5>()?)?.marked(10.0, 20.0);
    Ok(vec![
        ("masses", ModeDiagram::masses(&modes, &masses)?.to_string()),
        ("spectrum", ModeDiagram::spectrum(&modes, &spectrum, 0.05)?.to_string()),
        ("ranges", ranges.to_string()),
        ("peak", peak()?.to_string()),
        ("portal", Drawing::of(&system)?.to_string()),
        ("portal_mode", Drawing::of(&system)?.mode(&first)?.to_string()),
        ("portal_moment", moments.to_string()),
        ("space_portal_mode", Drawing::of(&in_space)?.mode(&third)?.to_string()),
        ("tip_body", Drawing::of(&tip_body)?.to_string()),
        ("restrained_beam", Drawing::of(&restrained_beam)?.to_string()),
        ("spring_and_mass", Drawing::of(&spring_and_mass)?.to_string()),
        ("two_spans", Drawing::of(&two_spans)?.to_string()),
        ("damped_oscillator", Drawing::of(&damped_oscillator)?.to_string()),
    ])
}
