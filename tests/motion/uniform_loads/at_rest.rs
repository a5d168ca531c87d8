//! Responses at rest in closed form.

use super::assert_close;
use mstmm::prelude::*;

/// Declares a beam of length 2 and EI = 3 between two supports, of a keyword with further parameters.
macro_rules! beams {
    ($($model:ident = $tip:ident, $keyword:ident, $root:ident { $($parameter:ident: $value:expr),* };)*) => {$(
        system! {
            struct $model { ei: f64 }
            $tip -> $keyword 1 { length: 1.0, bending_stiffness: ei, mass_per_length: 1.0 $(, $parameter: $value)* }
                 -> $keyword 3 { length: 1.0, bending_stiffness: ei, mass_per_length: 1.0 $(, $parameter: $value)* } -> $root
        }
    )*};
}
beams! {
    Cantilever = fixed, beam, free {};
    Simple = pinned, beam, pinned {};
    Clamped = fixed, beam, fixed {};
    Propped = fixed, beam, pinned {};
    Sheared = pinned, beam, pinned { shear_stiffness: 5.0 };
    Pulled = pinned, beam, pinned { axial_force: 30.0 };
    Taut = pinned, beam, pinned { axial_force: 1e7 };
    Pushed = pinned, beam, pinned { axial_force: -2.0 };
    Founded = pinned, beam, pinned { foundation_stiffness: 40.0 };
}

const EI: f64 = 3.0;
const L: f64 = 2.0;

/// The response at rest to a uniform load on both halves.
macro_rules! under_load {
    ($model:ident, $entry:expr) => {{
        let system = $model { ei: EI }.build().unwrap();
        [$model::beam_1.uniform_load(), $model::beam_3.uniform_load()]
            .map(|load| system.frequency_response(load, $entry).unwrap().at(0.0).unwrap())
            .iter()
            .sum::<f64>()
    }};
}

#[track_caller]
fn assert_share(actual: f64, expected: f64) {
    assert_close(actual / expected, 1.0, 1e-13);
}

/// Tables of beams: deflections, slopes, moments and forces under `q = 1`.
#[test]
fn beams_of_textbooks() {
    let (l2, l3, l4) = (L * L, L.powi(3), L.powi(4));
    let tip = Cantilever::beam_3.output();
    assert_share(under_load!(Cantilever, tip.deflection()), l4 / (8.0 * EI));
    assert_share(under_load!(Cantilever, tip.rotation()), l3 / (6.0 * EI));
    assert_share(under_load!(Cantilever, Cantilever::beam_1.input().moment()), l2 / 2.0);
    assert_share(under_load!(Cantilever, Cantilever::beam_1.input().shear()), -L);
    assert_close(under_load!(Cantilever, tip.shear()), 0.0, 1e-15);
    assert_share(under_load!(Simple, Simple::beam_1.output().deflection()), 5.0 * l4 / (384.0 * EI));
    assert_share(under_load!(Simple, Simple::beam_1.input().rotation()), l3 / (24.0 * EI));
    assert_share(under_load!(Simple, Simple::beam_3.output().rotation()), -l3 / (24.0 * EI));
    assert_share(under_load!(Simple, Simple::beam_1.output().moment()), -l2 / 8.0);
    assert_share(under_load!(Simple, Simple::beam_3.output().shear()), L / 2.0);
    assert_share(under_load!(Clamped, Clamped::beam_1.output().deflection()), l4 / (384.0 * EI));
    assert_share(under_load!(Clamped, Clamped::beam_1.input().moment()), l2 / 12.0);
    assert_share(under_load!(Clamped, Clamped::beam_1.output().moment()), -l2 / 24.0);
    assert_share(under_load!(Propped, Propped::beam_1.input().moment()), l2 / 8.0);
    assert_share(under_load!(Propped, Propped::beam_3.output().shear()), 3.0 * L / 8.0);
}

/// Shear adds `q l² f/8`; an axial force, by `u = l/2 √(N/EI)`, and a foundation, by `v = l/2 (k/4EI)^(1/4)`, change the deflection of the
/// middle as Timoshenko and Hetényi have it.
#[test]
fn beams_with_shear_force_and_foundation() {
    let simple = 5.0 * L.powi(4) / (384.0 * EI);
    let middle = under_load!(Sheared, Sheared::beam_1.output().deflection());
    assert_share(middle, simple + L * L * 0.2 / 8.0);
    let u = L / 2.0 * (30.0 / EI).sqrt();
    let pulled = L.powi(4) / (16.0 * EI * u.powi(4)) * (1.0 / u.cosh() - 1.0 + u * u / 2.0);
    assert_share(under_load!(Pulled, Pulled::beam_1.output().deflection()), pulled);
    let u = L / 2.0 * (2.0 / EI).sqrt();
    let pushed = L.powi(4) / (16.0 * EI * u.powi(4)) * (1.0 / u.cos() - 1.0 - u * u / 2.0);
    assert_close(under_load!(Pushed, Pushed::beam_1.output().deflection()) / pushed, 1.0, 1e-12);
    // a string but for the bending at its ends, l/2 √(N/EI) = 1826
    let taut = L * L / (8.0 * 1e7) * (1.0 - 8.0 * EI / (1e7 * L * L));
    assert_close(under_load!(Taut, Taut::beam_1.output().deflection()) / taut, 1.0, 1e-12);
    let v = L / 2.0 * (40.0 / (4.0 * EI)).powf(0.25);
    let founded = (1.0 - 2.0 * v.cos() * v.cosh() / ((2.0 * v).cos() + (2.0 * v).cosh())) / 40.0;
    assert_share(under_load!(Founded, Founded::beam_1.output().deflection()), founded);
}
