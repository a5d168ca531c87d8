//! Discs about eigenvalues that are known in many digits: they hold them, and no disc beside one is proven, or one that holds two.

use crate::element::{DampingNumbers, MemberNumbers, OwnPart};
use crate::model::Spot;
use crate::proof::disc::complex::ComplexBall;
use crate::proof::disc::eigenvalue::{MOST, ProvenDisc, examined, proven_disc};
use crate::proof::disc::memory::examine_in;
use crate::proof::number::{Number, OneWord};
use crate::proof::tests::discs::closed_forms::Row;
use crate::proof::tests::discs::exact_complex::ExactComplex;
use crate::proof::tests::exact::word;
use crate::proof::tests::random::Random;
use crate::proof::visit::{Visited, Visitor};
use crate::{Space, Support};
use core::f64::consts::TAU;
use num_complex::Complex;
use std::vec::Vec;

/// Half waves of the eigenvalues about which discs are tried; others are farther away than any disc is wide.
const HALF_WAVES: usize = 6;

fn rounded(number: &ExactComplex) -> Complex<f64> {
    Complex::new(word(&number.re), word(&number.im))
}

fn distance(number: &ExactComplex, other: Complex<f64>) -> f64 {
    (number - &ExactComplex::of(other.re, other.im)).size()
}

/// What became of discs.
#[derive(Debug, Default)]
struct Tally {
    simple: usize,
    proven: usize,
    /// Of these the ones of no more than an eps.
    within: usize,
    /// Discs without an eigenvalue.
    tried: usize,
    /// In one word: radii, and the largest part of one that the eigenvalue is away.
    rounded: usize,
    used: f64,
}

impl Tally {
    /// The disc about an estimate that is some steps off.
    fn try_true(&mut self, row: &Row, exact: &ExactComplex, random: &mut Random) {
        let lambda = rounded(exact);
        let unit = f64::EPSILON * lambda.norm();
        let off = Complex::from_polar(unit * 10f64.powf(3.0 * random.unit()), TAU * random.unit());
        // a part that is zero stays zero
        let off =
            Complex::new(if lambda.re == 0.0 { 0.0 } else { off.re }, if lambda.im == 0.0 { 0.0 } else { off.im });
        self.simple += 1;
        let Some(ProvenDisc { centre, radius }) = proven_disc(row, lambda + off, 1e-9 * lambda.norm()) else { return };
        self.proven += 1;
        self.within += usize::from(radius <= unit);
        assert!(distance(exact, centre) <= radius, "{radius:e} about {centre}: {exact:?} of {row:?}");
    }

    /// Discs about other centres.
    fn try_false(&mut self, row: &Row, lambda: Complex<f64>, all: &[ExactComplex], random: &mut Random) {
        let modulus = lambda.norm();
        for radius in [f64::EPSILON, MOST * f64::EPSILON, 1e-12, 1e-9, 1e-6].map(|share| share * modulus) {
            for away in [1.06, 1.5, 10.0] {
                let away = away * radius + 0.3 * f64::EPSILON * modulus;
                let centre = lambda + Complex::from_polar(away, TAU * random.unit());
                if all.iter().any(|other| distance(other, centre) < 1.03 * radius) {
                    continue;
                }
                self.tried += 1;
                let found = examined(row, centre, radius).and_then(|found| found.radius);
                assert!(found.is_none(), "no eigenvalue within {radius:e} of {centre}: {found:?} of {row:?}");
            }
        }
    }

    /// Radii in one word, where roundings show: about a centre that is off by about as much as these make of it.
    fn try_rounded(&mut self, row: &Row, exact: &ExactComplex, random: &mut Random) {
        let lambda = rounded(exact);
        let modulus = lambda.norm();
        for _ in 0..6 {
            let away = modulus * 10f64.powf(-16.0 + 3.0 * random.unit());
            let centre = lambda + Complex::from_polar(away, TAU * random.unit());
            let ball = ComplexBall::exactly(OneWord::of(centre.re), OneWord::of(centre.im));
            let Ok(found) = examine_in::<OneWord>(row, ball, 1e-8 * modulus) else { continue };
            let Some(radius) = found.radius else { continue };
            self.rounded += 1;
            self.used = self.used.max(distance(exact, centre) / radius);
            assert!(distance(exact, centre) <= radius, "{radius:e} about {centre}: {exact:?} of {row:?}");
        }
    }
}

fn campaign(seeds: core::ops::Range<u64>, enough: usize) {
    let mut tally = Tally::default();
    for seed in seeds {
        let mut random = Random::new(seed);
        let row = Row::new(&mut random);
        let all = row.eigenvalues(HALF_WAVES + 3);
        let near = row.eigenvalues(HALF_WAVES);
        for exact in near.iter().filter(|_| random.below(3) == 0).collect::<Vec<_>>() {
            let lambda = rounded(exact);
            // multiple ones, or nearly, are not looked at
            if all.iter().filter(|other| distance(other, lambda) < 1e-3 * lambda.norm()).count() > 1 {
                continue;
            }
            tally.try_true(&row, exact, &mut random);
            tally.try_false(&row, lambda, &all, &mut random);
            tally.try_rounded(&row, exact, &mut random);
        }
        if tally.tried >= enough {
            break;
        }
    }
    std::println!("{tally:?}");
    assert!(tally.tried >= enough, "too few discs");
    assert!(10 * tally.proven >= 9 * tally.simple && 10 * tally.within >= 9 * tally.proven, "too few are proven");
    assert!(tally.rounded >= tally.simple && tally.used > 0.2, "one word says too little");
}

#[test]
fn discs_hold_their_eigenvalue_and_no_false_one_is_proven() {
    campaign(0..400, 600);
}

#[test]
#[ignore = "long: .ci/long"]
fn no_false_disc_of_ten_thousand_is_proven() {
    campaign(1_000..20_000, 10_000);
}

/// Two oscillators of mass 1 with springs and dashpots, and a spring between them.
struct Pair {
    springs: [f64; 2],
    dashpots: [f64; 2],
    between: f64,
}

impl Visited for Pair {
    fn visit(&self, visitor: &mut dyn Visitor) {
        let spring = |k: usize| {
            let damping = DampingNumbers { viscous: [self.dashpots[k], 0.0], ..DampingNumbers::default() };
            MemberNumbers::Spring(0, [self.springs[k], 0.0]).damped(damping)
        };
        let mass = MemberNumbers::mass([1.0, 0.0]);
        let parts = [spring(0), mass, MemberNumbers::Spring(0, [self.between, 0.0]), mass, spring(1)];
        visitor.tip(0, Support::Fixed);
        parts.iter().enumerate().for_each(|(k, part)| visitor.element(k + 1, k, Space::Translation, part));
        visitor.root(parts.len(), Support::Fixed);
    }

    fn spot(&self, place: usize) -> Spot {
        Spot::Step(place)
    }

    fn own_part(&self, _: usize, _: [f64; 2]) -> Option<OwnPart> {
        None
    }
}

impl Pair {
    /// The eigenvalues of the upper half plane: roots of `(λ² + c₁λ + k₁ + b)(λ² + c₂λ + k₂ + b) = b²`.
    fn eigenvalues(&self) -> [Complex<f64>; 2] {
        let factor = |lambda: Complex<f64>, k: usize| {
            let stiffness = self.springs[k] + self.between;
            (lambda * (lambda + self.dashpots[k]) + stiffness, lambda * 2.0 + self.dashpots[k])
        };
        [0, 1].map(|k| {
            let start = self.springs[k] + self.between * if k == 0 { 0.3 } else { 1.7 };
            (0..60).fold(Complex::new(-0.5 * self.dashpots[k], start.sqrt()), |lambda, _| {
                let ((a, slope), (b, other)) = (factor(lambda, 0), factor(lambda, 1));
                lambda - (a * b - self.between * self.between) / (slope * b + a * other)
            })
        })
    }

    fn radius(&self, centre: Complex<f64>, most: f64) -> Option<f64> {
        examined(self, centre, most).and_then(|found| found.radius)
    }
}

/// A disc about one of two close eigenvalues is proven up to a part of their distance, and none that holds both.
#[test]
fn discs_do_not_hold_both_of_a_close_pair() {
    for between in [1e-1, 1e-2, 1e-4, 1e-6] {
        let pair = Pair { springs: [1.0; 2], dashpots: [0.2; 2], between };
        // λ² + 0.2 λ + 1 + (0 or 2 between) = 0
        let exact = [1.0, 1.0 + 2.0 * between].map(|stiffness: f64| Complex::new(-0.1, (stiffness - 0.01).sqrt()));
        let distance = (exact[1] - exact[0]).norm();
        for (own, other) in [(exact[0], exact[1]), (exact[1], exact[0])] {
            for part in [1.01, 1.2, 2.0, 4.0] {
                let found = pair.radius(own, part * distance);
                assert!(found.is_none(), "two are within {part} of their distance {distance:e}: {found:?}");
                let found = pair.radius(own + (other - own) * 0.5, 0.55 * part * distance);
                assert!(found.is_none(), "two are about their middle: {found:?}");
            }
            let found = pair.radius(own, 1e-4 * distance);
            assert!(found.is_some_and(|radius| radius < 1e-12 * distance + 1e-15), "{between}: {found:?}");
        }
    }
}

/// Discs so wide that slope and shape change on them, with the eigenvalue just outside.
#[test]
fn wide_discs_beside_an_eigenvalue_are_not_proven() {
    let mut proven = 0;
    for between in [0.0, 0.03, 0.2, 1.0] {
        for dashpots in [[0.2, 0.2], [0.0, 0.6], [0.5, 0.01]] {
            let pair = Pair { springs: [1.0, 1.3], dashpots, between };
            for lambda in pair.eigenvalues() {
                for radius in [2e-2, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5].map(|share| share * lambda.norm()) {
                    proven += usize::from(pair.radius(lambda, radius).is_some());
                    for turn in 0..24 {
                        let centre = lambda + Complex::from_polar(radius * (1.0 + 1e-7), TAU * f64::from(turn) / 24.0);
                        let found = pair.radius(centre, radius);
                        assert!(found.is_none(), "{lambda} is not within {radius:e} of {centre}: {found:?}");
                    }
                }
            }
        }
    }
    // of 144 discs about eigenvalues
    assert!(proven > 40, "{proven}");
}
