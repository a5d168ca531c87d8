//! Words in lanes, one after the other.

use crate::number::Part;
use crate::proof::word::Word;
use core::array::from_fn;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Four words at once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Four(pub(crate) [f64; 4]);

impl Four {
    fn by(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Four(from_fn(|lane| of(self.0[lane], other.0[lane])))
    }
}

macro_rules! operators {
    ($($Trait:ident $name:ident),*) => {$(
        impl $Trait for Four {
            type Output = Self;
            fn $name(self, other: Self) -> Self {
                self.by(other, f64::$name)
            }
        }
    )*};
}

operators!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Four {
    type Output = Self;
    fn neg(self) -> Self {
        Four(self.0.map(|lane| -lane))
    }
}

impl Word for Four {
    const LANES: usize = 4;
    type Mask = [bool; 4];

    fn load(numbers: &[f64]) -> Self {
        Four(from_fn(|lane| numbers[lane.min(numbers.len() - 1)]))
    }

    fn both(first: [bool; 4], second: [bool; 4]) -> [bool; 4] {
        from_fn(|lane| first[lane] && second[lane])
    }

    fn not(truth: [bool; 4]) -> [bool; 4] {
        truth.map(|truth| !truth)
    }

    fn call<P: Part>(part: P) -> P::Output {
        part.run()
    }

    fn of(number: f64) -> Self {
        Four([number; 4])
    }

    fn store(self, numbers: &mut [f64]) {
        numbers.iter_mut().zip(self.0).for_each(|(number, lane)| *number = lane);
    }

    fn size(self) -> Self {
        Four(self.0.map(Word::size))
    }

    fn root(self) -> Self {
        Four(self.0.map(Word::root))
    }

    fn power_of_two(self) -> Self {
        Four(self.0.map(Word::power_of_two))
    }

    fn is_less(self, other: Self) -> [bool; 4] {
        from_fn(|lane| self.0[lane] < other.0[lane])
    }

    fn vanishes(self) -> bool {
        self.0 == [0.0; 4]
    }

    fn select(truth: [bool; 4], first: Self, second: Self) -> Self {
        Four(from_fn(|lane| if truth[lane] { first.0[lane] } else { second.0[lane] }))
    }

    fn all(truth: [bool; 4]) -> bool {
        truth == [true; 4]
    }
}
