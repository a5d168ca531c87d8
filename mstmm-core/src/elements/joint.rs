//! Joint of two points at one place.

use crate::element::{
    Charted, Element, Forms, MemberEnds, MemberGradient, MemberMotion, MemberNumbers, TransferMatrix,
};
use crate::elements::planar_hinge::hinge_matrix;
use crate::elements::shared::connector::{chart_of_joint, freedoms_of};
use crate::elements::shared::line_forms::half;
use crate::elements::shared::massless;
use crate::elements::{ElasticHinge, PlanarHinge};
use crate::model::{EndMotion, FrequencyEstimates, InvalidParameter, Planar, Requirement};
use crate::number::{Frequency, FrequencyPowers, Parameter, Single};
use crate::structure::Chart;
use mstmm_plan::Freedoms;
use nalgebra::Matrix6;

/// A massless joint of two points at one place, which ties freedoms rigidly or by springs: a pin, a slider, an elastic hinge.
///
/// With `κ` of a spring, and without a flexibility where it is rigid, of each tied freedom
///
/// ```text
/// f_input = -f_output        u_input - u_output = f/κ
/// ```
///
/// Its axes are those of the plane, or x leads along a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint<T> {
    /// The freedoms that are rigid.
    rigid: Freedoms,
    /// The stiffnesses of x and y [N/m] and about z [N m/rad].
    elastic: [Option<T>; 3],
}

/// The elongation of a spring of a joint.
fn elongation<T: Parameter, S: Frequency<T>>(stiffness: T, ends: &[EndMotion<S>; 2], freedom: usize) -> S {
    massless::elongation(S::from_parameter(stiffness), stiffness.to_f64(), ends, freedom)
}

/// The parameters by which hinges give the stiffnesses.
const NAMES: [&str; 3] = ["stiffness_x", "stiffness_y", "stiffness_theta"];

impl<T> Joint<T> {
    /// A joint that ties freedoms rigidly.
    ///
    /// ```
    /// use mstmm_core::{Freedoms, Joint};
    /// let pin = Joint::<f64>::rigid(Freedoms::X.union(Freedoms::Y));
    /// let slider_along_x = Joint::<f64>::rigid(Freedoms::Y.union(Freedoms::RZ));
    /// # assert_ne!(pin, slider_along_x);
    /// ```
    pub fn rigid(freedoms: Freedoms) -> Self {
        Joint { rigid: freedoms, elastic: [const { None }; 3] }
    }

    /// A joint with springs along x, along y and about z where a stiffness is given. It is rigid in the other `freedoms`.
    pub fn hinge(freedoms: Freedoms, stiffness: [Option<T>; 3]) -> Self {
        Joint { rigid: freedoms.without(freedoms_of(&stiffness)), elastic: stiffness }
    }
}

#[cfg(feature = "std")]
impl<T> Joint<T> {
    /// Whether it has no spring.
    pub(crate) fn is_rigid(&self) -> bool {
        self.elastic.iter().all(Option::is_none)
    }
}

impl<T> From<ElasticHinge<T>> for Joint<T> {
    fn from(hinge: ElasticHinge<T>) -> Self {
        let ElasticHinge { stiffness_y, stiffness_theta } = hinge;
        Joint { rigid: Freedoms::NONE, elastic: [None, Some(stiffness_y), Some(stiffness_theta)] }
    }
}

impl<T> From<PlanarHinge<T>> for Joint<T> {
    fn from(hinge: PlanarHinge<T>) -> Self {
        let PlanarHinge { stiffness_x, stiffness_y, stiffness_theta } = hinge;
        Joint { rigid: Freedoms::NONE, elastic: [stiffness_x, stiffness_y, stiffness_theta].map(Some) }
    }
}

impl<T: Parameter> Joint<T> {
    /// The freedoms that it ties.
    pub(crate) fn freedoms(&self) -> Freedoms {
        self.rigid.union(freedoms_of(&self.elastic))
    }
}

impl<T: Parameter> Element for Joint<T> {
    type State = Planar;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        for (name, stiffness) in NAMES.into_iter().zip(self.elastic) {
            stiffness.map_or(Ok(()), |stiffness| Requirement::InvertibleOrZero.check(name, stiffness))?;
        }
        Ok(self)
    }

    fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
        let [x, y, rotation] = built.elastic;
        [x, y].into_iter().flatten().for_each(|stiffness| estimates.translational_stiffness(stiffness.to_f64()));
        rotation.into_iter().for_each(|stiffness| estimates.torsional_stiffness(stiffness.to_f64()));
    }

    fn member_numbers(built: &Self) -> MemberNumbers {
        MemberNumbers::Joint(built.rigid, built.elastic.map(|stiffness| stiffness.map_or([0.0; 2], T::words)))
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for Joint<T> {
    /// That of a [`PlanarHinge`], without compliances where it is rigid. What it does not tie has rows and columns, too, which no path takes.
    fn transfer_matrix(built: &Self, _x: S) -> Matrix6<S> {
        let compliance = |stiffness: T| S::from_parameter(T::one() / stiffness);
        hinge_matrix(built.elastic.map(|stiffness| stiffness.map_or(S::zero(), compliance)))
    }
}

impl<T: Parameter, S: Frequency<T>> Charted<S> for Joint<T> {
    fn chart(built: &Self, _at: &FrequencyPowers<S>, _length: S) -> Chart<S> {
        chart_of_joint(built.rigid, built.elastic.map(|stiffness| stiffness.map(S::from_parameter)))
    }
}

impl<T: Parameter, S: Frequency<T>> MemberGradient<S> for Joint<T> {
    type Gradient = PlanarHinge<S>;

    /// Half of the square of the elongation of each spring, which one without stiffness has, too.
    fn member_gradient(built: &Self, motion: &MemberEnds<S>) -> PlanarHinge<S> {
        let [stiffness_x, stiffness_y, stiffness_theta] = [0, 1, 2].map(|freedom| {
            built.elastic[freedom].map_or(S::zero(), |stiffness| {
                let elongation = elongation(stiffness, &motion.ends, freedom);
                half(elongation * elongation)
            })
        });
        PlanarHinge { stiffness_x, stiffness_y, stiffness_theta }
    }
}

impl<T: Parameter, S: Frequency<T>> MemberMotion<S> for Joint<T> {
    /// Stiffnesses times the elongations of both motions.
    fn forms(built: &Self, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        let mut stiffness = S::zero();
        for (freedom, own) in built.elastic.iter().enumerate() {
            let Some(own) = own else { continue };
            let [one, other]: [S; 2] = [first, second].map(|motion| elongation(*own, &motion.ends, freedom));
            stiffness += one * other * S::from_parameter(*own);
        }
        Forms { stiffness, ..Forms::none() }
    }
}
