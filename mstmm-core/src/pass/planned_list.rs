//! A list of steps with its plan: all that answers about motions ask for.

use crate::element::{ListElement, ListMoving, ListStepping, MOST_PARAMETERS, Visit};
use crate::model::{Chain, Ends, Fields, FrequencyEstimates, Label, Point};
use crate::number::{Frequency, FrequencyPowers, InLanes, Scalar, Scaled};
use crate::pass::characteristic::{Characteristic, System};
use crate::pass::searched::{ComplexPasses, RealPasses, Spectrum, Undamped};
use crate::pass::step_list::{ListError, ListStep, OPEN_PATHS, StepList};
use crate::pass::tree::{Planned, Tree};
use crate::proof::visit::Visitor;
use crate::subspace::RootCounter;
use core::fmt::Debug;
use mstmm_plan::{Place, Scheme, Step, Support};

/// Memory for the plan of a list of up to `STEPS` steps, some hundred bytes per step.
///
/// A room holds one plan: it is borrowed as long as its list lives, and each list takes a room of its own. What the list is asked about
/// motions takes a stack for `STEPS` steps, used or not, so that a room should not be much larger than its list.
#[derive(Clone, Debug)]
pub struct Room<'a, const STEPS: usize> {
    /// The inputs of all connections, one connection after the other.
    inputs: [usize; STEPS],
    steps: [Step<'a>; STEPS],
    places: [Place; STEPS],
    sorted: [usize; STEPS],
}

impl<const STEPS: usize> Room<'_, STEPS> {
    /// Memory in which nothing is planned.
    #[allow(clippy::new_without_default, reason = "an array of any length has no default")]
    pub const fn new() -> Self {
        Room {
            inputs: [0; STEPS],
            steps: [Step::Tip(Support::Free); STEPS],
            places: [Place::NOWHERE; STEPS],
            sorted: [0; STEPS],
        }
    }
}

/// The labels of lists.
#[derive(Clone, Copy, Debug)]
pub enum InList {}

/// A parameter of an element of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ListParameter {
    /// Its place among those of all elements.
    pub(crate) index: usize,
}

/// A [`StepList`] with its plan, which answers what a model answers but for the overall matrix: searches, blocks, shapes, responses,
/// sensitivities.
///
/// What it is asked about motions keeps values for each of `STEPS` steps on the stack. Release builds with real frequencies need per
/// step 0.5 kB for a response at one frequency, 0.9 kB for a shape or a motion in time, 1.1 kB for sensitivities, and 6 kB for all
/// shapes of a multiple root.
#[derive(Clone, Copy, Debug)]
pub struct PlannedList<'a, E, const STEPS: usize> {
    list: StepList<'a, E>,
    scheme: Scheme<'a>,
}

impl<'a, E: ListElement> StepList<'a, E> {
    /// Plans the list in memory of the caller's, which it keeps as long as it lives.
    ///
    /// # Errors
    /// [`ListError`] for a list of more than `STEPS` steps.
    pub fn planned<const STEPS: usize>(
        self,
        room: &'a mut Room<'a, STEPS>,
    ) -> Result<PlannedList<'a, E, STEPS>, ListError> {
        let Room { inputs, steps, places, sorted } = room;
        let count = self.steps.len();
        let (Some(steps), Some(places), Some(sorted)) =
            (steps.get_mut(..count), places.get_mut(..count), sorted.get_mut(..count))
        else {
            return Err(ListError { step: STEPS, problem: "the `Room` for the plan ends before this step" });
        };
        note_inputs(self.steps, inputs);
        let mut inputs: &'a [usize] = inputs;
        for (index, (step, planned)) in self.steps.iter().zip(&mut *steps).enumerate() {
            // a path goes on from the step before
            let input = index.saturating_sub(1);
            *planned = match step {
                ListStep::Tip(support) => Step::Tip(*support),
                ListStep::Element(element) => Step::Element(input, element.space()),
                ListStep::Root(support) => Step::Root(input, *support),
                ListStep::Connection(paths) => {
                    let (own, others) = inputs.split_at(*paths);
                    inputs = others;
                    Step::Connection(own)
                }
            };
        }
        Ok(PlannedList { list: self, scheme: Scheme::resolve(steps, places, sorted) })
    }
}

/// Notes the steps that connections join, one connection after the other.
fn note_inputs<E>(steps: &[ListStep<E>], inputs: &mut [usize]) {
    let mut open = [0; OPEN_PATHS];
    let (mut count, mut end) = (0, 0);
    for (index, step) in steps.iter().enumerate() {
        match step {
            ListStep::Tip(_) => count += 1,
            ListStep::Element(_) | ListStep::Root(_) => {}
            ListStep::Connection(paths) => {
                count -= paths;
                inputs[end..end + paths].copy_from_slice(&open[count..count + paths]);
                end += paths;
                count += 1;
            }
        }
        open[count - 1] = index;
    }
}

impl<E: ListElement, const STEPS: usize> PlannedList<'_, E, STEPS> {
    pub(super) fn element(&self, step: usize) -> Option<&E> {
        match self.list.steps.get(step) {
            Some(ListStep::Element(element)) => Some(element),
            _ => None,
        }
    }

    /// The label of the element that is a step; `None` if the step is none.
    ///
    /// Labels are indices: one of another list stands for the step of that index here, and beyond the end all is zero.
    pub fn label(&self, step: usize) -> Option<Label<InList, E>> {
        self.element(step).map(|_| Label::new(step, step - 1))
    }

    /// The point of the connection that is a step; `None` if the step is none.
    pub fn connection(&self, step: usize) -> Option<Point<InList>> {
        matches!(self.list.steps.get(step), Some(ListStep::Connection(_))).then(|| Point::connection(step))
    }

    /// A parameter of the element that is a step, by the name of its field; `None` if there is none of that name.
    pub fn parameter(&self, step: usize, name: &str) -> Option<ListParameter> {
        let place = self.element(step)?.parameters().iter().position(|parameter| *parameter == name)?;
        Some(ListParameter { index: step * MOST_PARAMETERS + place })
    }
}

impl<E: ListElement, const STEPS: usize> System for PlannedList<'_, E, STEPS> {
    type Parameter = E::Parameter;
    const MAY_BUCKLE: bool = E::MAY_BUCKLE;

    fn may_buckle(&self) -> bool {
        self.list.may_buckle()
    }

    fn name_parts(&self, visitor: &mut dyn Visitor) {
        self.list.name_parts(visitor);
    }

    fn frequency_estimates(&self) -> FrequencyEstimates {
        self.list.frequency_estimates()
    }
}

impl<E, S, const STEPS: usize> Characteristic<S> for PlannedList<'_, E, STEPS>
where
    E: ListStepping<S>,
    S: Frequency<E::Parameter>,
{
    fn pass<C: RootCounter<S>>(&self, x: S, counter: &mut C) -> Scaled<S> {
        self.list.pass(x, counter)
    }
}

impl<E: ListElement<Parameter: InLanes>, const STEPS: usize> Undamped for PlannedList<'_, E, STEPS> where
    Self: RealPasses
{
}

impl<E: ListElement, const STEPS: usize> Spectrum for PlannedList<'_, E, STEPS> where Self: ComplexPasses {}

impl<E: ListElement, const STEPS: usize> Planned for PlannedList<'_, E, STEPS> {
    type Model = InList;
    type PerStep<V: Copy + Debug> = [V; STEPS];

    fn per_step<V: Copy + Debug>(value: V) -> [V; STEPS] {
        [value; STEPS]
    }

    fn scheme(&self) -> Scheme<'_> {
        self.scheme
    }
}

impl<E, S, const STEPS: usize> Tree<S> for PlannedList<'_, E, STEPS>
where
    E: ListMoving<S>,
    S: Frequency<E::Parameter>,
{
    type Evaluated = ();

    fn at(x: S) -> FrequencyPowers<S> {
        FrequencyPowers::new(x, true)
    }

    /// Nothing: each element is evaluated where it is visited.
    fn evaluate(&self, _at: &FrequencyPowers<S>) {}

    fn visit<V: Visit<S>>(&self, _evaluated: Option<&()>, step: usize, visitor: V) -> Option<V::Output> {
        Some(self.element(step)?.visit(visitor))
    }
}

/// A value for each parameter of each step.
#[derive(Clone, Copy, Debug)]
pub struct PerParameter<V, const STEPS: usize>([[V; MOST_PARAMETERS]; STEPS]);

impl<V, const STEPS: usize> AsRef<[V]> for PerParameter<V, STEPS> {
    fn as_ref(&self) -> &[V] {
        self.0.as_flattened()
    }
}

impl<V, const STEPS: usize> AsMut<[V]> for PerParameter<V, STEPS> {
    fn as_mut(&mut self) -> &mut [V] {
        self.0.as_flattened_mut()
    }
}

impl<E: ListElement, const STEPS: usize> Fields for PlannedList<'_, E, STEPS> {
    type PerField<V: Copy + Debug> = PerParameter<V, STEPS>;

    fn per_field<V: Copy + Debug>(value: V) -> PerParameter<V, STEPS> {
        PerParameter([[value; MOST_PARAMETERS]; STEPS])
    }
}

impl<E: ListMoving<S>, S: Scalar, const STEPS: usize> Chain<S> for PlannedList<'_, E, STEPS> {
    fn chain(&self, ends: impl Fn(usize) -> Ends<S>) -> PerParameter<S, STEPS> {
        let mut gradients = Self::per_field(S::zero());
        for (step, gradient) in gradients.0.iter_mut().enumerate() {
            if let Some(element) = self.element(step) {
                *gradient = element.gradient(&ends(step));
            }
        }
        gradients
    }
}
