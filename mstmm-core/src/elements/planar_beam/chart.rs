//! The chart of a beam in planar motion: that of its bending and that of its longitudinal vibration.

use crate::element::Charted;
use crate::elements::planar_beam::{BuiltPlanarBeam, PlanarBeam};
use crate::number::{
    Frequency, FrequencyPowers, Parameter, Scalar, Scaled, Size, Truth, binary_exponent, series, twice,
};
use crate::subspace::{Chart, MOST_VARIABLES, Units, unit_of};
use core::f64::consts::FRAC_1_PI;
use mstmm_plan::Freedoms;

/// Places of the variables of bending and of longitudinal vibration among those of the member.
const BENDING: [usize; 4] = [1, 2, 4, 5];
const LONGITUDINAL: [usize; 2] = [0, 3];

/// What a chart is made of: wave numbers times the length, stiffnesses, and the length.
struct Waves<S> {
    /// `z⁴ = -mλ²l⁴/EI` and z.
    z_fourth: S,
    z: S,
    /// `ζ² = -mλ²l²/EA` and ζ.
    zeta_squared: S,
    zeta: S,
    /// `EI/l³` and `EA/l`.
    bending: S,
    longitudinal: S,
    length: S,
}

impl<T: Parameter> BuiltPlanarBeam<T> {
    /// The waves at a frequency; in extended precision computed from the parameters anew, since `build` has rounded.
    fn waves<S: Frequency<T>>(&self, at: &FrequencyPowers<S>, length: S) -> Waves<S> {
        let PlanarBeam { axial_stiffness, bending_stiffness, mass_per_length, .. } = self.parameters;
        if !S::IS_EXTENDED {
            return Waves {
                z_fourth: -at.lambda_squared * self.wave_fourth,
                z: at.powers[0] * self.wave,
                zeta_squared: -at.lambda_squared * self.axial_wave_squared,
                zeta: at.powers[1] * self.axial_wave,
                bending: S::from_parameter(self.bending),
                longitudinal: S::from_parameter(self.longitudinal),
                length,
            };
        }
        let [ea, ei, m] = [axial_stiffness, bending_stiffness, mass_per_length].map(S::from_parameter);
        let square = length * length;
        let (fourth, second) = (m / ei * square * square, m / ea * square);
        Waves {
            z_fourth: -at.lambda_squared * fourth,
            z: at.powers[0] * fourth.sqrt().sqrt(),
            zeta_squared: -at.lambda_squared * second,
            zeta: at.powers[1] * second.sqrt(),
            bending: ei / (square * length),
            longitudinal: ea / length,
            length,
        }
    }

    /// The units of displacements and rotations, and the wave number: logarithms to base 2.
    ///
    /// The unit of a motion lies between the softest elastic impedance and that of the inertia, which measures a mechanism. A soft
    /// rotation makes far ends soft in translation by the lever of a wave, and the other way round.
    fn units<S: Scalar>(&self, waves: &Waves<S>, lambda_squared: S) -> (Units, i32) {
        let PlanarBeam { length, axial_stiffness, bending_stiffness, mass_per_length } = self.parameters;
        let [l, ea, ei, m] = [length, axial_stiffness, bending_stiffness, mass_per_length].map(T::to_f64);
        let least_one = |size: f64| if size > 1.0 { size } else { 1.0 };
        let wave = least_one(waves.z.size().first()) / l;
        let axial = ea * least_one(waves.zeta.size().first()) / l;
        let inertia = m * lambda_squared.size().first() * l;
        let between = |impedance: f64, inertia: f64| {
            let own = binary_exponent(impedance);
            if inertia > 0.0 { (own + own.min(binary_exponent(inertia))).div_euclid(2) } else { own }
        };
        let translation = between((ei * wave * wave * wave).min(axial), inertia);
        let rotation = between(ei * wave, inertia * l * l);
        let lever = binary_exponent(wave);
        let translation = translation.min(rotation + 2 * lever);
        let rotation = rotation.min(translation - 2 * lever);
        (Units { displacement: unit_of(translation), rotation: unit_of(rotation) }, lever)
    }
}

impl<T: Parameter, S: Frequency<T>> Charted<S> for PlanarBeam<T> {
    fn chart(built: &BuiltPlanarBeam<T>, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
        let waves = built.waves(at, length);
        let (units, wave) = built.units(&waves, at.lambda_squared);
        let mut chart = Chart {
            freedoms: Freedoms::ALL,
            entries: [[S::zero(); MOST_VARIABLES]; MOST_VARIABLES],
            forces: 0,
            units,
            wave: Some(wave),
            product: Scaled::new(S::one(), 0),
            below: S::Size::of(0.0),
        };
        let bending = waves.bending_form();
        let factors = Factors::new(waves.bending, waves.length);
        bending.enter(&mut chart, BENDING, |a, b| factors.of(a, b));
        let longitudinal = waves.longitudinal_form();
        let factors = Factors::new(waves.longitudinal, S::one());
        longitudinal.enter(&mut chart, LONGITUDINAL, |a, b| factors.of(a, b));
        chart
    }
}

/// A matrix over `N` variables in units in which the member has neither stiffness nor length.
struct Form<S: Scalar, const N: usize> {
    entries: [[S; N]; N],
    /// Whether each variable is a force.
    forces: [bool; N],
    product: Scaled<S>,
    below: S::Size,
}

/// The factors of entries: a row of a displacement has the root of the stiffness, that of a rotation also the length, and rows of
/// forces have the inverse.
struct Factors<S> {
    stiffness: [S; 3],
    lengths: [S; 5],
}

impl<S: Scalar> Factors<S> {
    fn new(stiffness: S, length: S) -> Self {
        let inverse = S::one() / length;
        Factors {
            stiffness: [S::one() / stiffness, S::one(), stiffness],
            lengths: [inverse * inverse, inverse, S::one(), length, length * length],
        }
    }

    /// The factor of an entry, given of both variables whether they are forces and whether they are rotations.
    fn of(&self, one: (bool, bool), other: (bool, bool)) -> S {
        let sign = |is_force: bool| if is_force { -1 } else { 1 };
        let power = |(is_force, is_rotation): (bool, bool)| if is_rotation { sign(is_force) } else { 0 };
        let stiffness = (sign(one.0) + sign(other.0)) / 2;
        self.stiffness[(1 + stiffness) as usize] * self.lengths[(2 + power(one) + power(other)) as usize]
    }
}

impl<S: Scalar, const N: usize> Form<S, N> {
    /// Enters the form into the chart of the member.
    fn enter(self, chart: &mut Chart<S>, places: [usize; N], factor: impl Fn((bool, bool), (bool, bool)) -> S) {
        let kind = |k: usize| (self.forces[k], matches!(places[k], 2 | 5));
        let shift = |k: usize| {
            let unit = chart.units.of(kind(k).1);
            if self.forces[k] { -unit } else { unit }
        };
        for row in 0..N {
            for column in row..N {
                let entry = self.entries[row][column] * factor(kind(row), kind(column));
                let entry = entry.times_power_of_two(shift(row) + shift(column));
                chart.entries[places[row]][places[column]] = entry;
                chart.entries[places[column]][places[row]] = entry;
            }
        }
        for (place, is_force) in places.into_iter().zip(self.forces) {
            chart.forces |= u32::from(is_force) << place;
        }
        chart.product = chart.product.product(self.product);
        chart.below = chart.below + self.below;
    }
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

impl<S: Scalar> Waves<S> {
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
    fn bending_form(&self) -> Form<S, 4> {
        let x = self.z_fourth;
        let BendingFunctions { a, b, f, d, s, t, v, is_pinned, exponent } = self.bending_functions();
        let (half_waves, is_odd) = (self.z.size() * S::Size::of(FRAC_1_PI)).whole();
        let (xb, xf, xd, xv) = (-(x * b), -(x * f), -(x * d), -(x * v));
        let (entries, forces, below, divisor) = if is_pinned {
            let rows = [[xd, b, xv, t], [b, -d, -t, v], [xv, -t, xd, -b], [t, v, -b, -d]];
            (rows, [false, true, false, true], half_waves, twice(f))
        } else {
            let rows = [[xb, xf, -s, xv], [xf, xd, -t, -s], [-s, -t, -d, -f], [xv, -s, -f, -b]];
            (rows, [false, false, true, true], half_waves + S::Size::one_if(is_odd ^ a.is_negative()), a)
        };
        let inverse = S::one() / divisor;
        let product = if is_pinned { divisor * self.length * self.length } else { divisor };
        Form {
            entries: entries.map(|row| row.map(|entry| entry * inverse)),
            forces,
            product: Scaled::new(product, i64::from(exponent)),
            below: below + S::Size::of(-2.0),
        }
    }

    /// The form of longitudinal vibration: over the displacement of the input end and the force at the other, divided by cos ζ, or over
    /// both displacements, divided by sin ζ.
    fn longitudinal_form(&self) -> Form<S, 2> {
        let x = self.zeta_squared;
        let is_short = !S::Size::of(1.0).is_below(x.size()).any();
        let (cos, sinc, one, exponent) = if is_short {
            (series(-x, 0, 2), series(-x, 1, 2), S::one(), 0)
        } else {
            let waves = self.zeta.wave_functions();
            let exponent = waves.exponents[0];
            (waves.cos, waves.sin / self.zeta, S::one().times_power_of_two(-exponent), exponent)
        };
        let is_mixed = is_short || !cos.size().is_below((sinc * self.zeta).size()).any();
        let half_waves = |shift: f64| {
            let number = self.zeta.size() * S::Size::of(FRAC_1_PI) + S::Size::of(shift);
            number.whole().0
        };
        let divisor = if is_mixed { cos } else { sinc };
        let (inverse, exponent) = (S::one() / divisor, i64::from(exponent));
        let (sinc, one) = (sinc * inverse, -(one * inverse));
        if is_mixed {
            let below = half_waves(0.5) + S::Size::of(-1.0);
            let entries = [[-(x * sinc), one], [one, -sinc]];
            return Form { entries, forces: [false, true], product: Scaled::new(divisor, exponent), below };
        }
        let cot = cos * inverse;
        let product = Scaled::new(divisor / self.longitudinal, exponent);
        Form { entries: [[cot, one], [one, cot]], forces: [false; 2], product, below: half_waves(0.0) }
    }
}
