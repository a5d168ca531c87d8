//! Sections as functions, for formulas of a model.

use crate::sections::number::Number;
use crate::sections::rectangle::Rectangle;
use crate::sections::round::{Round, Tube};
use crate::sections::walls::{BoxSection, ISection};

/// The two functions of a section: its properties and its shear coefficients.
macro_rules! functions {
    ($(
        $(#[$of_properties:meta])* $properties:ident,
        $(#[$of_shear:meta])* $shear:ident,
        $section:ident { $($size:ident),* };
    )*) => {$(
        $(#[$of_properties])*
        #[must_use]
        pub fn $properties<T: Number>($($size: T),*) -> (T, T, T, T) {
            let nan = T::undefined();
            $section { $($size),* }.properties().map_or((nan, nan, nan, nan), |properties| properties.tuple())
        }

        $(#[$of_shear])*
        #[must_use]
        pub fn $shear<T: Number>($($size: T,)* poisson_ratio: T) -> (T, T) {
            let nan = T::undefined();
            let coefficients = $section { $($size),* }.shear_coefficients(poisson_ratio);
            coefficients.map_or((nan, nan), |coefficients| coefficients.tuple())
        }
    )*};
}

functions! {
    /// [`Round::properties`] for formulas: `(area, i_y, i_z, torsion)`, NaN where that is an error.
    ///
    /// ```
    /// let (area, i_y, _, torsion) = mstmm_core::sections::round(0.02);
    /// assert!(area > 3.14e-4 && torsion == 2.0 * i_y);
    /// ```
    round,
    /// [`Round::shear_coefficients`] for formulas: `(y, z)`, NaN where that is an error.
    ///
    /// ```
    /// let (y, z) = mstmm_core::sections::round_shear(0.02, 0.0);
    /// assert_eq!((y, z), (6.0 / 7.0, 6.0 / 7.0));
    /// ```
    round_shear,
    Round { diameter };

    /// [`Tube::properties`] for formulas: `(area, i_y, i_z, torsion)`, NaN where that is an error.
    ///
    /// ```
    /// let (area, ..) = mstmm_core::sections::tube(0.2, 0.18);
    /// assert!((area - 5.969e-3).abs() < 1e-6);
    /// assert!(mstmm_core::sections::tube(0.2, 0.2).0.is_nan());
    /// ```
    tube,
    /// [`Tube::shear_coefficients`] for formulas: `(y, z)`, NaN where that is an error.
    ///
    /// ```
    /// let (y, z) = mstmm_core::sections::tube_shear(0.2, 0.18, 0.3);
    /// assert!(y == z && (y - 0.533).abs() < 1e-3);
    /// ```
    tube_shear,
    Tube { outer, inner };

    /// [`Rectangle::properties`] for formulas: `(area, i_y, i_z, torsion)`, NaN where that is an error.
    ///
    /// ```
    /// let (area, i_y, i_z, _) = mstmm_core::sections::rectangle(0.5, 2.0);
    /// assert!(area == 1.0 && i_y == 16.0 * i_z);
    /// ```
    rectangle,
    /// [`Rectangle::shear_coefficients`] for formulas: `(y, z)`, NaN where that is an error.
    ///
    /// ```
    /// let (y, z) = mstmm_core::sections::rectangle_shear(0.5, 2.0, 0.0);
    /// assert_eq!((y, z), (5.0 / 6.0, 5.0 / 6.0));
    /// ```
    rectangle_shear,
    Rectangle { width, height };

    /// [`BoxSection::properties`] for formulas: `(area, i_y, i_z, torsion)`, NaN where that is an error.
    ///
    /// ```
    /// let (area, ..) = mstmm_core::sections::box_section(0.1, 0.2, 0.005);
    /// assert!((area - 2.9e-3).abs() < 1e-15);
    /// ```
    box_section,
    /// [`BoxSection::shear_coefficients`] for formulas: `(y, z)`, NaN where that is an error.
    ///
    /// ```
    /// let (y, z) = mstmm_core::sections::box_shear(0.1, 0.2, 0.005, 0.3);
    /// assert!(y < z);
    /// ```
    box_shear,
    BoxSection { width, height, wall };

    /// [`ISection::properties`] for formulas: `(area, i_y, i_z, torsion)`, NaN where that is an error.
    ///
    /// ```
    /// let (_, i_y, i_z, _) = mstmm_core::sections::i_section(0.1, 0.2, 0.0085, 0.0056);
    /// assert!(i_y > 12.0 * i_z);
    /// ```
    i_section,
    /// [`ISection::shear_coefficients`] for formulas: `(y, z)`, NaN where that is an error.
    ///
    /// ```
    /// let (y, z) = mstmm_core::sections::i_shear(0.1, 0.2, 0.0085, 0.0056, 0.3);
    /// assert!(z < 0.5 && y > 0.5);
    /// ```
    i_shear,
    ISection { width, height, flange, web };
}
