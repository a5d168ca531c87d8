//! A tapered beam in short pieces: each has a bound of its stiffness, and no frequency below with both ends held.
//!
//! A piece of the length Δ begins where the bending stiffness is EI. In units of both, its state at the share s obeys
//!
//! ```text
//! y' = θ     E θ' = m     m' = G θ + q     q' = P y     E = (1 + βs)(1 + ηs)³
//! ```
//!
//! Here `G = (N - r ω²) Δ²/EI` has degree 4, and `P = (m (ω² + Ω² sin² ψ) - k) Δ⁴/EI` has degree 2. The state is a Taylor series in s.
//!
//! Limits. `|p|` is the sum of `|p_j| ρ^j` over the coefficients of a polynomial p, with `ρ = 4`. A piece is short where, for all ω of the
//! lanes, `|βρ|, |ηρ| <= 1/2`, `|G| <= 8` and `|G|/39.4 + |P|/500 <= 0.58`. All sections are such that short pieces obey both theorems.
//!
//! Rest of the series. For all orders k, `|y_k| <= C ρ^-k/16`, `|θ_k| <= C ρ^-k`, `|m_k| <= C ρ^-k`, `|q_k| <= 8 C ρ^-k`. *Proof*: C is
//! read off the orders below 64. Let it hold below n, with `n >= 64`. Then `ρ/n <= 1/16 = a`. The series of `1/E` is bounded, term by
//! term, by that of `1/((1 - |β|s)(1 - |η|s)³)`. That is `F <= 16` at ρ. In units of `C ρ^-n` the order n is bounded so:
//! y by `a·1 = 1/16`, θ by `a F·1 <= 1`, m by `a (|G|·1 + 8) <= 1`, and q by `a |P|/16 <= 8`, since `|P| <= 290`. ∎
//!
//! No frequency. With both ends held, `∫ E y''² + G y'² - P y²` is positive unless y is zero. *Proof*: `∫ y''² >= 39.4 ∫ y'²` (4π², the
//! column) and `>= 500 ∫ y²` (4.73⁴, the beam). On [0, 1] `E >= (7/8)⁴ > 0.586`, and G and P are no larger than `|G|` and `|P|`. ∎
//! The number of frequencies below is the number of negative squares of this form, for ω² of either sign.

use crate::proof::ball::Ball;
use crate::proof::functions::Level;
use crate::proof::member::Member;
use crate::proof::number::Number;
use crate::proof::word::Word;

/// The parameters of a [tapered beam](crate::elements::TaperedBeam), each the exact sum of two words.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TaperedSection {
    pub(crate) length: [f64; 2],
    pub(crate) bending_stiffness: [f64; 2],
    pub(crate) mass_per_length: [f64; 2],
    pub(crate) width_taper: [f64; 2],
    pub(crate) height_taper: [f64; 2],
    pub(crate) rotary_inertia: [f64; 2],
    pub(crate) axial_force: [f64; 2],
    pub(crate) rotation_speed: [f64; 2],
    pub(crate) hub_radius: [f64; 2],
    pub(crate) setting_angle: [f64; 2],
    pub(crate) foundation_stiffness: [f64; 2],
}

/// The radius ρ of the limits.
const RADIUS: f64 = 4.0;
/// Limits of `|β|` and `|η|`, of `|G|` less a little, and of `|G|/39.4 + |P|/500`.
const MOST_TAPER: f64 = 0.125;
const MOST_FORCE: f64 = 8.0 - 1e-9;
const MOST_LOAD: f64 = 0.58;
/// The bounds of y, θ, m and q over `C ρ^-k`.
const WEIGHTS: [f64; 4] = [0.0625, 1.0, 1.0, 8.0];
/// The order from which on the rest of the series is bounded, and that at which it ends whatever the rest is.
const LEAST_ORDER: usize = 64;
const MOST_ORDER: usize = 160;
/// Places along the beam are whole numbers of such parts: they and their sums and halves are exact in a word.
const PARTS: u64 = 1 << 48;
const LEAST_PARTS: u64 = 16;
const MOST_PIECES: usize = 4096;

/// Calls `each` for the pieces of a beam from input to output, over the displacements `y1, θ1, y2, θ2`, at ω² of either sign. They are the
/// same in all lanes. None where they would be too many, or a number leaves the range: what was called before is of no use then.
pub(crate) fn pieces<N: Level>(
    section: &TaperedSection,
    square: Ball<N>,
    each: &mut dyn FnMut(Member<N, 4, 10>),
) -> Option<()> {
    let [sin, _] = Ball::<N>::of_pair(section.setting_angle).sin_cos();
    let turned = Ball::of_pair(section.rotation_speed) * sin;
    let beam = Beam { section, square, of_mass: square + turned * turned };
    let (mut start, mut width) = (0, PARTS);
    for _ in 0..MOST_PIECES {
        let rest = PARTS - start;
        width += width / 2;
        let piece = loop {
            // two pieces share what one cannot reach: none is far shorter than the one before
            width = if width < rest { width.min(rest.div_ceil(2)) } else { rest };
            let piece = beam.piece(start as f64 / PARTS as f64, width as f64 / PARTS as f64);
            if piece.is_short() {
                break piece;
            }
            width -= width / 4;
            if width < LEAST_PARTS {
                return None;
            }
        };
        each(piece.member());
        start += width;
        if start == PARTS {
            return Some(());
        }
    }
    None
}

/// A beam at a frequency, with `ω² + Ω² sin² ψ`.
struct Beam<'s, N: Number> {
    section: &'s TaperedSection,
    square: Ball<N>,
    of_mass: Ball<N>,
}

impl<N: Level> Beam<'_, N> {
    /// Width, height and position from the axis at a share, as means of those at the ends: of positive numbers no digits are lost.
    fn at(&self, share: f64) -> [Ball<N>; 3] {
        let TaperedSection { width_taper, height_taper, hub_radius, length, .. } = *self.section;
        let (one, hub) = (Ball::of(1.0), Ball::of_pair(hub_radius));
        let [width, height] = [width_taper, height_taper].map(|taper| one - Ball::of_pair(taper));
        let mean = |inner, outer| inner * Ball::of(1.0 - share) + outer * Ball::of(share);
        [mean(one, width), mean(one, height), mean(hub, hub + Ball::of_pair(length))]
    }

    /// The piece of a width at a share.
    fn piece(&self, start: f64, width: f64) -> Piece<N> {
        let (section, one) = (self.section, Ball::of(1.0));
        let [b, h, radius] = self.at(start);
        let [b_change, h_change] = [section.width_taper, section.height_taper].map(|c| -Ball::of_pair(c) * Ball::of(width));
        let (beta, eta) = (b_change * b.inverse(), h_change * h.inverse());
        let area: [_; 3] = product(&[one, beta], &[one, eta]);
        let bending: [_; 5] = product(&area, &product::<N, 3>(&[one, eta], &[one, eta]));
        let whole = Ball::of_pair(section.length);
        let length = whole * Ball::of(width);
        let shape = b * h * (h * h);
        let stiffness = Ball::of_pair(section.bending_stiffness) * shape;
        let (along, speed) = (length * length * stiffness.inverse(), Ball::of_pair(section.rotation_speed));
        let (across, mass) = (along * (length * length), Ball::of_pair(section.mass_per_length));
        // Ω² times the integral of m (R + x) up to the output end, a cubic: Simpson's rule is exact
        let (centrifugal, over) = (speed * speed * mass, |n: usize| Ball::of(n as f64).inverse());
        let pull = |share| self.at(share).into_iter().fold(centrifugal, |product, factor| product * factor);
        let sum = pull(start) + pull(0.5 + 0.5 * start).scaled(4.0) + pull(1.0);
        let force = Ball::of_pair(section.axial_force) + whole * Ball::of(1.0 - start) * over(6) * sum;
        let rotary = Ball::of_pair(section.rotary_inertia) * shape * self.square;
        // what the force loses along the piece
        let losses: [_; 4] = product(&area, &[radius, length]).map(|term| centrifugal * (b * h) * length * term);
        let forces = [0, 1, 2, 3, 4].map(|k| if k == 0 { force } else { -(losses[k - 1] * over(k)) });
        let g = [0, 1, 2, 3, 4].map(|k| (forces[k] - rotary * bending[k]) * along);
        let mut p = area.map(|term| mass * (b * h) * term * self.of_mass);
        p[0] = p[0] - Ball::of_pair(section.foundation_stiffness);
        Piece { length, stiffness, beta, eta, g, p: p.map(|term| term * across) }
    }
}

/// The product of two polynomials.
fn product<N: Level, const C: usize>(first: &[Ball<N>], second: &[Ball<N>]) -> [Ball<N>; C] {
    let mut product = [Ball::of(0.0); C];
    for (place, factor) in first.iter().enumerate() {
        for (term, other) in product[place..].iter_mut().zip(second) {
            *term = *term + *factor * *other;
        }
    }
    product
}

/// A piece: Δ, EI, β, η and the coefficients of G and P.
struct Piece<N: Number> {
    length: Ball<N>,
    stiffness: Ball<N>,
    beta: Ball<N>,
    eta: Ball<N>,
    g: [Ball<N>; 5],
    p: [Ball<N>; 3],
}

impl<N: Level> Piece<N> {
    /// Whether the piece is within the limits, in all lanes.
    fn is_short(&self) -> bool {
        let word = N::Word::of;
        let norm = |p: &[Ball<N>]| p.iter().rev().fold(word(0.0), |sum, term| sum * word(RADIUS) + term.largest());
        let (force, inertia) = (norm(&self.g), norm(&self.p));
        let load = force * word(1.0 / 39.4) + inertia * word(1.0 / 500.0);
        let limits = [self.beta, self.eta].map(|change| (change.largest(), MOST_TAPER));
        let is_below = |(size, most): (N::Word, f64)| N::Word::all(size.is_less(word(most)));
        limits.into_iter().chain([(force, MOST_FORCE), (load, MOST_LOAD)]).all(is_below)
    }

    /// The stiffness. Displacements `z = (y, θ)` and forces `p = (-q, m)` obey `z₂ = A z₁ + B p₁` and `p₂ = C z₁ + D p₁`: it is
    /// `[[B⁻¹A, -B⁻¹], [-B⁻ᵀ, D B⁻¹]]`, in units `EI/Δ` and as many `1/Δ` as it has deflections.
    fn member(&self) -> Member<N, 4, 10> {
        let [y, t, p, m] = self.columns([(0, 1.0), (1, 1.0), (3, -1.0), (2, 1.0)]);
        let minor = |u: [Ball<N>; 4], v: [Ball<N>; 4], i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        let det = minor(p, m, 0, 1);
        let over = self.length.inverse();
        let rotation = self.stiffness * over * det.inverse();
        let [mixed, across] = [rotation * over, rotation * over * over];
        let stiffness = [
            across * minor(y, m, 0, 1),
            mixed * minor(p, y, 0, 1),
            rotation * minor(p, t, 0, 1),
            -(across * m[1]),
            mixed * p[1],
            across * minor(p, m, 1, 3),
            mixed * m[0],
            -(rotation * p[0]),
            mixed * minor(p, m, 2, 1),
            rotation * minor(p, m, 0, 2),
        ];
        let sizes = [[0, 3], [2, 7], [5, 3], [9, 7]].map(|of| {
            let [own, between] = of.map(|k: usize| stiffness[k].mid.size().first());
            own.max(between)
        });
        let flexibility = self.length.mid.leading() * self.length.mid.leading() / self.stiffness.mid.leading();
        let minor = det.mid.leading() * flexibility * flexibility;
        Member { stiffness, border: None, held: [N::Word::of(0.0); 2], minor, sizes }
    }

    /// The states at the other end that are one unit at this one.
    fn columns(&self, units: [(usize, f64); 4]) -> [[Ball<N>; 4]; 4] {
        let word = N::Word::of;
        let mut series = units.map(|(number, unit)| {
            let mut terms = [[Ball::of(0.0); 4]; 5];
            terms[0][number] = Ball::of(unit);
            // 1 is within the weights of 16
            Series { terms, sum: terms[0], bends: [Ball::of(0.0); 4], most: word(16.0) }
        });
        let mut power = 1.0;
        for order in 1..MOST_ORDER {
            power *= RADIUS;
            let over = Ball::of(order as f64).inverse();
            series.iter_mut().for_each(|series| series.extend(self, over, power));
            let is_small = |series: &Series<N>| N::Word::all((series.most * word(1.0 / power)).is_less(word(0.02 * N::SUM)));
            if order >= LEAST_ORDER && series.iter().all(is_small) {
                break;
            }
        }
        // Σ ρ^-k over the orders beyond is a third of the last
        series.map(|Series { sum, most, .. }| {
            [0, 1, 2, 3].map(|k| sum[k].widened(most * word(0.34 * WEIGHTS[k] / power)))
        })
    }
}

/// The Taylor series of a state.
struct Series<N: Number> {
    /// The last terms, the newest first.
    terms: [[Ball<N>; 4]; 5],
    sum: [Ball<N>; 4],
    /// The last terms of m over the first factors of E.
    bends: [Ball<N>; 4],
    /// C
    most: N::Word,
}

impl<N: Level> Series<N> {
    /// Adds the next term, given the inverse of its order and a power of ρ.
    fn extend(&mut self, piece: &Piece<N>, over: Ball<N>, power: f64) {
        let [_, theta, mut bend, q] = self.terms[0];
        for (last, change) in self.bends.iter_mut().zip([piece.beta, piece.eta, piece.eta, piece.eta]) {
            *last = bend - change * *last;
            bend = *last;
        }
        let times = |polynomial: &[Ball<N>], number: usize| {
            polynomial.iter().zip(&self.terms).fold(Ball::of(0.0), |sum, (factor, term)| sum + *factor * term[number])
        };
        let next = [theta, bend, q + times(&piece.g, 1), times(&piece.p, 0)].map(|slope| slope * over);
        self.terms.rotate_right(1);
        self.terms[0] = next;
        for k in 0..4 {
            self.sum[k] = self.sum[k] + next[k];
            self.most = self.most.or_larger(next[k].largest() * N::Word::of(power / WEIGHTS[k]));
        }
    }
}
