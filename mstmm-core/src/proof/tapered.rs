//! A tapered beam in short pieces: each has a bound of its stiffness, and no frequency below with both ends held.
//!
//! A piece of the length Δ begins where the bending stiffness is EI. In units of both, its state at the share s obeys
//!
//! ```text
//! y' = θ     E θ' = m     m' = G θ + q     q' = P y     E = (1 + βs)(1 + ηs)³
//! ```
//!
//! Here `G = (N - r ω²) Δ²/EI` has degree 4, and `P = (m (ω² + Ω² sin² ψ) - k) Δ⁴/EI` has degree 2.
//!
//! Limits. `|p|` is the sum of `|p_j| ρ^j` over the coefficients of a polynomial p, where `ρ = 4`. A piece is short where, for all lanes,
//! `|β|, |η| <= 1/8`, `|G| <= 8` and `|G|/39.4 + |P|/500 <= 0.58`. Any beam can be cut into short pieces.
//!
//! No frequency: with both ends held, `∫ E y''² + G y'² - P y²` is positive unless y is zero. *Proof*. On [0, 1] E is at least
//! `(7/8)⁴ > 0.586`, and G and P are no larger in size than `|G|` and `|P|`. A held column has `∫ y''² >= 4π² ∫ y'²`, more than 39.4. A held
//! beam has `∫ y''² >= 4.73⁴ ∫ y²`, more than 500. ∎ The number of frequencies below is that of the negative squares of this form, for ω²
//! of either sign.

use crate::element::TaperedNumbers;
use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::member::Member;
use crate::proof::number::Number;
use crate::proof::word::Word;

mod series;

/// The radius ρ.
const RADIUS: f64 = 4.0;
/// The limits of `|β|` and `|η|`, of `|G|`, and of `|G|/39.4 + |P|/500`. Some room is left for roundings.
const MOST_TAPER: f64 = 0.125;
const MOST_FORCE: f64 = 8.0 - 1e-9;
const MOST_LOAD: f64 = 0.58;
/// Places along the beam are whole numbers of such parts: they and their sums and halves are exact in a word.
const PARTS: u64 = 1 << 48;
const LEAST_PARTS: u64 = 16;
const MOST_PIECES: usize = 1024;

/// Calls `each` for the pieces of a beam of a length from input to output, with whether it is the last one, over the displacements `y1, θ1, y2, θ2`, at ω² of either sign. The pieces
/// are the same in all lanes. None if they are too many or if a number leaves the range; the pieces before are of no use then.
pub(crate) fn pieces<N: Level>(
    section: (&TaperedNumbers, Ball<N>),
    square: Ball<N>,
    each: &mut dyn FnMut(Member<N, 4, 10>, bool),
) -> Option<()> {
    places(section, square, &mut |[start, width], member| each(member, start + width == 1.0))
}

/// The same with where a piece starts and how wide it is, in shares of the length: exact.
pub(in crate::proof) fn places<N: Level>(
    (section, whole): (&TaperedNumbers, Ball<N>),
    square: Ball<N>,
    each: &mut dyn FnMut([f64; 2], Member<N, 4, 10>),
) -> Option<()> {
    let [sin, _] = Ball::<N>::of_pair(section.setting_angle).sin_cos();
    let turned = Ball::of_pair(section.rotation_speed) * sin;
    let beam = Beam { section, whole, square, of_mass: square + turned * turned };
    let (mut start, mut width) = (0, PARTS);
    for _ in 0..MOST_PIECES {
        let rest = PARTS - start;
        width += width / 2;
        let (place, piece) = loop {
            // two pieces share what one cannot reach: none is far shorter than the one before
            width = if width < rest { width.min(rest.div_ceil(2)) } else { rest };
            let place = [start, width].map(|parts| parts as f64 / PARTS as f64);
            let piece = beam.piece(place);
            if piece.is_short() {
                break (place, piece);
            }
            width -= width / 4;
            if width < LEAST_PARTS {
                return None;
            }
        };
        each(place, piece.member());
        start += width;
        if start == PARTS {
            return Some(());
        }
    }
    None
}

/// A beam at a frequency, with `ω² + Ω² sin² ψ`.
struct Beam<'s, N: Number> {
    section: &'s TaperedNumbers,
    /// Its length.
    whole: Ball<N>,
    square: Ball<N>,
    of_mass: Ball<N>,
}

impl<N: Level> Beam<'_, N> {
    /// Width, height and position from the axis at a share, as means of those at the ends: of positive numbers no digits are lost.
    fn at(&self, share: f64) -> [Ball<N>; 3] {
        let TaperedNumbers { width_taper, height_taper, hub_radius, .. } = *self.section;
        let (one, hub) = (Ball::of(1.0), Ball::of_pair(hub_radius));
        let [width, height] = [width_taper, height_taper].map(|taper| one - Ball::of_pair(taper));
        let mean = |inner, outer| inner * Ball::of(1.0 - share) + outer * Ball::of(share);
        [mean(one, width), mean(one, height), mean(hub, hub + self.whole)]
    }

    /// The piece of a width at a share.
    fn piece(&self, [start, width]: [f64; 2]) -> Piece<N> {
        let (section, one) = (self.section, Ball::of(1.0));
        let [b, h, radius] = self.at(start);
        let [b_change, h_change] =
            [section.width_taper, section.height_taper].map(|c| -Ball::of_pair(c) * Ball::of(width));
        let (beta, eta) = (b_change * b.inverse(), h_change * h.inverse());
        let area: [_; 3] = product(&[one, beta], &[one, eta]);
        let bending: [_; 5] = product(&area, &product::<N, 3>(&[one, eta], &[one, eta]));
        let length = self.whole * Ball::of(width);
        let shape = b * h * (h * h);
        let stiffness = Ball::of_pair(section.bending_stiffness) * shape;
        let (along, speed) = (length * length * stiffness.inverse(), Ball::of_pair(section.rotation_speed));
        let (across, mass) = (along * (length * length), Ball::of_pair(section.mass_per_length));
        // Ω² times the integral of m (R + x) up to the output end, a cubic: Simpson's rule is exact
        let (centrifugal, over) = (speed * speed * mass, |n: usize| Ball::of(n as f64).inverse());
        let pull = |share| self.at(share).into_iter().fold(centrifugal, |product, factor| product * factor);
        let sum = pull(start) + pull(0.5 + 0.5 * start).scaled(4.0) + pull(1.0);
        let (load, rest) = (Ball::of_pair(section.axial_load), self.whole * Ball::of(1.0 - start));
        let force = Ball::of_pair(section.axial_force) + rest * load + rest * over(6) * sum;
        let rotary = Ball::of_pair(section.rotary_inertia) * shape * self.square;
        // what the force loses along the piece
        let mut losses: [_; 4] = product(&area, &[radius, length]).map(|term| centrifugal * (b * h) * length * term);
        losses[0] = losses[0] + load * length;
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
}
