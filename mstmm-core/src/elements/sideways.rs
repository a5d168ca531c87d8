//! The second plane of a string in space: there it moves across itself, and does not stretch once more.

use crate::element::{
    ByName, Charted, Element, Forms, Inside, MemberEnds, MemberGradient, MemberMotion, MemberNumbers, TransferMatrix,
};
use crate::elements::Across;
use crate::elements::in_plane::{ChartedAcross, Stretching};
use crate::model::{EndMotion, FrequencyEstimates, InvalidParameter, Planar, StateSpace};
use crate::number::{FrequencyPowers, Scalar, Single};
use crate::structure::Chart;
use mstmm_plan::WIDEST;
use nalgebra::Matrix6;

/// A string that moves across itself between two places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sideways<B> {
    /// The string.
    pub across: B,
}

/// The motion of an end as the string has it, along its path, or that back again.
fn turned<S: Scalar>(mut end: EndMotion<S>) -> EndMotion<S> {
    end.displacements.swap(0, 1);
    end.forces.swap(0, 1);
    end
}

/// The motion of both ends as the string has it.
fn along_path<S: Scalar>(motion: &MemberEnds<S>) -> MemberEnds<S> {
    MemberEnds { x: motion.x, ends: motion.ends.map(turned) }
}

impl<B: Across> Sideways<B> {
    /// The string of another length.
    pub(crate) fn of_length(self, length: B::Number) -> Self {
        Sideways { across: self.across.of_length(length) }
    }
}

#[diagnostic::do_not_recommend]
impl<B: Stretching> Element for Sideways<B> {
    type State = Planar;
    type Built = B::Built;

    fn build(self) -> Result<B::Built, InvalidParameter> {
        self.across.build()
    }

    fn add_axial_force(built: &mut B::Built, force: [f64; 2]) -> Result<bool, InvalidParameter> {
        B::add_axial_force(built, force)
    }

    fn estimate(built: &B::Built, estimates: &mut FrequencyEstimates) {
        B::estimate(built, estimates);
    }

    fn member_numbers(built: &B::Built) -> MemberNumbers {
        B::member_numbers(built).between_places(1)
    }
}

#[diagnostic::do_not_recommend]
impl<B: Stretching + TransferMatrix<S>, S: Single> TransferMatrix<S> for Sideways<B> {
    /// Takes the column of a unit state across; what else the state has the string does not act on.
    fn transfer_matrix(built: &B::Built, x: S) -> Matrix6<S> {
        let across = B::transfer_matrix(built, x);
        let columns: [[S; WIDEST]; WIDEST] = core::array::from_fn(|column| {
            let mut state = core::array::from_fn(|row| if row == column { S::one() } else { S::zero() });
            B::State::transfer(&across, &mut state);
            state
        });
        Matrix6::from_fn(|row, column| columns[column][row])
    }
}

#[diagnostic::do_not_recommend]
impl<B: Stretching + ChartedAcross<S>, S: Scalar> Charted<S> for Sideways<B> {
    fn chart(built: &B::Built, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
        B::chart_across(built, at, length, None)
    }
}

#[diagnostic::do_not_recommend]
impl<B: Stretching + MemberMotion<S>, S: Scalar> MemberMotion<S> for Sideways<B> {
    fn forms(built: &B::Built, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        B::forms(built, &along_path(first), &along_path(second))
    }

    fn inside(built: &B::Built, x: S) -> Option<Inside> {
        B::inside(built, x)
    }

    fn motion_at(built: &B::Built, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
        turned(B::motion_at(built, &along_path(motion), distance))
    }

    fn load_work(built: &B::Built, motion: &MemberEnds<S>) -> Option<[S; 2]> {
        let [across, along] = B::load_work(built, &along_path(motion))?;
        Some([along, across])
    }

    fn mass_per_length(built: &B::Built) -> S {
        B::mass_per_length(built)
    }

    fn motion_under_load(
        built: &B::Built,
        motion: &MemberEnds<S>,
        [along, across]: [S; 2],
        distance: f64,
    ) -> EndMotion<S> {
        turned(B::motion_under_load(built, &along_path(motion), [across, along], distance))
    }
}

#[diagnostic::do_not_recommend]
impl<B: Stretching + MemberGradient<S>, S: Scalar> MemberGradient<S> for Sideways<B> {
    type Gradient = Sideways<B::Gradient>;

    fn member_gradient(built: &B::Built, motion: &MemberEnds<S>) -> Sideways<B::Gradient> {
        Sideways { across: B::member_gradient(built, &along_path(motion)) }
    }
}

impl<S: Copy, G: ByName<S>> ByName<S> for Sideways<G> {
    /// The slope by the length is in the slopes by the places of its ends.
    fn by_name(&self, name: &str) -> Option<S> {
        if name == "length" { None } else { self.across.by_name(name) }
    }
}
