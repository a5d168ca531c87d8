//! A joint with damping of two points at one place.

use crate::element::{Charted, Element, Forms, MemberEnds, MemberGradient, MemberMotion, TransferMatrix};
use crate::elements::DampedPlanarHinge;
use crate::elements::shared::connector::{chart_of_joint, freedoms_of};
use crate::elements::shared::damped_ties::DampedTies;
use crate::model::{FrequencyEstimates, InvalidParameter, Planar};
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::structure::Chart;
use mstmm_plan::Freedoms;
use nalgebra::Matrix6;

/// A massless joint of two points at one place with damping: a [`Joint`](crate::Joint) with κ of a [`DampedPlanarHinge`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedJoint<T> {
    /// The freedoms that are rigid.
    rigid: Freedoms,
    /// Stiffness and damping of those that give way.
    parts: [Option<[T; 2]>; 3],
    /// Loss factor and time of Kelvin and Voigt.
    losses: [T; 2],
}

impl<T: Parameter> DampedJoint<T> {
    /// A joint with springs and dashpots along x, along y and about z where a stiffness or a damping is given, which have a loss factor and a time of
    /// Kelvin and Voigt. It is rigid in the other `freedoms`.
    pub fn hinge(freedoms: Freedoms, stiffness: [Option<T>; 3], damping: [Option<T>; 3], losses: [T; 2]) -> Self {
        let parts = core::array::from_fn(|k| match (stiffness[k], damping[k]) {
            (None, None) => None,
            (stiffness, damping) => Some([stiffness.unwrap_or(T::zero()), damping.unwrap_or(T::zero())]),
        });
        DampedJoint { rigid: freedoms.without(freedoms_of(&parts)), parts, losses }
    }

    /// Whether nothing gives way.
    #[cfg(feature = "std")]
    pub(crate) fn is_rigid(&self) -> bool {
        self.parts.iter().all(Option::is_none)
    }

    /// The freedoms that it ties.
    pub(crate) fn freedoms(&self) -> Freedoms {
        self.rigid.union(freedoms_of(&self.parts))
    }
}

/// A built joint with damping.
#[derive(Clone, Copy, Debug)]
pub struct BuiltDampedJoint<T> {
    rigid: Freedoms,
    flexible: DampedTies<T>,
}

impl<T: Parameter> Element for DampedJoint<T> {
    type State = Planar;
    type Built = BuiltDampedJoint<T>;

    fn build(self) -> Result<BuiltDampedJoint<T>, InvalidParameter> {
        Ok(BuiltDampedJoint { rigid: self.rigid, flexible: DampedTies::new(self.parts, self.losses)? })
    }

    fn estimate(built: &BuiltDampedJoint<T>, estimates: &mut FrequencyEstimates) {
        built.flexible.estimate(estimates);
    }
}

impl<T: Parameter, S: ComplexFrequency<T> + Single> TransferMatrix<S> for DampedJoint<T> {
    /// What it does not tie has rows and columns, too, which no path takes.
    fn transfer_matrix(built: &BuiltDampedJoint<T>, x: S) -> Matrix6<S> {
        DampedPlanarHinge::transfer_matrix(&built.flexible, x)
    }

    fn denominator(built: &BuiltDampedJoint<T>, x: S) -> Option<S> {
        DampedPlanarHinge::denominator(&built.flexible, x)
    }
}

impl<T: Parameter, S: ComplexFrequency<T>> Charted<S> for DampedJoint<T> {
    fn chart(built: &BuiltDampedJoint<T>, at: &FrequencyPowers<S>, _length: S) -> Chart<S> {
        chart_of_joint(built.rigid, built.flexible.ties.map(|tie| tie.map(|tie| tie.at(at.x))))
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberMotion<S> for DampedJoint<T> {
    fn forms(built: &BuiltDampedJoint<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        built.flexible.forms(first.x, of_members(&built.flexible, first, second))
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberGradient<S> for DampedJoint<T> {
    type Gradient = DampedPlanarHinge<S>;

    fn member_gradient(built: &BuiltDampedJoint<T>, motion: &MemberEnds<S>) -> DampedPlanarHinge<S> {
        let ([x, y, theta], [loss_factor, kelvin_voigt_time]) =
            built.flexible.gradient(motion.x, of_members(&built.flexible, motion, motion));
        DampedPlanarHinge {
            stiffness_x: x[0],
            stiffness_y: y[0],
            stiffness_theta: theta[0],
            damping_x: x[1],
            damping_y: y[1],
            damping_theta: theta[1],
            loss_factor,
            kelvin_voigt_time,
        }
    }
}

/// The products of the elongations of two motions between two points.
fn of_members<T: Real, S: ComplexFrequency<T> + Oscillation<T>>(
    flexible: &DampedTies<T>,
    first: &MemberEnds<S>,
    second: &MemberEnds<S>,
) -> [S; 3] {
    core::array::from_fn(|freedom| {
        let Some(tie) = flexible.ties[freedom] else { return S::zero() };
        let [one, other]: [S; 2] = [first, second].map(|motion| tie.elongation(motion, freedom));
        one * other
    })
}
