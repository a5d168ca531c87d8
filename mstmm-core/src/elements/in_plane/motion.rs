//! Motions of an element of the plane between its ends: across itself and along it, side by side.

use crate::element::{CarriesLoad, Deflection, Element, Forms, Inside, MemberEnds, MemberGradient, MemberMotion};
use crate::elements::in_plane::InPlane;
use crate::elements::in_plane::across::{Across, Stretching};
use crate::elements::in_plane::along::AlongMotion;
use crate::elements::shared::rod_motion::Stretch;
use crate::model::EndMotion;
use crate::number::Scalar;

/// The motion of an end as the element across itself has it, or that back again: of a string what is across is along its path.
fn turned<B: Stretching, S: Scalar>(mut end: EndMotion<S>) -> EndMotion<S> {
    if B::IS_STRING {
        end.displacements.swap(0, 1);
        end.forces.swap(0, 1);
    }
    end
}

/// The motion of both ends as the element across itself has it.
fn across<B: Stretching, S: Scalar>(motion: &MemberEnds<S>) -> MemberEnds<S> {
    MemberEnds { x: motion.x, ends: motion.ends.map(turned::<B, S>) }
}

/// What is along the element and what is across it, as the element across itself has both.
fn both<B: Stretching, S: Scalar>([along, across]: [S; 2]) -> [S; 2] {
    if B::IS_STRING { [across, along] } else { [along, across] }
}

impl<B: Stretching + CarriesLoad> CarriesLoad for InPlane<B> {}

impl<B, S: Scalar> MemberMotion<S> for InPlane<B>
where
    B: Stretching<Line: AlongMotion<S>> + MemberMotion<S>,
{
    fn forms(built: &Self::Built, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        let along = built.along.forms(&Stretch::of(first), &Stretch::of(second));
        B::forms(&built.across, &across::<B, S>(first), &across::<B, S>(second)).plus(along)
    }

    fn inside(built: &Self::Built, x: S) -> Option<Inside> {
        let (across, along) = (B::inside(&built.across, x)?, built.along.inside(x));
        Some(Inside { wave_number: across.wave_number.max(along.wave_number), ..across })
    }

    fn motion_at(built: &Self::Built, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
        let along = built.along.state_at(&Stretch::of(motion), distance);
        let bent = B::motion_at(&built.across, &across::<B, S>(motion), distance);
        turned::<B, S>(bent).stretched(along)
    }

    fn deflection(built: &Self::Built, motion: &MemberEnds<S>) -> Option<Deflection<S>> {
        B::deflection(&built.across, &across::<B, S>(motion))
    }

    fn load_work(built: &Self::Built, motion: &MemberEnds<S>) -> Option<[S; 2]> {
        let along = built.along.load_work(&Stretch::of(motion));
        let [_, across] = both::<B, S>(B::load_work(&built.across, &across::<B, S>(motion))?);
        Some([along, across])
    }

    fn mass_per_length(built: &Self::Built) -> S {
        B::mass_per_length(&built.across)
    }

    fn motion_under_load(built: &Self::Built, motion: &MemberEnds<S>, load: [S; 2], distance: f64) -> EndMotion<S> {
        let along = built.along.state_under(&Stretch::of(motion), load[0], distance);
        let (motion, load) = (across::<B, S>(motion), both::<B, S>(load));
        turned::<B, S>(B::motion_under_load(&built.across, &motion, load, distance)).stretched(along)
    }
}

impl<B, S: Scalar> MemberGradient<S> for InPlane<B>
where
    B: Stretching<Line: AlongMotion<S>> + MemberGradient<S, Gradient: Across<Number = S>>,
{
    type Gradient = InPlane<B::Gradient>;

    fn member_gradient(built: &<Self as Element>::Built, motion: &MemberEnds<S>) -> InPlane<B::Gradient> {
        let along = built.along.gradient(&Stretch::of(motion));
        let across = B::member_gradient(&built.across, &across::<B, S>(motion)).and_along(along);
        InPlane { axial_stiffness: along.stiffness, across }
    }
}
