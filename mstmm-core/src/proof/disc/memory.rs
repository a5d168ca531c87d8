//! Memory for examinations: on the stack in two sizes, with `std` for as many variables as a model has.

use crate::proof::disc::complex::ComplexBall;
use crate::proof::disc::examination::Examination;
use crate::proof::disc::room::{Examined, Room, Slope, Unknown};
use crate::proof::join::Failure;
use crate::proof::level::Level;
use crate::proof::number::TwoWords;
use crate::proof::tree::Path;
use crate::proof::visit::Visited;
use num_complex::Complex;

/// The numbers of a proof.
pub(crate) type Two = TwoWords<f64>;

/// A disc: a model, the centre and the radius.
struct Disc<'a, N> {
    model: &'a dyn Visited,
    centre: ComplexBall<N>,
    most: f64,
}

/// Examines a disc in the least memory that does.
pub(crate) fn examine_in<N: Level<Word = f64, Alone = N>>(
    model: &dyn Visited,
    centre: ComplexBall<N>,
    most: f64,
) -> Result<Examined, Failure> {
    let disc = Disc { model, centre, most };
    match on_stack::<N, 8, 36, 9, 81>(&disc) {
        Err(Failure::Full) => {}
        examined => return examined,
    }
    match on_stack::<N, 20, 210, 21, 441>(&disc) {
        Err(Failure::Full) => beyond_stack(&disc),
        examined => examined,
    }
}

/// In memory for W variables, `E = W (W + 1)/2` entries, `U = W + 1` unknowns and `S = U²` numbers.
#[inline(never)]
fn on_stack<N: Level<Word = f64, Alone = N>, const W: usize, const E: usize, const U: usize, const S: usize>(
    disc: &Disc<'_, N>,
) -> Result<Examined, Failure> {
    let zero = Complex::new(0.0, 0.0);
    let room = Room {
        entries: &mut [ComplexBall::of(0.0); E],
        others: &mut [ComplexBall::of(0.0); E],
        slopes: &mut [Slope::none(); E],
        unknowns: &mut [Unknown::none(); U],
        matrix: &mut [zero; S],
        inverse: &mut [zero; S],
        is_taken: &mut [false; W],
        pivots: &mut [0; U],
        paths: &mut [Path::none(); W],
    };
    let Disc { model, centre, most } = *disc;
    Examination { model, room, centre, most }.run()
}

/// In memory for as many variables as the model has.
#[cfg(feature = "std")]
#[inline(never)]
fn beyond_stack<N: Level<Word = f64, Alone = N>>(disc: &Disc<'_, N>) -> Result<Examined, Failure> {
    use crate::proof::disc::examination::variables;
    use std::vec;
    /// Most variables: twenty million numbers.
    const WIDEST: usize = 600;
    let Disc { model, centre, most } = *disc;
    let mut paths = vec![Path::none(); WIDEST];
    let mut is_taken = vec![false; WIDEST];
    let count = variables(model, centre, &mut is_taken, &mut paths)?;
    let (entries, n, zero) = (count * (count + 1) / 2, count + 1, Complex::new(0.0, 0.0));
    let room = Room {
        entries: &mut vec![ComplexBall::of(0.0); entries],
        others: &mut vec![ComplexBall::of(0.0); entries],
        slopes: &mut vec![Slope::none(); entries],
        unknowns: &mut vec![Unknown::none(); n],
        matrix: &mut vec![zero; n * n],
        inverse: &mut vec![zero; n * n],
        is_taken: &mut is_taken,
        pivots: &mut vec![0; n],
        paths: &mut paths,
    };
    Examination { model, room, centre, most }.run()
}

/// Without `std` there is no memory but the stack.
#[cfg(not(feature = "std"))]
fn beyond_stack<N: Level<Word = f64, Alone = N>>(_: &Disc<'_, N>) -> Result<Examined, Failure> {
    Err(Failure::Full)
}
