//! Numbers in the lanes of the widest vectors that the machine has.
//!
//! A program is compiled for the least machine it may run on, which on x86-64 has vectors of two numbers. A [`Task`] is
//! also compiled for wider vectors, of numbers in [`Lanes`], and the choice is made when it runs. No operation is fused with another
//! on any of them, but where the result is exact, so that every lane has the bits of a number alone.
//!
//! This crate is an implementation detail of `mstmm`, and the only one of its crates with `unsafe` code: a function for an
//! instruction set may be called only where the machine has it. The crate needs `std` to detect that.

mod lanes;
mod plain;
mod vector;

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;

#[cfg(target_arch = "x86_64")]
pub use avx2::Four;
#[cfg(target_arch = "x86_64")]
pub use avx512::Eight;
pub use lanes::{Lanes, Truths};
pub use plain::Plain;
pub use vector::{Part, Vector};

use std::sync::atomic::{AtomicU8, Ordering};

/// Work that is compiled for several instruction sets. All functions that it calls have to stand in line: one that does not is
/// compiled for the least machine.
pub trait Task {
    /// The result.
    type Output;

    /// The work in vectors of eight numbers. Mark it `#[inline(always)]`, as the others.
    #[cfg(target_arch = "x86_64")]
    fn on_avx512(self) -> Self::Output;

    /// The work in vectors of four numbers.
    #[cfg(target_arch = "x86_64")]
    fn on_avx2(self) -> Self::Output;

    /// The work one number at a time, on machines without such vectors.
    fn alone(self) -> Self::Output;
}

/// An instruction set for which a task is compiled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum InstructionSet {
    /// The instruction set of the target: one number at a time.
    Target,
    /// AVX2 with FMA: four numbers at once.
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
            if has!("avx2") && has!("fma") {
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
    task.alone()
}

#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx2,fma")]
fn on_avx2<T: Task>(task: T) -> T::Output {
    task.on_avx2()
}

#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl")]
fn on_avx512<T: Task>(task: T) -> T::Output {
    task.on_avx512()
}

#[cfg(test)]
mod tests;
