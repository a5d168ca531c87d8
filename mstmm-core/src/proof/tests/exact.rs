//! Many digits: the oracle of all tests.

use crate::proof::ball::Ball;
use crate::proof::four_words::FourWords;
use crate::proof::number::{Number, OneWord, TwoWords};
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use std::sync::OnceLock;

pub(super) type Exact = FBig<HalfEven, 2>;

/// Bits: those of four words, as many for what cancels, and room.
const BITS: usize = 500;

pub(super) fn exact(value: f64) -> Exact {
    Exact::try_from(value).unwrap().with_precision(BITS).value()
}

pub(super) fn word(value: &Exact) -> f64 {
    value.to_f64().value()
}

pub(super) fn size(value: &Exact) -> f64 {
    word(value).abs()
}

/// The fourth root.
pub(super) fn fourth_root(value: &Exact) -> Exact {
    value.sqrt().sqrt()
}

/// π.
pub(super) fn pi() -> Exact {
    static PI: OnceLock<Exact> = OnceLock::new();
    PI.get_or_init(by_tangents).clone()
}

fn by_tangents() -> Exact {
    // arctan 1/5 and 1/239 (Machin)
    let inverse_tangent = |n: f64| {
        let (square, mut power) = (exact(n * n), exact(1.0) / exact(n));
        let mut sum = exact(0.0);
        for k in 0..BITS {
            let term = &power / exact((2 * k + 1) as f64);
            sum = if k % 2 == 0 { sum + term } else { sum - term };
            power /= &square;
        }
        sum
    };
    exact(16.0) * inverse_tangent(5.0) - exact(4.0) * inverse_tangent(239.0)
}

/// A number in many digits.
pub(super) trait Exactly: Number<Word = f64> {
    const NAME: &'static str;

    fn exactly(self) -> Exact;
}

impl Exactly for OneWord {
    const NAME: &'static str = "one word";

    fn exactly(self) -> Exact {
        exact(self.0)
    }
}

impl Exactly for TwoWords<f64> {
    const NAME: &'static str = "two words";

    fn exactly(self) -> Exact {
        exact(self.hi) + exact(self.lo)
    }
}

impl Exactly for FourWords {
    const NAME: &'static str = "four words";

    fn exactly(self) -> Exact {
        self.words().into_iter().map(exact).fold(exact(0.0), |sum, part| sum + part)
    }
}

/// The part of its radius that a ball uses for a number; zero of a ball that says nothing.
pub(super) fn share<N: Exactly>(ball: Ball<N>, number: &Exact) -> f64 {
    if !ball.rad.is_finite() {
        return 0.0;
    }
    let off = size(&(ball.mid.exactly() - number));
    if off == 0.0 { 0.0 } else { off / ball.rad }
}
