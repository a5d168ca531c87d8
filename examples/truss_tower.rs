//! A guyed tower of bars: proven frequencies and where each mode moves. `-- --bays N` makes it higher, `-- --svg FILE` draws the first mode.

use mstmm::frame::{Bar, Frame, Point, PointMass, Section, Space, Structure, TautString, Tensor};
use mstmm::network::Support;
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, View};
use std::error::Error;
use std::time::Instant;

/// A square mast of bars, guyed at its height and at half of that by four ropes each, with an antenna on its top.
#[derive(Clone, Copy, Debug)]
pub struct TrussTower {
    /// Number of bays
    pub bays: usize,
    /// Height of a bay [m]
    pub bay: f64,
    /// Width of the mast [m]
    pub width: f64,
    /// Area of the legs [m²]
    pub legs: f64,
    /// Area of all other bars [m²]
    pub webs: f64,
    /// Second moment of area of a bar over its area squared
    pub slenderness: f64,
    /// Young's modulus [Pa]
    pub modulus: f64,
    /// Density [kg/m³]
    pub density: f64,
    /// Tension of the ropes [N]
    pub tension: f64,
    /// Axial stiffness of the ropes [N]
    pub rope_stiffness: f64,
    /// Mass per length of the ropes [kg/m]
    pub rope_mass: f64,
    /// Mass of the antenna at each corner of the top [kg]
    pub antenna: f64,
}

/// A mast of steel with twenty bays.
pub fn mast() -> TrussTower {
    TrussTower {
        bays: 20,
        bay: 1.0,
        width: 0.8,
        legs: 1.2e-3,
        webs: 4e-4,
        slenderness: 0.4,
        modulus: 2.1e11,
        density: 7850.0,
        tension: 2e4,
        rope_stiffness: 8e6,
        rope_mass: 0.9,
        antenna: 30.0,
    }
}

/// A built tower.
#[derive(Debug)]
pub struct Tower {
    /// The tower
    pub structure: Structure<Space>,
    /// A corner of its top
    pub top: Point<Space>,
}

impl TrussTower {
    /// The tower, built.
    ///
    /// # Errors
    /// A parameter out of its range.
    pub fn build(&self) -> Result<Tower, Box<dyn Error>> {
        let bar = |area: f64| {
            let section = Section::new().axial_stiffness(self.modulus * area).mass_per_length(self.density * area);
            Bar(section.bending_stiffness(self.modulus * self.slenderness * area * area))
        };
        let (leg, web) = (bar(self.legs), bar(self.webs));
        let corners = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(|corner| corner.map(|x| x * self.width));
        let mut frame = Frame::new();
        let mut level = corners.map(|[x, y]| frame.point([x, y, 0.0]));
        for foot in level {
            frame.hold(foot, Support::Pinned);
        }
        let rope = Section::new().tension(self.tension).axial_stiffness(self.rope_stiffness);
        let rope = TautString(rope.mass_per_length(self.rope_mass));
        let height = self.bay * self.bays as f64;
        for bay in 1..=self.bays {
            let z = self.bay * bay as f64;
            let next = corners.map(|[x, y]| frame.point([x, y, z]));
            for k in 0..4 {
                let beside = (k + 1) % 4;
                frame.member(level[k], next[k], leg);
                frame.member(next[k], next[beside], web);
                frame.member(level[k], next[beside], web);
            }
            frame.member(next[0], next[2], web);
            if bay == self.bays || bay == self.bays / 2 {
                for (k, corner) in next.into_iter().enumerate() {
                    let out = 1.0 + height / self.width;
                    let anchor = frame.point([corners[k][0] * out, corners[k][1] * out, 0.0]);
                    frame.hold(anchor, Support::Pinned);
                    frame.member(anchor, corner, rope);
                }
            }
            level = next;
        }
        for corner in level {
            frame.body([corner], PointMass { mass: self.antenna, inertia: Tensor::default() });
        }
        Ok(Tower { structure: frame.build()?, top: level[0] })
    }

    /// Number of its bars and ropes.
    pub fn members(&self) -> usize {
        13 * self.bays + 8
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let bays = argument("--bays").map_or(Ok(mast().bays), |bays| bays.parse())?;
    let model = TrussTower { bays, ..mast() };
    let Tower { structure: tower, top } = model.build()?;
    let start = Instant::now();
    let roots = tower.frequencies(10)?;
    println!("{} members, ten frequencies, each proven, in {:.2?}", model.members(), start.elapsed());
    println!(
        "mode count   f [Hz]         ω [rad/s]                          interval [rad/s]   top moves, of the largest motion"
    );
    for (mode, root) in roots.iter().enumerate() {
        let shape = tower.mode_shape(root)?;
        let mut largest = 0.0_f64;
        for point in tower.sketch().points() {
            largest = largest.max(size(&shape.motion_of(point.label)?));
        }
        let at_top = size(&shape.motion_of(top)?) / largest;
        let (hertz, omega) = (root.hertz(), root.omega);
        println!(
            "{:4} {:5} {hertz:8.4} {omega:17.10} {:20.13} ..{:20.13} {at_top:8.3}",
            mode + 1,
            root.multiplicity,
            root.lower,
            root.upper
        );
    }
    let Some(file) = argument("--svg") else { return Ok(()) };
    let shape = tower.mode_shape(&roots[0])?;
    Ok(Drawing::of(&tower)?.without_labels().view(View::of(30.0, 15.0))?.mode(&shape)?.write(file)?)
}

/// The size of a displacement.
fn size(motion: &[f64; 6]) -> f64 {
    motion[..3].iter().fold(0.0, |sum: f64, part| sum.hypot(*part))
}

/// What stands behind a word of the command.
fn argument(word: &str) -> Option<String> {
    std::env::args().skip_while(|argument| argument != word).nth(1)
}
