//! The derivatives of parameters with respect to fields, through every kind of formula.
//!
//! A model has a probe for an element, whose dynamic work is made up, so that the chain rule alone is tested: the oracle is
//! a central difference of the same formulas over plain numbers.

use mstmm::__private::{Chain, Fields, NamedFields};
use mstmm::element::{
    BackTransfer, Covector, Element, Ends, Energies, FrequencyPowers, InvalidParameter, PlaneStep, RootCounter,
    Subspace, Translation,
};
use mstmm::number::{Frequency, Parameter};
use mstmm::search::System;

mod probe {
    /// Takes whatever parameters, and does nothing to a state.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Probe<T> {
        pub(crate) first: T,
        pub(crate) second: T,
    }
}
use probe::Probe;

impl<T: Parameter> Element for Probe<T> {
    type State = Translation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Ok(self)
    }
}

impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for Probe<T> {
    type Coefficients = ();

    fn coefficients(_built: &Self, _at: &FrequencyPowers<S>) {}

    fn step<C: RootCounter<S>>(_coefficients: &(), input: Subspace<S>, _counter: &mut C) -> Subspace<S> {
        input
    }
}

/// Made up: `∂L/∂first` is the input's Y, `∂L/∂second` the output's.
impl<T: Parameter, S: Frequency<T>> BackTransfer<S> for Probe<T> {
    type BackCoefficients = ();
    const SYMMETRIC: bool = true;

    fn reversed(built: &Self) -> Self {
        *built
    }

    fn back_coefficients(_built: &Self, _at: &FrequencyPowers<S>) {}

    fn back_transfer(_links: &(), _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
        covector
    }
}

impl<T: Parameter, S: Frequency<T>> Energies<S> for Probe<T> {
    type Gradient = Probe<S>;

    fn units(_built: &Self, _at: &FrequencyPowers<S>) -> [f64; 2] {
        [1.0; 2]
    }

    fn mass_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    fn stiffness_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    fn gradient(_built: &Self, ends: &Ends<S>) -> Probe<S> {
        Probe { first: ends.input.y, second: ends.output.y }
    }
}

/// Made-up states, different at each step.
fn ends(step: usize) -> Ends<f64> {
    let mut ends = Ends { x: 1.0, input: Default::default(), output: Default::default() };
    (ends.input.y, ends.output.y) = (1.0 + step as f64, 0.3 - 0.7 * step as f64);
    ends
}

/// `∂/∂field` of `Σ Y_input first + Y_output second` by central differences; `formulas` gives the parameters by step.
fn differences<const K: usize>(values: [f64; K], formulas: impl Fn([f64; K]) -> Vec<(usize, f64, f64)>) -> [f64; K] {
    let step = f64::EPSILON.cbrt();
    let sum = |values: [f64; K]| -> f64 {
        let summand = |(index, first, second)| ends(index).input.y * first + ends(index).output.y * second;
        formulas(values).into_iter().map(summand).sum()
    };
    core::array::from_fn(|field| {
        let at = |change: f64| {
            let mut values = values;
            values[field] += change;
            sum(values)
        };
        (at(step) - at(-step)) / (2.0 * step)
    })
}

#[track_caller]
fn assert_near(actual: &[f64], expected: &[f64]) {
    assert_eq!(actual.len(), expected.len());
    for (a, e) in actual.iter().zip(expected) {
        assert!((a - e).abs() <= 1e-8 * (1.0 + e.abs()), "{actual:?} instead of {expected:?}");
    }
}

/// The chain rule of a built system.
fn chain<Y: Chain<f64> + System<Parameter = f64>>(system: &Y) -> Y::PerField<f64> {
    system.chain(ends)
}

const DENSITY: f64 = 7.8;

/// A function of the user's own.
fn area(width: f64, height: f64) -> f64 {
    width * height
}

/// The fields, and the same formulas twice: as a model of two probes in a row, steps 1 and 2, and as a function.
macro_rules! formulas {
    (
        $model:ident { $($field:ident: $value:literal),* }
        $(let $pattern:tt $(: $type:ty)? = $let:expr;)*
        => $first:expr, $second:expr
    ) => {{
        mstmm::system! {
            struct $model { $($field: f64),* }
            $(let $pattern $(: $type)? = $let;)*
            fixed -> probe::Probe 1 { first: $first, second: $second }
                  -> probe::Probe 2 { first: $second, second: 2.0 * $first } -> free;
        }
        #[allow(unused_variables)]
        let expected = differences([$($value),*], |[$($field),*]| {
            $(let $pattern $(: $type)? = $let;)*
            vec![(1, $first, $second), (2, $second, 2.0 * $first)]
        });
        let system = $model { $($field: $value),* }.build().unwrap();
        assert_near(&chain(&system), &expected);
    }};
}

#[test]
fn operators_constants_and_parentheses() {
    formulas!(Sums { a: 0.3, b: 1.7 } => a + b - 2.0, -(a - 3.0) + (1.0 - b));
    formulas!(Products { a: 0.3, b: 1.7 } => a * b / 2.0, 3.0 / (a + b) * DENSITY);
    formulas!(Constants { a: 0.3 } => 1.0, core::f64::consts::PI * a);
    formulas!(OfFunctions { a: 0.3 } => area(2.0, DENSITY) * a, a + f64::from(3_u8) * DENSITY.sqrt());
}

#[test]
fn lines() {
    formulas!(OneOfAnother { a: 0.3, b: 1.7 } let c = a * b; let d = c * c + a; let a = 2.0; => d * a, c / d);
    formulas!(Tuples { a: 0.3, b: 1.7 } let (c, d): (f64, f64) = (a * b, 3.0); let e: f64 = c * d; => e, d.powf(e));
    formulas!(Nested { a: 0.3, b: 1.7 } let ((c, n), .., d) = ((a * b, 3), b, a); => c.powi(n), c * d);
    formulas!(Parts { a: 0.3, b: 1.7 } let pair = (a, (2.0, b)); let (c, _) = pair; => pair.1.1 * c, pair.1.0 * pair.0);
    formulas!(Plain { a: 0.3 } let table: Vec<f64> = [1, 2].map(f64::from).to_vec();
        => a * table[1], table.iter().sum::<f64>() * a
    );
}

#[test]
fn blocks() {
    formulas!(Blocks { a: 0.3, b: 1.7 } let c = { let a = a * b; let b: f64 = 2.0; a * b };
        => { c * a }, { let a = 3.0; b * a } * a
    );
}

/// Either branch of each, and plain numbers beside numbers with derivatives.
#[test]
fn branches() {
    formulas!(Plus { a: 0.3, b: 1.7 } => if a < b { 1.0 } else { b * a }, if a < b { b * a } else { 1.0 });
    formulas!(Minus { a: 1.3, b: 0.7 } => if a < b { 1.0 } else { b * a }, if a < b { b * a } else { 1.0 });
    formulas!(Chained { a: 0.3, b: 1.7 } =>
        if a > b { a } else if a > 1.0 || b > 2.0 { DENSITY } else if !(b == 0.0) { a * b } else { 0.0 },
        if 1.0 <= a { 2.0 } else if !(a == 0.5) && b != 1.0 { b } else { a }
    );
    formulas!(Matched { a: 0.3, b: 1.7 }
        => match a < b { true => { 3.0 } false => a }, match a > b { true => 3.0, _ => a * b }
    );
    formulas!(Guarded { a: 0.3, b: 1.7 }
        => match a * b { c if c > 1.0 => c, c => 2.0 * c }, match (a, 2) { (c, n) if n == 2 => c.powi(n), _ => b }
    );
    formulas!(Optional { a: 0.3 }
        => if let Some(a) = Some(2.0) { a } else { a }, if let Some(b) = None::<f64> { b } else { a }
    );
    formulas!(Pairs { a: 0.3, b: 1.7 } let (c, d) = if a < b { (a, 1.0) } else { (2.0, b) }; => c * d, d * b);
    formulas!(PlainPairs { a: 1.3, b: 0.7 } let pair = (5.0, 2); let (c, n) = if a < b { (a, 1) } else { pair };
        => c * a, a.powi(n)
    );
}

/// Every function that is known, as a method, and some as functions.
#[test]
fn functions() {
    formulas!(Powers { a: 0.3, b: 1.7 }
        => a.sqrt() + b.cbrt() + a.recip(), a.powi(2) + a.powf(b) + 2_f64.powf(a) + a.powf(2.0)
    );
    formulas!(Exponentials { a: 0.3, b: 1.7 } => a.exp() + a.exp_m1() + b.ln(), a.ln_1p() + b.log10() + b.log2());
    formulas!(Angles { a: 0.3, b: 1.7 }
        => a.sin() + a.cos() + a.tan() + a.asin(), a.acos() + a.atan() + a.atan2(b) + b.atan2(2.0)
    );
    formulas!(Hyperbolic { a: 0.3, b: 1.7 } => a.sinh() + b.cosh() + a.tanh(), a.to_radians() + b.to_degrees());
    formulas!(Limits { a: 0.3, b: 1.7 }
        => a.min(b) * a + a.max(2.0) * b, (-a).abs() + b.signum() * a + 2_f64.max(a) * a
    );
    formulas!(More { a: 0.3, b: 1.7 } => a.hypot(b) + a.clamp(0.5, b) * a, a.mul_add(b, 2.0) + 2_f64.mul_add(a, b));
    formulas!(AsFunctions { a: 0.3, b: 1.7 }
        => f64::sqrt(a * b) + f64::max(2.0, a) * a, f64::powi(-a, 3) + f64::hypot(3.0, b)
    );
}

/// All sections; their own derivatives are tested in the core.
#[test]
fn sections() {
    use mstmm::sections;
    formulas!(Rings { d: 0.9, e: 1.1, nu: 0.3 }
        let (area, i_y, i_z, torsion) = sections::round(d);
        let (k, _) = sections::round_shear(1.0, nu);
        let tube = sections::tube(e, d);
        let (.., l) = mstmm::sections::tube_shear(e, 0.5, nu);
        => area + i_y * k - i_z + torsion, tube.0 * l + tube.3
    );
    formulas!(Rectangles { b: 0.9, h: 1.3, t: 0.2, nu: 0.3 }
        let (area, _, i_z, torsion) = sections::rectangle(b, h);
        let (k, _) = sections::rectangle_shear(b, 2.0, nu);
        let hollow = sections::box_section(b, h, t);
        let (l_y, l_z) = sections::box_shear(b, h, 0.1, nu);
        => k * area + i_z + torsion, hollow.1 * l_y + hollow.3 * l_z
    );
    formulas!(Girders { b: 0.9, h: 1.3, t: 0.1, w: 0.08, nu: 0.3 }
        let (area, i_y, i_z, torsion) = sections::i_section(b, h, t, w);
        let (k_y, k_z) = sections::i_shear(b, h, t, w, nu);
        => k_y * area + i_y, k_z * i_z + torsion
    );
}

mstmm::system! {
    struct Hollow { outer: f64, inner: f64 }
    let (area, i_y, ..) = mstmm::sections::tube(outer, inner);
    fixed -> beam 1 { length: 3.0, bending_stiffness: 2.1e11 * i_y, mass_per_length: 7850.0 * area } -> free;
}

/// Sizes that no section has make parameters that no beam has.
#[test]
fn wrong_sizes_are_told_when_a_model_is_built() {
    assert!(Hollow { outer: 0.2, inner: 0.18 }.build().is_ok());
    let error = Hollow { outer: 0.18, inner: 0.2 }.build().map(|_| ()).unwrap_err();
    assert_eq!((error.element, error.value.is_nan()), ("beam 1", true), "{error}");
}

/// Names of emitted variables, and a name that hides a field in a block or an arm alone.
#[test]
fn names() {
    formulas!(NamedLikeInternals { chain: 0.3, values: 1.7, ends: 0.2, gradient: 0.9, step: 1.1, part_0: 2.1 }
        let system = if chain < values { (ends, 2.0) } else { (1.0, gradient) };
        => system.0 * step.max(2.0) * gradient, values / chain * part_0);
    formulas!(Hidden { a: 0.3, b: 1.7 } =>
        { let a = 2.0; a * a } * a,
        (match Some(2.0) { Some(a) => a, None => b }) * if let Some(a) = Some(4_f64) { area(a, a) } else { 0.0 } * a
    );
}

/// A number that comes by a fragment keeps its value and its derivative.
#[test]
fn fragments() {
    macro_rules! twice {
        ($model:ident, $e:expr, $n:literal) => { formulas!($model { a: 0.3 } let b = $n * a; => $n * b, $e * 2.0 - $n); };
    }
    twice!(Fragments, 1.0 + 2.0, 4.0);
    macro_rules! of_field {
        ($model:ident, $a:ident, $e:expr) => { formulas!($model { $a: 0.3 } let a = 2.0; => $e * a, a * $a); };
    }
    of_field!(OfField, a, 1.0 + a);
}

mstmm::system! {
    struct Marked {
        width: f64,
        /// The user's own function knows no derivative.
        #[no_sensitivity]
        height: f64,
        #[cfg(any())]
        absent: f64,
        #[cfg(all())]
        density: f64,
        #[no_sensitivity]
        #[cfg(any())]
        other: f64,
        r#type: f64,
    }
    let section = area(height, height);
    fixed -> probe::Probe 1 { first: section * width, second: height.floor() } -> conn 3;
    fixed -> probe::Probe 2 { first: section * width, second: height.floor() } -> conn 3;
    conn 3 -> probe::Probe 4 { first: density * r#type, second: section } -> free
}

/// By hand; the first two probes are one element, built once, and two steps.
#[test]
fn marked_fields_are_plain_numbers_and_absent_ones_are_none() {
    assert_eq!(MarkedSystem::<f64>::NAMES, ["width", "density", "type"]);
    let system = Marked { width: 0.3, height: 2.0, density: 5.0, r#type: 0.7 }.build().unwrap();
    let [first, second, third] = [1, 3, 5].map(|step| ends(step).input.y);
    assert_near(&chain(&system), &[4.0 * (first + second), 0.7 * third, 5.0 * third]);
    assert_eq!(MarkedSystem::<f64>::per_field("a"), ["a"; 3]);
}

mstmm::system! {
    struct WithoutFields;
    fixed -> probe::Probe 1 { first: 1.0, second: DENSITY } -> free
}
mstmm::system! {
    struct WithPlainFieldsAlone { #[no_sensitivity] a: f64 }
    fixed -> probe::Probe 1 { first: a, second: area(a, a) } -> free
}

#[test]
fn a_model_may_have_no_fields_with_derivatives() {
    assert_eq!(chain(&WithoutFields.build().unwrap()), [0.0; 0]);
    assert_eq!(chain(&WithPlainFieldsAlone { a: 1.0 }.build().unwrap()), [0.0; 0]);
}
