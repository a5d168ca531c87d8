//! A shape as plain numbers: complex states at the ends of all elements and inside of the beams, by the names of the sketch.

use crate::mode_shapes::sketch::Sketch;
use mstmm::Complex;
use mstmm::element::State;
use mstmm::motion::{ModeShape, Root};
use mstmm::number::{Oscillation, Real};
use mstmm::search::System;
use std::collections::BTreeMap;

pub(crate) type C = Complex<f64>;

/// The states of an element.
pub(crate) struct Ends<'a> {
    pub(crate) input: State<C>,
    pub(crate) output: State<C>,
    /// The state at a distance from the input end.
    pub(crate) along: Box<dyn Fn(f64) -> State<C> + 'a>,
}

/// The states of a system.
pub(crate) struct Recorded<'a> {
    pub(crate) lambda_squared: C,
    /// Zero where the system is undamped.
    pub(crate) lambda: C,
    pub(crate) elements: BTreeMap<String, Ends<'a>>,
    pub(crate) connections: BTreeMap<String, State<C>>,
}

impl Recorded<'_> {
    /// At a frequency, without states.
    pub(crate) fn at<T: Real, S: Oscillation<T>>(x: S) -> Self {
        let (lambda_squared, lambda) = (plain_number(x.lambda_squared()), plain_number(x.lambda()));
        Recorded { lambda_squared, lambda, elements: BTreeMap::new(), connections: BTreeMap::new() }
    }
}

fn plain_number<T: Real, S: Oscillation<T>>(value: S) -> C {
    let value = value.to_complex();
    C::new(value.re.to_f64(), value.im.to_f64())
}

/// A state in complex doubles.
pub(crate) fn plain<T: Real, S: Oscillation<T>>(state: State<S>) -> State<C> {
    let State { y, theta, m, q } = state;
    let [y, theta, m, q] = [y, theta, m, q].map(plain_number);
    State { y, theta, m, q }
}

/// A built system whose shapes can be recorded.
pub(crate) trait Recordable<S: Oscillation<Self::Parameter>>:
    mstmm::motion::ExtendedTree<S> + System + Sized
{
    fn record<'a>(&self, shape: &'a ModeShape<'_, Self, S>, x: S) -> Recorded<'a>;
}

/// A model whose sketch can be read.
pub(crate) trait Sketched {
    fn sketch(&self) -> Sketch;
}

/// The shape of a root, recorded.
pub(crate) fn record<'a, Y, S>(
    system: &Y,
    shape: &'a ModeShape<'_, Y, S>,
    root: &impl Root<Y::Parameter, Frequency = S>,
) -> Recorded<'a>
where
    Y: Recordable<S>,
    S: Oscillation<Y::Parameter>,
{
    system.record(shape, root.frequency())
}

/// Makes models of a source file recordable, given the names of their elements and connections.
macro_rules! recordable {
    (in $source:expr; $($model:ident $system:ident [$($element:ident)*] [$($connection:ident)*];)*) => {
        $(impl crate::mode_shapes::recorded::Sketched for $model {
            fn sketch(&self) -> crate::mode_shapes::sketch::Sketch {
                crate::mode_shapes::sketch::Sketch::of($source, stringify!($model), &format!("{self:?}"))
            }
        })*
        crate::mode_shapes::recorded::recordable! { @states $($model $system [$($element)*] [$($connection)*];)* }
    };
    (@states $($model:ident $system:ident [$($element:ident)*] [$($connection:ident)*];)*) => {$(

        impl<T: mstmm::number::Real, S: mstmm::number::Oscillation<T>> crate::mode_shapes::recorded::Recordable<S> for $system<T>
        where
            $system<T>: mstmm::motion::ExtendedTree<S> + mstmm::motion::Planned<Model = $model> + mstmm::search::System<Parameter = T>,
        {
            fn record<'a>(&self, shape: &'a mstmm::motion::ModeShape<'_, Self, S>, x: S) -> crate::mode_shapes::recorded::Recorded<'a> {
                let mut recorded = crate::mode_shapes::recorded::Recorded::at(x);
                $(recorded.elements.insert(stringify!($element).to_owned(), crate::mode_shapes::recorded::Ends {
                    input: crate::mode_shapes::recorded::plain(shape.state($model::$element.input())),
                    output: crate::mode_shapes::recorded::plain(shape.state($model::$element.output())),
                    along: Box::new(|distance| {
                        crate::mode_shapes::recorded::plain(shape.along($model::$element, distance).unwrap())
                    }),
                });)*
                $(recorded.connections.insert(
                    stringify!($connection).to_owned(),
                    crate::mode_shapes::recorded::plain(shape.state($model::$connection)),
                );)*
                recorded
            }
        }
    )*};
}
pub(crate) use recordable;
