//! What searches ask of a system: a pass at numbers of several types.

use crate::element::OwnPart;
use crate::number::{Dual, InLanes, Real};
use crate::pass::characteristic::{Characteristic, System};
use num_complex::Complex;

/// The passes of a search for natural frequencies: Δ and its derivative in the precision of the parameters.
#[doc(hidden)]
pub trait RealPasses:
    System<Parameter: InLanes + Real>
    + Characteristic<<Self as System>::Parameter>
    + Characteristic<<<Self as System>::Parameter as InLanes>::OnAvx512>
    + Characteristic<<<Self as System>::Parameter as InLanes>::OnAvx2>
    + Characteristic<Dual<<Self as System>::Parameter>>
{
}

impl<Y> RealPasses for Y where
    Y: System<Parameter: InLanes + Real>
        + Characteristic<<Y as System>::Parameter>
        + Characteristic<<<Y as System>::Parameter as InLanes>::OnAvx512>
        + Characteristic<<<Y as System>::Parameter as InLanes>::OnAvx2>
        + Characteristic<Dual<<Y as System>::Parameter>>
        + ?Sized
{
}

/// A system that can be searched for natural frequencies.
///
/// Every undamped system is one but those with planar elements in paths without places, which have none of its passes; systems with a damper
/// are not: they have `eigenvalues`. It is implemented for each system by itself, so that the compiler says once what is missing.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no certified frequencies of its own",
    label = "neither of a rotor nor of planar elements without places",
    note = "a rotor has those of each whirl: ask `rotor.whirl(Whirl::Forward)`, `rotor.whirl(Whirl::Backward)`",
    note = "of planar elements say where their points are, `conn a at (x, y)`: then every search is there",
    note = "without places there are `overall_matrix` and `overall_determinant`: search that for roots by `fmin1d`"
)]
pub trait Undamped: RealPasses {
    /// The element of a step that is known by its step of the plane method alone, at ω, which is the sum of two words.
    #[doc(hidden)]
    fn own_part(&self, _step: usize, _omega: [f64; 2]) -> Option<OwnPart> {
        None
    }
}

/// The passes of a search for eigenvalues: Δ and its derivative in the precision of the parameters and in extended precision.
#[doc(hidden)]
pub trait ComplexPasses:
    System
    + Characteristic<Dual<Complex<<Self as System>::Parameter>>>
    + Characteristic<Dual<Complex<<<Self as System>::Parameter as Real>::Extended>>>
{
}

impl<Y> ComplexPasses for Y where
    Y: System
        + Characteristic<Dual<Complex<<Y as System>::Parameter>>>
        + Characteristic<Dual<Complex<<<Y as System>::Parameter as Real>::Extended>>>
        + ?Sized
{
}

/// A system that can be searched for eigenvalues.
///
/// Every system is one but those with planar elements in paths without places.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no certified eigenvalues of its own",
    label = "neither of a rotor nor of planar elements without places",
    note = "a rotor has those of each whirl: ask `rotor.whirl(Whirl::Forward)`, `rotor.whirl(Whirl::Backward)`",
    note = "of planar elements say where their points are, `conn a at (x, y)`: then every search is there",
    note = "without places there are `overall_matrix` and `overall_determinant`: search that for roots by `fmin1d` or `fmin2d`"
)]
pub trait Spectrum: ComplexPasses {}
