//! Motions that can be drawn: mode shapes, and the states of responses.

use crate::figure::{Inside, Moves};
use mstmm_core::{
    Complex, ModeShape, MotionError, MovingNetwork, Oscillation, Placed, PlacedMotions, PlaneFrequency, PlanePoint,
    PlaneShape, PlaneStates, Real, Single, State, System, SystemStates, Tree,
};

/// A motion of a system of the model `M`: a mode shape, or the states of a response.
pub trait Shape<M>: private::Moved<M> {}

impl<M, T: private::Moved<M>> Shape<M> for T {}

/// A number of a motion.
pub(crate) type Number = Complex<f64>;

/// A cross section of a member: its displacement, and its axial force, shear force and moment.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    pub(crate) displacement: [Number; 2],
    pub(crate) forces: [Number; 3],
}

pub(crate) mod private {
    use super::{Inside, MotionError, Moves, Number, Section};

    /// A motion that can be asked about anchors and members.
    pub trait Moved<M> {
        /// The displacement of an anchor along x and y, and its rotation.
        fn at(&self, moves: &Moves<M>) -> Result<[Number; 3], MotionError>;

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
fn directed(value: Number, along: [f64; 2]) -> [Number; 2] {
    along.map(|part| value * part)
}

const ZERO: Number = Complex { re: 0.0, im: 0.0 };

impl<Y, S> private::Moved<Y::Model> for PlaneStates<'_, Y, S>
where
    Y: PlacedMotions<S> + Placed,
    S: Oscillation<Y::Parameter>,
{
    fn at(&self, moves: &Moves<Y::Model>) -> Result<[Number; 3], MotionError> {
        match *moves {
            Moves::Point(point) => point_of(self, point),
            Moves::End(end) => {
                let entries = [end.displacement_x(), end.displacement_y(), end.rotation_z()];
                let [x, y, z] = entries.map(|entry| self.value(entry));
                Ok([plain(x?), plain(y?), plain(z?)])
            }
            Moves::Path { node, along } => {
                let [x, y] = directed(plain(self.node(node)?[0]), along);
                Ok([x, y, ZERO])
            }
            Moves::Rest | Moves::Tree { .. } | Moves::Tied { .. } => Ok([ZERO; 3]),
        }
    }

    fn along(&self, inside: &Inside<Y::Model>, part: f64) -> Result<Section, MotionError> {
        let Inside::Member(label, length) = *inside else { return Err(MotionError::NoInside) };
        let state = PlaneStates::along(self, label, part * length)?;
        Ok(Section {
            displacement: [plain(state.displacement_x), plain(state.displacement_y)],
            forces: [plain(state.axial_force), plain(state.shear), plain(state.moment)],
        })
    }
}

/// The displacements of a point; zero where no element brings a freedom to it.
fn point_of<Y, S>(states: &PlaneStates<'_, Y, S>, point: PlanePoint<Y::Model>) -> Result<[Number; 3], MotionError>
where
    Y: Placed,
    S: Oscillation<Y::Parameter>,
{
    let mut displacements = [ZERO; 3];
    for (displacement, entry) in
        displacements.iter_mut().zip([point.displacement_x(), point.displacement_y(), point.rotation_z()])
    {
        *displacement = match states.value(entry) {
            Err(MotionError::NoSuchFreedom { .. }) => ZERO,
            value => plain(value?),
        };
    }
    Ok(displacements)
}

impl<Y, S> private::Moved<<Y as Placed>::Model> for PlaneShape<'_, Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    fn at(&self, moves: &Moves<<Y as Placed>::Model>) -> Result<[Number; 3], MotionError> {
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
    fn at(&self, moves: &Moves<Y::Model>) -> Result<[Number; 3], MotionError> {
        let Moves::Tree { point, along, is_rotation } = *moves else { return Ok([ZERO; 3]) };
        let state = self.state(point);
        let [x, y] = deflection(&state, along, is_rotation);
        let rotation = if is_rotation { ZERO } else { plain(state.theta) };
        Ok([x, y, rotation])
    }

    fn along(&self, inside: &Inside<Y::Model>, part: f64) -> Result<Section, MotionError> {
        let Inside::Element { label, length, along, is_rotation } = *inside else { return Err(MotionError::NoInside) };
        let state = SystemStates::along(self, label, part * length)?;
        Ok(Section {
            displacement: deflection(&state, along, is_rotation),
            forces: [ZERO, plain(state.q), plain(state.m)],
        })
    }
}

/// What of a state is drawn.
fn deflection<T: Real, S: Oscillation<T>>(state: &State<S>, along: [f64; 2], is_rotation: bool) -> [Number; 2] {
    directed(plain(if is_rotation { state.theta } else { state.y }), along)
}

impl<Y, S> private::Moved<Y::Model> for ModeShape<'_, Y, S>
where
    Y: Tree<S>,
    S: Oscillation<Y::Parameter> + Single,
{
    fn at(&self, moves: &Moves<Y::Model>) -> Result<[Number; 3], MotionError> {
        private::Moved::at(&**self, moves)
    }

    fn along(&self, inside: &Inside<Y::Model>, part: f64) -> Result<Section, MotionError> {
        private::Moved::along(&**self, inside, part)
    }
}
