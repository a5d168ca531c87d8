//! A piece of a band: the box about it, and both sides of the ratio as polynomials on it.

use crate::model::{MotionError, PeakError};
use crate::number::{List, Scalar, modulus};
use crate::search::damped::found::Region;
use crate::search::damped::peak::function::{
    Coefficients, MOST_POLES, Pole, ROOM, Side, extremum, node, part_of, product_at, series_at, series_through,
};
use crate::search::damped::peak::source::Source;
use num_complex::Complex;

/// The sum of the half axes of the ellipse, in half lengths of the piece. A larger one takes fewer values and holds more poles.
const ELLIPSE: f64 = 3.0;
/// Size of the box, in sizes of the ellipse. So no pole that is not divided out is nearer to the ellipse than 0.2 half lengths.
const MARGIN: f64 = 1.15;
/// Number of values on the ellipse. They are up to 0.6 half lengths apart.
const RIM: usize = 16;
/// Factor on the largest of them: a double pole at the edge of the box is 0.2 from the ellipse and 0.36 from the nearest value, and makes the largest 3.2 times as
/// large.
const SAFETY: f64 = 4.0;
/// Bound of how much interpolation beside the zeros of a Chebyshev polynomial enlarges errors: at these `1 + (2/π) ln 48`, and beside them a ninth more.
const LEBESGUE: f64 = 3.9;
/// Steps by which a polynomial through values beside the zeros is found from those through the zeros. Each leaves a tenth, or far less.
const STEPS: usize = 4;
/// Places of the extrema between which polynomials are looked at, as parts of their number.
const CHECKED: [f64; 2] = [0.3, 0.8];
/// Factor on `M r^-d/(r - 1)` of what the series cut at d leaves out.
const BEST: f64 = 2.0;
/// Units of rounding of a value, and of the product of a value and its poles.
const ROUNDINGS: f64 = 16.0;
/// Share of the values on the axis at which it is asked what rounding leaves of zero: that times the product over the poles varies as slowly as the response.
const NOISE_AT: usize = 4;
/// Size of the values on the ellipse and of the slope of the ratio, in values on the axis, that the degree leaves room for.
const SPARE: f64 = 1600.0;

type C = Complex<f64>;

/// Number of values on a piece for a tolerance, so that the error of the polynomial is a small share of it.
pub(crate) fn values_for(tolerance: f64) -> usize {
    let wanted = BEST * (1.0 + LEBESGUE) * SAFETY * SPARE / tolerance;
    let (mut count, mut reached) = (1, 1.0);
    while reached < wanted && count < ROOM {
        (count, reached) = (count + 1, reached * ELLIPSE);
    }
    count
}

/// Number of evaluations of a response that such a polynomial takes, those on the ellipse among them.
pub(crate) fn evaluations_for(count: usize) -> usize {
    RIM + CHECKED.len() + count + count.div_ceil(NOISE_AT)
}

/// A piece of a band.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Piece {
    pub(crate) start: f64,
    pub(crate) end: f64,
}

/// Both sides of the ratio on a piece, the second of which is the product over the poles where one response is asked for.
pub(crate) struct Sides {
    pub(crate) sides: [Side; 2],
    /// The responses at the zeros of the Chebyshev polynomial.
    pub(crate) values: List<[C; 2], ROOM>,
}

/// What the values on a piece tell of the errors of a series.
#[derive(Clone, Copy, Default)]
struct Errors {
    /// The largest value on the ellipse.
    rim: f64,
    /// The largest error of a value on the axis.
    value: f64,
    /// The sum of the sizes of the coefficients.
    sum: f64,
}

impl Piece {
    pub(crate) fn middle(&self) -> f64 {
        0.5 * self.start + 0.5 * self.end
    }

    pub(crate) fn half(&self) -> f64 {
        0.5 * self.end - 0.5 * self.start
    }

    /// The frequency ω at x; the ends of the piece at its ends.
    pub(crate) fn omega(&self, x: f64) -> f64 {
        (self.middle() + self.half() * x).clamp(self.start, self.end)
    }

    /// λ at a complex x.
    fn lambda(&self, x: C) -> C {
        C::new(-self.half() * x.im, self.middle() + self.half() * x.re)
    }

    /// x at λ.
    fn x(&self, lambda: C) -> C {
        C::new((lambda.im - self.middle()) / self.half(), -lambda.re / self.half())
    }

    /// The box about the ellipse.
    pub(crate) fn region(&self) -> Region<f64> {
        let [along, across] = [1.0, -1.0].map(|sign| MARGIN * 0.5 * (ELLIPSE + sign / ELLIPSE) * self.half());
        Region { re: -across..=across, im: self.middle() - along..=self.middle() + along }
    }

    /// The poles of the list in the box, with their number; none where there are more than can be divided out.
    pub(crate) fn poles(&self, source: &dyn Source) -> Option<List<Pole, MOST_POLES>> {
        let (region, mut poles, mut is_full) = (self.region(), List::new(), false);
        source.for_each_pole(&mut |pole| {
            if region.re.contains(&pole.lambda.re) && region.im.contains(&pole.lambda.im) {
                let x = self.x(pole.lambda);
                // with what rounding makes of x
                let radius = pole.radius / self.half() + 4.0 * f64::EPSILON * modulus(x);
                for _ in 0..pole.multiplicity {
                    is_full |= poles.push(Pole { x, radius }).is_err();
                    if is_full {
                        return;
                    }
                }
            }
        });
        (!is_full).then_some(poles)
    }

    /// Both sides, of polynomials through so many values, and what the evaluations found.
    pub(crate) fn sides(
        &self,
        source: &dyn Source,
        poles: &List<Pole, MOST_POLES>,
        count: usize,
    ) -> Result<Sides, PeakError> {
        let mut errors = [Errors::default(); 2];
        for number in 0..RIM {
            let angle = core::f64::consts::PI * (2 * number + 1) as f64 / RIM as f64;
            let (sin, cos) = Scalar::sin_cos(angle);
            let x = (C::new(cos, sin) * ELLIPSE + C::new(cos, -sin) / ELLIPSE) * 0.5;
            let (lambda, product) = (self.lambda(x), product_at(poles, x));
            for (errors, value) in errors.iter_mut().zip(source.values(lambda)?) {
                errors.rim = errors.rim.max(finite(modulus(value * product), lambda)?);
            }
        }
        let (mut values, mut products) = (List::<[C; 2], ROOM>::new(), List::<[C; 2], ROOM>::new());
        let mut places = List::<f64, ROOM>::new();
        for number in 0..count {
            let lambda = C::new(0.0, self.omega(node(count, number)));
            let x = (lambda.im - self.middle()) / self.half();
            let (found, product) = (source.values(lambda)?, product_at(poles, C::from(x)));
            let noise = if number % NOISE_AT == 0 { source.noise(lambda) } else { [0.0; 2] };
            let own = |pole: &Pole| part_of(pole.radius, modulus(C::from(x) - pole.x));
            let share = ROUNDINGS * f64::EPSILON + poles.iter().map(own).sum::<f64>();
            for ((errors, value), noise) in errors.iter_mut().zip(found).zip(noise) {
                let error = (modulus(value) * share + noise) * modulus(product);
                errors.value = errors.value.max(finite(error, lambda)?);
            }
            // neither list is shorter than the room for coefficients
            let [first, second] =
                [values.push(found).is_err(), products.push(found.map(|value| value * product)).is_err()];
            let is_full = first || second || places.push(x).is_err();
            debug_assert!(!is_full, "{count} values");
        }
        let side = |k: usize| {
            let mut errors = errors[k];
            let coefficients = series_beside(&products.map(|values| values[k]), &places);
            errors.sum = coefficients.iter().map(|&coefficient| modulus(coefficient)).sum();
            Side::Series { error: errors.bound(count), coefficients }
        };
        let second = if source.is_ratio() { side(1) } else { Side::Product(*poles) };
        let sides = [side(0), second];
        self.check(source, poles, count, &sides)?;
        Ok(Sides { sides, values })
    }

    /// Looks at places between those of the values whether the polynomials are as near as their errors say: a pole that no count has seen shows there.
    fn check(&self, source: &dyn Source, poles: &[Pole], count: usize, sides: &[Side; 2]) -> Result<(), PeakError> {
        for part in CHECKED {
            let omega = self.omega(extremum(count, (part * count as f64) as usize));
            let x = (omega - self.middle()) / self.half();
            let (found, product) = (source.values(C::new(0.0, omega))?, product_at(poles, C::from(x)));
            for (side, value) in sides.iter().zip(found) {
                let Side::Series { error, .. } = side else { continue };
                let beside = modulus(side.value(x) - value * product);
                // with what the error of the value itself may be
                let is_near = beside <= 2.0 * error;
                if !is_near {
                    return Err(PeakError::Resonance { omega });
                }
            }
        }
        Ok(())
    }
}

impl Errors {
    /// The error of the polynomial through so many values. What roundings add to it where it is evaluated is a share of its coefficients.
    fn bound(&self, count: usize) -> f64 {
        let falling = (1..count).fold(1.0, |power, _| power / ELLIPSE);
        let beyond = BEST * (1.0 + LEBESGUE) * SAFETY * self.rim * falling / (ELLIPSE - 1.0);
        beyond + LEBESGUE * self.value + 2.0 * ROOM as f64 * f64::EPSILON * self.sum
    }
}

/// The polynomial through values at places that are a little beside the zeros of a Chebyshev polynomial.
fn series_beside(values: &List<C, ROOM>, places: &[f64]) -> Coefficients {
    let mut sum = series_through(values);
    for _ in 0..STEPS {
        let mut rest = *values;
        rest.as_mut_slice().iter_mut().zip(places).for_each(|(value, &x)| *value -= series_at(&sum, x));
        let step = series_through(&rest);
        sum.as_mut_slice().iter_mut().zip(step.iter()).for_each(|(coefficient, &step)| *coefficient += step);
    }
    sum
}

/// A number that is finite, or the error of what is not.
fn finite(size: f64, lambda: C) -> Result<f64, MotionError> {
    if size.is_finite() { Ok(size) } else { Err(MotionError::NotFinite { frequency: modulus(lambda) }) }
}
