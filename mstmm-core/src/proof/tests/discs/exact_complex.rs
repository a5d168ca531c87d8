//! Complex numbers of many digits.

use crate::proof::disc::complex::ComplexBall;
use crate::proof::level::Level;
use crate::proof::tests::exact::{Exact, Exactly, exact, size};
use core::ops::{Add, Div, Mul, Neg, Sub};
use std::vec::Vec;

#[derive(Clone, Debug)]
pub(super) struct ExactComplex {
    pub(super) re: Exact,
    pub(super) im: Exact,
}

impl ExactComplex {
    pub(super) fn of(re: f64, im: f64) -> Self {
        ExactComplex { re: exact(re), im: exact(im) }
    }

    pub(super) fn centre<N: Exactly>(ball: ComplexBall<N>) -> Self {
        ExactComplex { re: ball.re.exactly(), im: ball.im.exactly() }
    }

    pub(super) fn exp(&self) -> Self {
        let (size, (sine, cosine)) = (self.re.exp(), self.im.sin_cos());
        ExactComplex { re: &size * cosine, im: size * sine }
    }

    pub(super) fn square(&self) -> Exact {
        &self.re * &self.re + &self.im * &self.im
    }

    /// The root of positive real part.
    pub(super) fn sqrt(&self) -> Self {
        let modulus = self.square().sqrt();
        let half = exact(0.5);
        if self.re >= exact(0.0) {
            let re = ((modulus + &self.re) * half).sqrt();
            let im = &self.im / (exact(2.0) * &re);
            return ExactComplex { re, im };
        }
        let im = ((modulus - &self.re) * half).sqrt();
        let im = if self.im < exact(0.0) { -im } else { im };
        let re = &self.im / (exact(2.0) * &im);
        ExactComplex { re, im }
    }

    /// The size, rounded up by far less than tests need.
    pub(super) fn size(&self) -> f64 {
        let (re, im) = (size(&self.re), size(&self.im));
        re.hypot(im)
    }
}

macro_rules! operator {
    ($trait:ident $name:ident |$a:ident, $b:ident| $re:expr, $im:expr) => {
        impl $trait for &ExactComplex {
            type Output = ExactComplex;

            fn $name(self, $b: &ExactComplex) -> ExactComplex {
                let $a = self;
                ExactComplex { re: $re, im: $im }
            }
        }
    };
}

operator!(Add add |a, b| &a.re + &b.re, &a.im + &b.im);
operator!(Sub sub |a, b| &a.re - &b.re, &a.im - &b.im);
operator!(Mul mul |a, b| &a.re * &b.re - &a.im * &b.im, &a.re * &b.im + &a.im * &b.re);
operator!(Div div |a, b|
    (&a.re * &b.re + &a.im * &b.im) / b.square(),
    (&a.im * &b.re - &a.re * &b.im) / b.square()
);

impl Neg for &ExactComplex {
    type Output = ExactComplex;

    fn neg(self) -> ExactComplex {
        ExactComplex { re: -&self.re, im: -&self.im }
    }
}

/// The part of its radius that a ball uses for a number; none of a ball that says nothing.
pub(super) fn share<N: Exactly>(ball: ComplexBall<N>, number: &ExactComplex) -> Option<f64> {
    let off = (&ExactComplex::centre(ball) - number).size();
    match ball.rad {
        rad if !rad.is_finite() => None,
        _ if off == 0.0 => Some(0.0),
        rad => Some(off / rad),
    }
}

/// Points of a ball: its centre, or four points of its rim, by a little less than rounding may put them outside.
pub(super) fn points<N: Level<Word = f64> + Exactly>(ball: ComplexBall<N>) -> Vec<ExactComplex> {
    let centre = ExactComplex::centre(ball);
    if ball.rad == 0.0 {
        return [centre].into();
    }
    let away = [(1.0, 0.0), (-1.0, 0.0), (0.6, -0.8), (-0.28, 0.96)];
    let at = |(re, im): (f64, f64)| {
        &centre + &ExactComplex::of(re * ball.rad * (1.0 - 1e-15), im * ball.rad * (1.0 - 1e-15))
    };
    away.map(at).into()
}
