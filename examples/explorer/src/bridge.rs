//! A footbridge with a tuned mass damper.

use crate::drawing::{Kind, stations};
use crate::model::Explored;
use crate::problem::Problem;
use crate::shown::Shown;
use crate::slider::Slider;
use core::f64::consts::PI;
use core::iter::once;
use mstmm::prelude::*;

/// Mass per length of the bridge [kg/m].
const M: f64 = 1500.0;
/// `sqrt(EI/m)` of the bridge [m²/s]: the first frequency over `(π/l)²`.
const PACE: f64 = 730.0;
/// Bending stiffness of the bridge [N m²].
const EI: f64 = M * PACE * PACE;

system! {
    /// A bridge on two supports with a mass on a spring and a dashpot below it, in air that damps its first mode a little.
    #[derive(Clone, Copy, Debug, Default)]
    pub struct Bridge {
        /// Span [m]
        pub span: f64,
        /// Where the damper hangs, as a part of the span
        pub place: f64,
        /// Mass of the damper [kg]
        pub mass: f64,
        /// Stiffness of its spring [N/m]
        pub stiffness: f64,
        /// Damping of its dashpot [N s/m]
        pub damping: f64,
        /// Damping ratio of the bridge alone in its first mode
        pub ratio: f64,
    }

    let air = 2.0 * ratio * M * PACE * (PI / span) * (PI / span);

    pinned -> beam 1 { length: place * span, bending_stiffness: EI, mass_per_length: M, external_damping: air }
           -> conn 2
           -> beam 3 { length: (1.0 - place) * span, bending_stiffness: EI, mass_per_length: M, external_damping: air }
           -> pinned;
    conn 2 <- spring 4 { stiffness, damping } <- mass 5 { mass } <- free;
}

system! {
    /// The same without any damping.
    #[derive(Clone, Copy, Debug)]
    pub struct Undamped { span: f64, place: f64, mass: f64, stiffness: f64 }

    pinned -> beam 1 { length: place * span, bending_stiffness: EI, mass_per_length: M }
           -> conn 2
           -> beam 3 { length: (1.0 - place) * span, bending_stiffness: EI, mass_per_length: M }
           -> pinned;
    conn 2 <- spring 4 { stiffness } <- mass 5 { mass } <- free;
}

/// How many natural frequencies are shown: the damper's, and the first two of the bridge.
const MODES: usize = 3;
/// How far eigenvalues are looked for, and how far they are pictured, in multiples of the first frequency of the bridge alone.
const SEARCHED: f64 = 4.5;
const PICTURED: f64 = 1.8;
/// Room for the eigenvalues that are shown.
const EIGENVALUES: usize = 8;

impl Bridge {
    /// The bridge without what damps it.
    pub fn undamped(&self) -> Undamped {
        let Bridge { span, place, mass, stiffness, .. } = *self;
        Undamped { span, place, mass, stiffness }
    }

    /// The first natural frequency of the bridge alone [rad/s].
    fn bare_frequency(&self) -> f64 {
        PACE * (PI / self.span) * (PI / self.span)
    }

    /// Motions that take more than 0.6 periods of the first mode to decay to a tenth, up to a multiple of its frequency; the second mode
    /// of the bridge alone is at 4.
    fn region(&self, multiple: f64) -> Region {
        let first = self.bare_frequency();
        Region { re: -0.6 * first..=0.02 * first, im: 0.0..=multiple * first }
    }

    /// Draws the bridge, and the damper below it.
    fn draw(&self, shown: &Shown) -> Result<(), Problem> {
        let Bridge { span, place, .. } = *self;
        let [joint, hanging] = [[place * span, 0.0], [place * span, -0.16 * span]];
        shown.draw(Kind::Beam, stations(place * span).map(|x| [x, 0.0]))?;
        shown.draw(Kind::Beam, stations((1.0 - place) * span).map(|x| [place * span + x, 0.0]))?;
        shown.draw(Kind::Spring, [joint, hanging])?;
        shown.draw(Kind::Dashpot, [joint, hanging])?;
        shown.draw(Kind::Mass, once(hanging))?;
        shown.draw(Kind::Pinned, once([0.0, 0.0]))?;
        shown.draw(Kind::Pinned, once([span, 0.0]))
    }

    /// Shows the shape of a root, of the points in the order in which they are drawn.
    fn show_shape(&self, system: &BridgeSystem, root: &Eigenvalue, shown: &Shown) -> Result<(), Problem> {
        let shape = system.mode_shape(root).ok().and_then(|shape| shape.with_unit_deflection());
        let Some(shape) = shape else { return shown.rests() };
        let moves = |y| shown.moved(Complex::default(), y);
        for x in stations(self.place * self.span) {
            moves(shape.along(Bridge::beam_1, x)?.y)?;
        }
        for x in stations((1.0 - self.place) * self.span) {
            moves(shape.along(Bridge::beam_3, x)?.y)?;
        }
        let [joint, hanging] = [Bridge::conn_2, Bridge::mass_5.input()].map(|point| shape.state(point).y);
        [joint, hanging, joint, hanging, hanging].into_iter().try_for_each(moves)?;
        moves(Complex::default())?;
        moves(Complex::default())
    }

    /// The response where the damper hangs, around the first resonance of the bridge alone.
    fn each_response(
        &self,
        system: &BridgeSystem,
        roots: &[Eigenvalue],
        mut show: impl FnMut(&[f64]) -> Result<(), Problem>,
    ) -> Result<(), Problem> {
        let response = system.frequency_response(Bridge::conn_2.force(), Bridge::conn_2.deflection())?;
        let first = self.bare_frequency();
        let curve = response.curve::<2048, _>(0.5 * first..=1.7 * first, roots, 1e-2)?;
        curve.iter().try_for_each(|sample| show(&[sample.omega, sample.value.re, sample.value.im]))
    }
}

impl Explored for Bridge {
    const NAME: &'static str = "Footbridge with a tuned mass damper";
    const ABOUT: &'static str = "A mass on a spring and a dashpot calms the first mode of a footbridge. \
        Tuned well, it splits one high peak into two low ones.";
    const RESPONSE: [&'static str; 2] =
        ["Deflection where the damper hangs, under a force there", "without the damper"];
    const SLIDERS: &'static [Slider<Self>] = &[
        Slider {
            label: "Damping of its dashpot",
            unit: ("N s/m", 1.0),
            range: [0.0, 6000.0],
            step: 10.0,
            start: 760.0,
            field: |bridge| &mut bridge.damping,
        },
        Slider {
            label: "Stiffness of its spring",
            unit: ("kN/m", 1e3),
            range: [10.0, 150.0],
            step: 0.2,
            start: 55.2,
            field: |bridge| &mut bridge.stiffness,
        },
        Slider {
            label: "Mass of the damper",
            unit: ("kg", 1.0),
            range: [20.0, 2000.0],
            step: 10.0,
            start: 360.0,
            field: |bridge| &mut bridge.mass,
        },
        Slider {
            label: "Where it hangs",
            unit: ("% of the span", 0.01),
            range: [5.0, 95.0],
            step: 0.5,
            start: 50.0,
            field: |bridge| &mut bridge.place,
        },
        Slider {
            label: "Span",
            unit: ("m", 1.0),
            range: [16.0, 36.0],
            step: 0.1,
            start: 24.0,
            field: |bridge| &mut bridge.span,
        },
        Slider {
            label: "Damping ratio of the bridge",
            unit: ("%", 0.01),
            range: [0.1, 3.0],
            step: 0.05,
            start: 0.5,
            field: |bridge| &mut bridge.ratio,
        },
    ];

    fn show_roots(&self, shown: &Shown) -> Result<(), Problem> {
        shown.take_eigenvalues(&self.build()?.eigenvalues::<EIGENVALUES>(self.region(SEARCHED))?)
    }

    fn show(&self, shown: &Shown) -> Result<(), Problem> {
        let system = self.build()?;
        let roots = system.eigenvalues::<EIGENVALUES>(self.region(SEARCHED))?;
        shown.take_eigenvalues(&roots)?;
        [SEARCHED, PICTURED].into_iter().try_for_each(|multiple| shown.take_region(&self.region(multiple)))?;
        shown.take_frequencies(&self.undamped().build()?.first_frequencies::<MODES>()?)?;
        self.draw(shown)?;
        roots.iter().try_for_each(|root| self.show_shape(&system, root, shown))?;
        Shown::take_poles(&shown.poles, roots.iter().map(|root| (root.lambda, root.multiplicity)))?;
        self.each_response(&system, &roots, |row| shown.response.push(row))?;

        let bare = Bridge { mass: 0.0, ..*self }.build()?;
        let poles = bare.eigenvalues::<EIGENVALUES>(self.region(SEARCHED))?;
        Shown::take_poles(&shown.bare_poles, poles.iter().map(|pole| (pole.lambda, pole.multiplicity)))?;
        self.each_response(&bare, &poles, |row| shown.bare.push(row))
    }
}
