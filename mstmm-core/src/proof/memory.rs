//! Memory for runs, on the stack in a few sizes, and the choice of lanes.

use crate::proof::count::{At, Outcome, Outcomes, Place, Room, run};
use crate::proof::front::Variable;
use crate::proof::joining::Failure;
use crate::proof::level::Level;
use crate::proof::tree::Path;
use crate::proof::visit::Visited;

/// Runs in memory for as many variables as the model has at once.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Memory {
    /// Index of the smallest memory that may do.
    class: usize,
}

impl Memory {
    /// A run; where the front has no room it is made again with more.
    pub(crate) fn run<N: Level<Word = f64>>(
        &mut self,
        model: &dyn Visited,
        at: At<N>,
    ) -> Result<Outcome<f64>, Failure> {
        loop {
            let outcome = match self.class {
                0 => on_stack::<N, 6, 21, 4>(model, at),
                1 => on_stack::<N, 12, 78, 12>(model, at),
                2 => on_stack::<N, 24, 300, 24>(model, at),
                3 => on_stack::<N, 64, 2080, 64>(model, at),
                _ => return beyond_stack(model, at),
            };
            match outcome {
                Err(Failure::Full) => self.class += 1,
                outcome => return outcome,
            }
        }
    }

    /// Runs in two words at some points, in the lanes of the machine; none where it has no lanes, or too little memory for as many.
    #[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
    pub(crate) fn run_in_lanes(&mut self, model: &dyn Visited, points: &[Place], sign: f64) -> Option<Outcomes> {
        use mstmm_lanes::{Eight, Four, InstructionSet, Lanes};
        match InstructionSet::in_use() {
            InstructionSet::Target => None,
            InstructionSet::Avx512 if points.len() > 4 => self.in_lanes::<Lanes<Eight>>(model, points, sign),
            _ => self.in_lanes::<Lanes<Four>>(model, points, sign),
        }
    }

    /// The same in lanes of a word.
    #[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
    fn in_lanes<W: crate::proof::word::Word>(
        &mut self,
        model: &dyn Visited,
        points: &[Place],
        sign: f64,
    ) -> Option<Outcomes> {
        let points = &points[..points.len().min(W::LANES)];
        loop {
            let at = At::<crate::proof::number::TwoWords<W>>::new(points, sign);
            let outcome = match self.class {
                0 => on_stack::<_, 6, 21, 4>(model, at),
                1 => on_stack::<_, 12, 78, 12>(model, at),
                2 => on_stack::<_, 24, 300, 24>(model, at),
                _ => return None,
            };
            match outcome {
                Err(Failure::Full) => self.class += 1,
                outcome => return outcome.ok().map(|outcome| outcome.lanes(points.len())),
            }
        }
    }

    /// Where nothing stands in lanes.
    #[cfg(not(all(feature = "std", target_arch = "x86_64", not(debug_assertions))))]
    pub(crate) fn run_in_lanes(&mut self, _: &dyn Visited, _: &[Place], _: f64) -> Option<Outcomes> {
        None
    }
}

/// A run in memory for up to `W` variables with `E = W (W + 1)/2` entries, and for up to `P` open paths.
#[inline(never)]
fn on_stack<N: Level, const W: usize, const E: usize, const P: usize>(
    model: &dyn Visited,
    at: At<N>,
) -> Result<Outcome<N::Word>, Failure> {
    let (mut entries, mut variables, mut paths) = ([N::of(0.0); E], [Variable::none(); W], [Path::none(); P]);
    run(model, Room { entries: &mut entries, variables: &mut variables, paths: &mut paths }, at)
}

/// A run for a front that is too wide for the stack.
#[cfg(feature = "std")]
#[inline(never)]
fn beyond_stack<N: Level<Word = f64>>(model: &dyn Visited, at: At<N>) -> Result<Outcome<f64>, Failure> {
    /// Variables of the widest front.
    const WIDEST: usize = 512;
    let mut entries = std::vec![N::of(0.0); WIDEST * (WIDEST + 1) / 2];
    let mut variables = std::vec![Variable::none(); WIDEST];
    let mut paths = std::vec![Path::none(); WIDEST];
    run(model, Room { entries: &mut entries, variables: &mut variables, paths: &mut paths }, at)
}

/// Without `std` there is no memory but the stack.
#[cfg(not(feature = "std"))]
fn beyond_stack<N: Level<Word = f64>>(_: &dyn Visited, _: At<N>) -> Result<Outcome<f64>, Failure> {
    Err(Failure::Full)
}
