//! Runs a loop compiled for the widest instruction set that the machine has.
//!
//! A program is compiled for the least machine it may run on, which on x86-64 has vectors of two numbers. A [`Task`] is
//! also compiled for wider vectors, and the choice is made when it runs. No operation is fused with another on any of them, so
//! that every result has the same bits.
//!
//! This crate is an implementation detail of `mstmm`, and the only one of its crates with `unsafe` code: a function for an
//! instruction set may be called only where the machine has it. The crate needs `std` to detect that.

use std::sync::atomic::{AtomicU8, Ordering};

/// A loop that is compiled for several instruction sets.
pub trait Task {
    /// The result of the loop.
    type Output;

    /// Runs the loop. Mark it and all functions that it calls `#[inline(always)]`: a function that is not inlined is compiled for
    /// the least machine.
    fn run(self) -> Self::Output;
}

/// An instruction set for which a task is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum InstructionSet {
    /// The instruction set of the target: two numbers at once on x86-64.
    Target,
    /// AVX2: four numbers at once.
    Avx2,
    /// AVX-512: eight numbers at once.
    Avx512,
}

/// The set in use, plus one; 0 before the detection.
static IN_USE: AtomicU8 = AtomicU8::new(0);

impl InstructionSet {
    /// All instruction sets, narrowest first.
    pub const ALL: [Self; 3] = [Self::Target, Self::Avx2, Self::Avx512];

    /// The widest set of this machine.
    pub fn widest() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            use std::arch::is_x86_feature_detected as has;
            if has!("avx512f") && has!("avx512dq") && has!("avx512bw") && has!("avx512vl") {
                return Self::Avx512;
            }
            if has!("avx2") {
                return Self::Avx2;
            }
        }
        Self::Target
    }

    /// The set in use: the widest, unless [`limit`](Self::limit) has said otherwise.
    #[inline]
    pub fn in_use() -> Self {
        match IN_USE.load(Ordering::Relaxed) {
            1 => Self::Target,
            2 => Self::Avx2,
            3 => Self::Avx512,
            _ => Self::Avx512.limit(),
        }
    }

    /// Uses no wider set than this from now on, in the whole program, for comparisons. Returns the set in use.
    pub fn limit(self) -> Self {
        let set = self.min(Self::widest());
        IN_USE.store(set as u8 + 1, Ordering::Relaxed);
        set
    }
}

/// Runs a task, compiled for the instruction set in use.
#[inline]
pub fn run<T: Task>(task: T) -> T::Output {
    #[cfg(target_arch = "x86_64")]
    match InstructionSet::in_use() {
        // SAFETY: `in_use` is never wider than what was detected on this machine
        #[expect(unsafe_code, reason = "the instruction set has been detected")]
        InstructionSet::Avx512 => return unsafe { on_avx512(task) },
        // SAFETY: as above
        #[expect(unsafe_code, reason = "the instruction set has been detected")]
        InstructionSet::Avx2 => return unsafe { on_avx2(task) },
        InstructionSet::Target => {}
    }
    on_target(task)
}

#[inline(never)]
fn on_target<T: Task>(task: T) -> T::Output {
    task.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn on_avx2<T: Task>(task: T) -> T::Output {
    task.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl")]
fn on_avx512<T: Task>(task: T) -> T::Output {
    task.run()
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Sum<'a>(&'a [f64; 64]);

    impl Task for Sum<'_> {
        type Output = [f64; 64];

        #[inline(always)]
        fn run(self) -> [f64; 64] {
            self.0.map(|x| x * x + 1.0 / (x + 2.0))
        }
    }

    #[test]
    fn all_sets_give_the_same_bits_and_none_is_wider_than_the_machine() {
        let numbers = core::array::from_fn(|k| (k as f64).sin());
        let all = InstructionSet::ALL.map(|set| {
            assert!(set.limit() <= InstructionSet::widest());
            assert_eq!(InstructionSet::in_use(), set.min(InstructionSet::widest()));
            run(Sum(&numbers)).map(f64::to_bits)
        });
        assert!(all.iter().all(|bits| *bits == all[0]));
        assert_eq!(all[0][0], 0.5_f64.to_bits());
    }
}
