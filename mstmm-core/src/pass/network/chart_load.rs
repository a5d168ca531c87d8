//! Loads along members in their charts.

use crate::element::{MemberEnds, MemberMotion, VisitMember};
use crate::model::EndMotion;
use crate::number::{Oscillation, Scalar};
use crate::pass::network::placed::PlacedMotions;
use crate::structure::{Chart, MOST_VARIABLES};

/// What Π of a member grows by with each variable of its chart, under a load along it: the work of the load on the motion in which that
/// variable is 1 and the others are none, negative. The chart may have numbers of another precision, to which `nearest` and `precise` lead
/// and lead back.
pub(crate) fn load_on_chart<Y, S, R>(
    (system, x): (&Y, S),
    (member, load): (usize, [S; 2]),
    chart: &Chart<R>,
    nearest: impl Fn(R) -> S,
    precise: impl Fn(S) -> R,
) -> [R; MOST_VARIABLES]
where
    Y: PlacedMotions<S>,
    S: Oscillation<Y::Parameter>,
    R: Scalar,
{
    let zero = [R::zero(); MOST_VARIABLES];
    let mut sums = zero;
    if load.iter().all(|part| part.is_zero()) {
        return sums;
    }
    for place in 0..2 * chart.freedoms.count() {
        let mut values = zero;
        values[place] = R::one();
        let ends = chart.motion(&values, &zero).map(|EndMotion { displacements, forces }| EndMotion {
            displacements: displacements.map(&nearest),
            forces: forces.map(&nearest),
        });
        sums[place] = -precise(load_work(system, member, load, MemberEnds { x, ends }));
    }
    sums
}

/// The work of a load along a member on a motion of it.
pub(crate) fn load_work<Y, S>(system: &Y, member: usize, load: [S; 2], motion: MemberEnds<S>) -> S
where
    Y: PlacedMotions<S>,
    S: Oscillation<Y::Parameter>,
{
    let [along, across] = system.visit_member(member, LoadWork(motion)).flatten().unwrap_or_default();
    along * load[0] + across * load[1]
}

struct LoadWork<S>(MemberEnds<S>);

impl<S: Scalar> VisitMember<S> for LoadWork<S> {
    type Output = Option<[S; 2]>;

    fn member<E: MemberMotion<S>>(self, built: &E::Built) -> Option<[S; 2]> {
        E::load_work(built, &self.0)
    }
}
