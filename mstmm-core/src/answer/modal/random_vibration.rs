//! Random vibrations: the root mean square of an entry under a load with a power spectrum, in closed form.
//!
//! The mean square is `∫ G |H|² df`. A piece of the spectrum is cut into segments, over each of which the integral is a sum over poles and series: see `segment`. All parts are positive,
//! so that nothing cancels between them. Of white noise the sum over poles is the whole: `-(level/4) Re Σ R_n (R̄_m/(λ_n + λ̄_m) + R_m/(λ_n + λ_m))`.

use crate::answer::modal::power_spectrum::{Piece, PowerSpectrum};
use crate::answer::modal::response::{ModalResponse, Term};
use crate::answer::modal::segment::{FAR, Segment};
use crate::model::{MotionError, RandomError};
use crate::number::{Real, Scalar, binary_exponent, larger, modulus, smaller, turn, twice};
use num_complex::Complex;
use num_traits::Zero;

/// Widest segment over the frequency where it begins: a mirrored pole, a real one and one at zero are far of it.
const WIDEST: f64 = 0.125;

/// Largest change of the level within half a segment, as a power of e: with it the binomial series loses a factor of 4 with each term, as others do.
const LARGEST_CHANGE: f64 = 0.25;

/// Roundings of an eigenvalue below which its decay is none, and of a sum below which it is zero.
const ROUNDINGS: f64 = 64.0;

/// An entry under a random load, which neither begins nor ends: how far it goes, and how often.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RandomResponse<T> {
    /// The root mean square of the entry, σ. Of a normal distribution 99.7 % is within 3σ.
    pub rms: T,
    /// That of its rate; none where it is infinite, since white noise makes the rate jump.
    pub rate_rms: Option<T>,
}

impl<T: Real> RandomResponse<T> {
    /// How often per second the entry crosses zero upwards, `σ_rate/(2π σ)`, of a normal distribution: of a narrow band how many peaks there are. None where the rate is infinite, and
    /// where nothing moves.
    ///
    /// # Source
    /// Rice, Mathematical analysis of random noise, 1945.
    pub fn up_crossings_hertz(&self) -> Option<T> {
        self.rate_rms.filter(|_| !self.rms.is_zero()).map(|rate| rate / (turn::<T>() * self.rms))
    }
}

impl<T: Real, const N: usize, M> ModalResponse<T, N, M> {
    /// The root mean square of the entry, and of its rate, under a load of a power spectrum: in closed form, with all correlations of modes, exact beside rounding for the modes of the list and
    /// their residual compliance.
    ///
    /// ```
    /// use mstmm_core::frame::{Frame, Section};
    /// use mstmm_core::search::NaturalFrequencies;
    /// use mstmm_core::{FrameAnalysis, PowerSpectrum, Support};
    ///
    /// let mut frame = Frame::new();
    /// let [foot, tip] = [0.0, 2.0].map(|place| frame.point(place));
    /// frame.hold(foot, Support::Fixed);
    /// let beam = frame.member(foot, tip, Section::new().bending_stiffness(8.0).mass_per_length(1.5));
    /// let cantilever = frame.build()?;
    /// let roots = cantilever.frequencies(4)?;
    /// let response = cantilever.modal_response::<4, _>(&roots, tip.force_y(), beam.input().moment())?;
    ///
    /// // 0.3 N²/Hz from 0.1 to 15 Hz, with a damping ratio of 2 %
    /// let wind = PowerSpectrum::band(0.1..=15.0, 0.3)?;
    /// let moment = response.with_damping_ratio(0.02)?.random(&wind)?;
    /// println!("3σ are {:.2} N m", 3.0 * moment.rms);
    /// assert!(moment.rms > wind.rms());
    /// assert!(moment.up_crossings_hertz().is_some_and(|hertz| hertz > roots[0].hertz()));
    ///
    /// // the spectrum of the moment; white noise on the modes of the list; what the list leaves out
    /// let first = roots[0].hertz();
    /// assert!(response.with_damping_ratio(0.02)?.power_at(first, &wind)? > 100.0 * wind.at(first));
    /// let noise = PowerSpectrum::white(0.3);
    /// assert!(response.with_damping_ratio(0.02)?.random(&noise).is_err());
    /// let of_modes = response.without_residual()?.with_damping_ratio(0.02)?.random(&noise)?;
    /// assert!(of_modes.rms > moment.rms);
    /// let reach = 0.9 * cantilever.frequencies(5)?[4].omega;
    /// let truncation = cantilever.truncation::<4>(&roots, tip.force_y(), beam.input().moment(), reach)?;
    /// assert!(truncation.random(&wind, 0.02).is_some_and(|bound| bound < 0.2 * moment.rms));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RandomError::NoDamping`] for a mode without damping where the spectrum has power; [`RandomError::AtRest`] for a rigid body under a spectrum that reaches down to zero;
    /// [`RandomError::Residual`] for white noise on what follows it at once; [`RandomError::Unstable`] for a motion that grows; [`RandomError::Level`] for a level or a factor that is not
    /// positive; [`RandomError::Overflow`] for numbers out of range.
    pub fn random(&self, spectrum: &PowerSpectrum<'_, T>) -> Result<RandomResponse<T>, RandomError> {
        spectrum.checked()?;
        self.check_growth()?;
        if spectrum.is_white() {
            return self.under_white_noise(spectrum);
        }
        let ends @ [start, end] = spectrum.ends();
        let own = self.in_hertz();
        own.check_decay(&Segment::new(ends), start.is_zero())?;
        let (_, size) = own.sum_at(Complex::new(T::zero(), end));
        let at_once = own.residual.abs() + (own.flow * end).abs() + own.away().abs() / (end * end);
        let exponent = binary_exponent(size + at_once.size());
        let own = own.scaled(-exponent);
        let mut sums = [T::zero(); 2];
        for piece in spectrum.pieces() {
            own.add_piece(&piece, &mut sums)?;
        }
        let [rms, rate] = sums.map(|sum| {
            // of parts that are zero rounding may be less
            let sum = if sum < T::zero() { T::zero() } else { sum };
            spectrum.root_of(sum).times_power_of_two(exponent)
        });
        checked(rms, Some(rate * turn()))
    }

    /// The power spectrum of the entry at a frequency \[Hz\], `|H|² G`: its mean square per hertz.
    ///
    /// # Errors
    /// [`RandomError::Frequency`] for a frequency that is negative or not finite; [`RandomError::NoDamping`] at the frequency of a mode without damping, [`RandomError::AtRest`]
    /// of what moves off at rest; [`RandomError::Unstable`] and [`RandomError::Level`] as [`random`](ModalResponse::random).
    pub fn power_at(&self, hertz: T, spectrum: &PowerSpectrum<'_, T>) -> Result<T, RandomError> {
        spectrum.checked()?;
        self.check_growth()?;
        if !(hertz >= T::zero() && hertz.size().is_finite()) {
            return Err(RandomError::Frequency { hertz: hertz.to_f64() });
        }
        let level = spectrum.at(hertz);
        if level.is_zero() {
            return Ok(level);
        }
        let own = self.in_hertz();
        own.check_decay(&Segment::new([hertz, hertz]), hertz.is_zero())?;
        let response = own.whole_at(Complex::new(T::zero(), hertz)).map_err(|_| RandomError::AtRest)?;
        let root = modulus(response) * level.sqrt();
        let power = root * root;
        if power.size().is_finite() { Ok(power) } else { Err(RandomError::Overflow) }
    }

    /// The response of the modes of the list alone, without the residual compliance of all others: what white noise asks for, since what follows it at once has an infinite mean square.
    ///
    /// # Errors
    /// [`MotionError::AtOnce`] for a rate or an acceleration, of which the modes of the list have a part that follows at once, too: leave the residual out before.
    pub fn without_residual(&self) -> Result<Self, MotionError> {
        if self.facts.is_derived || !self.flow.is_zero() {
            return Err(MotionError::AtOnce);
        }
        let zero = T::zero();
        Ok(ModalResponse { residual: zero, lag: zero, ..*self })
    }

    /// The same response of frequencies in hertz, to which the ends of pieces are exact: λ is counted in turns, `λ/2π`.
    fn in_hertz(&self) -> Self {
        let turn = turn::<T>();
        let terms = self.terms.map(|term| Term { lambda: term.lambda / turn, residue: term.residue / turn, ..term });
        let [rigid, carried] = [self.rigid, self.carried].map(|away| away / (turn * turn));
        ModalResponse { terms, rigid, carried, lag: self.lag * turn, flow: self.flow * turn, ..*self }
    }

    /// The response times a power of two.
    fn scaled(&self, exponent: i32) -> Self {
        let to = |number: T| number.times_power_of_two(exponent);
        let terms = self.terms.map(|term| Term { residue: term.residue.times_power_of_two(exponent), ..term });
        let [rigid, residual, flow, carried] = [self.rigid, self.residual, self.flow, self.carried].map(to);
        ModalResponse { terms, rigid, residual, flow, carried, ..*self }
    }

    /// Checks that no motion grows.
    fn check_growth(&self) -> Result<(), RandomError> {
        let grows = |term: &&Term<T>| term.lambda.re.size() > rounding_of(term.lambda) && term.lambda.re > T::zero();
        match self.terms.iter().find(grows) {
            Some(term) => Err(RandomError::Unstable { growth: term.lambda.re.to_f64() }),
            None => Ok(()),
        }
    }

    /// Checks that all modes within a range of hertz decay, and that nothing moves off if it begins at rest.
    fn check_decay(&self, range: &Segment<T>, begins_at_rest: bool) -> Result<(), RandomError> {
        let drifts = self.terms.iter().any(|term| term.lambda.is_zero()) || !self.away().is_zero();
        if begins_at_rest && drifts {
            return Err(RandomError::AtRest);
        }
        let is_free = |term: &&Term<T>| {
            let is_undamped = !term.lambda.im.is_zero() && term.lambda.re.size() <= rounding_of(term.lambda);
            is_undamped && range.holds(term.lambda.im)
        };
        match self.terms.iter().find(is_free) {
            Some(term) => Err(RandomError::NoDamping { omega: (term.lambda.im * turn()).to_f64() }),
            None => Ok(()),
        }
    }

    /// Adds `∫ G |H|² df` and `∫ f² G |H|² df` over a piece, in segments as wide as they may be.
    fn add_piece(&self, piece: &Piece<T>, sums: &mut [T; 2]) -> Result<(), RandomError> {
        let [mut from, end] = piece.ends;
        let mut add = |segment: &Segment<T>, level: T, slope: T| {
            let parts = self.mean_squares(segment, slope);
            *sums = [sums[0] + parts[0] * level, sums[1] + parts[1] * level];
        };
        if from.is_zero() {
            from = smaller(self.lowest() / T::from_f64(FAR), end);
            add(&Segment::new([T::zero(), from]), piece.at(from), T::zero());
        }
        // the rate has two powers more
        let steepest = T::from_f64(piece.slope.size() + 2.0);
        let most = smaller(T::from_f64(WIDEST), T::from_f64(2.0 * LARGEST_CHANGE) / steepest);
        let mut width = from * most;
        while from < end {
            width = smaller(twice(width), from * most);
            let mut to = smaller(from + width, end);
            let mut segment = Segment::new([from, to]);
            while !self.terms.iter().all(|term| segment.suits(term.lambda)) {
                width = (to - from) * T::from_f64(0.5);
                to = from + width;
                segment = Segment::new([from, to]);
                // of a mode that is no number
                if to <= from {
                    return Err(RandomError::Overflow);
                }
            }
            add(&segment, piece.at(segment.middle()), piece.slope);
            from = to;
        }
        Ok(())
    }

    /// The size of the lowest pole; infinite without any.
    fn lowest(&self) -> T {
        let late = self.late();
        let sizes = self.terms.iter().chain(&late).map(|term| modulus(term.lambda));
        sizes.fold(T::from_f64(f64::INFINITY), smaller)
    }

    /// The mean squares under white noise, by the sum over poles.
    fn under_white_noise(&self, spectrum: &PowerSpectrum<'_, T>) -> Result<RandomResponse<T>, RandomError> {
        let late = self.late();
        let terms = || self.terms.iter().chain(&late);
        let everywhere = Segment::new(spectrum.ends());
        self.in_hertz().check_decay(&everywhere, true)?;
        let size = terms().fold(0.0, |size, term| size + (term.residue / term.lambda).size());
        let at_once = larger(self.flow.abs(), if late.is_some() { T::zero() } else { self.residual.abs() });
        if at_once.size() > ROUNDINGS * T::EPSILON * size {
            return Err(RandomError::Residual { residual: at_once.to_f64() });
        }
        let exponent = binary_exponent(size);
        let scaled = self.scaled(-exponent);
        let late = scaled.late();
        let terms = || scaled.terms.iter().chain(&late).copied();
        let rates = || terms().map(|term| Term { residue: term.residue * term.lambda, ..term });
        let rms = |sum: T| spectrum.root_of(sum * T::from_f64(0.25)).times_power_of_two(exponent);
        // what is left of the response at high frequencies, with the first power of them
        let (jump, of_terms) =
            terms().fold((T::zero(), 0.0), |(sum, size), term| (sum + term.residue.re, size + term.residue.size()));
        let has_rate = jump.size() <= ROUNDINGS * T::EPSILON * of_terms;
        checked(rms(over_all(terms)), has_rate.then(|| rms(over_all(rates))))
    }
}

/// `-Re Σ R_n (R̄_m/(λ_n + λ̄_m) + R_m/(λ_n + λ_m))`, of real terms by their real parts alone.
fn over_all<T: Real, I: Iterator<Item = Term<T>>>(terms: impl Fn() -> I) -> T {
    let own = |term: &Term<T>| if term.lambda.im.is_zero() { Complex::from(term.residue.re) } else { term.residue };
    terms().fold(T::zero(), |sum, one| {
        let with = |sum: Complex<T>, other: Term<T>| {
            let residue = own(&other);
            sum + residue.conj() / (one.lambda + other.lambda.conj()) + residue / (one.lambda + other.lambda)
        };
        sum - (own(&one) * terms().fold(Complex::zero(), with)).re
    })
}

/// A size below which a decay is rounding.
fn rounding_of<T: Real>(lambda: Complex<T>) -> f64 {
    ROUNDINGS * T::EPSILON * modulus(lambda).size()
}

/// A result, if its numbers are some.
fn checked<T: Real>(rms: T, rate_rms: Option<T>) -> Result<RandomResponse<T>, RandomError> {
    let is_one = |number: T| number.size().is_finite();
    let are = is_one(rms) && rate_rms.is_none_or(is_one);
    are.then_some(RandomResponse { rms, rate_rms }).ok_or(RandomError::Overflow)
}

#[cfg(test)]
mod tests;
