//! An element as numbers, from which its dynamic stiffness follows at any frequency.

use crate::number::Parameter;
use mstmm_plan::Freedoms;

/// A parameter, exactly: the sum of two words. The second one is zero but of numbers with more digits than an `f64` has.
pub(crate) type Exact = [f64; 2];

/// The parameters of a line: of a rod, a string or a shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineNumbers {
    /// Length l.
    pub(crate) length: Exact,
    /// Stiffness H: tension, axial stiffness or torsional stiffness.
    pub(crate) stiffness: Exact,
    /// Inertia per length, and the stiffness of a foundation per length.
    pub(crate) inertia: Exact,
    pub(crate) foundation: Exact,
}

/// The parameters of a uniform beam, each zero where the beam has nothing of that kind.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BeamNumbers {
    pub(crate) length: Exact,
    /// Bending stiffness EI and mass per length m.
    pub(crate) bending_stiffness: Exact,
    pub(crate) mass_per_length: Exact,
    /// Axial stiffness EA; zero without longitudinal vibration.
    pub(crate) axial_stiffness: Exact,
    /// Shear stiffness kGA; zero without shear.
    pub(crate) shear_stiffness: Exact,
    pub(crate) rotary_inertia: Exact,
    /// Axial force, and the shear layer of the foundation, which acts as one in tension.
    pub(crate) axial_force: Exact,
    pub(crate) shear_layer: Exact,
    pub(crate) foundation_stiffness: Exact,
}

impl BeamNumbers {
    /// Whether it has no shear, no rotary inertia, no axial force and no foundation.
    pub(crate) fn is_plain(&self) -> bool {
        let others =
            [self.shear_stiffness, self.rotary_inertia, self.axial_force, self.shear_layer, self.foundation_stiffness];
        others.iter().all(|parameter| *parameter == [0.0; 2])
    }

    /// Whether it is sheared.
    pub(crate) fn shears(&self) -> bool {
        self.shear_stiffness != [0.0; 2]
    }

    /// Whether it has no shear, no rotary inertia, no axial force and no shear layer: its foundation acts as its mass does.
    pub(crate) fn bends_alone(&self) -> bool {
        BeamNumbers { foundation_stiffness: [0.0; 2], ..*self }.is_plain()
    }

    /// Its longitudinal vibration, if it has one.
    pub(crate) fn longitudinal(&self) -> Option<LineNumbers> {
        (self.axial_stiffness != [0.0; 2]).then_some(LineNumbers {
            length: self.length,
            stiffness: self.axial_stiffness,
            inertia: self.mass_per_length,
            foundation: [0.0; 2],
        })
    }
}

/// The parameters of a rigid body or link in a bending path.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyNumbers {
    pub(crate) mass: Exact,
    /// Moment of inertia about the input end, or about the mass centre.
    pub(crate) inertia: Exact,
    /// Whether it is about the mass centre.
    pub(crate) is_central: bool,
    /// Positions of the mass centre and of the output end.
    pub(crate) centre_x: Exact,
    pub(crate) output_x: Exact,
    /// Axial force between both ends.
    pub(crate) axial_force: Exact,
}

/// The parameters of a [tapered beam](crate::elements::TaperedBeam).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TaperedNumbers {
    pub(crate) length: Exact,
    pub(crate) bending_stiffness: Exact,
    pub(crate) mass_per_length: Exact,
    pub(crate) width_taper: Exact,
    pub(crate) height_taper: Exact,
    pub(crate) rotary_inertia: Exact,
    pub(crate) axial_force: Exact,
    /// Per length, towards the output end.
    pub(crate) axial_load: Exact,
    pub(crate) rotation_speed: Exact,
    pub(crate) hub_radius: Exact,
    pub(crate) setting_angle: Exact,
    pub(crate) foundation_stiffness: Exact,
}

/// What damps an element, each zero where it has nothing of that kind.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DampingNumbers {
    /// Loss factor η and time c of Kelvin and Voigt: the stiffness is multiplied by `(1 + iη)(1 + cλ)`.
    pub(crate) loss_factor: Exact,
    pub(crate) time: Exact,
    /// Viscous damping: of a spring C, which adds `Cλ` to its stiffness; of a medium around a member c_e, which adds `c_e λ` to its foundation.
    pub(crate) viscous: Exact,
    /// Cross stiffness and cross damping of a spring beside a rotor, which take `i (k_c + c_c λ)` from its stiffness.
    pub(crate) cross: [Exact; 2],
}

impl DampingNumbers {
    /// Whether nothing is damped.
    pub(crate) fn is_none(&self) -> bool {
        *self == DampingNumbers::default()
    }

    /// With cross terms.
    pub(crate) fn across(self, cross: [Exact; 2]) -> Self {
        DampingNumbers { cross, ..self }
    }
}

/// What spins about the axis of a line, as a whirl sees it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SpinNumbers {
    /// Polar moment of inertia, of a member per length.
    pub(crate) polar_inertia: Exact,
    /// Speed, positive in the sense of the whirl.
    pub(crate) speed: Exact,
}

impl SpinNumbers {
    /// What does not spin.
    pub(crate) const NONE: Self = SpinNumbers { polar_inertia: [0.0; 2], speed: [0.0; 2] };

    /// Whether nothing spins.
    pub(crate) fn is_none(&self) -> bool {
        *self == Self::NONE
    }
}

/// What an element is made of, as far as its dynamic stiffness follows from these numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum MemberNumbers {
    /// Something else.
    #[default]
    Other,
    /// A beam; between two places it is as long as these are apart.
    Beam(BeamNumbers),
    /// A beam that spins.
    SpinningBeam(BeamNumbers, SpinNumbers),
    /// A beam that spins with damping.
    DampedSpinningBeam(BeamNumbers, DampingNumbers, SpinNumbers),
    /// The gyroscopic moment between the rotations of both ends.
    Gyroscope(SpinNumbers),
    /// A point mass that spins.
    Disc(BodyNumbers, SpinNumbers),
    /// A tapered beam, which rotates or not.
    Tapered(TaperedNumbers),
    /// A line in the freedom of that index.
    Line(usize, LineNumbers),
    /// A line in the freedom of that index, as long as its places are apart.
    LineBetween(usize, LineNumbers),
    /// A string in the plane: the lines along it and across it. Between two places it is as long as these are apart.
    String([LineNumbers; 2]),
    /// A spring in the freedom of that index.
    Spring(usize, Exact),
    /// A joint, which ties freedoms rigidly or by springs; zero where there is none.
    Joint(Freedoms, [Exact; 3]),
    /// A rigid body, or a mass or an inertia alone.
    Body(BodyNumbers),
    /// A beam with damping.
    DampedBeam(BeamNumbers, DampingNumbers),
    /// A line with damping, in the freedom of that index.
    DampedLine(usize, LineNumbers, DampingNumbers),
    /// A line with damping in the freedom of that index, as long as its places are apart.
    DampedLineBetween(usize, LineNumbers, DampingNumbers),
    /// A string in the plane with damping.
    DampedString([LineNumbers; 2], DampingNumbers),
    /// A spring or a dashpot in the freedom of that index.
    DampedSpring(usize, Exact, DampingNumbers),
}

/// What an element that is no numbers is at a frequency, as far as it is known: no bound of its rounding is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OwnPart {
    /// The stiffness of its input end, that between both ends and that of its output end, and the number of its frequencies below with both ends
    /// held.
    Stiffness {
        /// The three stiffnesses.
        stiffness: [Exact; 3],
        /// The number of frequencies.
        held: f64,
    },
    /// Its output end moves so many times as far as its input end, against a stiffness.
    Tie {
        /// The ratio of both displacements.
        ratio: Exact,
        /// The stiffness against that of the input end.
        stiffness: Exact,
    },
}

impl MemberNumbers {
    /// A uniform line in the freedom of an index, 0 along the member or 2 about z, as long as its parameter says:
    /// `H y'' = (mλ² + k) y` with the length, H, m and k.
    pub fn uniform_line(freedom: usize, [length, stiffness, inertia, foundation]: [f64; 4]) -> Self {
        let [length, stiffness, inertia, foundation] = [length, stiffness, inertia, foundation].map(|x| [x, 0.0]);
        let numbers = LineNumbers { length, stiffness, inertia, foundation };
        if freedom < 3 { MemberNumbers::Line(freedom, numbers) } else { MemberNumbers::Other }
    }

    /// The bending stiffness of a beam, of a tapered one at its input end; zero of all else.
    pub(crate) fn bending_stiffness(&self) -> f64 {
        match self {
            MemberNumbers::Beam(beam)
            | MemberNumbers::SpinningBeam(beam, _)
            | MemberNumbers::DampedBeam(beam, _)
            | MemberNumbers::DampedSpinningBeam(beam, ..) => beam.bending_stiffness[0],
            MemberNumbers::Tapered(beam) => beam.bending_stiffness[0],
            _ => 0.0,
        }
    }

    /// A beam, and its spin if it has one.
    pub(crate) fn spun_beam(&self) -> Option<(&BeamNumbers, &SpinNumbers)> {
        match self {
            MemberNumbers::Beam(beam) => Some((beam, &SpinNumbers::NONE)),
            MemberNumbers::SpinningBeam(beam, spin) => Some((beam, spin)),
            _ => None,
        }
    }

    /// The element without its damping, and that.
    pub(crate) fn parted(&self) -> (MemberNumbers, DampingNumbers) {
        match *self {
            MemberNumbers::DampedBeam(beam, damping) => (MemberNumbers::Beam(beam), damping),
            MemberNumbers::DampedSpinningBeam(beam, damping, spin) => {
                (MemberNumbers::SpinningBeam(beam, spin), damping)
            }
            MemberNumbers::DampedLine(freedom, line, damping) => (MemberNumbers::Line(freedom, line), damping),
            MemberNumbers::DampedLineBetween(freedom, line, damping) => {
                (MemberNumbers::LineBetween(freedom, line), damping)
            }
            MemberNumbers::DampedString(lines, damping) => (MemberNumbers::String(lines), damping),
            MemberNumbers::DampedSpring(freedom, spring, damping) => (MemberNumbers::Spring(freedom, spring), damping),
            undamped => (undamped, DampingNumbers::default()),
        }
    }

    /// A line of a path as one between places, in a freedom of the member.
    pub(crate) fn between_places(self, freedom: usize) -> Self {
        match self {
            MemberNumbers::Line(_, line) => MemberNumbers::LineBetween(freedom, line),
            MemberNumbers::DampedLine(_, line, damping) => MemberNumbers::DampedLineBetween(freedom, line, damping),
            _ => MemberNumbers::Other,
        }
    }

    /// The element with an axial stiffness; of one that has none in these numbers nothing is known.
    pub(crate) fn stretching(self, axial_stiffness: Exact) -> Self {
        let lines =
            |across: LineNumbers| [LineNumbers { stiffness: axial_stiffness, foundation: [0.0; 2], ..across }, across];
        match self {
            MemberNumbers::Line(_, across) => MemberNumbers::String(lines(across)),
            MemberNumbers::DampedLine(_, across, damping) => MemberNumbers::DampedString(lines(across), damping),
            MemberNumbers::Beam(beam) => MemberNumbers::Beam(BeamNumbers { axial_stiffness, ..beam }),
            MemberNumbers::DampedBeam(beam, damping) => {
                MemberNumbers::DampedBeam(BeamNumbers { axial_stiffness, ..beam }, damping)
            }
            _ => MemberNumbers::Other,
        }
    }

    /// The element with damping; of one that has none in these numbers nothing is known.
    pub(crate) fn damped(self, damping: DampingNumbers) -> Self {
        match self {
            MemberNumbers::Beam(beam) => MemberNumbers::DampedBeam(beam, damping),
            MemberNumbers::Line(freedom, line) => MemberNumbers::DampedLine(freedom, line, damping),
            MemberNumbers::Spring(freedom, spring) => MemberNumbers::DampedSpring(freedom, spring, damping),
            _ => MemberNumbers::Other,
        }
    }

    /// A plain beam, as long as its parameter says, without longitudinal vibration.
    pub(crate) fn beam<T: Parameter>([length, bending_stiffness, mass_per_length]: [T; 3]) -> Self {
        MemberNumbers::Beam(BeamNumbers {
            length: length.words(),
            bending_stiffness: bending_stiffness.words(),
            mass_per_length: mass_per_length.words(),
            ..BeamNumbers::default()
        })
    }

    /// The rigid body under an axial force.
    pub(crate) fn under_axial_force(self, axial_force: Exact) -> Self {
        match self {
            MemberNumbers::Body(body) => MemberNumbers::Body(BodyNumbers { axial_force, ..body }),
            other => other,
        }
    }

    /// A point mass with its moment of inertia.
    pub(crate) fn mass<T: Parameter>([mass, inertia]: [T; 2]) -> Self {
        MemberNumbers::Body(BodyNumbers { mass: mass.words(), inertia: inertia.words(), ..BodyNumbers::default() })
    }
}
