//! Members against many digits: no entry, force, flexibility or minor is outside of its ball.

use crate::proof::ball::Ball;
use crate::proof::bending::{Bending, bending};
use crate::proof::four_words::FourWords;
use crate::proof::level::Level;
use crate::proof::line::{Line, line};
use crate::proof::member::{Member, place};
use crate::proof::number::{OneWord, TwoWords};
use crate::proof::tests::exact::{Exact, Exactly, exact, fourth_root, pi, share, size, word};
use crate::proof::tests::random::Random;
use std::sync::OnceLock;
use std::vec::Vec;

/// A member in many digits: its stiffness, the border `v`, σ before and after a part of `v vᵀ` is left in the matrix, and the minor.
pub(super) struct Oracle<const F: usize, const E: usize> {
    pub(super) stiffness: [Exact; E],
    pub(super) forces: [Exact; F],
    pub(super) flexibility: Exact,
    pub(super) kappa: Exact,
    pub(super) minor: Exact,
}

/// The bending of a beam, with all functions times `2e^-z`.
pub(super) fn exact_bending(x: &Exact) -> Oracle<4, 10> {
    let z = fourth_root(x);
    let (s, c) = z.sin_cos();
    let decay = (-&z).exp();
    let square = &decay * &decay;
    let (ch, sh, o) = (exact(1.0) + &square, exact(1.0) - &square, exact(2.0) * &decay);
    let minor = &o - &ch * &c;
    let (z2, z3) = (&z * &z, &z * &z * &z);
    let b = &z3 * (&ch * &s + &sh * &c);
    let f = &z2 * (&sh * &s);
    let d = &z * (&ch * &s - &sh * &c);
    let t = &z3 * (&sh + &o * &s);
    let u = &z2 * (&ch - &o * &c);
    let v = &z * (&sh - &o * &s);
    let over = |entry: &Exact| entry / &minor;
    Oracle {
        stiffness: [
            over(&b),
            over(&f),
            over(&d),
            -over(&t),
            -over(&u),
            over(&b),
            over(&u),
            over(&v),
            -over(&f),
            over(&d),
        ],
        flexibility: &b * &minor,
        forces: [b, f, -t, u],
        kappa: z3,
        minor: minor / (&z2 * &z2),
    }
}

/// A line of x > 0.
pub(super) fn exact_line(x: &Exact) -> Oracle<2, 3> {
    if *x < exact(0.0) {
        return exact_stiff_line(x);
    }
    let z = x.sqrt();
    let (s, c) = z.sin_cos();
    let own = &z * &c / &s;
    Oracle {
        stiffness: [own.clone(), -(&z / &s), own],
        flexibility: &z * &c * &s,
        forces: [&z * &c, -z.clone()],
        minor: &s / &z,
        kappa: z,
    }
}

fn exact_stiff_line(x: &Exact) -> Oracle<2, 3> {
    let z = (-x).sqrt();
    let decay = (-&z).exp();
    let sinh = exact(1.0) - &decay * &decay;
    let own = &z * (exact(1.0) + &decay * &decay) / &sinh;
    Oracle {
        stiffness: [own.clone(), -(&z * exact(2.0) * &decay / &sinh), own],
        flexibility: exact(0.0),
        forces: [exact(0.0), exact(0.0)],
        minor: sinh / &z,
        kappa: z,
    }
}

/// Most that entries use of their radii: without a border, and with one.
type Used = [f64; 2];

/// Notes what a member uses at an argument; returns whether it says anything.
fn compare<N: Exactly, const F: usize, const E: usize>(
    member: &Member<N, F, E>,
    oracle: &Oracle<F, E>,
    at: f64,
    used: &mut Used,
) -> bool {
    let mut note = |k: usize, ball: Ball<N>, expected: &Exact, what: usize| {
        let share = share(ball, expected);
        assert!(share <= 1.0, "{}: {what} at {at:e}, border {k}, {ball:?} uses {share}", N::NAME);
        used[k] = used[k].max(share);
    };
    match member.border {
        None => {
            for (index, entry) in member.stiffness.iter().enumerate() {
                note(0, *entry, &oracle.stiffness[index], index);
            }
        }
        Some(border) => {
            for row in 0..F {
                note(1, border.forces[row], &oracle.forces[row], 100 + row);
            }
            let flexibility = &oracle.flexibility / (exact(1.0) - &oracle.flexibility / &oracle.kappa);
            note(1, border.flexibility, &flexibility, 200);
            for row in 0..F {
                for column in 0..=row {
                    let index = place(row, column);
                    let product = &oracle.forces[row] * &oracle.forces[column];
                    let rest = &oracle.stiffness[index] - product / &flexibility;
                    note(1, member.stiffness[index], &rest, index);
                }
            }
        }
    }
    // the factor of Δ decides nothing, but its sign is that of the minor; a border has a pivot of its own
    let own = member.border.map_or(Ball::of(-1.0), |border| border.flexibility);
    let is_known = member.stiffness.iter().all(|entry| entry.rad < f64::INFINITY);
    if is_known && (own.is_positive() || own.is_negative()) {
        assert!(-own.mid.leading() * member.minor * word(&oracle.minor) > 0.0, "{}: Δ at {at:e}", N::NAME);
    }
    is_known
}

/// Arguments z: random decades, the nearest ones to kπ/2 and to what is given, and both sides of 1.
fn arguments(random: &mut Random, runs: usize, power: i32, poles: &[Exact]) -> Vec<f64> {
    let to_power = |z: &Exact| word(&(0..power).fold(exact(1.0), |product, _| product * z));
    let mut all: Vec<f64> = (0..runs).map(|_| 10f64.powf(-6.0 + 11.0 * random.unit()).powi(power)).collect();
    let half_pi = pi() / exact(2.0);
    for count in 0..runs / 4 {
        let k = if count < 5 { count + 1 } else { 1 + random.below(60_000) };
        let near = to_power(&(&half_pi * exact(k as f64)));
        all.extend([near, near.next_up(), near.next_down()]);
        // the borders begin here
        all.push(near * (1.0 + 2.1e-3 * random.signed() / k as f64));
    }
    for pole in &poles[..poles.len().min(runs / 4)] {
        let near = to_power(pole);
        all.extend([near, near.next_up(), near.next_down(), near * (1.0 + 3e-3 * random.signed())]);
    }
    all.extend([1.0, 1.0f64.next_down(), 1.0f64.next_up(), 0.999_999, 1.000_001]);
    all
}

/// What numbers of one kind use of their radii, and how often nothing is known.
#[derive(Default)]
struct Uses {
    beam: (Used, usize),
    line: (Used, usize),
}

impl Uses {
    fn beam<N: Level<Word = f64> + Exactly>(&mut self, x: f64, oracle: &Oracle<4, 10>) {
        let member: Bending<N> = bending(Ball::of(x));
        self.beam.1 += usize::from(!compare(&member, oracle, x, &mut self.beam.0));
    }

    fn line<N: Level<Word = f64> + Exactly>(&mut self, x: f64, oracle: &Oracle<2, 3>) {
        let member: Line<N> = line(Ball::of(x));
        self.line.1 += usize::from(!compare(&member, oracle, x, &mut self.line.0));
    }

    fn tell<N: Exactly>(&self) {
        for (what, (used, unknown)) in [("beams", self.beam), ("lines", self.line)] {
            std::println!("{}: {what} use {used:.3?} of their radii; {unknown} unknown", N::NAME);
            assert!(unknown == 0 || N::SUM > 1e-20);
        }
    }
}

fn check(runs: usize) {
    let mut random = Random::new(6);
    let mut uses = [Uses::default(), Uses::default(), Uses::default()];
    for x in arguments(&mut random, runs, 4, poles()) {
        let oracle = exact_bending(&exact(x));
        uses[0].beam::<OneWord>(x, &oracle);
        uses[1].beam::<TwoWords<f64>>(x, &oracle);
        uses[2].beam::<FourWords>(x, &oracle);
    }
    for x in arguments(&mut random, runs, 2, &[]).into_iter().flat_map(|x| [x, -x]) {
        let oracle = exact_line(&exact(x));
        uses[0].line::<OneWord>(x, &oracle);
        uses[1].line::<TwoWords<f64>>(x, &oracle);
        uses[2].line::<FourWords>(x, &oracle);
    }
    uses[0].tell::<OneWord>();
    uses[1].tell::<TwoWords<f64>>();
    uses[2].tell::<FourWords>();
}

/// Number of poles that are listed.
pub(super) const POLES: usize = 16;

/// The first roots of `1 = ch z cos z`: those of `cos z = 1/ch z` beside `kπ + π/2`, one in each `[kπ, kπ + π]`.
pub(super) fn poles() -> &'static [Exact] {
    static ALL: OnceLock<Vec<Exact>> = OnceLock::new();
    ALL.get_or_init(found)
}

fn found() -> Vec<Exact> {
    let pi = pi();
    (1..=POLES)
        .map(|k| {
            let mut z = &pi * exact(k as f64 + 0.5);
            for _ in 0..7 {
                let (s, c) = z.sin_cos();
                let square = (exact(-2.0) * &z).exp();
                let inverse = exact(2.0) * (-&z).exp() / (exact(1.0) + &square);
                let tangent = (exact(1.0) - &square) / (exact(1.0) + &square);
                z += (c - &inverse) / (s - inverse * tangent);
            }
            let (_, c) = z.sin_cos();
            let off = c * (z.exp() + (-&z).exp()) - exact(2.0);
            assert!(size(&off) < 1e-100, "{k}");
            z
        })
        .collect()
}

#[test]
fn members_are_in_their_balls() {
    check(30);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_members_are_in_their_balls() {
    check(4_000);
}

/// All numbers of a wide ball: its ends and its middle.
fn check_wide<N: Level<Word = f64> + Exactly>(runs: usize) {
    let mut random = Random::new(8);
    let mut used = Used::default();
    let all = arguments(&mut random, runs, 4, poles());
    for x in all.into_iter().filter(|x| *x < 1e9) {
        let rad = x * 10f64.powf(-16.0 * random.unit());
        let ball = Ball { mid: N::of(x), rad };
        let (beam, rod): (Bending<N>, Line<N>) = (bending(ball), line(ball));
        for part in [-1.0, -0.5, 0.0, 0.5, 1.0] {
            let at = exact(x) + exact(rad) * exact(part);
            if word(&at) > 0.0 {
                compare(&beam, &exact_bending(&at), x, &mut used);
                compare(&rod, &exact_line(&at), x, &mut used);
            }
        }
    }
}

#[test]
fn members_of_wide_balls_are_in_their_balls() {
    check_wide::<OneWord>(8);
    check_wide::<TwoWords<f64>>(8);
}
