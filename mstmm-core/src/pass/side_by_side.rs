//! Systems of several models of one topology, each in a lane of the vectors.
//!
//! AVX-512 alone has lanes enough: on AVX2 the roots of one model fill them better than models do.

use crate::number::{InLanes, Packed, Parameters, Task, run};
use crate::pass::at_once::{Block, lanes};
use crate::pass::characteristic::{Characteristic, System};
use crate::pass::model::Model;
use crate::subspace::Purpose;

/// Models that are evaluated at once.
pub(crate) const MODELS: usize = 8;

/// Frequencies of as many models, in lanes.
type Frequencies = <f64 as InLanes>::OnAvx512;

/// A model of which several can be evaluated at once.
#[diagnostic::on_unimplemented(
    message = "several models `{Self}` cannot be evaluated at once",
    note = "the items of a sweep are models that `system!` declares, or references to them, without dampers and planar elements"
)]
pub trait Lanewise:
    Model<System<f64>: System<Parameter = f64>, System<Parameters>: Characteristic<Frequencies>>
{
}

impl<M> Lanewise for M where
    M: Model<System<f64>: System<Parameter = f64>, System<Parameters>: Characteristic<Frequencies>>
{
}

/// The built system of one model.
pub(crate) type Built<M> = <M as Model>::System<f64>;

/// The built system of eight models, with their parameters in lanes.
pub(crate) struct SideBySide<M: Model>(M::System<Parameters>);

impl<M: Lanewise> SideBySide<M> {
    /// The system of models, the last of which fills the lanes that are left; none without such vectors, or for models whose pass does
    /// not stand in line. Each has been built alone before.
    #[inline]
    pub(crate) fn new(models: &[Option<&M>; MODELS]) -> Option<Self> {
        if !Built::<M>::STANDS_IN_LINE || lanes::<f64, Built<M>>() < MODELS {
            return None;
        }
        let last = models.iter().flatten().last()?;
        let numbers = models.each_ref().map(|model| model.unwrap_or(last).numbers());
        let number = |place: usize| {
            let mut lanes = [0.0; MODELS];
            for (lane, numbers) in lanes.iter_mut().zip(&numbers) {
                *lane = numbers.as_ref()[place];
            }
            Parameters::load(&lanes)
        };
        last.of_numbers(number).ok().map(SideBySide)
    }

    /// Evaluates each model at its own frequency.
    #[inline]
    pub(crate) fn evaluate(&self, block: &mut Block<f64>, purpose: Purpose) {
        block.begin();
        run(Evaluation { system: &self.0, block, purpose });
    }
}

/// The evaluation of all models.
#[cfg_attr(not(all(feature = "std", target_arch = "x86_64")), expect(dead_code, reason = "there are no vectors"))]
struct Evaluation<'a, Y> {
    system: &'a Y,
    block: &'a mut Block<f64>,
    purpose: Purpose,
}

impl<Y: Characteristic<Frequencies>> Task for Evaluation<'_, Y> {
    type Output = ();

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx512(self) {
        self.block.evaluate::<Frequencies>(self.system, 0, self.purpose);
    }

    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline(always)]
    fn on_avx2(self) {
        self.alone();
    }

    /// Leaves all unknown: the instruction set was changed meanwhile.
    #[inline]
    fn alone(self) {
        self.block.unknown = u32::MAX;
    }
}
