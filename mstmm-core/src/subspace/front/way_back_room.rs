//! The memory of the way back through fronts.

use crate::number::Scalar;
use crate::subspace::front::chart::MOST_FREEDOMS;
use crate::subspace::front::eliminate::Choice;
use crate::subspace::front::fronts::Fronts;
use crate::subspace::front::matrix::Front;
use crate::subspace::front::objects::{Objects, Start};
use crate::subspace::front::target::Target;
use crate::subspace::front::total::Total;
use crate::subspace::front::variable::Variable;
use crate::subspace::front::way_back::{Back, Kept, Left, Mark};

/// Memory for the way back through so many nodes, with fronts of up to `W` variables at once.
///
/// With its riders, one per variable that leaves and the load, a front has up to 2 W + 1 variables, of which a triangle has no more
/// entries than four squares. Objects have at most twice as many variables as without a load.
#[derive(Debug)]
pub(crate) struct WayBackRoom<S, const W: usize, const NODES: usize> {
    front: [[[S; W]; W]; 4],
    objects: [[[S; W]; W]; 3],
    pivots: [[[S; W]; 3]; 4],
    variables: [[[Variable; W]; 3]; 2],
    object_rows: [[[S; MOST_FREEDOMS]; W]; 2],
    targets: [[Target; W]; 2],
    sizes: [[[f64; W]; 3]; 3],
    starts: [[Start; W]; 2],
    values: [[S; W]; 3],
    numbers: [[[S; W]; W]; NODES],
    rows: [[[S; MOST_FREEDOMS]; W]; NODES],
    sources: [[Target; W]; NODES],
    left: [[Left; W]; NODES],
    marks: [[Mark; 2]; NODES],
}

impl<S: Scalar, const W: usize, const NODES: usize> WayBackRoom<S, W, NODES> {
    /// Memory without a network.
    pub(crate) fn new() -> Self {
        let zero = S::zero();
        WayBackRoom {
            front: [[[zero; W]; W]; 4],
            objects: [[[zero; W]; W]; 3],
            pivots: [[[zero; W]; 3]; 4],
            variables: [[[Variable::DISPLACEMENT; W]; 3]; 2],
            object_rows: [[[zero; MOST_FREEDOMS]; W]; 2],
            targets: [[Target::NONE; W]; 2],
            sizes: [[[0.0; W]; 3]; 3],
            starts: [[Start::FIRST; W]; 2],
            values: [[zero; W]; 3],
            numbers: [[[zero; W]; W]; NODES],
            rows: [[[zero; MOST_FREEDOMS]; W]; NODES],
            sources: [[Target::NONE; W]; NODES],
            left: [[Left::NONE; W]; NODES],
            marks: [[Mark::FIRST; 2]; NODES],
        }
    }

    /// The way back, with nothing kept.
    pub(crate) fn way_back(&mut self) -> WayBack<'_, S> {
        let [one, other, solved, other_solved] = self.pivots.each_mut().map(|pivots| pivots.as_flattened_mut());
        let [waiting, variables] = self.variables.each_mut().map(|variables| variables.as_flattened_mut());
        let [waiting_errors, errors, terms] = self.sizes.each_mut().map(|sizes| sizes.as_flattened_mut());
        let (values, of_front) = self.values.as_flattened_mut().split_at_mut(2 * W);
        let fronts = Fronts {
            objects: Objects {
                entries: self.objects.as_flattened_mut().as_flattened_mut(),
                variables: waiting,
                rows: self.object_rows.as_flattened_mut(),
                errors: waiting_errors,
                starts: self.starts.as_flattened_mut(),
                count: 0,
                loads: 1,
            },
            front: Front {
                entries: self.front.as_flattened_mut().as_flattened_mut(),
                pivots: [one, other],
                solved: [solved, other_solved],
                variables,
                terms,
                errors,
                riders: 0,
                boundary: 0,
                count: 0,
            },
            targets: self.targets.as_flattened_mut(),
            total: Total::new(false),
            choice: Choice::Largest,
            has_readers: true,
        };
        let kept = Kept {
            numbers: self.numbers.as_flattened_mut().as_flattened_mut(),
            rows: self.rows.as_flattened_mut(),
            sources: self.sources.as_flattened_mut(),
            left: self.left.as_flattened_mut(),
            marks: self.marks.as_flattened_mut(),
            count: 0,
            form: S::zero(),
        };
        WayBack { fronts, back: Back { kept, values, count: 0, of_front } }
    }
}

/// Fronts, and the way back through them.
#[derive(Debug)]
pub struct WayBack<'r, S: Scalar> {
    pub(crate) fronts: Fronts<'r, S>,
    pub(crate) back: Back<'r, S>,
}
