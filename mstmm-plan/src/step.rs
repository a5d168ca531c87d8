//! Steps of a plan: what is evaluated, in the order in which it is.

use crate::space::Space;
use crate::support::Support;

/// A step of the plan; a step refers to earlier ones by index.
#[derive(Clone, Copy, Debug)]
pub enum Step<'a> {
    /// A boundary from which a path starts.
    Tip(Support),
    /// An element, its input step, and the space of its states; [`Space::NONE`] where that is not known.
    Element(usize, Space),
    /// A connection of the paths that end in these steps, in the order of the source.
    Connection(&'a [usize]),
    /// The boundary in which all paths end: always the last step.
    Root(usize, Support),
}

impl Step<'_> {
    /// Earlier steps from which this one goes on, in the order of the source.
    pub const fn inputs(&self) -> &[usize] {
        match self {
            Step::Tip(_) => &[],
            Step::Element(input, _) | Step::Root(input, _) => core::slice::from_ref(input),
            Step::Connection(inputs) => inputs,
        }
    }

    /// The support of a boundary.
    pub const fn support(&self) -> Option<Support> {
        match *self {
            Step::Tip(support) | Step::Root(_, support) => Some(support),
            Step::Element(..) | Step::Connection(_) => None,
        }
    }
}
