//! Numbers that compute without branches.

mod operators;

use crate::number::frequency::{Frequency, Real};
use crate::number::scalar::{Branches, Scalar};
use crate::number::wave_functions::WaveFunctions;
use core::ops::Mul;

/// A number that computes without branches: NaN where a branch would be needed, and never shifted into another range. Waves
/// have the series for short ones with `SERIES`, else the closed forms without scaling.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BranchFree<S, const SERIES: bool>(pub(crate) S);

impl<S: Scalar, const SERIES: bool> Scalar for BranchFree<S, SERIES> {
    type Plain = BranchFree<S::Plain, SERIES>;
    const BRANCHES: Branches = if SERIES { Branches::Series } else { Branches::Waves };
    const EPSILON: f64 = S::EPSILON;
    const WAVE_LIMIT: f64 = S::WAVE_LIMIT;
    const SERIES_TERMS: usize = S::SERIES_TERMS;
    const LONGEST_IN_LINE: usize = usize::MAX;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        BranchFree(S::from_f64(value))
    }

    #[inline(always)]
    fn reciprocal_factorial(n: usize) -> Self {
        BranchFree(S::reciprocal_factorial(n))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        BranchFree(self.0.moderate_sqrt()).valid_if(self.0.is_plain())
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (BranchFree(sin), BranchFree(cos))
    }

    #[inline(always)]
    fn sinh_cosh(self) -> (Self, Self) {
        let (sinh, cosh) = self.0.sinh_cosh();
        (BranchFree(sinh), BranchFree(cosh))
    }

    #[inline(always)]
    fn wave_functions(self) -> WaveFunctions<Self> {
        self.valid_if(self.size() < Self::WAVE_LIMIT).moderate_wave_functions()
    }

    #[inline(always)]
    fn moderate_wave_functions(self) -> WaveFunctions<Self> {
        let WaveFunctions { sin, cos, sh, ch, one, exponents } = self.0.moderate_wave_functions();
        let [sin, cos, sh, ch, one] = [sin, cos, sh, ch, one].map(BranchFree);
        WaveFunctions { sin, cos, sh, ch, one, exponents }
    }

    #[inline(always)]
    fn functions<const N: usize, R>(
        self,
        values: impl FnOnce(Self::Plain) -> ([Self::Plain; N], R),
        slopes: impl FnOnce([Self::Plain; N]) -> [Self::Plain; N],
    ) -> ([Self; N], R) {
        let plain = |numbers: [Self::Plain; N]| numbers.map(|number| number.0);
        let values = |number| {
            let (values, rest) = values(BranchFree(number));
            (plain(values), rest)
        };
        let (values, rest) = self.0.functions(values, |values| plain(slopes(values.map(BranchFree))));
        (values.map(BranchFree), rest)
    }

    #[inline(always)]
    fn constant(value: Self::Plain) -> Self {
        BranchFree(S::constant(value.0))
    }

    #[inline(always)]
    fn is_negative(self) -> bool {
        self.0.is_negative()
    }

    #[inline(always)]
    fn size(self) -> f64 {
        self.0.size()
    }

    #[inline(always)]
    fn times_power_of_two(self, exponent: i32) -> Self {
        BranchFree(self.0.times_power_of_two(exponent))
    }

    #[inline(always)]
    fn times_normal_power_of_two(self, exponent: i32) -> Self {
        BranchFree(self.0.times_normal_power_of_two(exponent))
    }

    #[inline(always)]
    fn or_nan(self, condition: bool) -> Self {
        BranchFree(self.0.or_nan(condition))
    }

    #[inline(always)]
    fn valid_if(self, condition: bool) -> Self {
        self.or_nan(condition)
    }

    /// The whole part of a number below 2^32, as every count of waves below [`WAVE_LIMIT`](Scalar::WAVE_LIMIT) is. Vector
    /// instructions before AVX-512 have no conversion to wider integers.
    #[inline(always)]
    fn whole(number: f64) -> u64 {
        u64::from(number as u32)
    }

    /// Leaves the entries as they are. The loop over the lanes checks the range of the results.
    #[inline(always)]
    fn in_range<const N: usize>(entries: [Self; N], _: f64) -> ([Self; N], i32) {
        (entries, 0)
    }
}

impl<T: Real, S: Frequency<T>, const SERIES: bool> Frequency<T> for BranchFree<S, SERIES>
where
    Self: Mul<T, Output = Self>,
{
    type Meaning = S::Meaning;
    const IS_EXTENDED: bool = S::IS_EXTENDED;

    #[inline(always)]
    fn lambda_squared(self) -> Self {
        BranchFree(self.0.lambda_squared())
    }

    #[inline(always)]
    fn omega(self) -> Self {
        BranchFree(self.0.omega())
    }

    #[inline(always)]
    fn from_parameter(parameter: T) -> Self {
        BranchFree(S::from_parameter(parameter))
    }
}
