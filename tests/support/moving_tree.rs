//! A tree as data whose motions can be asked for: what the macro emits for a model, made at run time.
#![expect(clippy::unwrap_used, reason = "random trees have valid parameters")]

use super::random_tree::{Random, random_tree};
use super::tree::{Part, Tree};
use core::cell::Cell;
use core::fmt::Debug;
use mstmm::__private::{Layout, Visit};
use mstmm::element::{Element, Ends, Energies, FrequencyEstimates, FrequencyPowers, PlaneStep, TransferMatrix};
use mstmm::elements::{
    Beam, Body, Damper, ElasticHinge, Inertia, Mass, PointMass, Spring, SpringDamper, TorsionDamper, TorsionSpring,
    TorsionSpringDamper,
};
use mstmm::list::ListStep;
use mstmm::motion::Planned;
use mstmm::number::{DoubleDouble, Real};
use mstmm::search::System;
use mstmm::{Complex, TreeInBlocks, VisitAt, VisitInBlock};
use mstmm_core::{Chain, Fields, Scheme, Step};

/// Most steps of a tree.
pub(crate) const MOST: usize = 40;

thread_local! {
    static SCHEME: Cell<Option<Scheme<'static>>> = const { Cell::new(None) };
}

/// A tree whose labels are numbers of steps; on each thread the one made last may be asked.
#[derive(Debug)]
pub(crate) struct MovingTree<T: Real> {
    parts: Vec<Option<Moving<T>>>,
}

/// A random tree, damped if its seed is even, whose bodies reach in both directions and whose parameters have 24 bits.
pub(crate) fn varied_tree(seed: u64) -> Tree {
    let mut tree = random_tree(seed, 3, seed.is_multiple_of(2));
    let mut random = Random(seed);
    for step in &mut tree {
        let ListStep::Element(part) = step else { continue };
        if let Part::Body(body) = part {
            for place in [&mut body.output_x, &mut body.centre_x] {
                *place *= if random.unit() < 0.5 { -1.0 } else { 1.0 };
            }
        }
        for parameter in part.parameters() {
            *parameter = f64::from(*parameter as f32);
        }
    }
    tree
}

/// Stands for the model of labels.
#[derive(Debug)]
pub(crate) struct Labels;

/// The inputs of the steps of a tree: a connection takes the last open paths.
pub(crate) fn steps_of(tree: &Tree) -> Vec<Step<'static>> {
    let mut open: Vec<usize> = Vec::new();
    let mut steps = Vec::new();
    for (index, step) in tree.iter().enumerate() {
        let step = match *step {
            ListStep::Tip(support) => Step::Tip(support),
            ListStep::Element(part) => Step::Element(open.pop().unwrap(), part.space()),
            ListStep::Connection(count) => {
                let inputs = open.split_off(open.len() - count);
                Step::Connection(Vec::leak(inputs))
            }
            ListStep::Root(support) => Step::Root(open.pop().unwrap(), support),
        };
        open.push(index);
        steps.push(step);
    }
    steps
}

/// Resolves a plan of any of these lengths.
macro_rules! scheme_of {
    ($steps:expr; $($length:literal)*) => {
        match $steps.len() {
            $($length => {
                let steps: [Step<'static>; $length] = $steps.clone().try_into().unwrap();
                let layout: &'static Layout<'static, $length> = Box::leak(Box::new(Layout::new(steps)));
                layout.scheme()
            })*
            other => panic!("{other} steps"),
        }
    };
}

macro_rules! moving {
    ($($kind:ident { $($field:ident),* })*) => {
        /// A built element.
        #[derive(Clone, Debug)]
        enum Moving<T: Real> {
            $($kind(<$kind<T> as Element>::Built),)*
        }

        impl<T: Real> Moving<T> {
            fn of(part: Part) -> Self {
                match part {
                    $(Part::$kind(part) => {
                        let part = $kind { $($field: T::from_f64(part.$field)),* };
                        Moving::$kind(part.build().unwrap())
                    })*
                }
            }

            fn estimate(&self, estimates: &mut FrequencyEstimates) {
                match self {
                    $(Moving::$kind(built) => $kind::<T>::estimate(built, estimates),)*
                }
            }
        }

        impl Part {
            /// The parameters, by number.
            pub(crate) fn parameters(&mut self) -> Vec<&mut f64> {
                match self {
                    $(Part::$kind($kind { $($field),* }) => vec![$($field),*],)*
                }
            }
        }

        impl<T: Real> Chain<Complex<T>> for MovingTree<T> {
            fn chain(&self, ends: impl Fn(usize) -> Ends<Complex<T>>) -> [Complex<T>; 4 * MOST] {
                let mut values = [Complex::default(); 4 * MOST];
                for (step, part) in self.parts.iter().enumerate() {
                    match part {
                        None => {}
                        $(Some(Moving::$kind(built)) => {
                            let gradient = <$kind<T> as Energies<Complex<T>>>::gradient(built, &ends(step));
                            for (k, value) in [$(gradient.$field),*].into_iter().enumerate() {
                                values[4 * step + k] = value;
                            }
                        })*
                    }
                }
                values
            }
        }

        /// The transfer matrix of an element in twice the digits, by columns of its own state.
        pub(crate) fn transfer_matrix(part: Part, lambda: Complex<DoubleDouble>) -> Vec<Vec<Complex<DoubleDouble>>> {
            match Moving::<DoubleDouble>::of(part) {
                $(Moving::$kind(built) => {
                    let u = <$kind<DoubleDouble> as TransferMatrix<Complex<DoubleDouble>>>::transfer_matrix(&built, lambda);
                    u.row_iter().map(|row| row.iter().copied().collect()).collect()
                })*
            }
        }
    };
}

moving! {
    Beam { length, bending_stiffness, mass_per_length }
    Body { mass, inertia, output_x, centre_x }
    ElasticHinge { stiffness_y, stiffness_theta }
    PointMass { mass, inertia }
    Spring { stiffness }
    TorsionSpring { stiffness }
    Mass { mass }
    Inertia { inertia }
    Damper { damping }
    TorsionDamper { damping }
    SpringDamper { stiffness, damping }
    TorsionSpringDamper { stiffness, damping }
}

impl<T: Real> MovingTree<T> {
    pub(crate) fn new(tree: &Tree) -> Self {
        let steps = steps_of(tree);
        let scheme = scheme_of!(steps; 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31
            32 33 34 35 36 37 38 39 40);
        SCHEME.set(Some(scheme));
        let part =
            |step: &ListStep<Part>| if let ListStep::Element(part) = *step { Some(Moving::of(part)) } else { None };
        MovingTree { parts: tree.iter().map(part).collect() }
    }
}

impl<T: Real> System for MovingTree<T> {
    type Parameter = T;

    fn estimates(&self) -> FrequencyEstimates {
        let mut estimates = FrequencyEstimates::default();
        self.parts.iter().flatten().for_each(|part| part.estimate(&mut estimates));
        estimates
    }
}

/// Fields are the parameters of all elements, four to a step.
impl<T: Real> Fields for MovingTree<T> {
    const NAMES: &'static [&'static str] = &["parameter"; 4 * MOST];
    type PerField<V: Copy + Debug> = [V; 4 * MOST];

    fn per_field<V: Copy + Debug>(value: V) -> [V; 4 * MOST] {
        [value; 4 * MOST]
    }
}

impl<T: Real> Planned for MovingTree<T> {
    type Model = Labels;
    type PerStep<V: Copy + Debug> = [V; MOST];

    fn per_step<V: Copy + Debug>(value: V) -> [V; MOST] {
        [value; MOST]
    }

    fn scheme() -> Scheme<'static> {
        SCHEME.get().unwrap()
    }
}

macro_rules! tree {
    ([$($generic:tt)*], $parameter:ty, $scalar:ty; $($kind:ident)*) => {
        impl<$($generic)*> mstmm::motion::Tree<$scalar> for MovingTree<$parameter> {
            type Evaluated = FrequencyPowers<$scalar>;

            fn at(x: $scalar) -> FrequencyPowers<$scalar> {
                FrequencyPowers::new(x, true)
            }

            fn evaluate(&self, at: &FrequencyPowers<$scalar>) -> FrequencyPowers<$scalar> {
                *at
            }

            fn visit<V: Visit<$scalar>>(&self, step: usize, visitor: V) -> Option<V::Output> {
                match self.parts[step].as_ref()? {
                    $(Moving::$kind(built) => Some(visitor.element::<$kind<$parameter>>(built)),)*
                    #[allow(unreachable_patterns, reason = "dampers have no real frequency")]
                    other => panic!("{other:?} at a real frequency"),
                }
            }

            fn visit_at<V: VisitAt<$scalar>>(&self, at: &FrequencyPowers<$scalar>, step: usize, visitor: V) -> Option<V::Output> {
                match self.parts[step].as_ref()? {
                    $(Moving::$kind(built) => {
                        let coefficients = <$kind<$parameter> as PlaneStep<$scalar>>::coefficients(built, at);
                        Some(visitor.element::<$kind<$parameter>>(built, &coefficients))
                    })*
                    #[allow(unreachable_patterns, reason = "dampers have no real frequency")]
                    other => panic!("{other:?} at a real frequency"),
                }
            }
        }

        impl<$($generic)*> TreeInBlocks<$scalar> for MovingTree<$parameter> {
            fn visit_in_block<V: VisitInBlock<$scalar>>(&self, step: usize, visitor: V) {
                match self.parts[step].as_ref() {
                    None => {}
                    $(Some(Moving::$kind(built)) => visitor.element::<$kind<$parameter>>(built),)*
                    #[allow(unreachable_patterns, reason = "dampers have no real frequency")]
                    other => panic!("{other:?} at a real frequency"),
                }
            }
        }
    };
}

tree!([T: Real], T, Complex<T>; Beam Body ElasticHinge PointMass Spring TorsionSpring Mass Inertia Damper TorsionDamper
    SpringDamper TorsionSpringDamper);
tree!([], f64, f64; Beam Body ElasticHinge PointMass Spring TorsionSpring Mass Inertia);
