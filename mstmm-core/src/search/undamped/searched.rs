//! What searches for natural frequencies ask of a system: a pass at numbers of several types.

use crate::number::{Dual, Growth, InLanes, Real};
use crate::pass::characteristic::{Characteristic, System};

/// A system that can be searched for natural frequencies: it has Δ and its derivative in the precision of the parameters and in
/// extended precision, and Δ where motions grow.
///
/// Every undamped system without planar elements is one; systems with a damper are not: they have `eigenvalues`.
pub trait Undamped:
    System<Parameter: InLanes + Real>
    + Characteristic<<Self as System>::Parameter>
    + Characteristic<<<Self as System>::Parameter as InLanes>::OnAvx512>
    + Characteristic<<<Self as System>::Parameter as InLanes>::OnAvx2>
    + Characteristic<Dual<<Self as System>::Parameter>>
    + Characteristic<<<Self as System>::Parameter as Real>::Extended>
    + Characteristic<Dual<<<Self as System>::Parameter as Real>::Extended>>
    + Characteristic<Growth<<Self as System>::Parameter>>
    + Characteristic<Growth<<<Self as System>::Parameter as Real>::Extended>>
{
}

impl<Y> Undamped for Y where
    Y: System<Parameter: InLanes + Real>
        + Characteristic<<Y as System>::Parameter>
        + Characteristic<<<Y as System>::Parameter as InLanes>::OnAvx512>
        + Characteristic<<<Y as System>::Parameter as InLanes>::OnAvx2>
        + Characteristic<Dual<<Y as System>::Parameter>>
        + Characteristic<<<Y as System>::Parameter as Real>::Extended>
        + Characteristic<Dual<<<Y as System>::Parameter as Real>::Extended>>
        + Characteristic<Growth<<Y as System>::Parameter>>
        + Characteristic<Growth<<<Y as System>::Parameter as Real>::Extended>>
        + ?Sized
{
}
