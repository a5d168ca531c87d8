//! Elements of a line in the plane, where they stretch as well.

use crate::element::{ByName, Charted, Element, MemberNumbers, TransferMatrix};
use crate::elements::beam::BuiltBeam;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::uniform_line::UniformLine;
use crate::elements::{Beam, GeneralBeam};
use crate::model::{Extent, FrequencyEstimates, InvalidParameter, Planar, StateSpace};
use crate::number::{FrequencyPowers, Parameter, Single};
use crate::structure::Chart;
use across::Along;
pub(crate) use across::ChartedAcross;
pub(crate) use along::AlongWaves;
use mstmm_plan::{Coordinate, WIDEST};
use nalgebra::Matrix6;

pub(crate) mod across;
mod along;
mod motion;
mod string;

pub use across::{Across, Stretching};

/// An element of a line between two points of the plane, with exact longitudinal vibration; both motions do not couple along it.
///
/// Transfer matrix on `[X, Y, Θ, M, Qx, Qy]`: rows and columns `[Y, Θ, M, Qy]` are those of the element across itself, rows and columns
/// `[X, Qx]` are, with `ζ² = -mλ²l²/EA`,
///
/// ```text
/// cos ζ           -(l/EA) sin ζ/ζ
/// (EA/l) ζ sin ζ   cos ζ
/// ```
///
/// A foundation and an axial force act across it alone. Damping is that of both motions: EA has the losses of the other stiffnesses, and
/// a medium resists all displacements.
///
/// ```
/// use mstmm_core::elements::{Beam, InPlane};
/// let across = Beam { length: 2.0, bending_stiffness: 1e6, mass_per_length: 20.0 };
/// let column = InPlane { axial_stiffness: 4e8, across };
/// # assert_eq!(column.across.length, 2.0);
/// ```
///
/// # Source
/// That of the element; along it `EA X'' = mλ² X` with `Qx = -EA X'` in the sign convention of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InPlane<B: Across> {
    /// Axial stiffness EA \[N\], positive.
    pub axial_stiffness: B::Number,
    /// What it is across itself.
    pub across: B,
}

impl<B: Across> InPlane<B> {
    /// The element of another length.
    #[must_use]
    pub fn of_length(self, length: B::Number) -> Self {
        InPlane { across: self.across.of_length(length), ..self }
    }
}

/// What is built of both motions.
#[derive(Clone, Copy, Debug)]
pub struct BuiltInPlane<B, L> {
    across: B,
    along: L,
}

impl<B: Stretching> Element for InPlane<B> {
    type State = Planar;
    type Built = BuiltInPlane<B::Built, B::Line>;
    const MAY_BUCKLE: bool = B::MAY_BUCKLE;

    fn build(self) -> Result<Self::Built, InvalidParameter> {
        let across = self.across.build()?;
        let along = B::line(&across, self.axial_stiffness)?;
        Ok(BuiltInPlane { across, along })
    }

    fn add_axial_force(built: &mut Self::Built, force: [f64; 2]) -> Result<bool, InvalidParameter> {
        B::add_axial_force(&mut built.across, force)
    }

    fn estimate(built: &Self::Built, estimates: &mut FrequencyEstimates) {
        B::estimate(&built.across, estimates);
        let [length, axial_stiffness] = built.along.length_and_stiffness();
        estimates.translational_stiffness((axial_stiffness / length).to_f64());
    }

    fn extent(built: &Self::Built) -> Extent {
        B::extent(&built.across)
    }

    fn member_numbers(built: &Self::Built) -> MemberNumbers {
        let [_, axial_stiffness] = built.along.length_and_stiffness();
        B::member_numbers(&built.across).stretching(axial_stiffness.words())
    }
}

impl<T: Parameter> BuiltInPlane<BuiltBeam<T>, UniformLine<T>> {
    /// The beam under an axial force.
    pub(crate) fn under_axial_force(&self, axial_force: T) -> InPlane<GeneralBeam<T>> {
        let Beam { length, bending_stiffness, mass_per_length } = self.across.parameters();
        let [_, axial_stiffness] = self.along.length_and_stiffness();
        let across = GeneralBeam {
            length,
            bending_stiffness,
            mass_per_length,
            shear_stiffness: T::from_f64(f64::INFINITY),
            rotary_inertia: T::zero(),
            axial_force,
            foundation_stiffness: T::zero(),
            foundation_shear_stiffness: T::zero(),
        };
        InPlane { axial_stiffness, across }
    }
}

/// Takes the column of a unit state through both motions.
impl<B, S: Single> TransferMatrix<S> for InPlane<B>
where
    B: Stretching<Line: AlongWaves<S>> + TransferMatrix<S>,
{
    fn transfer_matrix(built: &Self::Built, x: S) -> Matrix6<S> {
        let (across, along) = (B::transfer_matrix(&built.across, x), built.along.transfer_matrix(x));
        let [x, force] = [Coordinate::X as usize, Coordinate::Qx as usize];
        let columns: [[S; WIDEST]; WIDEST] = core::array::from_fn(|column| {
            let mut state = core::array::from_fn(|row| if row == column { S::one() } else { S::zero() });
            B::State::transfer(&across, &mut state);
            let input = [state[x], state[force]];
            [state[x], state[force]] = [0, 1].map(|row| along[(row, 0)] * input[0] + along[(row, 1)] * input[1]);
            state
        });
        Matrix6::from_fn(|row, column| columns[column][row])
    }
}

impl<B, S> Charted<S> for InPlane<B>
where
    B: Stretching<Line: AlongWaves<S>> + ChartedAcross<S>,
    S: ChartScalar,
{
    fn chart(built: &Self::Built, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
        let waves = built.along.longitudinal(at, length);
        let mut chart = B::chart_across(&built.across, at, length, Some(waves.unit()));
        let count = chart.freedoms.count();
        S::enter_longitudinal(&waves, &mut chart, [0, count]);
        chart
    }
}

impl<S: Copy, B: Across<Number = S> + ByName<S>> ByName<S> for InPlane<B> {
    fn by_name(&self, name: &str) -> Option<S> {
        if name == "axial_stiffness" { Some(self.axial_stiffness) } else { self.across.by_name(name) }
    }
}

#[cfg(test)]
impl<B: Stretching<Number = f64> + crate::elements::laws::Sample> crate::elements::laws::Sample for InPlane<B> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        InPlane { axial_stiffness: next(), across: B::sample(next) }
    }

    fn length(&self) -> f64 {
        self.across.length()
    }

    fn halves(self) -> Option<Self> {
        let InPlane { axial_stiffness, across } = self;
        Some(InPlane { axial_stiffness, across: across.halves()? })
    }

    fn phase(&self, s: f64) -> f64 {
        self.across.phase(s)
    }

    fn untied(self) -> Self {
        InPlane { across: self.across.untied(), ..self }
    }

    fn lossless(self) -> Self {
        InPlane { across: self.across.lossless(), ..self }
    }
}
