//! Sections of thin walls: hollow rectangles and I sections.

use crate::model::error::InvalidParameter;
use crate::sections::number::Number;
use crate::sections::properties::{Properties, ShearCoefficients, check_ratio, check_room, check_size};
use crate::sections::rectangle;

/// A hollow rectangle, whose walls have one thickness.
///
/// Area and second moments are exact, for sharp corners. The torsion constant and the shear coefficients are those of thin walls.
///
/// ```
/// use mstmm_core::sections::BoxSection;
///
/// let post = BoxSection { width: 0.1, height: 0.2, wall: 0.005 }.properties()?;
/// assert!((post.area - 2.9e-3).abs() < 1e-15);
/// assert!((post.torsion - 1.1834e-5).abs() < 1e-9);
///
/// let error = BoxSection { width: 0.1, height: 0.2, wall: 0.0625 }.properties().unwrap_err();
/// assert_eq!(error.to_string(), "width is 0.1, but must be finite and greater than 2 wall = 0.125");
/// # Ok::<(), mstmm_core::InvalidParameter>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxSection<T> {
    /// The outer width b, along y \[m\].
    pub width: T,
    /// The outer height h, along z \[m\].
    pub height: T,
    /// The thickness t of all walls \[m\].
    pub wall: T,
}

impl<T: Number> BoxSection<T> {
    /// `A = b h - b' h'`, `I_y = (b h³ - b' h'³)/12`, `I_z = (h b³ - h' b'³)/12`, with the sizes `b' = b - 2 t` and `h' = h - 2 t` of the hole.
    ///
    /// `J = 2 t b₀² h₀²/(b₀ + h₀)` by Bredt, with the sizes `b₀ = b - t` and `h₀ = h - t` of the middle line of the walls.
    ///
    /// # Errors
    /// [`InvalidParameter`] for sizes that are not positive, or not from 1e-50 to 1e50, and for walls that are half as thick as a side, or thicker.
    ///
    /// # Source
    /// W. C. Young and R. G. Budynas, Roark's Formulas for Stress and Strain, 7th edition, 2002, table 10.1, hollow
    /// rectangle of thin walls.
    pub fn properties(self) -> Result<Properties<T>, InvalidParameter> {
        self.check()?;
        let BoxSection { width, height, wall } = self;
        let [across, along] = [width, height].map(|side| side - wall);
        Ok(Properties {
            area: (across + along) * wall * 2.0,
            i_y: hollow(width, height, wall, wall * 2.0),
            i_z: hollow(height, width, wall, wall * 2.0),
            torsion: across * across * along * along * wall * 2.0 / (across + along),
        })
    }

    /// `k = 10 (1 + ν) (1 + 3 m)²/(12 + 72 m + 150 m² + 90 m³ + ν (11 + 66 m + 135 m² + 90 m³) + 10 m² ((3 + ν) m + 3 m²))`, given the
    /// Poisson ratio ν.
    ///
    /// For deflections along z `m = b₀/h₀`, with `b₀ = b - t` and `h₀ = h - t`; along y it is the reciprocal.
    ///
    /// # Errors
    /// [`InvalidParameter`] as of [`properties`](BoxSection::properties), and for a ratio that is not from 0 to 0.5.
    ///
    /// # Source
    /// G. R. Cowper, The shear coefficient in Timoshenko's beam theory, Journal of Applied Mechanics 33, 1966.
    pub fn shear_coefficients(self, poisson_ratio: T) -> Result<ShearCoefficients<T>, InvalidParameter> {
        self.check()?;
        check_ratio(poisson_ratio)?;
        let nu = poisson_ratio;
        let [across, along] = [self.width, self.height].map(|side| side - self.wall);
        let k = |m: T| thin_shear(m, nu, m * m * ((nu + 3.0) * m + m * m * 3.0) * 10.0);
        Ok(ShearCoefficients { y: k(along / across), z: k(across / along) })
    }

    fn check(self) -> Result<(), InvalidParameter> {
        for (name, size) in [("width", self.width), ("height", self.height), ("wall", self.wall)] {
            check_size(name, size)?;
        }
        check_room("width", self.width, self.wall * 2.0, "2 wall")?;
        check_room("height", self.height, self.wall * 2.0, "2 wall")
    }
}

/// An I section with two equal flanges along y and a web along z.
///
/// Area and second moments are exact, without fillets. The torsion constant and the shear coefficients are those of thin walls, and there is no
/// warping.
///
/// ```
/// use mstmm_core::sections::ISection;
///
/// // IPE 200, which has fillets besides
/// let girder = ISection { width: 0.1, height: 0.2, flange: 0.0085, web: 0.0056 }.properties()?;
/// assert!((girder.i_y / 1.943e-5 - 1.0).abs() < 0.06 && girder.i_y < 1.943e-5);
///
/// let error = ISection { width: 0.1, height: 0.2, flange: 0.125, web: 0.0056 }.properties().unwrap_err();
/// assert_eq!(error.to_string(), "height is 0.2, but must be finite and greater than 2 flange = 0.25");
/// # Ok::<(), mstmm_core::InvalidParameter>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ISection<T> {
    /// The width b of both flanges, along y \[m\].
    pub width: T,
    /// The whole height h, along z \[m\].
    pub height: T,
    /// The thickness t of each flange \[m\].
    pub flange: T,
    /// The thickness w of the web \[m\].
    pub web: T,
}

impl<T: Number> ISection<T> {
    /// `A = 2 b t + w h'`, `I_y = (b h³ - (b - w) h'³)/12`, `I_z = (2 t b³ + h' w³)/12`, with the height `h' = h - 2 t` of the web between the
    /// flanges.
    ///
    /// `J = (2 b t³ + (h - t) w³)/3`
    ///
    /// # Errors
    /// [`InvalidParameter`] for sizes that are not positive, or not from 1e-50 to 1e50, for flanges that are half as thick as the section is high, or
    /// thicker, and for a web as thick as the flanges are wide, or thicker.
    ///
    /// # Source
    /// Torsional Section Properties of Steel Shapes, Canadian Institute of Steel Construction, 2002.
    pub fn properties(self) -> Result<Properties<T>, InvalidParameter> {
        self.check()?;
        let ISection { width, height, flange, web } = self;
        let flanges = width * flange * 2.0;
        let clear = height - flange * 2.0;
        let cube = |size: T| size * size * size;
        Ok(Properties {
            area: flanges + web * clear,
            i_y: hollow(width, height, flange, web),
            i_z: (flanges * width * width + clear * cube(web)) * (1.0 / 12.0),
            torsion: (width * cube(flange) * 2.0 + (height - flange) * cube(web)) * (1.0 / 3.0),
        })
    }

    /// Along z `k = 10 (1 + ν) (1 + 3 m)²/(12 + 72 m + 150 m² + 90 m³ + ν (11 + 66 m + 135 m² + 90 m³) + 30 n² (m + m²) + 5 ν n² (8 m + 9 m²))`, with
    /// `m = 2 b t/(h₀ w)`, `n = b/h₀` and `h₀ = h - t`, given the Poisson ratio ν.
    ///
    /// Along y the flanges carry all, as two rectangles: `k = 10 (1 + ν)/(12 + 11 ν) · 2 b t/A`.
    ///
    /// # Errors
    /// [`InvalidParameter`] as of [`properties`](ISection::properties), and for a ratio that is not from 0 to 0.5.
    ///
    /// # Source
    /// G. R. Cowper, The shear coefficient in Timoshenko's beam theory, Journal of Applied Mechanics 33, 1966.
    pub fn shear_coefficients(self, poisson_ratio: T) -> Result<ShearCoefficients<T>, InvalidParameter> {
        let Properties { area, .. } = self.properties()?;
        check_ratio(poisson_ratio)?;
        let (nu, flanges, along) = (poisson_ratio, self.width * self.flange * 2.0, self.height - self.flange);
        let (m, n) = (flanges / (along * self.web), self.width / along);
        let own = n * n * m * ((m + 1.0) * 30.0 + nu * (m * 9.0 + 8.0) * 5.0);
        Ok(ShearCoefficients { y: rectangle::shear(nu) * flanges / area, z: thin_shear(m, nu, own) })
    }

    fn check(self) -> Result<(), InvalidParameter> {
        let sizes = [("width", self.width), ("height", self.height), ("flange", self.flange), ("web", self.web)];
        for (name, size) in sizes {
            check_size(name, size)?;
        }
        check_room("height", self.height, self.flange * 2.0, "2 flange")?;
        check_room("width", self.width, self.web, "web")
    }
}

/// The second moment `(b h³ - (b - w) h'³)/12` with `h' = h - 2 t`, of two flanges of thickness t and webs of thickness w together, without
/// cancellation where walls are thin.
fn hollow<T: Number>(width: T, height: T, flange: T, webs: T) -> T {
    let clear = height - flange * 2.0;
    let flanges = width * flange * 2.0 * (height * height + height * clear + clear * clear);
    (flanges + webs * clear * clear * clear) * (1.0 / 12.0)
}

/// Cowper's coefficient of two flanges and webs, given the ratio m of their areas and what is the section's own in its denominator.
fn thin_shear<T: Number>(m: T, nu: T, own: T) -> T {
    // (12 + 72 m + 150 m² + 90 m³) + ν (11 + 66 m + 135 m² + 90 m³)
    let plain = m * (m * (m * 90.0 + 150.0) + 72.0) + 12.0;
    let lateral = m * (m * (m * 90.0 + 135.0) + 66.0) + 11.0;
    let root = m * 3.0 + 1.0;
    (nu + 1.0) * 10.0 * root * root / (plain + nu * lateral + own)
}
