//! The cases of validation.json as lists of steps, with the parameters on which their frequencies depend.

use mstmm::element::{FrequencyEstimates, ParameterError, RootCounter, Support};
use mstmm::elements::{Beam, Mass, Spring};
use mstmm::list::{AnyUndamped, ListStep, StepList};
use mstmm::number::{Frequency, Scaled};
use mstmm::search::{Characteristic, System, Undamped};

/// Steps of a list.
pub(crate) type Sequence = Vec<ListStep<AnyUndamped<f64>>>;

/// Steps for any values of a case's parameters.
type Builder = dyn Fn(&[f64]) -> Sequence;

/// A list of steps that owns them.
pub(crate) struct Steps(pub(crate) Sequence);

impl Steps {
    fn list(&self) -> StepList<'_, AnyUndamped<f64>> {
        StepList::new(&self.0).unwrap()
    }
}

impl System for Steps {
    type Parameter = f64;
    fn name_parts(&self, visitor: &mut dyn mstmm::__private::Visitor) {
        self.list().name_parts(visitor);
    }
    fn frequency_estimates(&self) -> FrequencyEstimates {
        self.list().frequency_estimates()
    }
}

impl Undamped for Steps {}

impl<S: Frequency<f64>> Characteristic<S> for Steps {
    fn pass<C: RootCounter<S>>(&self, x: S, counter: &mut C) -> Scaled<S> {
        self.list().pass(x, counter)
    }
}

/// A case: steps for any values of its parameters, and the values.
pub(crate) struct Case {
    pub(crate) parameters: Vec<f64>,
    steps: Box<Builder>,
}

pub(crate) fn element<E>(element: E) -> ListStep<AnyUndamped<f64>>
where
    AnyUndamped<f64>: TryFrom<E, Error = ParameterError>,
{
    ListStep::Element(element.try_into().unwrap())
}

/// A beam from its length, EI and mass per length.
pub(crate) fn beam(parameters: &[f64]) -> ListStep<AnyUndamped<f64>> {
    let &[length, bending_stiffness, mass_per_length] = parameters else { panic!("{parameters:?}") };
    element(Beam { length, bending_stiffness, mass_per_length })
}

pub(crate) fn spring(stiffness: f64) -> ListStep<AnyUndamped<f64>> {
    element(Spring { stiffness })
}

pub(crate) fn mass(mass: f64) -> ListStep<AnyUndamped<f64>> {
    element(Mass { mass })
}

pub(crate) use mstmm::list::ListStep::{Connection, Root, Tip};

fn support(name: &str) -> Support {
    match name {
        "fixed" => Support::Fixed,
        "pinned" => Support::Pinned,
        "guided" => Support::Guided,
        "free" => Support::Free,
        _ => panic!("no support {name}"),
    }
}

impl Case {
    fn new(parameters: &[f64], steps: impl Fn(&[f64]) -> Sequence + 'static) -> Self {
        Case { parameters: parameters.to_vec(), steps: Box::new(steps) }
    }

    /// The system for values of its parameters.
    pub(crate) fn build(&self, parameters: &[f64]) -> Steps {
        Steps((self.steps)(parameters))
    }

    /// The case with an id of validation.json, read from its parts; `None` for the damped one.
    pub(crate) fn of(id: &str) -> Option<Case> {
        if id == "damped_beam" {
            return None;
        }
        if id == "three_sprung_masses" {
            return Some(sprung_masses());
        }
        let (kind, value) = id.rsplit_once('_').unwrap();
        let number = || value.parse::<f64>().unwrap();
        Some(match kind {
            "tip_spring" => tip_spring(number()),
            "tip_mass" => tip_mass(number()),
            "stepped_light" => stepped(number()),
            "twin_cantilevers" => twins(number()),
            "chain" => chain(value.parse().unwrap()),
            _ => single(support(kind.strip_prefix("single_").unwrap()), support(value)),
        })
    }
}

fn single(tip: Support, root: Support) -> Case {
    Case::new(&[1.0, 1.0, 1.0], move |p| vec![Tip(tip), beam(p), Root(root)])
}

fn tip_spring(k: f64) -> Case {
    Case::new(&[1.0, 1.0, 1.0, k], |p| {
        vec![Tip(Support::Fixed), beam(&p[..3]), Tip(Support::Fixed), spring(p[3]), Connection(2), Root(Support::Free)]
    })
}

fn tip_mass(m: f64) -> Case {
    Case::new(&[1.0, 1.0, 1.0, m], |p| {
        vec![Tip(Support::Fixed), beam(&p[..3]), Tip(Support::Free), mass(p[3]), Connection(2), Root(Support::Free)]
    })
}

fn stepped(ratio: f64) -> Case {
    Case::new(&[0.5, 1.0, 1.0, 0.5, ratio, ratio], |p| {
        vec![Tip(Support::Fixed), beam(&p[..3]), beam(&p[3..]), Root(Support::Free)]
    })
}

/// Two cantilevers whose tips are joined by a spring: out of the first into the spring, in at the second.
fn twins(k: f64) -> Case {
    Case::new(&[1.0, 1.0, 1.0, k], |p| {
        let first = [Tip(Support::Fixed), beam(&p[..3]), Connection(1), spring(p[3])];
        let second = [Tip(Support::Fixed), beam(&p[..3]), Connection(2), Root(Support::Free)];
        first.into_iter().chain(second).collect()
    })
}

fn sprung_masses() -> Case {
    let lengths = [0.1, 0.3, 0.4, 0.2];
    let (masses, springs) = ([0.2, 0.5, 1.0], [3.0, 4.5, 6.0]);
    Case::new(&[&[1.0, 1.0][..], &lengths, &masses, &springs].concat(), |p| {
        let mut steps = vec![Tip(Support::Fixed)];
        for k in 0..3 {
            steps.push(beam(&[p[2 + k], p[0], p[1]]));
            steps.extend([Tip(Support::Free), mass(p[6 + k]), spring(p[9 + k]), Connection(2)]);
        }
        steps.extend([beam(&[p[5], p[0], p[1]]), Root(Support::Free)]);
        steps
    })
}

fn chain(count: usize) -> Case {
    Case::new(&[1.0, 1.0], move |p| {
        let mut steps = vec![Tip(Support::Fixed), spring(p[0])];
        for _ in 0..count {
            steps.extend([mass(p[1]), spring(p[0])]);
        }
        steps.push(Root(Support::Fixed));
        steps
    })
}
