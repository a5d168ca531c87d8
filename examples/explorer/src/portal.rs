//! A portal frame with a machine on its girder.

use crate::drawing::{Kind, stations};
use crate::model::Explored;
use crate::problem::Problem;
use crate::shown::Shown;
use crate::slider::Slider;
use core::iter::once;
use mstmm::Complex;
use mstmm::elements::{Beam, InPlane};
use mstmm::motion::MemberLabel;
use mstmm::prelude::*;

/// Axial stiffness of all beams [N].
const EA: f64 = 4e8;
/// Bending stiffness of the girder [N m²].
const EI: f64 = 1e6;
/// Mass per length of all beams [kg/m].
const M: f64 = 20.0;

system! {
    /// A portal with clamped feet and a machine on its girder.
    #[derive(Clone, Copy, Debug, Default)]
    pub struct Portal {
        /// Height of the columns [m]
        pub height: f64,
        /// Distance of the columns [m]
        pub span: f64,
        /// Where the machine stands, as a part of the span
        pub place: f64,
        /// Mass of the machine [kg]
        pub machine: f64,
        /// Bending stiffness of the columns, as a multiple of the girder's
        pub columns: f64,
    }

    fixed at (0.0, 0.0)
        -> beam 1 { axial_stiffness: EA, bending_stiffness: columns * EI, mass_per_length: M } -> conn b at (0.0, height)
        -> beam 2 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } -> conn machine at (place * span, height)
        -> beam 3 { axial_stiffness: EA, bending_stiffness: EI, mass_per_length: M } -> conn c at (span, height)
        -> beam 4 { axial_stiffness: EA, bending_stiffness: columns * EI, mass_per_length: M } -> fixed at (span, 0.0);
    conn machine -> point_mass 5 { mass: machine };
}

/// How many roots are shown.
const MODES: usize = 5;

/// In how many pieces the response is drawn between two roots at least, and how many more there are for all the range.
const PIECES: [f64; 2] = [6.0, 30.0];

/// The beams with both ends, in the order of the path.
type Beams = [(MemberLabel<Portal, InPlane<Beam<f64>>>, [[f64; 2]; 2]); 4];

impl Portal {
    fn beams(&self) -> Beams {
        let Portal { height, span, place, .. } = *self;
        let points = [[0.0, 0.0], [0.0, height], [place * span, height], [span, height], [span, 0.0]];
        let labels = [Portal::beam_1, Portal::beam_2, Portal::beam_3, Portal::beam_4];
        core::array::from_fn(|k| (labels[k], [points[k], points[k + 1]]))
    }

    fn draw(&self, shown: &Shown) -> Result<(), Problem> {
        let Portal { height, span, place, .. } = *self;
        for (_, [[x, y], [to_x, to_y]]) in self.beams() {
            shown.draw(Kind::Beam, stations(1.0).map(|part| [x + part * (to_x - x), y + part * (to_y - y)]))?;
        }
        shown.draw(Kind::Mass, once([place * span, height]))?;
        shown.draw(Kind::Fixed, once([0.0, 0.0]))?;
        shown.draw(Kind::Fixed, once([span, 0.0]))
    }

    /// Shows the shape of a root, of the points in the order in which they are drawn.
    fn show_shape(&self, system: &PortalSystem, root: &NaturalFrequency, shown: &Shown) -> Result<(), Problem> {
        let shape = system.mode_shape(root).ok().and_then(|shape| shape.with_unit_deflection());
        let Some(shape) = shape else { return shown.rests() };
        for (label, [[x, y], [to_x, to_y]]) in self.beams() {
            // one of both is zero
            for distance in stations((to_x - x).abs() + (to_y - y).abs()) {
                let state = shape.along(label, distance)?;
                shown.moved(state.displacement_x.into(), state.displacement_y.into())?;
            }
        }
        let machine = Portal::conn_machine;
        shown.moved(shape.value(machine.displacement_x())?.into(), shape.value(machine.displacement_y())?.into())?;
        (0..2).try_for_each(|_| shown.moved(Complex::default(), Complex::default()))
    }

    /// The response at the machine from rest to a little beyond the last root, but not to the next one, with samples that are denser near the roots,
    /// where it is infinite: while roots move, samples move with them.
    fn show_response(
        system: &PortalSystem,
        (roots, next): (&[NaturalFrequency], &[NaturalFrequency]),
        shown: &Shown,
    ) -> Result<(), Problem> {
        let pole = |root: &NaturalFrequency| (Complex::new(0.0, root.omega), root.multiplicity);
        Shown::take_poles(&shown.poles, roots.iter().chain(next).map(pole))?;
        let machine = Portal::conn_machine;
        let response = system.frequency_response(machine.force_y(), machine.displacement_y())?;
        let mut from = 0.0;
        let last = roots.last().map_or(0.0, |root| root.omega);
        let last = next.first().map_or(1.1 * last, |next| (1.1 * last).min(0.5 * (last + next.omega)));
        for to in roots.iter().map(|root| root.omega).chain(once(last)) {
            let pieces = (PIECES[0] + PIECES[1] * (to - from) / last) as u32;
            for k in 0..=pieces {
                let [near, far] = [f64::from(k), f64::from(pieces - k)].map(|steps| steps * steps);
                let omega = from + (to - from) * (near / (near + far));
                if let Ok(value) = response.at(omega) {
                    shown.response.push(&[omega, value, 0.0])?;
                }
            }
            from = to;
        }
        Ok(())
    }
}

impl Explored for Portal {
    const NAME: &'static str = "Portal frame with a machine";
    const ABOUT: &'static str = "With the machine in the middle, frequencies of symmetric and of antisymmetric modes cross while the span \
        changes. With the machine beside the middle they turn away from each other.";
    const RESPONSE: [&'static str; 2] = [
        "Vertical deflection of the machine under a force on it: infinite at natural frequencies, since nothing is damped",
        "",
    ];
    const SLIDERS: &'static [Slider<Self>] = &[
        Slider {
            label: "Span",
            unit: ("m", 1.0),
            range: [1.5, 8.0],
            step: 0.05,
            start: 4.0,
            field: |portal| &mut portal.span,
        },
        Slider {
            label: "Machine at",
            unit: ("% of the span", 0.01),
            range: [5.0, 95.0],
            step: 0.5,
            start: 44.0,
            field: |portal| &mut portal.place,
        },
        Slider {
            label: "Height",
            unit: ("m", 1.0),
            range: [1.5, 6.0],
            step: 0.05,
            start: 3.0,
            field: |portal| &mut portal.height,
        },
        Slider {
            label: "Mass of the machine",
            unit: ("kg", 1.0),
            range: [0.0, 1000.0],
            step: 5.0,
            start: 200.0,
            field: |portal| &mut portal.machine,
        },
        Slider {
            label: "Stiffness of columns",
            unit: ("× girder", 1.0),
            range: [0.1, 10.0],
            step: 0.05,
            start: 1.0,
            field: |portal| &mut portal.columns,
        },
    ];

    fn show_roots(&self, shown: &Shown) -> Result<(), Problem> {
        shown.take_frequencies(&self.build()?.first_frequencies::<MODES>()?)
    }

    fn show(&self, shown: &Shown) -> Result<(), Problem> {
        let system = self.build()?;
        // the page draws the response, which has one more pole in its range than the list has frequencies
        let roots = system.first_frequencies::<{ MODES + 1 }>()?;
        let (roots, next) = roots.split_at(MODES.min(roots.len()));
        shown.take_frequencies(roots)?;
        self.draw(shown)?;
        roots.iter().try_for_each(|root| self.show_shape(&system, root, shown))?;

        Portal::show_response(&system, (roots, next), shown)
    }
}
