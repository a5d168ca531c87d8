//! A portal in space with a machine on a bushing: proven frequencies, how the machine and the roof move in each mode, and what the bushing alone
//! would do on rigid ground.

use mstmm::frame::{Bar, Frame, Hinge, Point, RigidBody, Section, Space, Structure, Tensor};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm_drawing::Drawing;
use std::error::Error;
use std::path::Path;

/// A portal of four columns with a ring of girders, one across that carries the machine, and two braces.
///
/// ```text
///          d ------- c
///         /   m     /|        z  y
///        a ---+--- b |        | /
///        |   |     | |        |/
///        |         |          +-- x
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SpacePortal {
    /// Distance of the columns along x, and along y [m]
    pub spans: [f64; 2],
    /// Height of the columns [m]
    pub height: f64,
    /// A factor of all stiffnesses of the portal
    pub stiffer: f64,
    /// Mass of the machine [kg]
    pub mass: f64,
    /// Its moments of inertia about x, y and z through its mass centre [kg m²]
    pub inertia: [f64; 3],
    /// Height of its mass centre above the bushing [m]
    pub above: f64,
    /// Stiffness of the bushing along x and y, and along z [N/m]
    pub stiffness: [f64; 2],
    /// Stiffness of the bushing about x and y, and about z [N m]
    pub rotational_stiffness: [f64; 2],
}

/// A portal of steel tubes with a machine of 180 kg.
pub fn steel() -> SpacePortal {
    SpacePortal {
        spans: [4.0, 2.6],
        height: 3.0,
        stiffer: 1.0,
        mass: 180.0,
        inertia: [9.0, 12.0, 10.0],
        above: 0.35,
        stiffness: [4e5, 9e5],
        rotational_stiffness: [3e4, 1.2e4],
    }
}

/// The portal, and what one asks about it.
#[derive(Debug)]
pub struct Portal {
    /// The portal, built
    pub structure: Structure<Space>,
    /// A corner of the roof
    pub corner: Point<Space>,
    /// The machine, where the bushing holds it
    pub machine: Point<Space>,
}

impl SpacePortal {
    /// The portal, built.
    ///
    /// # Errors
    /// A parameter out of its range.
    pub fn build(&self) -> Result<Portal, Box<dyn Error>> {
        let [x, y] = self.spans;
        let z = self.height;
        let tube = Section::new()
            .axial_stiffness(4e8 * self.stiffer)
            .torsional_stiffness(9e5 * self.stiffer)
            .bending_stiffness(1.2e6 * self.stiffer)
            .mass_per_length(16.0)
            .polar_inertia_per_length(0.09);
        let tie = Bar(Section::new()
            .axial_stiffness(8e7 * self.stiffer)
            .bending_stiffness(3e4 * self.stiffer)
            .mass_per_length(4.0));
        let mut frame = Frame::new();
        let corners = [[0.0, 0.0], [x, 0.0], [x, y], [0.0, y]];
        let feet = corners.map(|[x, y]| frame.point([x, y, 0.0]));
        let roof = corners.map(|[x, y]| frame.point([x, y, z]));
        let [front, middle, back, machine] =
            [[0.0, z], [0.5 * y, z], [y, z], [0.5 * y, z]].map(|[y, z]| frame.point([0.5 * x, y, z]));
        for (foot, head) in feet.into_iter().zip(roof) {
            frame.member(foot, head, tube);
        }
        for (foot, support) in feet.into_iter().zip([Support::Fixed, Support::Pinned, Support::Fixed, Support::Pinned])
        {
            frame.hold(foot, support);
        }
        let [a, b, c, d] = roof;
        for (from, to) in
            [(a, front), (front, b), (b, c), (c, back), (back, d), (d, a), (front, middle), (middle, back)]
        {
            frame.member(from, to, tube);
        }
        frame.member(feet[0], d, tie);
        frame.member(feet[1], c, tie);
        let ([across, along], [tilt, twist]) = (self.stiffness, self.rotational_stiffness);
        let bushing = Hinge::new().stiffness_x(across).stiffness_y(across).stiffness_z(along);
        let bushing = bushing.stiffness_rx(tilt).stiffness_ry(tilt).stiffness_rz(twist);
        frame.member(middle, machine, bushing);
        let inertia = Tensor::principal(self.inertia);
        let body = RigidBody { mass: self.mass, inertia, centre: [0.5 * x, 0.5 * y, z + self.above] };
        frame.body([machine], body);
        Ok(Portal { structure: frame.build()?, corner: a, machine })
    }

    /// The frequencies of the machine on the bushing alone, up and down and about z [rad/s].
    pub fn on_rigid_ground(&self) -> [f64; 2] {
        [(self.stiffness[1] / self.mass).sqrt(), (self.rotational_stiffness[1] / self.inertia[2]).sqrt()]
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = steel();
    let portal = model.build()?;
    let roots = portal.structure.frequencies(8)?;
    println!(
        "Natural frequencies, each proven, and displacements of a corner of the roof and of the machine, the largest of them 1"
    );
    println!(
        "mode  f [Hz]   ω [rad/s]           interval [rad/s]                            corner x, y, z         machine x, y, z"
    );
    for (mode, root) in roots.iter().enumerate() {
        let shape = portal.structure.mode_shape(root)?;
        let [corner, machine] = [shape.motion_of(portal.corner)?, shape.motion_of(portal.machine)?];
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
    let stiff = SpacePortal { stiffer: 1e6, ..model };
    let found = stiff.build()?.structure.frequencies(6)?;
    println!("\nOn a portal a million times as stiff, and on rigid ground [rad/s]");
    for ground in model.on_rigid_ground() {
        let distance = |omega: f64| (omega - ground).abs();
        let near = found.iter().map(|root| root.omega).min_by(|a, b| distance(*a).total_cmp(&distance(*b)));
        println!("{:12.6} {ground:12.6}", near.ok_or("no frequency")?);
    }
    draw(&portal.structure)
}

/// Draws the first modes in files whose names end with their numbers, given a file by `--svg`.
fn draw(structure: &Structure<Space>) -> Result<(), Box<dyn Error>> {
    let Some(file) = std::env::args().skip_while(|argument| argument != "--svg").nth(1) else { return Ok(()) };
    for (mode, root) in structure.frequencies(6)?.iter().enumerate() {
        let shape = structure.mode_shape(root)?;
        let stem = Path::new(&file).with_extension("");
        Drawing::of(structure)?.mode(&shape)?.write(format!("{}_{}.svg", stem.display(), mode + 1))?;
    }
    Ok(())
}
