//! The traits of elements: transfer matrix, step of the plane method, back transfer and energies.

pub(crate) mod back_transfer;
pub(crate) mod carries_load;
pub(crate) mod charted;
pub(crate) mod deflection;
pub(crate) mod energies;
pub(crate) mod listed;
pub(crate) mod member_gradient;
pub(crate) mod member_motion;
pub(crate) mod member_numbers;
pub(crate) mod member_transfer;
pub(crate) mod moving;
pub(crate) mod spins;
pub(crate) mod traits;
pub(crate) mod visit;

pub(crate) use back_transfer::BackTransfer;
pub(crate) use carries_load::CarriesLoad;
pub(crate) use charted::{Charted, MemberChart, MemberElement, MemberVisit, along_member};
pub(crate) use deflection::Deflection;
pub(crate) use energies::{Energies, Inside};
pub(crate) use listed::{ListElement, ListMoving, ListStepping, MOST_PARAMETERS};
pub(crate) use member_gradient::{ByName, MemberGradient, MemberSlopes};
pub(crate) use member_motion::{Forms, MemberEnds, MemberMotion, VisitMember};
pub(crate) use member_numbers::{
    BeamNumbers, BodyNumbers, DampingNumbers, Exact, LineNumbers, MemberNumbers, OwnPart, SpinNumbers, TaperedNumbers,
};
pub(crate) use member_transfer::{MemberMatrix, MemberTransfer, PartState, member_transfer};
pub(crate) use moving::{CoefficientsOf, Moving};
#[cfg(feature = "std")]
pub(crate) use spins::MemberSpins;
pub(crate) use spins::Spins;
pub(crate) use traits::{Element, MatrixOf, PlaneStep, TransferMatrix, build, space_of};
pub(crate) use visit::{Visit, VisitStep};
