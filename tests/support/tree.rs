//! Trees as data: the same description leads to a list of steps of the library and to an independent model.

use mstmm::Complex;
use mstmm::element::{SMatrix, Space, Support, TransferMatrix};
use mstmm::elements::{
    Beam, Body, Damper, ElasticHinge, Inertia, Lever, Mass, PointMass, RotationalHinge, ShearHinge, Spring,
    SpringDamper, TorsionDamper, TorsionSpring, TorsionSpringDamper,
};
use mstmm::list::{AnyElement, AnyUndamped, ListStep};
use mstmm::number::{DoubleDouble, Real};

/// A tree: tips before what they lead to, inputs of a connection before it, the root last.
///
/// The `Debug` text of a tree is, but for paths, the source that builds it.
pub(crate) type Tree = Vec<ListStep<Part>>;

/// A chain of equal springs and masses, each mass behind its spring, fixed at the begin and free at the end.
pub(crate) fn chain(masses: usize, stiffness: f64, mass: f64) -> Tree {
    let cell = [Part::Spring(Spring { stiffness }), Part::Mass(Mass { mass })].map(ListStep::Element);
    let cells = std::iter::repeat_n(cell, masses).flatten();
    [ListStep::Tip(Support::Fixed)].into_iter().chain(cells).chain([ListStep::Root(Support::Free)]).collect()
}

/// A complex number of twice the digits.
pub(crate) type Wide = Complex<DoubleDouble>;

/// Declares the elements with their parameters, in the order of their numbers.
macro_rules! parts {
    (
        undamped { $($kind:ident { $($field:ident),* })* }
        damped { $($damped:ident { $($damped_field:ident),* })* }
    ) => {
        /// An element with its parameters.
        #[derive(Clone, Copy, Debug)]
        pub(crate) enum Part {
            $($kind($kind<f64>),)*
            $($damped($damped<f64>),)*
        }

        impl Part {
            /// The parameters, by number.
            pub(crate) fn parameters(&mut self) -> Vec<&mut f64> {
                match self {
                    $(Part::$kind($kind { $($field),* }) => vec![$($field),*],)*
                    $(Part::$damped($damped { $($damped_field),* }) => vec![$($damped_field),*],)*
                }
            }

            /// The names of the parameters, by number.
            pub(crate) fn names(&self) -> &'static [&'static str] {
                match self {
                    $(Part::$kind(_) => &[$(stringify!($field)),*],)*
                    $(Part::$damped(_) => &[$(stringify!($damped_field)),*],)*
                }
            }

            /// The element as one of a list.
            pub(crate) fn any<T: Real>(self) -> AnyElement<T> {
                match self {
                    $(Part::$kind($kind { $($field),* }) => $kind { $($field: T::from_f64($field)),* }.try_into(),)*
                    $(Part::$damped($damped { $($damped_field),* }) => {
                        $damped { $($damped_field: T::from_f64($damped_field)),* }.try_into()
                    })*
                }
                .unwrap()
            }

            /// The element as one of a list without dashpots.
            pub(crate) fn undamped<T: Real>(self) -> AnyUndamped<T> {
                match self {
                    $(Part::$kind($kind { $($field),* }) => $kind { $($field: T::from_f64($field)),* }.try_into(),)*
                    dashpot => panic!("{dashpot:?} in an undamped tree"),
                }
                .unwrap()
            }

            /// The transfer matrix in twice the digits, by rows.
            pub(crate) fn transfer_matrix(self, lambda: Wide) -> Vec<Vec<Wide>> {
                match self.any::<DoubleDouble>() {
                    $(AnyElement::$kind(built) => rows(<$kind<DoubleDouble> as TransferMatrix<_>>::transfer_matrix(&built, lambda)),)*
                    $(AnyElement::$damped(built) => rows(<$damped<DoubleDouble> as TransferMatrix<_>>::transfer_matrix(&built, lambda)),)*
                    other => panic!("{other:?} is no part of these trees"),
                }
            }
        }
    };
}

parts! {
    undamped {
        Beam { length, bending_stiffness, mass_per_length }
        Body { mass, inertia, output_x, centre_x }
        ElasticHinge { stiffness_y, stiffness_theta }
        PointMass { mass, inertia }
        Spring { stiffness }
        TorsionSpring { stiffness }
        Mass { mass }
        Inertia { inertia }
        RotationalHinge { stiffness }
        ShearHinge { stiffness }
        Lever { output_x }
    }
    damped {
        Damper { damping }
        TorsionDamper { damping }
        SpringDamper { stiffness, damping }
        TorsionSpringDamper { stiffness, damping }
    }
}

/// A matrix by rows.
fn rows<const N: usize>(matrix: SMatrix<Wide, N, N>) -> Vec<Vec<Wide>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

impl Part {
    /// Space of the states at both ends.
    pub(crate) fn space(&self) -> Space {
        match self {
            Part::Beam(_) | Part::Body(_) | Part::ElasticHinge(_) | Part::PointMass(_) => Space::Bending,
            Part::RotationalHinge(_) | Part::ShearHinge(_) | Part::Lever(_) => Space::Bending,
            Part::Spring(_) | Part::Mass(_) | Part::Damper(_) | Part::SpringDamper(_) => Space::Translation,
            _ => Space::Rotation,
        }
    }

    /// Names in the language and values of the parameters.
    pub(crate) fn named(mut self) -> Vec<(&'static str, f64)> {
        let values = self.parameters().into_iter().map(|value| *value).collect::<Vec<_>>();
        let word = |name: &&'static str| match (self, *name) {
            (Part::RotationalHinge(_), "stiffness") | (_, "stiffness_theta") => "stiffness_rz",
            (Part::ShearHinge(_), "stiffness") => "stiffness_y",
            (_, name) => name,
        };
        self.names().iter().map(word).zip(values).collect()
    }

    /// The keyword of the language.
    pub(crate) fn keyword(&self) -> &'static str {
        match self {
            Part::Beam(_) => "beam",
            Part::Body(_) => "body",
            Part::ElasticHinge(_) | Part::RotationalHinge(_) | Part::ShearHinge(_) => "hinge",
            Part::PointMass(_) => "point_mass",
            Part::Spring(_) | Part::SpringDamper(_) => "spring",
            Part::TorsionSpring(_) | Part::TorsionSpringDamper(_) => "torsion_spring",
            Part::Mass(_) => "mass",
            Part::Inertia(_) => "inertia",
            Part::Lever(_) => "rigid_link",
            Part::Damper(_) => "damper",
            Part::TorsionDamper(_) => "torsion_damper",
        }
    }

    /// Stiffness and damping of a link between two displacements of one kind.
    pub(crate) fn link(&self) -> Option<[f64; 2]> {
        match *self {
            Part::Spring(p) => Some([p.stiffness, 0.0]),
            Part::TorsionSpring(p) => Some([p.stiffness, 0.0]),
            Part::Damper(p) => Some([0.0, p.damping]),
            Part::TorsionDamper(p) => Some([0.0, p.damping]),
            Part::SpringDamper(p) => Some([p.stiffness, p.damping]),
            Part::TorsionSpringDamper(p) => Some([p.stiffness, p.damping]),
            _ => None,
        }
    }
}

/// Space of the element to which a step leads, if it leads to one.
pub(crate) fn next_space(tree: &Tree, step: usize) -> Option<Space> {
    match tree.get(step + 1) {
        Some(ListStep::Element(part)) => Some(part.space()),
        _ => None,
    }
}
