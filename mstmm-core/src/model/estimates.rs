//! Rough bounds of a system's frequencies, from which searches take their first steps.

use crate::number::elementary;

/// How far the mean of the largest stiffness and of inertias may be below that stiffness, in bits: half of those of extended precision. A number of a node in its units
/// loses as many, and the other half is the rounded answer.
const SOFTEST: i32 = 53;

/// Extreme stiffnesses and inertias of a system, translation and rotation apart.
///
/// They certify nothing: they only give the frequencies at which counting starts.
#[derive(Clone, Copy, Debug)]
pub struct FrequencyEstimates {
    stiffness: [Range; 2],
    inertia: [Range; 2],
    damping: [Range; 2],
    waves: Range,
    /// Sum of `z/sqrt(ω)` of all continuous elements.
    wave_sum: f64,
    /// Of strings, rods and shafts, the phase of whose waves grows with ω and not with its root.
    linear_waves: Range,
    /// Sum of all lengths: no lever is longer.
    reach: f64,
    /// Levers of rigid bodies.
    levers: Range,
    /// The largest loss factor.
    loss_factor: f64,
    /// Rates of decay at which the stiffness of a member with waves vanishes.
    singularities: Range,
    /// Whether one of these is at a point off the real axis.
    are_off_axis: bool,
    /// Whether eigenvalues are those of one whirl, which differ from those of the other one.
    is_whirl: bool,
    /// Logarithms to base 2 of a low estimate of the frequencies, of one that no other falls short of by much, and of a high one.
    exponents: [i32; 3],
}

/// Smallest and largest positive value so far.
#[derive(Clone, Copy, Debug)]
struct Range {
    least: f64,
    greatest: f64,
}

impl Range {
    const EMPTY: Range = Range { least: f64::INFINITY, greatest: 0.0 };

    // called at many places: in line where a sweep builds many models, not where size counts
    #[cfg_attr(feature = "std", inline)]
    #[cfg_attr(not(feature = "std"), inline(never))]
    fn include(&mut self, value: f64) {
        if value > 0.0 && value < f64::INFINITY {
            self.least = if value < self.least { value } else { self.least };
            self.greatest = if value > self.greatest { value } else { self.greatest };
        }
    }
}

impl Default for FrequencyEstimates {
    fn default() -> Self {
        FrequencyEstimates {
            stiffness: [Range::EMPTY; 2],
            inertia: [Range::EMPTY; 2],
            damping: [Range::EMPTY; 2],
            waves: Range::EMPTY,
            wave_sum: 0.0,
            linear_waves: Range::EMPTY,
            reach: 0.0,
            levers: Range::EMPTY,
            loss_factor: 0.0,
            singularities: Range::EMPTY,
            are_off_axis: false,
            is_whirl: false,
            exponents: [0; 3],
        }
    }
}

impl FrequencyEstimates {
    /// A translational stiffness [N/m].
    pub fn translational_stiffness(&mut self, value: f64) {
        self.stiffness[0].include(value);
    }

    /// A torsional stiffness [N m/rad].
    pub fn torsional_stiffness(&mut self, value: f64) {
        self.stiffness[1].include(value);
    }

    /// A mass \[kg\].
    pub fn mass(&mut self, value: f64) {
        self.inertia[0].include(value);
    }

    /// A moment of inertia [kg m²].
    pub fn moment_of_inertia(&mut self, value: f64) {
        self.inertia[1].include(value);
    }

    /// A translational damping [N s/m].
    pub fn translational_damping(&mut self, value: f64) {
        self.damping[0].include(value);
    }

    /// A torsional damping [N m s/rad].
    pub fn torsional_damping(&mut self, value: f64) {
        self.damping[1].include(value);
    }

    /// A continuous element with frequencies of its own from this order [rad/s] on; it has infinitely many.
    pub fn waves(&mut self, omega: f64) {
        self.waves.include(omega);
        self.wave_sum += elementary!(f64::sqrt, libm::sqrt, omega.recip());
    }

    /// A string, a rod or a shaft with frequencies of its own from this order [rad/s] on; it has infinitely many, evenly spaced.
    pub fn linear_waves(&mut self, omega: f64) {
        self.linear_waves.include(omega);
    }

    /// A length along a path \[m\]: masses may turn about the far end of a lever that long.
    pub fn length(&mut self, value: f64) {
        self.reach += value.abs();
    }

    /// A lever of a rigid body \[m\]: on a short one even a stiff spring turns the body slowly.
    pub fn lever(&mut self, value: f64) {
        self.length(value);
        self.levers.include(value.abs());
    }

    /// A loss factor η of a stiffness, which describes motions with `Im λ > 0` alone.
    pub fn loss_factor(&mut self, value: f64) {
        self.loss_factor = if value > self.loss_factor { value } else { self.loss_factor };
    }

    /// A rate of decay a [1/s], at which the stiffness of a continuous element vanishes: `λ = -a` is an essential singularity of Δ, about
    /// which eigenvalues accumulate. An infinite one is none.
    pub fn essential_singularity(&mut self, rate: f64) {
        self.singularities.include(rate);
    }

    /// The same of a shaft that spins: there it vanishes at `λ = -a + iΩ`.
    pub fn turning_singularity(&mut self, rate: f64) {
        self.singularities.include(rate);
        self.are_off_axis |= rate > 0.0 && rate < f64::INFINITY;
    }

    /// Something has gyroscopic moments or cross terms: eigenvalues have no mirror images, and motions may grow.
    pub fn whirl(&mut self) {
        self.is_whirl = true;
    }

    /// Whether eigenvalues are those of one whirl.
    pub(crate) fn is_whirl(&self) -> bool {
        self.is_whirl
    }

    /// Whether each eigenvalue has a mirror image on the other side of the real axis.
    pub(crate) fn have_images(&self) -> bool {
        !(self.has_loss() || self.is_whirl)
    }

    /// Whether an essential singularity is off the real axis, at a place that is not known here.
    pub(crate) fn are_off_axis(&self) -> bool {
        self.are_off_axis
    }

    /// Whether some stiffness has a loss factor.
    pub(crate) fn has_loss(&self) -> bool {
        self.loss_factor > 0.0
    }

    /// The rightmost and the leftmost essential singularity of Δ on the real axis of λ.
    pub(crate) fn singularities(&self) -> Option<[f64; 2]> {
        let Range { least, greatest } = self.singularities;
        (greatest > 0.0).then_some([-least, -greatest])
    }

    /// Sum of `z/sqrt(ω)` of all continuous elements.
    pub(crate) fn wave_sum(&self) -> f64 {
        self.wave_sum
    }

    /// Largest `z/sqrt(ω)` of a continuous element; zero if there is none.
    pub(crate) fn longest_wave(&self) -> f64 {
        elementary!(f64::sqrt, libm::sqrt, self.waves.least.recip())
    }

    /// Whether some element has infinitely many frequencies.
    pub(crate) fn is_continuous(&self) -> bool {
        self.waves.greatest > 0.0 || self.linear_waves.greatest > 0.0
    }

    /// Squares of a low and a high estimate of the system's frequencies.
    fn estimates(&self) -> Range {
        let mut squares = Range::EMPTY;
        for (stiffness, inertia) in self.stiffness.iter().zip(&self.inertia) {
            if inertia.greatest > 0.0 && stiffness.greatest > 0.0 {
                squares.include(stiffness.least / inertia.greatest);
                squares.include(stiffness.greatest / inertia.least);
            }
        }
        for (damping, (stiffness, inertia)) in self.damping.iter().zip(self.stiffness.iter().zip(&self.inertia)) {
            if damping.greatest > 0.0 && inertia.greatest > 0.0 {
                let (slow, fast) = (damping.least / inertia.greatest, damping.greatest / inertia.least);
                squares.include(slow * slow);
                squares.include(fast * fast);
            }
            if damping.greatest > 0.0 && stiffness.greatest > 0.0 {
                let (slow, fast) = (stiffness.least / damping.greatest, stiffness.greatest / damping.least);
                squares.include(slow * slow);
                squares.include(fast * fast);
            }
        }
        let lever = self.inertia[0].greatest * self.reach * self.reach;
        if lever > 0.0 && self.stiffness[1].greatest > 0.0 {
            squares.include(self.stiffness[1].least / lever);
        }
        for waves in [&self.waves, &self.linear_waves] {
            if waves.greatest > 0.0 {
                squares.include(waves.least * waves.least);
                squares.include(waves.greatest * waves.greatest);
            }
        }
        if squares.greatest == 0.0 { Range { least: 1.0, greatest: 1.0 } } else { squares }
    }

    /// Takes the logarithms that searches ask for, once all is added.
    #[doc(hidden)]
    #[inline(never)]
    pub fn finish(&mut self) {
        let squares = self.estimates();
        let lowest = exponent(squares.least) / 2 - 1;
        // the softest spring on the shortest lever
        let (stiffness, inertia) = (self.stiffness[0].least, self.inertia[1].greatest);
        let by_lever = stiffness / inertia * self.levers.least * self.levers.least;
        let is_one = by_lever > 0.0 && by_lever.is_finite();
        let least = if is_one { lowest.min(exponent(by_lever) / 2 - 1) } else { lowest };
        self.exponents = [lowest, least, exponent(squares.greatest) / 2 + 1];
    }

    /// Logarithm to base 2 of a low estimate of the frequencies.
    #[inline]
    pub(crate) fn lowest_exponent(&self) -> i32 {
        self.exponents[0]
    }

    /// Logarithm to base 2 of a frequency that no other falls short of by much: that of the softest spring on the shortest lever.
    #[inline]
    pub(crate) fn least_exponent(&self) -> i32 {
        self.exponents[1]
    }

    /// Logarithms to base 2 of the mean of the largest stiffness and of the largest inertia times a λ² of a size, of translations and of
    /// rotations; none without both. At rest λ is the least frequency. It is no less than [`SOFTEST`] below the largest stiffness.
    pub(crate) fn between_stiffness_and_inertia(&self, square: f64) -> [Option<i32>; 2] {
        let least = 2 * self.least_exponent();
        let square = if square > 0.0 { exponent(square).max(least) } else { least };
        [0, 1].map(|kind| {
            let (stiffness, inertia) = (self.stiffness[kind].greatest, self.inertia[kind].greatest);
            let are_known = stiffness > 0.0 && inertia > 0.0;
            are_known.then(|| {
                let stiffness = exponent(stiffness);
                (stiffness + exponent(inertia) + square).max(2 * (stiffness - SOFTEST)).div_euclid(2)
            })
        })
    }

    /// Logarithm to base 2 of a frequency that counts as zero beside any other.
    pub(crate) fn negligible_exponent(&self) -> i32 {
        self.least_exponent() - 20
    }

    /// Logarithm to base 2 of a high estimate of the frequencies of discrete elements.
    pub(crate) fn highest_exponent(&self) -> i32 {
        self.exponents[2]
    }
}

/// Binary exponent of a positive number.
fn exponent(value: f64) -> i32 {
    crate::number::exponent::binary_exponent(value)
}
