//! The model of the README.

use mstmm::prelude::*;

system! {
    /// Cantilever with an eccentric tip body (section 4.1 of the paper).
    ///
    /// `length`, `centre`, `depth` [m], `ei` [N m²], `m` [kg/m], `mass` [kg], `inertia` about the mass centre [kg m²].
    #[derive(Debug)]
    pub struct TipBody { length: f64, ei: f64, m: f64, mass: f64, inertia: f64, centre: f64, depth: f64 }

    fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m }
          -> body 2 { mass, inertia, output_x: depth, centre_x: centre }
          -> free;
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (m, ei) = (0.212058, 33.8703);
    // the paper has one number for the mass per length, the mass and the inertia
    let model = TipBody { length: 1.0, ei, m, mass: m, inertia: m, centre: 0.4, depth: 0.8 };
    let system = model.build()?;
    for root in &system.frequencies(5)? {
        println!("{:.10} rad/s, in an interval {:.0e} rad/s wide", root.omega, root.upper - root.lower);
    }
    Ok(())
}
