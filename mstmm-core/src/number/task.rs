//! Work that is compiled for several instruction sets.

#[cfg(feature = "std")]
pub(crate) use mstmm_lanes::{Part, Task, run};

/// A part of work that stands apart.
#[cfg(not(feature = "std"))]
pub(crate) trait Part {
    /// The result.
    type Output;
    /// Does it.
    fn run(self) -> Self::Output;
}

/// Work on numbers in lanes. Without `std` the instruction sets of the machine cannot be detected.
#[cfg(not(feature = "std"))]
pub(crate) trait Task {
    /// The result.
    type Output;
    /// The work one number at a time.
    fn alone(self) -> Self::Output;
}

#[cfg(not(feature = "std"))]
pub(crate) fn run<T: Task>(task: T) -> T::Output {
    task.alone()
}
