//! Numbers whose charts are compiled with this library.

use crate::elements::shared::bending_chart::BendingWaves;
use crate::elements::shared::longitudinal_chart::LongitudinalWaves;
use crate::elements::tapered_beam::Tapered;
use crate::number::for_compiled_numbers;
use crate::structure::{Chart, StructureScalar};

/// A number whose charts of beams are compiled with this library, once, as its elimination is.
pub trait ChartScalar: StructureScalar {
    /// Enters the bending of a beam into its chart, at the places of deflections and rotations of both ends.
    #[doc(hidden)]
    fn enter_bending(waves: &BendingWaves<Self>, chart: &mut Chart<Self>, places: [usize; 4]);

    /// Enters the longitudinal vibration of a beam into its chart, at the places of the displacements of both ends.
    #[doc(hidden)]
    fn enter_longitudinal(waves: &LongitudinalWaves<Self>, chart: &mut Chart<Self>, places: [usize; 2]);

    /// Enters a tapered beam into its chart, at the places of deflections and rotations of both ends.
    #[doc(hidden)]
    fn enter_tapered(beam: &Tapered<Self>, chart: &mut Chart<Self>, places: [usize; 4]);
}

/// Compiles charts of numbers.
macro_rules! compiled {
    ($($number:ty;)*) => {$(
        impl ChartScalar for $number {
            fn enter_bending(waves: &BendingWaves<Self>, chart: &mut Chart<Self>, places: [usize; 4]) {
                waves.enter(chart, places);
            }

            fn enter_longitudinal(waves: &LongitudinalWaves<Self>, chart: &mut Chart<Self>, places: [usize; 2]) {
                waves.enter(chart, places);
            }

            fn enter_tapered(beam: &Tapered<Self>, chart: &mut Chart<Self>, places: [usize; 4]) {
                beam.enter(chart, places);
            }
        }
    )*};
}

for_compiled_numbers!(compiled);

/// The elimination has no lanes, and so have charts.
#[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
impl<V: crate::number::lanes::Waving> ChartScalar for mstmm_lanes::Lanes<V> {
    fn enter_bending(_waves: &BendingWaves<Self>, _chart: &mut Chart<Self>, _places: [usize; 4]) {}

    fn enter_longitudinal(_waves: &LongitudinalWaves<Self>, _chart: &mut Chart<Self>, _places: [usize; 2]) {}

    fn enter_tapered(_beam: &Tapered<Self>, _chart: &mut Chart<Self>, _places: [usize; 4]) {}
}
