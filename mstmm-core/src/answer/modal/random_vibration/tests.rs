//! Directed families: narrow modes, close modes, steep and narrow spectra, beside quadratures in double-double arithmetic that share nothing with the sums.

use super::*;
use crate::answer::facts::Facts;
use crate::number::{ComplexEigenvalue, DoubleDouble, List, Parameter};
use core::marker::PhantomData;
use std::vec;
use std::vec::Vec;

type Response<T> = ModalResponse<T, 256, ComplexEigenvalue>;
type Rows = [(f64, f64)];

/// A response of no modes.
fn empty<T: Real>() -> Response<T> {
    let [rigid, residual, lag, flow, carried] = [T::zero(); 5];
    let (terms, facts, meaning) = (List::new(), Facts::default(), PhantomData);
    ModalResponse { terms, rigid, residual, lag, flow, carried, roots: 0, facts, meaning }
}

fn with<T: Real>(mut response: Response<T>, lambda: Complex<T>, residue: Complex<T>) -> Response<T> {
    response.push(Term { lambda, residue, root: 0 }).unwrap();
    response
}

/// Modes of frequencies \[Hz\], ratios and parts at rest, such as a force has.
fn of_modes(modes: &[(f64, f64, f64)]) -> Response<f64> {
    modes.iter().fold(empty(), |response, (hertz, ratio, at_rest)| {
        let omega = turn::<f64>() * hertz;
        let slowed = ((1.0 - ratio) * (1.0 + ratio)).sqrt();
        let lambda = Complex::new(-ratio * omega, slowed * omega);
        with(response, lambda, Complex::new(0.0, -at_rest * omega / slowed))
    })
}

/// Three modes of usual ratios.
fn three() -> Response<f64> {
    of_modes(&[(12.0, 0.01, 1e-3), (70.0, 0.03, -2e-4), (300.0, 0.002, 1e-5)])
}

fn wide(number: f64) -> DoubleDouble {
    DoubleDouble::from_f64(number)
}

fn in_wide(response: &Response<f64>) -> Response<DoubleDouble> {
    let long = |z: Complex<f64>| Complex::new(wide(z.re), wide(z.im));
    let start = response.terms.iter().fold(empty(), |sum, term| with(sum, long(term.lambda), long(term.residue)));
    let ModalResponse { rigid, residual, lag, flow, carried, .. } = *response;
    let [rigid, residual, lag, flow, carried] = [rigid, residual, lag, flow, carried].map(wide);
    ModalResponse { rigid, residual, lag, flow, carried, ..start }
}

/// Nodes and weights of Gauss and Legendre on [-1, 1], by Newton's method.
fn gauss() -> Vec<(f64, f64)> {
    let count = 20;
    let legendre = |x: f64| {
        (1..count).fold((1.0, x), |(before, last), n| {
            let n = f64::from(n);
            (last, ((2.0 * n + 1.0) * x * last - n * before) / (n + 1.0))
        })
    };
    let node = |k: i32| {
        let (mut x, mut slope) =
            ((core::f64::consts::PI * (f64::from(k) + 0.75) / (f64::from(count) + 0.5)).cos(), 1.0);
        for _ in 0..40 {
            let (before, last) = legendre(x);
            slope = f64::from(count) * (before - x * last) / ((1.0 - x) * (1.0 + x));
            x -= last / slope;
        }
        (x, 2.0 / ((1.0 - x) * (1.0 + x) * slope * slope))
    };
    (0..count).map(node).collect()
}

/// Root mean squares by panels that are narrow beside their distance from each pole, and in which the level changes little.
fn by_quadrature(response: &Response<f64>, rows: &Rows) -> [f64; 2] {
    let (exact, nodes, circle) = (in_wide(response), gauss(), turn::<DoubleDouble>());
    let mut sums = [0.0; 2];
    for pair in rows.windows(2) {
        let ((start, low), (end, high)) = (pair[0], pair[1]);
        let (span, change) = (end - start, high.ln() - low.ln());
        // places as parts of the piece, so that narrow ones are told
        let mut stack = vec![(0.0_f64, 1.0_f64)];
        while let Some((from, to)) = stack.pop() {
            let half = 0.5 * span * (to - from);
            let middle = wide(start) + wide(span) * wide(0.5 * (from + to));
            let apart = |term: &Term<f64>| {
                let across = (middle * circle - wide(term.lambda.im)).to_f64();
                across.hypot(term.lambda.re) / circle.to_f64()
            };
            let poles = response.terms.iter().map(apart);
            let nearest = poles.fold(middle.to_f64(), f64::min);
            let part = 2.0 * half / middle.to_f64() / (span / start).ln_1p();
            if (half > 0.5 * nearest || (change * part).abs() > 2.0) && to - from > 1e-15 {
                stack.extend([(from, 0.5 * (from + to)), (0.5 * (from + to), to)]);
                continue;
            }
            for (node, weight) in &nodes {
                let hertz = middle + wide(half) * wide(*node);
                let above = (hertz - wide(start)).to_f64();
                let shape = (above / start).ln_1p() / (span / start).ln_1p();
                let omega = hertz * circle;
                let value = exact.whole_at(Complex::new(wide(0.0), omega)).unwrap();
                let power = (low.ln() + change * shape).exp() * value.norm_sqr().to_f64() * weight * half;
                sums[0] += power;
                sums[1] += power * omega.to_f64().powi(2);
            }
        }
    }
    sums.map(f64::sqrt)
}

/// Compares root mean squares with quadratures.
#[track_caller]
fn compare(name: &str, response: &Response<f64>, rows: &Rows, tolerance: f64) {
    let found = response.random(&PowerSpectrum::hertz(rows).unwrap()).unwrap();
    let expected = by_quadrature(response, rows);
    for (found, expected) in [found.rms, found.rate_rms.unwrap()].into_iter().zip(expected) {
        let error = (found / expected - 1.0).abs();
        assert!(error < tolerance, "{name}: {found:e}, {expected:e} by quadrature: {error:e}");
    }
}

#[test]
fn narrow_modes_and_edges_at_them() {
    for ratio in [1e-8, 1e-3, 0.2, 0.3, 0.7, 0.71, 0.99] {
        let response = of_modes(&[(40.0, ratio, 1e-4)]);
        let bands = [(1.0, 100.0), (40.0, 80.0), (39.0, 40.0), (1.0, 39.9), (40.0 + 1e-6, 41.0)];
        for (start, end) in bands {
            // an edge at a mode is as far of it as rounding tells
            let is_beside = start < 39.5 && end > 40.5 || end < 39.95;
            let tolerance = 1e-13 + if is_beside { 0.0 } else { 1e-16 / ratio };
            // of the narrowest mode the quadrature has ten digits
            let tolerance = if ratio < 1e-7 { tolerance.max(1e-10) } else { tolerance };
            compare(&std::format!("{ratio} {start} {end}"), &response, &[(start, 2.0), (end, 2.0)], tolerance);
        }
    }
}

#[test]
fn close_modes_that_add_and_cancel() {
    for (gap, sign, ratio) in
        [(1e-9, 1.0, 0.02), (1e-9, -1.0, 0.02), (1e-4, 1.0, 1e-5), (1e-4, -1.0, 1e-5), (1e-2, -1.0, 0.4)]
    {
        let response = of_modes(&[(40.0, ratio, 1e-4), (40.0 * (1.0 + gap), ratio, sign * 1e-4), (90.0, ratio, 2e-5)]);
        let name = std::format!("{gap} {sign} {ratio}");
        compare(&name, &response, &[(10.0, 2.0), (30.0, 5.0), (200.0, 0.5)], 1e-12);
        compare(&name, &response, &[(42.0, 2.0), (50.0, 5.0), (80.0, 0.5)], 1e-13);
    }
}

/// Among the slopes are those at which an exponent vanishes, and an integral of powers would be a logarithm.
#[test]
fn slopes_of_all_kinds() {
    for slope in [-300.0, -100.0, -7.0, -5.0, -4.0, -3.0, -2.0, -1.0, 0.0, 1.0, 3.0, 100.0, 300.0] {
        compare(&std::format!("{slope}"), &three(), &[(10.0, 1.0), (13.0, 1.3_f64.powf(slope))], 1e-13);
        let far = 10.0_f64.powf(slope.clamp(-30.0, 30.0));
        compare(&std::format!("{slope} over a decade"), &three(), &[(10.0, 1.0), (100.0, far)], 1e-13);
    }
}

#[test]
fn steps_and_narrow_bands() {
    for (gap, jump) in [(1e-3, 1e8), (1e-6, 10.0), (1e-6, 1e-8), (1e-9, 1e100), (1e-13, 10.0)] {
        let beyond = 12.0 * (1.0 + gap);
        let name = std::format!("{gap} {jump}");
        compare(&name, &three(), &[(5.0, 1.0), (12.0, 1.0), (beyond, jump), (400.0, jump)], 1e-13);
        compare(&name, &three(), &[(12.0, 1.0), (beyond, jump)], 1e-13);
    }
    compare("one step of numbers", &three(), &[(12.0, 1.0), (12.0_f64.next_up(), 1.0)], 1e-13);
}

#[test]
fn levels_and_sizes_beyond_their_squares() {
    for level in [1e-300, 1e300] {
        compare(&std::format!("{level}"), &three(), &[(5.0, level), (500.0, level)], 2e-13);
    }
    let rows = [(5.0, 1.0), (500.0, 3.0)];
    let known = three().random(&PowerSpectrum::hertz(&rows).unwrap()).unwrap();
    for exponent in [-700, -500, 500, 700] {
        let found = three().scaled(exponent).random(&PowerSpectrum::hertz(&rows).unwrap()).unwrap();
        assert_eq!(found.rms, known.rms.times_power_of_two(exponent));
    }
    let peaked = [(5.0, 1e-300), (50.0, 1e300), (500.0, 1e-300)];
    compare("600 powers of ten", &three(), &peaked, 1e-12);
    let wide = three().random(&PowerSpectrum::hertz(&[(1e-100, 1.0), (1e100, 1.0)]).unwrap()).unwrap();
    let noise = three().random(&PowerSpectrum::white(1.0)).unwrap();
    assert!((wide.rms / noise.rms - 1.0).abs() < 1e-13, "{wide:?} {noise:?}");
}

/// Bodies that move off, drifts, real eigenvalues, what follows at once, late, or the rate.
#[test]
fn parts_of_all_kinds() {
    let number = |re| Complex::new(re, 0.0);
    let mut all = with(with(three(), number(0.0), number(0.02)), number(-30.0), number(0.02));
    all.terms.as_mut_slice()[0].residue += number(0.003);
    (all.rigid, all.residual, all.flow, all.carried) = (0.01, 3e-6, 2e-7, 0.002);
    let rows = [(0.01, 1.0), (1.0, 3.0), (500.0, 1.0), (5000.0, 1e-3)];
    compare("at once", &all, &rows, 1e-13);
    all.lag = 1e-3;
    compare("late", &all, &rows, 1e-13);
}

#[test]
fn undamped_modes_beside_a_spectrum() {
    let undamped = of_modes(&[(40.0, 0.0, 1e-4), (90.0, 0.0, 2e-5), (120.0, 1e-15, 3e-5), (95.0, 1e-8, 1e-5)]);
    compare("between", &undamped, &[(41.0, 1.0), (89.0, 3.0)], 1e-13);
    compare("near", &undamped, &[(40.0 + 1e-4, 1.0), (90.0 - 1e-4, 3.0)], 1e-10);
    let of = |start, end| undamped.random(&PowerSpectrum::band(start..=end, 1.0).unwrap());
    for (start, end) in [(30.0, 50.0), (40.0, 50.0), (30.0, 40.0), (110.0, 130.0), (40.0_f64.next_up(), 50.0)] {
        assert!(matches!(of(start, end), Err(RandomError::NoDamping { .. })), "{start} {end}");
    }
    let growing = with(three(), Complex::new(1e-3, 50.0), Complex::new(0.0, 1e-3));
    let refused = growing.random(&PowerSpectrum::white(1.0));
    assert_eq!(refused, Err(RandomError::Unstable { growth: 1e-3 }));
    assert_eq!(growing.power_at(1.0, &PowerSpectrum::white(1.0)), Err(RandomError::Unstable { growth: 1e-3 }));
    let broken = with(three(), Complex::new(f64::NAN, 50.0), Complex::new(0.0, 1e-3));
    assert_eq!(broken.random(&PowerSpectrum::band(1.0..=9.0, 1.0).unwrap()), Err(RandomError::Overflow));
    let still = empty::<f64>().random(&PowerSpectrum::white(1.0)).unwrap();
    assert_eq!((still.rms, still.up_crossings_hertz()), (0.0, None));
    assert_eq!(empty::<f64>().random(&PowerSpectrum::band(0.0..=1.0, 1.0).unwrap()).unwrap().rms, 0.0);
}

#[test]
fn many_modes() {
    for spread in [5.0, 1e-3, 1e-9] {
        let modes: Vec<_> = (0..200)
            .map(|k| {
                let k = f64::from(k);
                (20.0 + spread * k, 0.005 + 0.01 * (k * 0.37).sin().abs(), 1e-4 * (k * 1.7).cos() / (1.0 + k))
            })
            .collect();
        let response = of_modes(&modes);
        let rows = [(15.0, 1.0), (50.0, 10.0), (80.0, 10.0)];
        let found = response.random(&PowerSpectrum::hertz(&rows).unwrap()).unwrap();
        // the same by other segments
        let finer = [(15.0, 1.0), (19.0, response_level(&rows, 19.0)), (50.0, 10.0), (51.3, 10.0), (80.0, 10.0)];
        let again = response.random(&PowerSpectrum::hertz(&finer).unwrap()).unwrap();
        assert!((found.rms / again.rms - 1.0).abs() < 1e-14, "{spread}: {found:?} {again:?}");
        if spread < 1.0 {
            compare(&std::format!("{spread}"), &response, &[(19.0, 1.0), (21.0, 2.0)], 1e-12);
        }
    }
}

fn response_level(rows: &Rows, hertz: f64) -> f64 {
    PowerSpectrum::hertz(rows).unwrap().at(hertz)
}

/// In double-doubles all digits are those of double-doubles: of other segments, and of white noise.
#[test]
fn more_digits() {
    let response = in_wide(&three());
    let [start, end, level] = [5.0, 500.0, 2.0].map(wide);
    let whole = response.random(&PowerSpectrum::band(start..=end, level).unwrap()).unwrap();
    let rows = [(start, level), (wide(13.0), level), (wide(71.0), level), (end, level)];
    let parts = response.random(&PowerSpectrum::hertz(&rows).unwrap()).unwrap();
    assert!((whole.rms / parts.rms - wide(1.0)).size() < 1e-29, "{whole:?} {parts:?}");
    let noise = response.random(&PowerSpectrum::white(level)).unwrap();
    let all = response.random(&PowerSpectrum::band(wide(0.0)..=wide(1e14), level).unwrap()).unwrap();
    assert!((noise.rms / all.rms - wide(1.0)).size() < 1e-29, "{noise:?} {all:?}");
}
