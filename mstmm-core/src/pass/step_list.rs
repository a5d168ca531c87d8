//! The plane method runs over a list of steps, with the arithmetic of the macro's code, for trees whose size the program decides.

use crate::element::{ListElement, ListStepping, PlaneStep, VisitStep};
use crate::model::FrequencyEstimates;
use crate::model::error;
use crate::number::{Frequency, FrequencyPowers, InLanes, Scalar, Scaled};
use crate::pass::characteristic::{Characteristic, System};
use crate::pass::inlining::into_root;
use crate::pass::searched::{ComplexPasses, RealPasses, Spectrum, Undamped};
use crate::proof::visit::Visitor;
use crate::subspace::{Connecting, RootCounter, Subspace, connection};
use core::fmt;
use mstmm_plan::{Space, Support};

/// Number of paths that may be open at once while a list is evaluated: branches within branches.
pub const OPEN_PATHS: usize = 64;

/// A step of a list: tips before the elements that they lead to, inputs of a connection before it, the root last.
#[derive(Clone, Copy, Debug)]
pub enum ListStep<E> {
    /// A path starts from a support.
    Tip(Support),
    /// The last open path goes through an element.
    Element(E),
    /// The last so many open paths are joined.
    Connection(usize),
    /// The one open path ends in the root.
    Root(Support),
}

/// A list that cannot be evaluated.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct ListError {
    /// Index of the step.
    pub step: usize,
    /// What is wrong with it.
    pub problem: &'static str,
}

impl fmt::Display for ListError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "step {}: {}", self.step, self.problem)
    }
}

error! { ListError }

/// A tree of elements as a list of steps in the caller's memory.
///
/// ```
/// use mstmm_core::elements::{Mass, Spring};
/// use mstmm_core::search::NaturalFrequencies;
/// use mstmm_core::{AnyUndamped, ListStep, StepList, Support};
///
/// let steps = [
///     ListStep::Tip(Support::Fixed),
///     ListStep::Element(AnyUndamped::try_from(Spring { stiffness: 8.0_f64 })?),
///     ListStep::Element(Mass { mass: 2.0 }.try_into()?),
///     ListStep::Root(Support::Free),
/// ];
/// let list = StepList::new(&steps).unwrap();
/// let found = list.first_frequencies::<1>().unwrap();
/// assert!((found[0].omega - 2.0).abs() < 1e-15);
/// # Ok::<(), mstmm_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct StepList<'a, E> {
    pub(crate) steps: &'a [ListStep<E>],
}

impl<'a, E: ListElement> StepList<'a, E> {
    /// A list that can be evaluated.
    ///
    /// # Errors
    /// [`ListError`] for a step without the open paths that it takes, states that do not fit, or a list that does not end
    /// in one root.
    pub fn new(steps: &'a [ListStep<E>]) -> Result<Self, ListError> {
        let mut open = [Open { space: None, support: None }; OPEN_PATHS];
        let mut count = 0;
        for (step, entry) in steps.iter().enumerate() {
            let fail = |problem| Err(ListError { step, problem });
            match entry {
                ListStep::Tip(_) if count == OPEN_PATHS => {
                    return fail("as many paths as may be are open: a connection before joins some");
                }
                ListStep::Tip(support) => {
                    let space = next_space(steps, step);
                    if space.is_some_and(|space| !is_support_of(*support, space)) {
                        return fail("the path that starts here has no such support");
                    }
                    open[count] = Open { space, support: Some(*support) };
                    count += 1;
                }
                ListStep::Element(_) if count == 0 => {
                    return fail("no path is open that could go through this element");
                }
                ListStep::Element(element) => match open[count - 1].space {
                    Some(space) if !space.is(element.space()) => {
                        return fail(
                            "the path has another state than this element: a connection leads from one to the other",
                        );
                    }
                    _ => open[count - 1] = Open { space: Some(element.space()), support: None },
                },
                ListStep::Connection(0) => return fail("a connection joins one path or more"),
                ListStep::Connection(inputs) if *inputs > count => return fail("fewer paths are open than it joins"),
                ListStep::Connection(inputs) => {
                    let joined = joined(&open[count - inputs..count], next_space(steps, step));
                    count -= inputs - 1;
                    match joined {
                        Ok(space) => open[count - 1] = Open { space: Some(space), support: None },
                        Err(problem) => return fail(problem),
                    }
                }
                ListStep::Root(_) if step + 1 != steps.len() => return fail("steps follow the root"),
                ListStep::Root(_) if count == 0 => return fail("no path is open that could end in the root"),
                ListStep::Root(_) if count > 1 => {
                    return fail("several paths are open at the root: a connection joins them");
                }
                ListStep::Root(support) => match open[0] {
                    Open { space: Some(space), support: None } if is_support_of(*support, space) => {}
                    Open { space: Some(_), support: None } => {
                        return fail("the path that ends here has no such support");
                    }
                    _ => return fail("the path that ends here has no element"),
                },
            }
        }
        if steps.is_empty() {
            return Err(ListError { step: 0, problem: "the list is empty" });
        }
        if !matches!(steps.last(), Some(ListStep::Root(_))) {
            return Err(ListError { step: steps.len(), problem: "the list does not end in a root" });
        }
        Ok(StepList { steps })
    }
}

/// An open path while a list is checked.
#[derive(Clone, Copy)]
struct Open {
    /// Its space; none behind a support that holds a connection and adopts the space of that.
    space: Option<Space>,
    /// The support behind which nothing has come yet.
    support: Option<Support>,
}

fn is_support_of(support: Support, space: Space) -> bool {
    !space.is(Space::Planar) && support.exists_in(space)
}

/// Returns the space in which a connection leads on, or why its paths cannot meet.
fn joined(inputs: &[Open], next: Option<Space>) -> Result<Space, &'static str> {
    let paths = inputs.iter().filter(|path| path.support.is_none()).filter_map(|path| path.space);
    let own = match paths.reduce(|a, b| a.join(b).unwrap_or(Space::Planar)) {
        Some(space) => space,
        None => next.ok_or("supports alone")?,
    };
    // the widest state here is what supports hold
    let widest = next.map_or(Some(own), |next| own.join(next));
    let Some(widest @ (Space::Translation | Space::Rotation | Space::Bending)) = widest else {
        return Err("its paths cannot meet, or not lead on to that state");
    };
    let holds = |path: &Open| path.support.is_none_or(|support| is_support_of(support, widest));
    if inputs.iter().all(holds) { Ok(next.unwrap_or(own)) } else { Err("a support that its state does not have") }
}

/// Returns the space of the element that follows a step, if one does.
fn next_space<E: ListElement>(steps: &[ListStep<E>], step: usize) -> Option<Space> {
    match steps.get(step + 1) {
        Some(ListStep::Element(element)) => Some(element.space()),
        _ => None,
    }
}

impl<E: ListElement> System for StepList<'_, E> {
    type Parameter = E::Parameter;
    const MAY_BUCKLE: bool = E::MAY_BUCKLE;

    fn may_buckle(&self) -> bool {
        let may = |step: &ListStep<E>| matches!(step, ListStep::Element(element) if element.may_buckle());
        E::MAY_BUCKLE && self.steps.iter().any(may)
    }

    fn name_parts(&self, visitor: &mut dyn Visitor) {
        // the steps that the open paths have come to
        let (mut open, mut count) = ([0; OPEN_PATHS], 0);
        for (step, entry) in self.steps.iter().enumerate() {
            match entry {
                ListStep::Tip(support) => {
                    visitor.tip(step, *support);
                    count += 1;
                }
                ListStep::Element(element) => {
                    visitor.element(step, open[count - 1], element.space(), &element.member_numbers());
                }
                ListStep::Connection(inputs) => {
                    visitor.connection(step, &open[count - inputs..count], next_space(self.steps, step));
                    count -= inputs - 1;
                }
                ListStep::Root(support) => visitor.root(open[0], *support),
            }
            open[count - 1] = step;
        }
    }

    fn frequency_estimates(&self) -> FrequencyEstimates {
        let mut estimates = FrequencyEstimates::default();
        for step in self.steps {
            if let ListStep::Element(element) = step {
                element.estimate(&mut estimates);
            }
        }
        estimates.finish();
        estimates
    }
}

impl<E, S> Characteristic<S> for StepList<'_, E>
where
    E: ListStepping<S>,
    S: Frequency<E::Parameter>,
{
    fn pass<C: RootCounter<S>>(&self, x: S, counter: &mut C) -> Scaled<S> {
        let at = FrequencyPowers::new(x, true);
        let mut open = [Subspace::Tip(Support::Free, Space::Bending); OPEN_PATHS];
        let mut count = 0;
        for (index, step) in self.steps.iter().enumerate() {
            match step {
                ListStep::Tip(support) => {
                    let space = next_space(self.steps, index).unwrap_or(Space::Bending);
                    open[count] = Subspace::Tip(*support, space);
                    count += 1;
                }
                ListStep::Element(element) => {
                    let input = open[count - 1];
                    if let Some(ListStep::Root(support)) = self.steps.get(index + 1) {
                        return element.visit_step(IntoRoot { at: &at, input, support: *support, counter });
                    }
                    open[count - 1] = element.visit_step(Through { at: &at, input, counter });
                }
                ListStep::Connection(inputs) => {
                    let joined =
                        connection(open[count - inputs..count].iter().copied(), next_space(self.steps, index), counter);
                    count -= inputs - 1;
                    open[count - 1] = joined;
                }
                ListStep::Root(support) => return open[0].at_root(*support, counter),
            }
        }
        Scaled::new(S::zero(), 0) // `new` has refused lists without a root
    }
}

impl<E: ListElement<Parameter: InLanes>> Undamped for StepList<'_, E> where Self: RealPasses {}

impl<E: ListElement> Spectrum for StepList<'_, E> where Self: ComplexPasses {}

/// Takes a subspace through an element.
struct Through<'a, S, C> {
    at: &'a FrequencyPowers<S>,
    input: Subspace<S>,
    counter: &'a mut C,
}

impl<S: Scalar, C: RootCounter<S>> VisitStep<S> for Through<'_, S, C> {
    type Output = Subspace<S>;

    fn element<E: PlaneStep<S>>(self, built: &E::Built) -> Subspace<S> {
        <E as PlaneStep<S>>::step(&E::coefficients(built, self.at), self.input, self.counter)
    }
}

/// Takes a subspace through the last element into the root.
struct IntoRoot<'a, S, C> {
    at: &'a FrequencyPowers<S>,
    input: Subspace<S>,
    support: Support,
    counter: &'a mut C,
}

impl<S: Scalar, C: RootCounter<S>> VisitStep<S> for IntoRoot<'_, S, C> {
    type Output = Scaled<S>;

    fn element<E: PlaneStep<S>>(self, built: &E::Built) -> Scaled<S> {
        into_root::<E, S, C>(&E::coefficients(built, self.at), self.input, self.support, self.counter)
    }
}
