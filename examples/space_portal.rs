//! A portal in space with a machine on a bushing: proven frequencies, how the machine and the roof move in each mode, what the diameters of the tubes
//! do, and what the bushing alone would do on rigid ground.

use mstmm::prelude::*;
use mstmm::sections;
use mstmm_drawing::Drawing;
use std::error::Error;
use std::path::Path;

system! {
    /// A portal of four columns with a ring of girders, one across that carries the machine, and two braces.
    ///
    /// ```text
    ///          d --------- c
    ///         /    m      /|        z  y
    ///        a ----+---- b |        | /
    ///        |     |     | |        |/
    ///        |           |          +-- x
    /// ```
    #[derive(Clone, Copy, Debug)]
    pub struct SpacePortal {
        /// Distance of the columns along x [m]
        pub span: f64,
        /// Distance of the columns along y [m]
        pub depth: f64,
        /// Height of the columns [m]
        pub height: f64,
        /// Outer diameter of all tubes [m]
        pub outer: f64,
        /// Inner diameter of all tubes [m]
        pub inner: f64,
        /// Young's modulus [Pa]
        pub e: f64,
        /// Shear modulus [Pa]
        pub g: f64,
        /// Density [kg/m³]
        pub rho: f64,
        /// Mass of the machine [kg]
        pub mass: f64,
        /// Its moment of inertia about x through its mass centre [kg m²]
        pub inertia_x: f64,
        /// That about y [kg m²]
        pub inertia_y: f64,
        /// That about z [kg m²]
        pub inertia_z: f64,
        /// Height of its mass centre above the bushing [m]
        pub above: f64,
        /// Stiffness of the bushing along x and y [N/m]
        pub across: f64,
        /// Stiffness of the bushing along z [N/m]
        pub along: f64,
        /// Stiffness of the bushing about x and y [N m]
        pub tilt: f64,
        /// Stiffness of the bushing about z [N m]
        pub twist: f64,
    }

    let (area, i, _, j) = sections::tube(outer, inner);
    section tube {
        axial_stiffness: e * area, torsional_stiffness: g * j, bending_stiffness: e * i, mass_per_length: rho * area,
        polar_inertia_per_length: 2.0 * rho * i,
    }
    section tie { axial_stiffness: 4e-4 * e, bending_stiffness: 1.5e-7 * e, mass_per_length: 5e-4 * rho }

    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..tube } -> conn a at (0.0, 0.0, height);
    pinned at (span, 0.0, 0.0) -> beam 2 { ..tube } -> conn b at (span, 0.0, height);
    fixed at (span, depth, 0.0) -> beam 3 { ..tube } -> conn c at (span, depth, height);
    pinned at (0.0, depth, 0.0) -> beam 4 { ..tube } -> conn d at (0.0, depth, height);
    conn a -> beam 5 { ..tube } -> conn front at (0.5 * span, 0.0, height) -> beam 6 { ..tube } -> conn b -> beam 7 { ..tube } -> conn c
        -> beam 8 { ..tube } -> conn back at (0.5 * span, depth, height) -> beam 9 { ..tube } -> conn d -> beam 10 { ..tube } -> conn a;
    conn front -> beam 11 { ..tube } -> conn middle at (0.5 * span, 0.5 * depth, height) -> beam 12 { ..tube } -> conn back;
    pinned at (0.25, 0.0, 0.0) -> bar 13 { ..tie } -> conn d;
    pinned at (span - 0.25, 0.0, 0.0) -> bar 14 { ..tie } -> conn c;
    conn middle -> hinge 15 {
        stiffness_x: across, stiffness_y: across, stiffness_z: along, stiffness_rx: tilt, stiffness_ry: tilt, stiffness_rz: twist,
    } -> conn machine
        -> rigid_body 16 { mass, inertia: (inertia_x, inertia_y, inertia_z), centre: (0.5 * span, 0.5 * depth, height + above) };
}

/// A portal of steel tubes with a machine of 180 kg.
pub fn steel() -> SpacePortal {
    SpacePortal {
        span: 4.0,
        depth: 2.6,
        height: 3.0,
        outer: 0.12,
        inner: 0.11,
        e: 2.1e11,
        g: 8.1e10,
        rho: 7850.0,
        mass: 180.0,
        inertia_x: 9.0,
        inertia_y: 12.0,
        inertia_z: 10.0,
        above: 0.35,
        across: 4e5,
        along: 9e5,
        tilt: 3e4,
        twist: 1.2e4,
    }
}

impl SpacePortal {
    /// The frequencies of the machine on the bushing alone, up and down and about z [rad/s].
    pub fn on_rigid_ground(&self) -> [f64; 2] {
        [(self.along / self.mass).sqrt(), (self.twist / self.inertia_z).sqrt()]
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = steel();
    let portal = model.build()?;
    let roots = portal.first_frequencies::<8>()?;
    println!(
        "Natural frequencies, each proven; motions of a corner of the roof and of the machine, the largest of them 1"
    );
    println!(
        "mode  f [Hz]   ω [rad/s]           interval [rad/s]                            corner x, y, z         machine x, y, z"
    );
    for (mode, root) in roots.iter().enumerate() {
        let shape = portal.mode_shape(root)?;
        let [corner, machine] = [shape.motion_of(SpacePortal::conn_a)?, shape.motion_of(SpacePortal::conn_machine)?];
        let largest = corner[..3].iter().chain(&machine[..3]).fold(0.0, |most: f64, part| most.max(part.abs()));
        let written = |motion: [f64; 6]| [0, 1, 2].map(|k| format!("{:6.3}", motion[k] / largest + 0.0)).join(" ");
        println!(
            "{:4} {:8.4} {:16.10} {:18.13} ..{:18.13}  {}   {}",
            mode + 1,
            root.hertz(),
            root.omega,
            root.lower,
            root.upper,
            written(corner),
            written(machine)
        );
    }
    println!("\nRelative change of the first frequency per relative change of some fields");
    let slopes = portal.sensitivity(&roots[0])?;
    let fields = [("outer", model.outer), ("inner", model.inner), ("height", model.height), ("mass", model.mass)];
    for (name, value) in fields {
        let slope = slopes.get(name).ok_or(name)?;
        println!("{name:8} {:9.5}", slope * value / roots[0].omega);
    }
    let found = SpacePortal { e: 1e6 * model.e, g: 1e6 * model.g, ..model }.build()?.first_frequencies::<6>()?;
    println!("\nOn a portal a million times as stiff, and on rigid ground [rad/s]");
    for ground in model.on_rigid_ground() {
        let distance = |omega: f64| (omega - ground).abs();
        let near = found.iter().map(|root| root.omega).min_by(|a, b| distance(*a).total_cmp(&distance(*b)));
        println!("{:12.6} {ground:12.6}", near.ok_or("no frequency")?);
    }
    draw(&portal)
}

/// Draws the first modes in files whose names end with their numbers, given a file by `--svg`.
fn draw(portal: &SpacePortalSystem) -> Result<(), Box<dyn Error>> {
    let Some(file) = std::env::args().skip_while(|argument| argument != "--svg").nth(1) else { return Ok(()) };
    for (mode, root) in portal.first_frequencies::<6>()?.iter().enumerate() {
        let shape = portal.mode_shape(root)?;
        let stem = Path::new(&file).with_extension("");
        Drawing::of(portal)?.mode(&shape)?.write(format!("{}_{}.svg", stem.display(), mode + 1))?;
    }
    Ok(())
}
