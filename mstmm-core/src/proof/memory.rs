//! Memory for runs, on the stack in a few sizes, and the choice of lanes.

use crate::proof::count::{At, Outcomes, Place, Room, run};
use crate::proof::front::Variable;
use crate::proof::join::Failure;
use crate::proof::level::Level;
use crate::proof::tree::Path;
use crate::proof::visit::Visited;
use crate::proof::word::apart;
use core::marker::PhantomData;

/// Runs in memory for as many variables as the model has at once.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Memory {
    /// Index of the smallest memory that may do.
    class: usize,
    /// Whether the model has a part that is taken alone.
    is_alone: bool,
}

/// Where a model is counted: at `sign ω²` for each place.
#[derive(Clone, Copy)]
pub(crate) struct Question<'q> {
    pub(crate) model: &'q dyn Visited,
    pub(crate) places: &'q [Place],
    pub(crate) sign: f64,
}

/// A number in which a run counts, and its memory: for up to `W` variables with `E = W (W + 1)/2` entries, and for up to `P` open paths.
type Kind<N, const W: usize, const E: usize, const P: usize> = PhantomData<([N; W], [N; E], [N; P])>;

impl Memory {
    /// A run at a place; where the front has no room it is made again with more.
    pub(crate) fn run<N: Level<Word = f64>>(&mut self, question: Question<'_>) -> Result<Outcomes, Failure> {
        if let Some(outcomes) = self.in_small::<N>(question) {
            return outcomes;
        }
        if self.class == SMALL {
            match on_stack(question, PhantomData as Kind<N, 64, 2080, 64>) {
                Err(Failure::Full) => self.class += 1,
                outcomes => return outcomes,
            }
        }
        beyond_stack::<N>(question)
    }

    /// A run in one of the first so many memories, which lanes have room for, too; none where they are too small.
    fn in_small<N: Level>(&mut self, question: Question<'_>) -> Option<Result<Outcomes, Failure>> {
        loop {
            let outcomes = match self.class {
                0 => on_stack(question, PhantomData as Kind<N, 6, 21, 4>),
                1 => on_stack(question, PhantomData as Kind<N, 12, 78, 12>),
                2 => on_stack(question, PhantomData as Kind<N, 24, 300, 24>),
                3 => on_stack(question, PhantomData as Kind<N, 36, 666, 36>),
                4 => on_stack(question, PhantomData as Kind<N, 48, 1176, 48>),
                _ => return None,
            };
            match outcomes {
                Err(Failure::Full) => self.class += 1,
                outcomes => return Some(outcomes),
            }
        }
    }

    /// Runs in two words at the first few places, so many, in the lanes of the machine; none where it has no lanes, too little memory for as many, or
    /// where a part of the model is taken alone. Then all runs are alone from now on.
    pub(crate) fn run_in_lanes(&mut self, question: Question<'_>) -> Option<(Outcomes, usize)> {
        if self.is_alone {
            return None;
        }
        let found = self.in_widest_lanes(question);
        self.is_alone = found.is_none();
        found
    }

    #[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
    fn in_widest_lanes(&mut self, question: Question<'_>) -> Option<(Outcomes, usize)> {
        use mstmm_lanes::{Eight, Four, InstructionSet, Lanes};
        match InstructionSet::in_use() {
            InstructionSet::Target => None,
            InstructionSet::Avx512 if question.places.len() > 4 => self.in_lanes::<Lanes<Eight>>(question),
            _ => self.in_lanes::<Lanes<Four>>(question),
        }
    }

    #[cfg(not(all(feature = "std", target_arch = "x86_64", not(debug_assertions))))]
    fn in_widest_lanes(&mut self, _: Question<'_>) -> Option<(Outcomes, usize)> {
        None
    }

    /// The same in lanes of a word.
    #[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
    fn in_lanes<W: crate::proof::word::Word>(&mut self, question: Question<'_>) -> Option<(Outcomes, usize)> {
        let places = &question.places[..question.places.len().min(W::LANES)];
        let outcomes = self.in_small::<crate::proof::number::TwoWords<W>>(Question { places, ..question })?;
        outcomes.ok().map(|outcomes| (outcomes, places.len()))
    }
}

/// The number of memories that are small enough for lanes.
const SMALL: usize = 5;

apart! {
    /// Runs in memory on the stack.
    fn on_stack<N: Level, const W: usize, const E: usize, const P: usize>(
        question: Question<'_>,
        _kind: Kind<N, W, E, P>,
    ) -> Result<Outcomes, Failure> {
        let (mut entries, mut variables, mut paths) = ([N::of(0.0); E], [Variable::none(); W], [Path::none(); P]);
        let room = Room { entries: &mut entries, variables: &mut variables, paths: &mut paths };
        run(question.model, room, At::<N>::new(question.places, question.sign))
    }
}

/// A run for a front that is too wide for the stack.
#[cfg(feature = "std")]
#[inline(never)]
fn beyond_stack<N: Level<Word = f64>>(question: Question<'_>) -> Result<Outcomes, Failure> {
    /// Unknowns at once.
    const WIDEST: usize = 512;
    let mut entries = std::vec![N::of(0.0); WIDEST * (WIDEST + 1) / 2];
    let mut variables = std::vec![Variable::none(); WIDEST];
    let mut paths = std::vec![Path::none(); WIDEST];
    let room = Room { entries: &mut entries, variables: &mut variables, paths: &mut paths };
    run(question.model, room, At::<N>::new(question.places, question.sign))
}

/// Without `std` there is no memory but the stack.
#[cfg(not(feature = "std"))]
fn beyond_stack<N: Level<Word = f64>>(_: Question<'_>) -> Result<Outcomes, Failure> {
    Err(Failure::Full)
}
