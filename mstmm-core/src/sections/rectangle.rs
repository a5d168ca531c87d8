//! Rectangles.

use crate::model::error::InvalidParameter;
use crate::sections::number::Number;
use crate::sections::properties::{Properties, ShearCoefficients, check_ratio, check_size};
use core::f64::consts::PI;

/// `Σ 1/n⁵` of all odd n, `31 ζ(5)/32`.
const ODD_FIFTHS: f64 = 1.004_523_762_795_139_6;

/// `64/π⁵`
const FACTOR: f64 = 0.209_136_873_155_416_67;

/// The number of terms of the series: those behind are below 1e-22.
const TERMS: u32 = 6;

/// A full rectangle.
///
/// ```
/// use mstmm_core::sections::Rectangle;
///
/// let square = Rectangle { width: 1.0, height: 1.0 }.properties()?;
/// assert!((square.torsion - 0.140577014955153715588).abs() < 1e-16);
/// # Ok::<(), mstmm_core::InvalidParameter>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle<T> {
    /// The width b, along y \[m\].
    pub width: T,
    /// The height h, along z \[m\].
    pub height: T,
}

impl<T: Number> Rectangle<T> {
    /// `A = b h`, `I_y = b h³/12`, `I_z = h b³/12`.
    ///
    /// Of the long side l and the short side s, `J = l s³ (1/3 - 64/π⁵ s/l Σ tanh(n π l/2s)/n⁵)` over all odd n. The sum is `31 ζ(5)/32` less what
    /// each `tanh` lacks to 1. Six terms of this difference give all digits.
    ///
    /// # Errors
    /// [`InvalidParameter`] for a side that is not positive, or not from 1e-50 to 1e50.
    ///
    /// # Source
    /// S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, 3rd edition, 1970, section 109.
    pub fn properties(self) -> Result<Properties<T>, InvalidParameter> {
        self.check()?;
        let Rectangle { width, height } = self;
        let area = width * height;
        let [i_y, i_z] = [height, width].map(|across| area * across * across * (1.0 / 12.0));
        Ok(Properties { area, i_y, i_z, torsion: torsion(width, height) })
    }

    /// `k = 10 (1 + ν)/(12 + 11 ν)` in both directions, given the Poisson ratio ν.
    ///
    /// # Errors
    /// [`InvalidParameter`] as of [`properties`](Rectangle::properties), and for a ratio that is not from 0 to 0.5.
    ///
    /// # Source
    /// G. R. Cowper, The shear coefficient in Timoshenko's beam theory, Journal of Applied Mechanics 33, 1966.
    pub fn shear_coefficients(self, poisson_ratio: T) -> Result<ShearCoefficients<T>, InvalidParameter> {
        self.check()?;
        check_ratio(poisson_ratio)?;
        let k = shear(poisson_ratio);
        Ok(ShearCoefficients { y: k, z: k })
    }

    fn check(self) -> Result<(), InvalidParameter> {
        check_size("width", self.width)?;
        check_size("height", self.height)
    }
}

/// The shear coefficient of a rectangle.
pub(super) fn shear<T: Number>(nu: T) -> T {
    (nu + 1.0) * 10.0 / (nu * 11.0 + 12.0)
}

/// The torsion constant.
fn torsion<T: Number>(width: T, height: T) -> T {
    let [short, long] = width.sorted(height);
    // tanh x = 1 - 2 e/(1 + e), e = exp(-2 x)
    let mut sum = T::constant(ODD_FIFTHS);
    for n in (0..TERMS).map(|term| f64::from(2 * term + 1)) {
        let e = (long / short * (-PI * n)).exponential();
        sum = sum - e / (e + 1.0) * (2.0 / (n * n * n * n * n));
    }
    long * short * short * short * (short / long * sum * -FACTOR + 1.0 / 3.0)
}
