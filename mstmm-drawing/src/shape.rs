//! Motions that can be drawn: mode shapes, and the states of responses.

use crate::figure::{Inside, Moves};
use mstmm_core::{
    Complex, ModeShape, MotionError, MovingNetwork, Oscillation, Placed, PlacedMotions, PlaneFrequency, PlaneShape,
    PlaneStates, Real, Single, State, System, SystemStates, Tree,
};

/// A motion of a system of the model `M`: a mode shape, or the states of a response.
pub trait Shape<M>: private::Moved<M> {}

impl<M, T: private::Moved<M>> Shape<M> for T {}

/// A number of a motion.
pub(crate) type Number = Complex<f64>;

/// A cross section of a member: its displacement along x, y and z of the model, and the forces in it.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    pub(crate) displacement: [Number; 3],
    /// Axial force, shear force along y and moment about z of the member; in space these along z and about y, and the torque.
    pub(crate) forces: [Number; 6],
}

pub(crate) mod private {
    use super::{Inside, MotionError, Moves, Number, Section};

    /// A motion that can be asked about anchors and members.
    pub trait Moved<M> {
        /// Whether its sign, or its phase, says nothing: that of a mode shape, and not of a response.
        const IS_MODE: bool = false;

        /// The displacement of an anchor along x, y and z, and its rotations about them.
        fn at(&self, moves: &Moves<M>) -> Result<[Number; 6], MotionError>;

        /// The cross section of a member at a part of its length.
        fn along(&self, inside: &Inside<M>, part: f64) -> Result<Section, MotionError>;
    }
}

/// A number in plain ones.
fn plain<T: Real, S: Oscillation<T>>(value: S) -> Number {
    let Complex { re, im } = value.to_complex();
    Complex { re: re.to_f64(), im: im.to_f64() }
}

/// A deflection along a direction.
fn directed<const N: usize>(value: Number, along: [f64; N]) -> [Number; N] {
    along.map(|part| value * part)
}

const ZERO: Number = Complex { re: 0.0, im: 0.0 };

impl<Y, S> private::Moved<Y::Model> for PlaneStates<'_, Y, S>
where
    Y: PlacedMotions<S> + Placed,
    S: Oscillation<Y::Parameter>,
{
    fn at(&self, moves: &Moves<Y::Model>) -> Result<[Number; 6], MotionError> {
        match *moves {
            Moves::Point(point) => Ok(self.motion_of(point)?.map(plain)),
            Moves::End(end) => Ok(self.motion_of(end)?.map(plain)),
            Moves::Path { node, along } => {
                let [x, y, z] = directed(plain(self.node(node)?[0]), along);
                Ok([x, y, z, ZERO, ZERO, ZERO])
            }
            Moves::Rest | Moves::Tree { .. } | Moves::Tied { .. } => Ok([ZERO; 6]),
        }
    }

    fn along(&self, inside: &Inside<Y::Model>, part: f64) -> Result<Section, MotionError> {
        let Inside::Member(label, length) = *inside else { return Err(MotionError::NoInside) };
        let state = PlaneStates::along(self, label, part * length)?;
        Ok(Section {
            displacement: [state.displacement_x, state.displacement_y, state.displacement_z].map(plain),
            forces: [state.axial_force, state.shear, state.moment, state.shear_z, state.moment_y, state.torque]
                .map(plain),
        })
    }
}

impl<Y, S> private::Moved<<Y as Placed>::Model> for PlaneShape<'_, Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    const IS_MODE: bool = true;

    fn at(&self, moves: &Moves<<Y as Placed>::Model>) -> Result<[Number; 6], MotionError> {
        private::Moved::at(&**self, moves)
    }

    fn along(&self, inside: &Inside<<Y as Placed>::Model>, part: f64) -> Result<Section, MotionError> {
        private::Moved::along(&**self, inside, part)
    }
}

impl<Y, S> private::Moved<Y::Model> for SystemStates<'_, Y, S>
where
    Y: Tree<S>,
    S: Oscillation<Y::Parameter> + Single,
{
    fn at(&self, moves: &Moves<Y::Model>) -> Result<[Number; 6], MotionError> {
        let Moves::Tree { point, along, is_rotation } = *moves else { return Ok([ZERO; 6]) };
        let state = self.state(point);
        let [x, y, z] = deflection(&state, along, is_rotation);
        let rotation = if is_rotation { ZERO } else { plain(state.theta) };
        Ok([x, y, z, ZERO, ZERO, rotation])
    }

    fn along(&self, inside: &Inside<Y::Model>, part: f64) -> Result<Section, MotionError> {
        let Inside::Element { label, length, along, is_rotation } = *inside else { return Err(MotionError::NoInside) };
        let state = SystemStates::along(self, label, part * length)?;
        Ok(Section {
            displacement: deflection(&state, along, is_rotation),
            forces: [ZERO, plain(state.q), plain(state.m), ZERO, ZERO, ZERO],
        })
    }
}

/// What of a state is drawn.
fn deflection<T: Real, S: Oscillation<T>>(state: &State<S>, along: [f64; 2], is_rotation: bool) -> [Number; 3] {
    let [x, y] = directed(plain(if is_rotation { state.theta } else { state.y }), along);
    [x, y, ZERO]
}

impl<Y, S> private::Moved<Y::Model> for ModeShape<'_, Y, S>
where
    Y: Tree<S>,
    S: Oscillation<Y::Parameter> + Single,
{
    const IS_MODE: bool = true;

    fn at(&self, moves: &Moves<Y::Model>) -> Result<[Number; 6], MotionError> {
        private::Moved::at(&**self, moves)
    }

    fn along(&self, inside: &Inside<Y::Model>, part: f64) -> Result<Section, MotionError> {
        private::Moved::along(&**self, inside, part)
    }
}
