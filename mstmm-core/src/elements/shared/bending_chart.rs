//! The chart of the bending of a beam.

use crate::elements::shared::chart_form::{Factors, Form};
use crate::number::{
    Frequency, FrequencyPowers, Parameter, Scalar, Scaled, Size, Truth, binary_exponent, series, twice,
};
use crate::structure::{Chart, Units, unit_of};
use core::f64::consts::FRAC_1_PI;

/// What the bending of a beam is made of: the wave number times the length, the stiffness, and the length.
#[derive(Clone, Copy, Debug)]
pub struct BendingWaves<S> {
    /// `z⁴ = -mλ²l⁴/EI` and z.
    pub(crate) z_fourth: S,
    pub(crate) z: S,
    /// `EI/l³`.
    pub(crate) stiffness: S,
    pub(crate) length: S,
}

/// `A, B, F, D, S, T, V` of a beam: its entire functions, all divided by `2^exponent`.
struct BendingFunctions<S> {
    a: S,
    b: S,
    f: S,
    d: S,
    s: S,
    t: S,
    v: S,
    /// Whether `|sh sin| > |ch cos|`, where A is closer to its zeros than F.
    is_pinned: bool,
    exponent: i32,
}

/// `z⁴/ω² = ml⁴/EI` of a beam of a bending stiffness, a mass per length and a length.
#[inline(always)]
pub(crate) fn wave_fourth<T: Parameter, S: Frequency<T>>(stiffness_and_mass: [T; 2], length: S) -> S {
    let [ei, m] = stiffness_and_mass.map(S::from_parameter);
    let square = length * length;
    m / ei * square * square
}

impl<S: Scalar> BendingWaves<S> {
    /// The waves of a beam of a bending stiffness, a mass per length and a length, without what `build` has rounded.
    pub(crate) fn exact<T: Parameter>(at: &FrequencyPowers<S>, stiffness_and_mass: [T; 2], length: S) -> Self
    where
        S: Frequency<T>,
    {
        let fourth = wave_fourth(stiffness_and_mass, length);
        let z = at.powers[0] * fourth.sqrt().sqrt();
        BendingWaves {
            z_fourth: -at.lambda_squared * fourth,
            z,
            stiffness: S::from_parameter(stiffness_and_mass[0]) / (length * length * length),
            length,
        }
    }

    /// Enters deflections and rotations of both ends into a chart, at their places.
    pub(super) fn enter(&self, chart: &mut Chart<S>, places: [usize; 4]) {
        let factors = Factors::new(self.stiffness, self.length);
        self.form().enter(chart, places, [false, true, false, true], &factors);
    }

    fn bending_functions(&self) -> BendingFunctions<S> {
        let (z, x) = (self.z, self.z_fourth);
        let half = |number: S| number.times_power_of_two(-1);
        if !S::Size::of(1.0).is_below(x.size()).any() {
            let [c, b, f, d, _] = x.short_wave_products();
            let [s, t, v] = [0, 1, 3].map(|first| series(x, first, 4));
            let [b, f, d] = [b, f, d].map(half);
            return BendingFunctions { a: half(S::one() + c), b, f, d, s, t, v, is_pinned: false, exponent: 0 };
        }
        let waves = z.wave_functions();
        let [circular, hyperbolic] = waves.exponents;
        let (sin, cos) = (waves.sin.times_power_of_two(-hyperbolic), waves.cos.times_power_of_two(-hyperbolic));
        let (sh, ch) = (waves.sh.times_power_of_two(-circular), waves.ch.times_power_of_two(-circular));
        let (ch_cos, sh_sin) = (waves.ch * waves.cos, waves.sh * waves.sin);
        let (ch_sin, sh_cos) = (waves.ch * waves.sin, waves.sh * waves.cos);
        let first = S::one() / z;
        let second = first * first;
        let third = second * first;
        BendingFunctions {
            a: half(waves.one + ch_cos),
            b: half((ch_sin + sh_cos) * first),
            f: half(sh_sin * second),
            d: half((ch_sin - sh_cos) * third),
            s: half(ch + cos),
            t: half((sh + sin) * first),
            v: half((sh - sin) * third),
            is_pinned: ch_cos.size().is_below(sh_sin.size()).all(),
            exponent: circular.saturating_add(hyperbolic),
        }
    }

    /// The form of bending: over deflection and rotation of the input end and both forces of the other, or over both deflections
    /// and both moments. The first is divided by A, of the size of cos z, the second by F, of that of sin z.
    fn form(&self) -> Form<S, 4, 10> {
        let x = self.z_fourth;
        let BendingFunctions { a, b, f, d, s, t, v, is_pinned, exponent } = self.bending_functions();
        let (half_waves, is_odd) = (self.z.size() * S::Size::of(FRAC_1_PI)).whole();
        let (xb, xf, xd, xv) = (-(x * b), -(x * f), -(x * d), -(x * v));
        let (entries, forces, below, divisor) = if is_pinned {
            let rows = [xd, b, -d, xv, -t, xd, t, v, -b, -d];
            (rows, [false, true, false, true], half_waves, twice(f))
        } else {
            let rows = [xb, xf, xd, -s, -t, -d, xv, -s, -f, -b];
            (rows, [false, false, true, true], half_waves + S::Size::one_if(is_odd ^ a.is_negative()), a)
        };
        let inverse = S::one() / divisor;
        let product = if is_pinned { divisor * self.length * self.length } else { divisor };
        Form {
            entries: entries.map(|entry| entry * inverse),
            forces,
            product: Scaled::new(product, i64::from(exponent)),
            below: below + S::Size::of(-2.0),
        }
    }
}

/// The units of displacements and rotations of a beam: logarithms to base 2. The axial impedance is beyond all others where there is none.
///
/// The unit of a motion lies between the softest elastic impedance and that of the inertia, which measures a mechanism. A soft
/// rotation makes far ends soft in translation by the lever of a wave, and the other way round.
pub(crate) fn beam_units<T: Parameter, S: Scalar>(
    waves: &BendingWaves<S>,
    [length, bending_stiffness, mass_per_length]: [T; 3],
    axial: f64,
    lambda_squared: S,
) -> Units {
    let [l, ei, m] = [length, bending_stiffness, mass_per_length].map(T::to_f64);
    let z = waves.z.size().first();
    let wave = if z > 1.0 { z } else { 1.0 } / l;
    let impedances = Impedances {
        wave,
        translation: (ei * wave * wave * wave).min(axial),
        rotation: ei * wave,
        mass: m * l,
        inertia: m * l * l * l,
    };
    units_of_waves(&impedances, lambda_squared)
}

/// What the units of a beam are found from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Impedances {
    /// The wave number, at least that of the length.
    pub(crate) wave: f64,
    /// The softest stiffnesses of a wave against displacement and against rotation.
    pub(crate) translation: f64,
    pub(crate) rotation: f64,
    /// The inertias of the whole beam.
    pub(crate) mass: f64,
    pub(crate) inertia: f64,
}

/// The units of displacements and rotations: logarithms to base 2.
pub(crate) fn units_of_waves<S: Scalar>(impedances: &Impedances, lambda_squared: S) -> Units {
    let Impedances { wave, translation, rotation, mass, inertia } = *impedances;
    let square = lambda_squared.size().first();
    // an inertia that is rounding beside an elastic impedance lowers no unit: a stiffness in its unit would lose half of the bits between both
    let slightest = -binary_exponent(S::EPSILON);
    let between = |impedance: f64, inertia: f64| {
        let own = binary_exponent(impedance);
        if inertia > 0.0 { (own + binary_exponent(inertia).clamp(own - slightest, own)).div_euclid(2) } else { own }
    };
    let translation = between(translation, mass * square);
    let rotation = between(rotation, inertia * square);
    let lever = binary_exponent(wave);
    let translation = translation.min(rotation + 2 * lever);
    let rotation = rotation.min(translation - 2 * lever);
    Units { displacement: unit_of(translation), rotation: unit_of(rotation) }
}
