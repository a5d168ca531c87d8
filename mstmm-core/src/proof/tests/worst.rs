//! A number whose every operation is rounded to a side, within its bounds, and as badly as these allow.

use crate::proof::level::Level;
use crate::proof::number::{Number, OneWord, U, two_sum};
use crate::proof::tests::exact::{Exact, Exactly, exact};
use crate::proof::word::Word;
use std::cell::Cell;

/// How an operation is rounded.
#[derive(Clone, Copy, Debug)]
pub(super) enum Way {
    Up,
    Down,
    Away,
    Nearer,
    Random,
}

pub(super) const WAYS: [Way; 5] = [Way::Up, Way::Down, Way::Away, Way::Nearer, Way::Random];

std::thread_local! {
    /// The ways of sums and of products, what inverses are off by, and the state of random ways.
    static CHOSEN: Cell<(Way, Way, f64, u64)> = const { Cell::new((Way::Up, Way::Up, 0.0, 1)) };
}

/// Chooses ways for the sums and the products, and a relative error of inverses, of this thread.
pub(super) fn choose(sums: Way, products: Way, of_inverses: f64, seed: u64) {
    CHOSEN.set((sums, products, of_inverses, seed | 1));
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Worst(pub(super) f64);

/// The neighbour that a way chooses of a nearest float and what that lacks of the number.
fn rounded(nearest: f64, lacks: f64, way: Way) -> Worst {
    if lacks == 0.0 || !nearest.is_finite() {
        return Worst(nearest);
    }
    let [low, high] = if lacks > 0.0 { [nearest, nearest.next_up()] } else { [nearest.next_down(), nearest] };
    let is_up = match way {
        Way::Up => true,
        Way::Down => false,
        Way::Away => nearest > 0.0,
        Way::Nearer => nearest < 0.0,
        Way::Random => {
            let (sums, products, of_inverses, mut seed) = CHOSEN.get();
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            CHOSEN.set((sums, products, of_inverses, seed));
            seed & 64 == 0
        }
    };
    Worst(if is_up { high } else { low })
}

impl Number for Worst {
    type Word = f64;
    /// An ulp of the result at most, which is `2u` of it; of a power of two from below it is `2u(1 + u)`.
    const SUM: f64 = 2.000_001 * U;
    const PRODUCT: f64 = 2.000_001 * U;

    fn of_parts([first, ..]: [f64; 4]) -> Self {
        Worst(first)
    }

    fn of_word(word: f64) -> Self {
        Worst(word)
    }

    fn of_product(a: f64, b: f64) -> Self {
        Worst(a).times(Worst(b))
    }

    fn plus(self, other: Self) -> Self {
        let sum = two_sum(self.0, other.0);
        rounded(sum.hi, sum.lo, CHOSEN.get().0)
    }

    fn times(self, other: Self) -> Self {
        let product = self.0 * other.0;
        rounded(product, self.0.product_error(other.0, product), CHOSEN.get().1)
    }

    fn negated(self) -> Self {
        Worst(-self.0)
    }

    fn scaled(self, power: f64) -> Self {
        Worst(self.0 * power)
    }

    fn leading(self) -> f64 {
        self.0
    }

    fn near_inverse(self) -> Self {
        Worst((1.0 + CHOSEN.get().2) / self.0)
    }

    fn near_root(self) -> Self {
        Worst(self.0.sqrt())
    }

    fn select(truth: bool, first: Self, second: Self) -> Self {
        if truth { first } else { second }
    }
}

impl Exactly for Worst {
    const NAME: &'static str = "the worst word";

    fn exactly(self) -> Exact {
        exact(self.0)
    }
}

impl Level for Worst {
    type Alone = Self;
    const PRODUCT_OF_WORDS: f64 = Worst::PRODUCT;
    const PARTS: (usize, f64) = OneWord::PARTS;
    const TERMS: usize = OneWord::TERMS;

    fn everywhere(alone: Self) -> Self {
        alone
    }

    fn lane(self, _: usize) -> Self {
        self
    }
}
