//! A load along members and its own work: what bounds of sums over modes ask of it.

use crate::answer::at_rest::Part;
use crate::answer::facts::Facts;
use crate::answer::modal::response::Superposed;
use crate::answer::network::of_frame::for_each_shape;
use crate::answer::network::response::PlaneResponse;
use crate::answer::network::states::PlaneStates;
use crate::answer::network::under_load::UnderLoad;
use crate::answer::root::Root;
use crate::element::{MemberEnds, MemberMotion, VisitMember};
use crate::model::{MotionError, PlaneActing, PlaneLoad, SpreadLoad};
use crate::number::gauss::integrals;
use crate::number::{Oscillation, Real, Scalar};
use crate::pass::characteristic::System;
use crate::pass::network::{MovingNetwork, Placed, PlaneFrequency, Wanted};
use core::marker::PhantomData;
use num_traits::Zero;

/// A load along members, with its work on the motion under it.
pub(super) struct OwnLoad<'a, Y: Placed>(UnderLoad<'a, Y>);

impl<'a, Y: Placed> OwnLoad<'a, Y> {
    pub(super) fn new(system: &'a Y, load: PlaneLoad<Y::Model>) -> Result<Self, MotionError> {
        UnderLoad::new(system, load).map(OwnLoad)
    }
}

/// How far a load of 1 at rest moves its own place, or the work of one along a member.
pub(crate) fn compliance_under<Y, T>(system: &Y, load: PlaneLoad<Y::Model>) -> Result<T, MotionError>
where
    T: Real + PlaneFrequency<T>,
    Y: Placed + MovingNetwork<T> + System<Parameter = T>,
{
    let under = UnderLoad::new(system, load)?;
    match load.acting {
        PlaneActing::Force(..) => {
            let own = load.dual().ok_or(MotionError::NotModal)?;
            PlaneResponse::new(system, load, own)?.at(T::zero())
        }
        PlaneActing::Spread(SpreadLoad { member: Some(_), .. }) => under.states(T::zero(), Wanted::All)?.own_work(),
        _ => Err(MotionError::NotModal),
    }
}

impl<T, R, Y> Superposed<T, R> for OwnLoad<'_, Y>
where
    T: Real,
    R: Root<T, Frequency: PlaneFrequency<T>>,
    Y: MovingNetwork<R::Frequency> + System<Parameter = T>,
{
    fn for_each_product<const CAP: usize>(
        &self,
        root: &R,
        add: &mut dyn FnMut(R::Frequency) -> Result<(), MotionError>,
    ) -> Result<(), MotionError> {
        let square = |work: R::Frequency| work * work;
        for_each_shape::<CAP, _, _, _>(self.0.system, root, |shape| shape.work(self.0.load).map(square), add)
    }

    /// Of what floats there is no limit: integrals along members have too many waves where it is sought.
    fn held_at_rest(&self) -> Result<Option<R::Frequency>, MotionError> {
        self.0.states(R::Frequency::zero(), Wanted::All)?.own_work().map(Some)
    }

    fn exactly(&self, x: R::Frequency) -> Result<R::Frequency, MotionError> {
        self.0.states(x, Wanted::All)?.own_work()
    }

    fn sized(&self, x: R::Frequency) -> Result<Part<R::Frequency>, MotionError> {
        let value = self.0.states(x, Wanted::All)?.own_work()?;
        Ok(Part::new(value, value.size()))
    }

    fn lowest_exponent(&self) -> i32 {
        self.0.lowest_exponent()
    }

    fn facts(&self) -> Facts<T> {
        Facts::default()
    }

    fn has_loss(&self) -> bool {
        self.0.system.frequency_estimates().has_loss()
    }
}

impl<Y, S> PlaneStates<'_, Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    /// The work of a load along members on the motion under it, by integrals along all of them.
    fn own_work(&self) -> Result<S, MotionError> {
        let Some(load) = self.load else { return Ok(S::zero()) };
        let mut work = self.work_on_nodes(&load)?;
        for member in 0..self.system.sizes()[1] {
            if let Some(load) = self.load_on(member) {
                let own = OwnWork::<Y::Parameter, S> { ends: self.member_ends(member), load, numbers: PhantomData };
                work += self.system.visit_member(member, own).unwrap_or_default();
            }
        }
        Ok(work)
    }
}

/// The work of a load along a member and across it on the motion under it.
struct OwnWork<T, S> {
    ends: MemberEnds<S>,
    load: [S; 2],
    numbers: PhantomData<fn() -> T>,
}

impl<T: Real, S: Oscillation<T>> VisitMember<S> for OwnWork<T, S> {
    type Output = S;

    fn member<E: MemberMotion<S>>(self, built: &E::Built) -> S {
        let OwnWork { ends, load: load @ [along, across], .. } = self;
        let Some(inside) = E::inside(built, ends.x) else { return S::zero() };
        let [work] = integrals(T::from_f64(inside.length), inside.wave_number * inside.length, |distance: T| {
            let [x, y, _] = E::motion_under_load(built, &ends, load, distance.to_f64()).displacements;
            [x * along + y * across]
        });
        work
    }
}
