//! What an evaluation costs: the emitted code runs over a scalar that counts, against counts by hand, term by term.
//!
//! By hand a beam is `z = βl = s (m/EI)^¼ l` with `s = √ω`, its circular and hyperbolic functions of z, the products
//! `ch c, ch s, sh c, f = sh s`, and of these the sums `a = 1 + ch c, c = 2 ch c, b = ch s + sh c, d = ch s - sh c,
//! e = 1 - ch c`, each only where Δ depends on it; halves of them would do as well. Minors have the units `EIβ, EIβ², EIβ³,
//! EI²β⁴`, or one over these, each a parameter times a power of s or 1/s: the units of p_YM, w, p_ΘQ, p_MQ in this order.
//! Powers are there once for all beams: `s² = ω` costs nothing, `s³` and `λ²` (for `s⁴ = -λ²`) a multiplication each, `1/s` a
//! division, `s⁻²`, `s⁻³`, `s⁻⁴` a multiplication each.

mod counted;
mod examples;
mod motions;
mod scenes;
mod small;

use crate::support::models;
use counted::{ADD, COS, Counts, EXP, MUL, Operations, SIN};
use mstmm::Complex;

/// A step of a count by hand: what it computes, and what that takes.
type Step = (&'static str, Operations);

/// The operations of Δ(ω).
macro_rules! at_omega {
    ($model:expr, $omega:expr) => {{
        let (system, counting) = ($model.build().unwrap(), $model.build_as::<Counted>().unwrap());
        let (counts, mantissa) = count(&counting, Counted::from($omega));
        let plain = Characteristic::<f64>::characteristic(&system, $omega).mantissa();
        assert_same(Complex::new(mantissa.to_f64(), 0.0), Complex::new(plain, 0.0));
        counts
    }};
}

/// The operations of Δ(λ).
macro_rules! at_lambda {
    ($model:expr, $re:expr, $im:expr) => {{
        let (system, counting) = ($model.build().unwrap(), $model.build_as::<Counted>().unwrap());
        let (counts, mantissa) = count(&counting, Complex::new(Counted::from($re), Counted::from($im)));
        let plain = system.characteristic(Complex::new($re, $im)).mantissa();
        assert_same(Complex::new(mantissa.re.to_f64(), mantissa.im.to_f64()), plain);
        counts
    }};
}
pub(crate) use {at_lambda, at_omega};

/// Asserts that what was counted is what is computed in `f64`, but for other roundings of the functions.
fn assert_same(counted: Complex<f64>, plain: Complex<f64>) {
    assert!((counted - plain).norm() < 1e-12, "{counted} is not {plain}");
}

/// Asserts that exactly the steps by hand are needed, and that no function is computed without need.
fn assert_counts(counts: Counts, steps: &[Step]) {
    let by_hand = steps.iter().fold(Operations::default(), |sum, (_, step)| sum + *step);
    assert_eq!(counts.needed, by_hand, "{steps:#?}");
    assert_eq!(counts.executed.functions(), counts.needed.functions());
}

/// The functions of a beam, z included.
fn functions() -> Operations {
    MUL + SIN + COS + EXP
}

/// The whole plane behind a beam that starts on a pin: `[d/EIβ³, 2f L², b L, c, -d EIβ]` with `L = EIβ / EIβ²`.
fn behind_pinned_tip() -> Step {
    let units = 3 * MUL + 2 * MUL;
    ("z, products, b, c, d, 2f; EIβ, 1/EIβ², 1/EIβ³, L, L²; four minors", functions() + 8 * MUL + 4 * ADD + units)
}

/// A beam that starts on a pin and ends on one: of the plane behind it, `d/EIβ³` and `2f L²`.
fn from_pin_to_pin() -> Step {
    let units = 3 * MUL + 2 * MUL;
    ("z, ch s, sh c, f; d, 2f; EIβ, 1/EIβ², 1/EIβ³, L, L²; two minors", functions() + 5 * MUL + 2 * ADD + units)
}

/// The last beam before a pinned root: a whole plane comes in,
/// `p_YM = (c p_YM - d p_YΘ) + (b 2w + f 2p_ΘQ) + d p_MQ` goes out.
fn into_pinned_root() -> Step {
    let own = 4 * MUL + 3 * ADD;
    let minors = 4 * MUL + 4 * MUL;
    let sum = 5 * MUL + 4 * ADD + 2 * ADD;
    ("z, products, b, c, d; units, times minors; the sum; EIβ, times it", functions() + own + minors + sum + 2 * MUL)
}
