//! What can be drawn: built systems with a sketch.

use crate::error::DrawingError;
use crate::figure::Figure;
use mstmm_core::{Drawn, DrawnTree, FrameAnalysis, ModalAnalysis};

/// A system that can be drawn: one whose points have places, in the plane or in space, or one of paths. `Kind` is [`Frame`] or [`Tree`], and follows from the system.
pub trait Sketched<Kind>: private::Figured<Kind> {}

/// The kind of systems whose points have places.
#[derive(Debug)]
pub enum Frame {}

/// The kind of systems of paths.
#[derive(Debug)]
pub enum Tree {}

impl<Y: private::Figured<Kind>, Kind> Sketched<Kind> for Y {}

impl<Y: Drawn> private::Figured<Frame> for Y {
    type Model = Y::Model;

    fn figure(&self) -> Result<Figure<Y::Model>, DrawingError> {
        let sketch = FrameAnalysis::sketch(self);
        if Y::IS_IN_SPACE { crate::in_space::figure(&sketch) } else { crate::frame::figure(&sketch) }
    }
}

impl<Y: DrawnTree> private::Figured<Tree> for Y {
    type Model = Y::Model;

    fn figure(&self) -> Result<Figure<Y::Model>, DrawingError> {
        crate::tree::figure(&ModalAnalysis::sketch(self))
    }
}

pub(crate) mod private {
    use super::{DrawingError, Figure};

    /// A system that can be put on the paper.
    pub trait Figured<Kind> {
        /// The model whose labels it has.
        type Model;

        /// The system on the paper.
        fn figure(&self) -> Result<Figure<Self::Model>, DrawingError>;
    }
}
