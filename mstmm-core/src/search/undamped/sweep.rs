//! Sweeps: the lowest frequencies of many models of one topology.

use crate::model::{ParameterError, SearchError};
use crate::pass::searched::Undamped;
use crate::pass::side_by_side::{Lanewise, MODELS};
use crate::search::undamped::found::FrequencyList;
use crate::search::undamped::in_step::InStep;
use crate::search::undamped::natural::{NaturalFrequencies, proven_list};
use crate::search::undamped::sampling::Isolation;
use core::fmt;

/// Why a model of a sweep has no certified frequencies.
#[derive(Clone, Copy, PartialEq)]
pub enum SweepError<E = ParameterError> {
    /// A parameter is out of its range.
    Parameter(E),
    /// The search failed.
    Search(SearchError),
}

impl<E: fmt::Display> fmt::Display for SweepError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SweepError::Parameter(error) => error.fmt(f),
            SweepError::Search(error) => error.fmt(f),
        }
    }
}

impl<E: fmt::Display> fmt::Debug for SweepError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl<E: core::error::Error + 'static> core::error::Error for SweepError<E> {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            SweepError::Parameter(error) => Some(error),
            SweepError::Search(error) => Some(error),
        }
    }
}

/// What a search for the lowest frequencies of a model gives.
type Found<const N: usize> = Result<FrequencyList<f64, N>, SweepError>;

/// Models of one topology, or references to them, one after the other.
pub trait Sweep: Iterator + Sized {
    /// The lowest natural frequencies of each model, as
    /// [`first_frequencies`](NaturalFrequencies::first_frequencies) of the built system gives them, in the order of the models.
    ///
    /// With `std`, in release builds on x86-64 with AVX-512, eight models at a time are searched in step, each in a lane; what does not
    /// keep step is searched alone, as all models are elsewhere. Both ways give proven intervals. Nothing is
    /// allocated; several threads take a part of the models each. A thread of 256 kB is enough, of 512 kB in debug builds.
    ///
    /// # Errors
    /// The items are errors, [`SweepError`], of a model with a parameter out of its range, or whose search fails.
    fn first_frequencies<const N: usize>(self) -> FirstFrequencies<Self, N>
    where
        Self::Item: Lanewise<System<f64>: Undamped<Parameter = f64>>,
    {
        FirstFrequencies::new(self, true)
    }

    /// Estimates of them, as [`estimates`](NaturalFrequencies::estimates) of the built system gives them, at the cost of the fast search alone:
    /// nothing is proven.
    ///
    /// # Errors
    /// As [`first_frequencies`](Sweep::first_frequencies).
    fn estimates<const N: usize>(self) -> FirstFrequencies<Self, N>
    where
        Self::Item: Lanewise<System<f64>: Undamped<Parameter = f64>>,
    {
        FirstFrequencies::new(self, false)
    }
}

impl<I: Iterator> Sweep for I {}

/// An iterator over the lowest frequencies of models, see [`Sweep::first_frequencies`] and [`Sweep::estimates`].
#[derive(Clone, Debug)]
pub struct FirstFrequencies<I, const N: usize> {
    models: I,
    found: [Option<Found<N>>; MODELS],
    next: usize,
    is_proven: bool,
}

impl<I, const N: usize> FirstFrequencies<I, N> {
    fn new(models: I, is_proven: bool) -> Self {
        FirstFrequencies { models, found: [const { None }; MODELS], next: 0, is_proven }
    }
}

impl<I, const N: usize> Iterator for FirstFrequencies<I, N>
where
    I: Iterator<Item: Lanewise<System<f64>: Undamped<Parameter = f64>>>,
{
    type Item = Found<N>;

    fn next(&mut self) -> Option<Found<N>> {
        if self.next == MODELS {
            self.next = 0;
        }
        if self.next == 0 {
            let mut models = [const { None }; MODELS];
            for (place, model) in models.iter_mut().zip(self.models.by_ref()) {
                *place = Some(model);
            }
            self.found = frequencies(&models, self.is_proven);
        }
        let found = self.found[self.next].take();
        self.next = if found.is_some() { self.next + 1 } else { 0 };
        found
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let (least, most) = self.models.size_hint();
        let found = self.found.iter().flatten().count();
        (least.saturating_add(found), most.and_then(|most| most.checked_add(found)))
    }
}

/// The lowest frequencies of up to eight models: of each in step with the others, else alone.
fn frequencies<M, const N: usize>(models: &[Option<M>; MODELS], is_proven: bool) -> [Option<Found<N>>; MODELS]
where
    M: Lanewise<System<f64>: Undamped<Parameter = f64>>,
{
    let systems = models.each_ref().map(|model| model.as_ref().map(M::build));
    let alone = systems.each_ref().map(|system| Some(Isolation::new(system.as_ref()?.as_ref().ok()?)));
    let in_step = InStep::first(models, &alone);
    let mut found = [const { None }; MODELS];
    for ((found, system), in_step) in found.iter_mut().zip(&systems).zip(in_step) {
        *found = system.as_ref().map(|system| match (system, in_step) {
            (Ok(system), Some(proposals)) if is_proven => proven_list(system, proposals).map_err(SweepError::Search),
            (Ok(_), Some(proposals)) => Ok(FrequencyList::from(proposals)),
            (Ok(system), None) if is_proven => system.first_frequencies().map_err(SweepError::Search),
            (Ok(system), None) => system.estimates().map_err(SweepError::Search),
            (Err(error), _) => Err(SweepError::Parameter(*error)),
        });
    }
    found
}
