//! Hinges with damping: in a bending path, in a planar path, and between two points at one place.

use crate::element::{
    BackTransfer, Charted, Element, Energies, Forms, MemberEnds, MemberGradient, MemberMotion, MemberWork, PlaneStep,
    TransferMatrix,
};
use crate::elements::shared::connector::{Tie, chart_of_ties};
use crate::elements::shared::damped_stiffness::DampedStiffness;
use crate::elements::shared::line_forms::elongations;
use crate::elements::shared::massless::off_pole;
use crate::model::{Bending, Ends, FrequencyEstimates, InvalidParameter, Planar, Requirement};
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real, Scalar, Single, Size, Truth};
use crate::structure::Chart;
use crate::subspace::{Covector, Held, Plane, RootCounter, Subspace};
use mstmm_plan::{Coordinate, Freedoms};
use nalgebra::{Matrix4, Matrix6};

/// The parameters by which hinges give stiffness and damping along x, along y and about z.
const NAMES: [[&str; 2]; 3] =
    [["stiffness_x", "damping_x"], ["stiffness_y", "damping_y"], ["stiffness_theta", "damping_theta"]];

/// What gives way in each freedom, along x, along y and about z; none where it is rigid, or not tied.
#[derive(Clone, Copy, Debug)]
pub struct DampedTies<T> {
    ties: [Option<DampedStiffness<T>>; 3],
}

impl<T: Parameter> DampedTies<T> {
    /// The ties of stiffnesses and dampings, with a loss factor and a time.
    fn new(parts: [Option<[T; 2]>; 3], [loss_factor, time]: [T; 2]) -> Result<Self, InvalidParameter> {
        let mut ties = [None; 3];
        for ((tie, part), names) in ties.iter_mut().zip(parts).zip(NAMES) {
            let Some([stiffness, damping]) = part else { continue };
            let numbers = [stiffness, loss_factor, time, damping];
            *tie = Some(DampedStiffness::new(Requirement::InvertibleOrZero, numbers, names)?);
        }
        Ok(DampedTies { ties })
    }

    /// The same of numbers of which those of a rigid freedom are infinite.
    fn or_rigid(parts: [[T; 2]; 3], losses: [T; 2]) -> Result<Self, InvalidParameter> {
        DampedTies::new(parts.map(|part| (part[0].to_f64() != f64::INFINITY).then_some(part)), losses)
    }

    /// Adds stiffnesses, dampings and losses to the estimates.
    fn estimate(&self, estimates: &mut FrequencyEstimates) {
        let [x, y, rotation] = self.ties;
        for tie in [x, y].into_iter().flatten() {
            let own = [FrequencyEstimates::translational_stiffness, FrequencyEstimates::translational_damping];
            tie.estimate(estimates, own);
        }
        if let Some(tie) = rotation {
            tie.estimate(estimates, [FrequencyEstimates::torsional_stiffness, FrequencyEstimates::torsional_damping]);
        }
    }

    /// The compliance of each freedom, zero where it is rigid.
    fn compliances<S: ComplexFrequency<T> + Single>(&self, x: S) -> [S; 3] {
        self.ties.map(|tie| tie.map_or(S::zero(), |tie| off_pole(tie.at(x)).1))
    }

    /// The product of all dynamic stiffnesses, whose zeros are poles of the compliances.
    fn denominator<S: ComplexFrequency<T> + Single>(&self, x: S) -> S {
        self.ties.iter().flatten().fold(S::one(), |product, tie| product * off_pole(tie.at(x)).0)
    }
}

impl<T: Real> DampedTies<T> {
    /// The forms of two motions, the first of them at λ, given the products of their elongations.
    fn forms<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S, elongations: [S; 3]) -> Forms<S> {
        let parts = self.ties.iter().zip(elongations);
        let forms = parts.filter_map(|(tie, product)| Some(tie.as_ref()?.forms(lambda, product)));
        forms.fold(Forms::none(), Forms::plus)
    }

    /// The derivatives of the dynamic work with respect to stiffness and damping of each freedom, and to loss factor and time, given the squares of
    /// the elongations.
    fn gradient<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S, squares: [S; 3]) -> ([[S; 2]; 3], [S; 2]) {
        let (mut own, mut losses) = ([[S::zero(); 2]; 3], [S::zero(); 2]);
        for ((own, tie), square) in own.iter_mut().zip(&self.ties).zip(squares) {
            let Some(tie) = tie else { continue };
            let [stiffness, loss, time, damping] = tie.gradient(lambda, square);
            *own = [stiffness, damping];
            losses = [losses[0] + loss, losses[1] + time];
        }
        (own, losses)
    }
}

/// Massless hinge in a bending path with damping, at complex frequencies λ only: in each freedom `κ = K (1 + iη)(1 + cλ) + dλ`.
///
/// Transfer matrix on `[Y, Θ, M, Q]`: the identity plus `-1/κ_y` at (Y, Q) and `1/κ_θ` at (Θ, M). A plane goes on times both κ, so that a
/// κ of zero lets go.
///
/// # Source
/// Eq. (32) of the paper with complex stiffnesses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedHinge<T> {
    /// Translational stiffness K_y [N/m], zero or positive; infinite is rigid.
    pub stiffness_y: T,
    /// Torsional stiffness K_θ [N m/rad], zero or positive; infinite is rigid.
    pub stiffness_theta: T,
    /// Damping d_y of a dashpot beside the one [N s/m], zero or positive.
    pub damping_y: T,
    /// Damping d_θ of a dashpot beside the other [N m s/rad], zero or positive.
    pub damping_theta: T,
    /// Loss factor η, zero or positive.
    pub loss_factor: T,
    /// Time c of Kelvin and Voigt \[s\], zero or positive.
    pub kelvin_voigt_time: T,
}

impl<T: Parameter> Element for DampedHinge<T> {
    type State = Bending;
    type Built = DampedTies<T>;
    const IS_STRAIGHT: bool = false;

    fn build(self) -> Result<DampedTies<T>, InvalidParameter> {
        let DampedHinge { stiffness_y, stiffness_theta, damping_y, damping_theta, loss_factor, kelvin_voigt_time } =
            self;
        let along_x = [T::from_f64(f64::INFINITY), T::zero()];
        DampedTies::or_rigid(
            [along_x, [stiffness_y, damping_y], [stiffness_theta, damping_theta]],
            [loss_factor, kelvin_voigt_time],
        )
    }

    fn estimate(built: &DampedTies<T>, estimates: &mut FrequencyEstimates) {
        built.estimate(estimates);
    }
}

impl<T: Parameter, S: ComplexFrequency<T> + Single> TransferMatrix<S> for DampedHinge<T> {
    fn transfer_matrix(built: &DampedTies<T>, x: S) -> Matrix4<S> {
        let [_, y, rotation] = built.compliances(x);
        let mut u = Matrix4::identity();
        (u[(0, 3)], u[(1, 2)]) = (-y, rotation);
        u
    }

    fn denominator(built: &DampedTies<T>, x: S) -> Option<S> {
        Some(built.denominator(x))
    }
}

/// Of both freedoms κ, or 1 where it is rigid, and 1, or 0 there: the compliance is the second over the first.
#[derive(Clone, Copy, Debug)]
pub struct DampedHingeCoefficients<S> {
    stiffness: [S; 2],
    gives_way: [S; 2],
}

impl<S: Scalar> DampedHingeCoefficients<S> {
    /// Takes a plane through the hinge, times both stiffnesses.
    fn through(&self, p: &Plane<S>) -> Plane<S> {
        let ([y, rotation], [of_y, of_rotation]) = (self.stiffness, self.gives_way);
        let product = y * rotation;
        let (mixed_y, mixed_rotation) = (y * of_rotation, rotation * of_y);
        let minors = [
            p.y_theta * product + p.y_m * mixed_y + p.theta_q * mixed_rotation + p.m_q * of_y * of_rotation,
            p.y_m * product + p.m_q * mixed_rotation,
            p.w * product,
            p.theta_q * product + p.m_q * mixed_y,
            p.m_q * product,
        ];
        Plane::new(minors, p.exponent)
    }
}

impl<T: Parameter, S: ComplexFrequency<T>> PlaneStep<S> for DampedHinge<T> {
    type Coefficients = DampedHingeCoefficients<S>;

    fn coefficients(built: &DampedTies<T>, at: &FrequencyPowers<S>) -> DampedHingeCoefficients<S> {
        let [_, y, rotation] = built.ties;
        let both = [y, rotation].map(|tie| tie.map_or([S::one(), S::zero()], |tie| [tie.at(at.x), S::one()]));
        DampedHingeCoefficients { stiffness: both.map(|part| part[0]), gives_way: both.map(|part| part[1]) }
    }

    fn step<C: RootCounter<S>>(
        coefficients: &DampedHingeCoefficients<S>,
        input: Subspace<S>,
        counter: &mut C,
    ) -> Subspace<S> {
        let before = input.plane();
        let after = coefficients.through(&before);
        let stiffness = [coefficients.stiffness[0], S::one()];
        let held = Held { below: S::Size::of(0.0), is_negative: S::Truth::of(false), stiffness, units: None };
        counter.plane(&before, &after, held);
        Subspace::Plane(after)
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> BackTransfer<S> for DampedHinge<T> {
    type BackCoefficients = DampedHingeCoefficients<S>;
    const SYMMETRIC: bool = true;

    fn reversed(built: &DampedTies<T>) -> DampedTies<T> {
        *built
    }

    fn back_coefficients(built: &DampedTies<T>, at: &FrequencyPowers<S>) -> DampedHingeCoefficients<S> {
        Self::coefficients(built, at)
    }

    /// `κ_y κ_θ Uᵀ η`, since the step multiplies by the stiffnesses.
    fn back_transfer(
        coefficients: &DampedHingeCoefficients<S>,
        _input: &Subspace<S>,
        covector: Covector<S>,
    ) -> Covector<S> {
        let ([y, theta, m, q], exponent) = covector.entries();
        let ([of_y, of_theta], [gives_y, gives_theta]) = (coefficients.stiffness, coefficients.gives_way);
        let product = of_y * of_theta;
        let entries = [
            y * product,
            theta * product,
            m * product + theta * of_y * gives_theta,
            q * product - y * of_theta * gives_y,
        ];
        Covector::Plane(entries, exponent)
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> Energies<S> for DampedHinge<T> {
    type Gradient = DampedHinge<S>;

    fn units(built: &DampedTies<T>, at: &FrequencyPowers<S>) -> [f64; 2] {
        let [_, y, rotation] = built.ties;
        [y, rotation].map(|tie| tie.map_or(0.0, |tie| tie.size(S::size(at.x))))
    }

    fn mass_form(_built: &DampedTies<T>, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    fn stiffness_form(built: &DampedTies<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first.x, of_path(first, second)).stiffness
    }

    fn damping_form(built: &DampedTies<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first.x, of_path(first, second)).damping
    }

    fn gradient(built: &DampedTies<T>, ends: &Ends<S>) -> DampedHinge<S> {
        let ([_, [stiffness_y, damping_y], [stiffness_theta, damping_theta]], [loss_factor, kelvin_voigt_time]) =
            built.gradient(ends.x, of_path(ends, ends));
        DampedHinge { stiffness_y, stiffness_theta, damping_y, damping_theta, loss_factor, kelvin_voigt_time }
    }
}

/// The products of the elongations of two motions of a bending path.
fn of_path<S: Scalar>(first: &Ends<S>, second: &Ends<S>) -> [S; 3] {
    let [y, rotation] = [Coordinate::Y, Coordinate::Theta].map(|coordinate| elongations(coordinate, first, second));
    [S::zero(), y, rotation]
}

/// Massless hinge in planar motion with damping, at complex frequencies λ only: in each freedom `κ = K (1 + iη)(1 + cλ) + dλ`.
///
/// Transfer matrix on `[X, Y, Θ, M, Qx, Qy]`: that of a [`PlanarHinge`](crate::elements::PlanarHinge) with κ in the place of K.
///
/// # Source
/// Eqs. (3), (4) and (32) of the paper with complex stiffnesses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedPlanarHinge<T> {
    /// Stiffness K_x along x [N/m], zero or positive; infinite is rigid.
    pub stiffness_x: T,
    /// Stiffness K_y along y [N/m], zero or positive; infinite is rigid.
    pub stiffness_y: T,
    /// Torsional stiffness K_θ [N m/rad], zero or positive; infinite is rigid.
    pub stiffness_theta: T,
    /// Damping d_x of a dashpot along x [N s/m], zero or positive.
    pub damping_x: T,
    /// Damping d_y of a dashpot along y [N s/m], zero or positive.
    pub damping_y: T,
    /// Damping d_θ of a dashpot about z [N m s/rad], zero or positive.
    pub damping_theta: T,
    /// Loss factor η, zero or positive.
    pub loss_factor: T,
    /// Time c of Kelvin and Voigt \[s\], zero or positive.
    pub kelvin_voigt_time: T,
}

impl<T: Parameter> Element for DampedPlanarHinge<T> {
    type State = Planar;
    type Built = DampedTies<T>;

    fn build(self) -> Result<DampedTies<T>, InvalidParameter> {
        let parts = [
            [self.stiffness_x, self.damping_x],
            [self.stiffness_y, self.damping_y],
            [self.stiffness_theta, self.damping_theta],
        ];
        DampedTies::or_rigid(parts, [self.loss_factor, self.kelvin_voigt_time])
    }

    fn estimate(built: &DampedTies<T>, estimates: &mut FrequencyEstimates) {
        built.estimate(estimates);
    }
}

impl<T: Parameter, S: ComplexFrequency<T> + Single> TransferMatrix<S> for DampedPlanarHinge<T> {
    fn transfer_matrix(built: &DampedTies<T>, x: S) -> Matrix6<S> {
        let [of_x, of_y, rotation] = built.compliances(x);
        let mut u = Matrix6::identity();
        (u[(0, 4)], u[(1, 5)], u[(2, 3)]) = (-of_x, -of_y, rotation);
        u
    }

    fn denominator(built: &DampedTies<T>, x: S) -> Option<S> {
        Some(built.denominator(x))
    }
}

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
        let flexible = Freedoms::SINGLE.into_iter().zip(&parts).filter(|(_, part)| part.is_some());
        let rigid = flexible.fold(freedoms, |rigid, (freedom, _)| rigid.without(freedom));
        DampedJoint { rigid, parts, losses }
    }

    /// Whether nothing gives way.
    #[cfg(feature = "std")]
    pub(crate) fn is_rigid(&self) -> bool {
        self.parts.iter().all(Option::is_none)
    }

    /// The freedoms that it ties.
    pub(crate) fn freedoms(&self) -> Freedoms {
        let flexible = Freedoms::SINGLE.into_iter().zip(&self.parts).filter(|(_, part)| part.is_some());
        flexible.fold(self.rigid, |sum, (freedom, _)| sum.union(freedom))
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
        let ties = Freedoms::SINGLE.into_iter().zip(built.flexible.ties).filter_map(|(freedom, tie)| {
            let flexible = tie.map(|tie| Tie::Elastic(tie.at(at.x)));
            Some((freedom, flexible.or(built.rigid.contains(freedom).then_some(Tie::Rigid))?))
        });
        chart_of_ties(ties)
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberMotion<S> for DampedJoint<T> {
    fn forms(built: &BuiltDampedJoint<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        built.flexible.forms(first.x, of_members(&built.flexible, first, second))
    }
}

impl<T: Real, S: ComplexFrequency<T> + Oscillation<T>> MemberGradient<S> for DampedJoint<T> {
    type Gradient = DampedPlanarHinge<S>;

    fn member_gradient(built: &BuiltDampedJoint<T>, work: &MemberWork<S>) -> DampedPlanarHinge<S> {
        let motion = MemberEnds { x: work.x, ends: work.ends };
        let ([x, y, theta], [loss_factor, kelvin_voigt_time]) =
            built.flexible.gradient(work.x, of_members(&built.flexible, &motion, &motion));
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

#[cfg(test)]
impl super::laws::Sample for DampedHinge<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        DampedHinge {
            stiffness_y: by_compliance(next()),
            stiffness_theta: by_compliance(next()),
            damping_y: 0.5 * next(),
            damping_theta: 0.5 * next(),
            loss_factor: 0.2 * next(),
            kelvin_voigt_time: next(),
        }
    }

    fn lossless(self) -> Self {
        DampedHinge { loss_factor: 0.0, ..self }
    }
}

#[cfg(test)]
impl super::laws::Sample for DampedPlanarHinge<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        DampedPlanarHinge {
            stiffness_x: by_compliance(next()),
            stiffness_y: by_compliance(next()),
            stiffness_theta: by_compliance(next()),
            damping_x: 0.5 * next(),
            damping_y: 0.5 * next(),
            damping_theta: 0.5 * next(),
            loss_factor: 0.2 * next(),
            kelvin_voigt_time: next(),
        }
    }

    fn lossless(self) -> Self {
        DampedPlanarHinge { loss_factor: 0.0, ..self }
    }
}

/// A stiffness from a compliance: an infinite one is no hinge, an infinite stiffness is rigid.
#[cfg(test)]
fn by_compliance(compliance: f64) -> f64 {
    1.0 / compliance
}
