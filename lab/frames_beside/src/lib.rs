//! A portal frame here and in two programs of finite elements: what each takes for ten frequencies, and how far they are off.

mod figures;
mod portal;
mod programs;

pub use figures::{EXACT, Figures, Program, Run};
pub use portal::{Portal, PortalSystem, hertz, steel};
pub use programs::{BesideError, Missing, PYTHON, here, measure};
