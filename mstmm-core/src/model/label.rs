//! Labels of a model as values: a label of another model does not compile.

use crate::model::direction::Direction;
use crate::model::plain::plain;
use core::marker::PhantomData;
use mstmm_plan::Coordinate;

/// The label of an element of type `E` in a model `M`, such as `TipBody::beam_1`.
pub struct Label<M, E> {
    pub(crate) step: usize,
    input: usize,
    of: PhantomData<fn() -> (M, E)>,
}

/// A point of a model `M`: an end of an element, or a connection.
pub struct Point<M> {
    /// The step of the plan behind which it is.
    pub(crate) step: usize,
    /// Whether what acts at the point is between its step and this side of it.
    pub(crate) beyond: bool,
    of: PhantomData<fn() -> M>,
}

/// A harmonic load of 1: a force or a moment at a point, a dislocation there, a load all along an element, the weight of all that moves in Y, or an acceleration
/// of the ground.
pub struct Load<M> {
    pub(crate) acting: Acting,
    of: PhantomData<fn() -> M>,
}

/// Where a load acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Acting {
    /// Behind a step, as a jump of an entry.
    At(usize, Coordinate),
    /// Along elements.
    Spread(Spread),
}

/// A load that acts along elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Spread {
    /// 1 N/m, or 1 N m/m, along the element of a step.
    Along(usize),
    /// The weight of all elements under an acceleration of 1 m/s².
    Weight,
    /// The inertia of all elements where the ground has an acceleration of 1 m/s² along an axis: the weight with the other sign.
    Inertia(usize),
}

impl<M> Load<M> {
    /// The entry that the load works with; none of a load along elements.
    pub(crate) const fn dual(self) -> Option<Entry<M>> {
        match self.acting {
            Acting::At(step, coordinate) => {
                let point = Point { step, beyond: false, of: PhantomData };
                Some(Entry { point, coordinate: coordinate.dual() })
            }
            Acting::Spread(_) => None,
        }
    }
}

impl<M> Entry<M> {
    /// The load that works with the entry.
    pub(crate) const fn dual(self) -> Load<M> {
        Load::at(self.point, self.coordinate.dual())
    }
}

/// An entry of the state at a point.
pub struct Entry<M> {
    pub(crate) point: Point<M>,
    pub(crate) coordinate: Coordinate,
}

impl<M, E> Label<M, E> {
    /// For emitted code.
    #[doc(hidden)]
    pub const fn new(step: usize, input: usize) -> Self {
        Label { step, input, of: PhantomData }
    }

    /// The input end of the element, where the arrow arrives.
    pub const fn input(self) -> Point<M> {
        Point { step: self.input, beyond: true, of: PhantomData }
    }

    /// The output end of the element.
    pub const fn output(self) -> Point<M> {
        Point { step: self.step, beyond: false, of: PhantomData }
    }
}

impl<M> Point<M> {
    /// For emitted code: the point of a connection, with the state that goes on.
    #[doc(hidden)]
    pub const fn connection(step: usize) -> Self {
        Point { step, beyond: true, of: PhantomData }
    }

    /// A force of 1 N in the direction of Y at this point.
    pub const fn force(self) -> Load<M> {
        Load::new(Acting::At(self.step, Coordinate::Q))
    }

    /// A moment of 1 N m in the direction of Θ at this point.
    pub const fn torque(self) -> Load<M> {
        Load::new(Acting::At(self.step, Coordinate::M))
    }

    /// The deflection Y \[m\].
    pub const fn deflection(self) -> Entry<M> {
        Entry { point: self, coordinate: Coordinate::Y }
    }

    /// The rotation Θ \[rad\].
    pub const fn rotation(self) -> Entry<M> {
        Entry { point: self, coordinate: Coordinate::Theta }
    }

    /// The bending moment M [N m].
    pub const fn moment(self) -> Entry<M> {
        Entry { point: self, coordinate: Coordinate::M }
    }

    /// The shear force Q \[N\].
    pub const fn shear(self) -> Entry<M> {
        Entry { point: self, coordinate: Coordinate::Q }
    }
}

impl<M> Load<M> {
    const fn new(acting: Acting) -> Self {
        Load { acting, of: PhantomData }
    }

    /// A jump of an entry at a point.
    pub(crate) const fn at(point: Point<M>, coordinate: Coordinate) -> Self {
        Load::new(Acting::At(point.step, coordinate))
    }

    /// A load of 1 per length along the element of a step.
    pub(crate) const fn along(step: usize) -> Self {
        Load::new(Acting::Spread(Spread::Along(step)))
    }

    /// The weight of the whole model under an acceleration of 1 m/s² towards Y: each element whose deflection is Y is loaded by its mass per
    /// length, each mass and body in its mass centre. For a model on the earth the response is `g` times as large, negative where Y points
    /// upwards.
    pub const fn self_weight() -> Self {
        Load::new(Acting::Spread(Spread::Weight))
    }

    /// An acceleration of 1 m/s² of the ground, to which all supports belong. Entries are relative to the ground, as whose part a mass m bears the force `-m a`;
    /// [`absolute`](crate::ModalResponse::absolute) adds the motion of the ground. Deflections have one direction, y.
    pub const fn base_acceleration(direction: Direction<M>) -> Self {
        Load::new(Acting::Spread(Spread::Inertia(direction.axis)))
    }
}

plain!(Label<M, E>, step, input);
plain!(Point<M>, step, beyond);
plain!(Load<M>, acting);
plain!(Entry<M>, point, coordinate);
