//! Each operation in lanes against that of one number, on each instruction set that the machine has.

use crate::{InstructionSet, Lanes, Task, Truths, Vector, run};

/// Numbers of all kinds.
const NUMBERS: [f64; 12] =
    [0.0, -0.0, 1.0, -1.5, 2.7, -3.9, 1e300, -1e-300, f64::INFINITY, f64::NAN, 4_503_599_627_370_495.5, 5e-324];

/// All operations on two numbers, as bits.
fn alone(a: f64, b: f64) -> Vec<u64> {
    let select = |truth: bool| if truth { a } else { b };
    let numbers = [
        a + b,
        a - b,
        a * b,
        a.mul_add(b, -(a * b)),
        a / b,
        -a,
        a.abs(),
        a.sqrt(),
        a.floor(),
        select(a < b),
        select(a == 0.0),
        select(a.is_sign_negative()),
        select(a.to_bits() & 1 == 1),
        f64::from_bits(a.to_bits() ^ ((b.to_bits().wrapping_add(1) & 2) << 62)),
        f64::from_bits((1022_u64 << 52).wrapping_add(a.to_bits() << 52)),
        f64::from_bits((1022_u64 << 52).wrapping_sub(a.to_bits() << 52)),
    ];
    numbers.map(f64::to_bits).to_vec()
}

fn in_lanes<V: Vector>(a: &[f64], b: &[f64]) -> Vec<Vec<u64>> {
    let (x, y) = (Lanes(V::load(a)), Lanes(V::load(b)));
    let select = |truth| Lanes::select(truth, x, y);
    let [up, down] = x.0.powers();
    let numbers = [
        x + y,
        x - y,
        x * y,
        x.product_error(y, x * y),
        x / y,
        -x,
        Lanes(x.0.magnitude()),
        Lanes(x.0.root()),
        Lanes(x.0.floor()),
        select(x.is_less(y)),
        select(Truths(x.0.is_nought())),
        select(Truths(x.0.has_minus())),
        select(Truths(x.0.last_bit())),
        Lanes(x.0.signed_by(y.0, 1)),
        Lanes(up),
        Lanes(down),
    ];
    (0..a.len()).map(|lane| numbers.iter().map(|number| number.to_array()[lane].to_bits()).collect()).collect()
}

struct Operations<'a>(&'a [f64], &'a [f64]);

impl Task for Operations<'_> {
    type Output = Vec<Vec<u64>>;

    #[cfg(target_arch = "x86_64")]
    fn on_avx512(self) -> Self::Output {
        let parts = self.0.chunks(8).zip(self.1.chunks(8));
        parts.flat_map(|(a, b)| in_lanes::<crate::Eight>(a, b)).collect()
    }

    #[cfg(target_arch = "x86_64")]
    fn on_avx2(self) -> Self::Output {
        let parts = self.0.chunks(4).zip(self.1.chunks(4));
        parts.flat_map(|(a, b)| in_lanes::<crate::Four>(a, b)).collect()
    }

    fn alone(self) -> Self::Output {
        self.0.iter().zip(self.1).map(|(&a, &b)| alone(a, b)).collect()
    }
}

/// NaNs have many bits, and arithmetic keeps none of them in particular.
fn canonical(bits: Vec<u64>) -> Vec<u64> {
    bits.into_iter().map(|bits| if f64::from_bits(bits).is_nan() { f64::NAN.to_bits() } else { bits }).collect()
}

/// Oracle: the operations of the standard library on one number.
#[test]
fn each_lane_has_the_bits_of_a_number_alone_on_each_set() {
    let pairs = NUMBERS.iter().flat_map(|&a| NUMBERS.iter().map(move |&b| (a, b)));
    let (a, b): (Vec<f64>, Vec<f64>) = pairs.unzip();
    let expected: Vec<_> = a.iter().zip(&b).map(|(&a, &b)| canonical(alone(a, b))).collect();
    for set in InstructionSet::ALL {
        let in_use = set.limit();
        assert!(in_use <= InstructionSet::widest() && InstructionSet::in_use() == in_use);
        let found: Vec<_> = run(Operations(&a, &b)).into_iter().map(canonical).collect();
        for (k, (found, expected)) in found.iter().zip(&expected).enumerate() {
            assert_eq!(found, expected, "{} and {} on {set:?}", a[k], b[k]);
        }
    }
}
