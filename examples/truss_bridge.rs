//! Truss bridge with pins in its joints: certified frequencies, its first shape, forces in the bars under a load at rest beside those of
//! the method of joints, and what a thinner bar moves.

use mstmm::motion::DrawnPoint;
use mstmm::prelude::*;
use mstmm_drawing::Drawing;
use std::error::Error;

system! {
    /// Warren truss of three panels on a pin and a roller, with a deck on its lower joints. Bars are tubes with pins at their ends, so that none
    /// is bent by the others.
    ///
    /// ```text
    ///        u1 ---- u2 ---- u3
    ///       /  \    /  \    /  \
    ///     l0 --- l1 ---- l2 --- l3
    /// ```
    #[derive(Clone, Copy, Debug)]
    pub struct TrussBridge {
        /// Length of a panel [m]
        pub panel: f64,
        /// Distance of the chords [m]
        pub height: f64,
        /// Cross section of the lower chord [m²]
        pub lower: f64,
        /// Cross section of the upper chord [m²]
        pub upper: f64,
        /// Cross section of the diagonals at both ends [m²]
        pub posts: f64,
        /// Cross section of the other diagonals [m²]
        pub webs: f64,
        /// Radius of gyration of all cross sections [m]
        pub gyration: f64,
        /// Modulus of elasticity [N/m²]
        pub modulus: f64,
        /// Density [kg/m³]
        pub density: f64,
        /// Mass of the deck at each inner lower joint [kg]
        pub deck: f64,
    }

    let half = 0.5 * panel;
    let square = gyration * gyration;
    section lower_chord { axial_stiffness: modulus * lower, bending_stiffness: modulus * lower * square, mass_per_length: density * lower }
    section upper_chord { axial_stiffness: modulus * upper, bending_stiffness: modulus * upper * square, mass_per_length: density * upper }
    section post { axial_stiffness: modulus * posts, bending_stiffness: modulus * posts * square, mass_per_length: density * posts }
    section web { axial_stiffness: modulus * webs, bending_stiffness: modulus * webs * square, mass_per_length: density * webs }

    pinned -> conn l0 at (0.0, 0.0);
    roller -> conn l3 at (3.0 * panel, 0.0);

    conn l0 -> bar l0l1 { ..lower_chord } -> conn l1 at (panel, 0.0)
            -> bar l1l2 { ..lower_chord } -> conn l2 at (2.0 * panel, 0.0)
            -> bar l2l3 { ..lower_chord } -> conn l3;

    conn u1 at (half, height) -> bar u1u2 { ..upper_chord } -> conn u2 at (panel + half, height)
                              -> bar u2u3 { ..upper_chord } -> conn u3 at (2.0 * panel + half, height);

    conn l0 -> bar l0u1 { ..post } -> conn u1 -> bar u1l1 { ..web } -> conn l1 -> bar l1u2 { ..web } -> conn u2;
    conn u2 -> bar u2l2 { ..web } -> conn l2 -> bar l2u3 { ..web } -> conn u3 -> bar u3l3 { ..post } -> conn l3;

    conn l1 -> point_mass 1 { mass: deck };
    conn l2 -> point_mass 2 { mass: deck };
}

/// A footbridge of steel, eighteen metres long and four metres high.
pub fn footbridge() -> TrussBridge {
    TrussBridge {
        panel: 6.0,
        height: 4.0,
        lower: 0.01,
        upper: 0.015,
        posts: 0.012,
        webs: 0.008,
        gyration: 0.08,
        modulus: 2.1e11,
        density: 7850.0,
        deck: 2e4,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let bridge = footbridge();
    let system = bridge.build()?;

    println!("Natural frequencies; ω lies in the certified interval, and none is left out");
    println!("mode  count   f [Hz]         ω [rad/s]                          interval [rad/s]");
    for (mode, root) in system.first_frequencies::<6>()?.iter().enumerate() {
        let (hertz, omega, often) = (root.hertz(), root.omega, root.multiplicity);
        println!("{:4} {often:6} {hertz:8.4} {omega:17.10} {:20.13} ..{:20.13}", mode + 1, root.lower, root.upper);
    }
    show_shape(&system)?;
    show_forces(&bridge, &system)?;
    show_thinner_bars(&bridge, &system)?;
    draw(&system)
}

/// The first mode with the largest displacement of 1, at the joints.
fn show_shape(system: &TrussBridgeSystem) -> Result<(), Box<dyn Error>> {
    let first = system.first_frequencies::<1>()?[0];
    let shape = system.mode_shape(&first)?;
    let moved = |point: DrawnPoint<TrussBridge, f64>| -> Result<_, Box<dyn Error>> {
        Ok((point, shape.value(point.label.displacement_x())?, shape.value(point.label.displacement_y())?))
    };
    let joints = system.sketch().points().filter(|point| point.name.to_string().starts_with("conn"));
    let joints: Vec<_> = joints.map(moved).collect::<Result<_, _>>()?;
    let parts = joints.iter().flat_map(|(_, u, v)| [*u, *v]);
    let most = parts.max_by(|one, other| one.abs().total_cmp(&other.abs())).ok_or("no joints")?;
    println!("\nFirst mode, {:.4} Hz, with a largest displacement of 1", first.hertz());
    println!("joint      x [m]   y [m]    along x    along y");
    for (point, u, v) in joints {
        let [x, y, _] = point.position;
        // a zero has no sign
        println!("{:8} {x:7} {y:7} {:10.6} {:10.6}", point.name.to_string(), u / most + 0.0, v / most + 0.0);
    }
    Ok(())
}

/// Axial forces in the bars under a load of 1 N downwards at the joint l1, at rest.
fn show_forces(bridge: &TrussBridge, system: &TrussBridgeSystem) -> Result<(), Box<dyn Error>> {
    println!("\nForces in bars under 1 N downwards at l1, tension positive");
    println!("bar                  found [N]   method of joints [N]   difference");
    let bars = system.sketch().members().filter(|member| member.kind == "Beam");
    for (bar, expected) in bars.zip(method_of_joints(bridge)) {
        let upwards = TrussBridge::conn_l1.force_y();
        let found = -system.frequency_response(upwards, bar.ends[0].label.axial_force())?.at(0.0)?;
        println!("{:18} {found:11.8} {expected:22.8} {:12.0e}", bar.name.to_string(), (found - expected).abs());
    }
    Ok(())
}

/// The axial forces of all bars, in the order of the sketch, joint by joint from both reactions.
pub fn method_of_joints(bridge: &TrussBridge) -> [f64; 11] {
    let half = 0.5 * bridge.panel;
    let bar = f64::hypot(half, bridge.height);
    let (cos, sin) = (half / bar, bridge.height / bar);
    // moments about the other support: a third of the span from the first
    let [first, last] = [2.0 / 3.0, 1.0 / 3.0];
    let (l0u1, u3l3) = (-first / sin, -last / sin);
    let (l0l1, l2l3) = (-l0u1 * cos, -u3l3 * cos);
    let (u1l1, l2u3) = (-l0u1, -u3l3);
    let (u1u2, u2u3) = ((l0u1 - u1l1) * cos, (u3l3 - l2u3) * cos);
    // upwards at l1 the load, at l2 nothing
    let (l1u2, u2l2) = (1.0 / sin - u1l1, -l2u3);
    let l1l2 = l0l1 + (u1l1 - l1u2) * cos;
    [l0l1, l1l2, l2l3, u1u2, u2u3, l0u1, u1l1, l1u2, u2l2, l2u3, u3l3]
}

/// The change of the first frequency where bars become thinner: as sensitivities say, and as a thinner bridge has it.
fn show_thinner_bars(bridge: &TrussBridge, system: &TrussBridgeSystem) -> Result<(), Box<dyn Error>> {
    let first = system.first_frequencies::<1>()?[0];
    let slopes = system.sensitivity(&first)?;
    println!("\nBars a hundredth thinner: change of the first frequency [%]");
    println!("bars        by slope    by search");
    let thinner = |section: f64| 0.99 * section;
    let bridges = [
        ("lower", bridge.lower, TrussBridge { lower: thinner(bridge.lower), ..*bridge }),
        ("upper", bridge.upper, TrussBridge { upper: thinner(bridge.upper), ..*bridge }),
        ("posts", bridge.posts, TrussBridge { posts: thinner(bridge.posts), ..*bridge }),
        ("webs", bridge.webs, TrussBridge { webs: thinner(bridge.webs), ..*bridge }),
    ];
    for (name, section, other) in bridges {
        let slope = slopes.get(name).ok_or("no such field")?;
        let omega = other.build()?.first_frequencies::<1>()?[0].omega;
        println!("{name:8} {:11.5} {:12.5}", -slope * section / first.omega, 100.0 * (omega / first.omega - 1.0));
    }
    Ok(())
}

/// With `-- --svg FILE`: a picture of the first mode.
fn draw(system: &TrussBridgeSystem) -> Result<(), Box<dyn Error>> {
    let Some(file) = std::env::args().skip_while(|argument| argument != "--svg").nth(1) else { return Ok(()) };
    let shape = system.mode_shape(&system.first_frequencies::<1>()?[0])?;
    Ok(Drawing::of(system)?.mode(&shape)?.write(file)?)
}
