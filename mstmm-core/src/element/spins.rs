//! What spins.

#[cfg(feature = "std")]
use crate::element::charted::MemberElement;
use crate::element::traits::Element;

/// An element with gyroscopic moments, which forward whirl and backward whirl see with speeds of opposite sign.
pub trait Spins: Element {
    /// The element as the other whirl sees it.
    #[must_use]
    fn turned_round(built: Self::Built) -> Self::Built;
}

/// A member of any type, some of which may spin.
#[cfg(feature = "std")]
pub trait MemberSpins: MemberElement {
    /// The member as the other whirl sees it.
    #[must_use]
    fn turned_round(built: Self::Built) -> Self::Built;
}
