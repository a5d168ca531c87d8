//! Memory of a network: arrays of a size that the compiler knows, or vectors of a size that the program decides.

use crate::number::Scalar;
use crate::structure::{Factor, in_memory};
use core::fmt::Debug;

/// What holds a value for each node and for each member of a network, and the unknowns of its elimination.
pub trait Memory: Copy + Debug {
    /// Most unknowns at once.
    const WIDTH: usize;

    /// A value for each node.
    type PerNode<V: Copy + Debug>: AsRef<[V]> + AsMut<[V]> + Clone + Debug;

    /// A value for each member.
    type PerMember<V: Copy + Debug>: AsRef<[V]> + AsMut<[V]> + Clone + Debug;

    /// The same value for each of `nodes` nodes. Arrays have their own size.
    fn per_node<V: Copy + Debug>(nodes: usize, value: V) -> Self::PerNode<V>;

    /// The same value for each of `members` members. Arrays have their own size.
    fn per_member<V: Copy + Debug>(members: usize, value: V) -> Self::PerMember<V>;

    /// Calls `work` with a factor that holds up to `width` unknowns at once. The factor keeps the row of each unknown that is eliminated.
    fn in_factor<S: Scalar, R>(width: usize, work: impl FnOnce(Factor<'_, S>) -> R) -> R;

    /// Calls `work` with a factor that holds up to `width` unknowns at once. The factor keeps no row.
    fn in_front<S: Scalar, R>(width: usize, work: impl FnOnce(Factor<'_, S>) -> R) -> R;
}

/// Arrays for up to `NODES` nodes and `MEMBERS` members, with up to `WIDTH` unknowns at once.
#[derive(Clone, Copy, Debug)]
pub enum Arrays<const WIDTH: usize, const NODES: usize, const MEMBERS: usize> {}

impl<const WIDTH: usize, const NODES: usize, const MEMBERS: usize> Memory for Arrays<WIDTH, NODES, MEMBERS> {
    const WIDTH: usize = WIDTH;
    type PerNode<V: Copy + Debug> = [V; NODES];
    type PerMember<V: Copy + Debug> = [V; MEMBERS];

    fn per_node<V: Copy + Debug>(_nodes: usize, value: V) -> [V; NODES] {
        [value; NODES]
    }

    fn per_member<V: Copy + Debug>(_members: usize, value: V) -> [V; MEMBERS] {
        [value; MEMBERS]
    }

    fn in_factor<S: Scalar, R>(_width: usize, work: impl FnOnce(Factor<'_, S>) -> R) -> R {
        in_memory::<WIDTH, NODES, S, R>(true, work)
    }

    fn in_front<S: Scalar, R>(_width: usize, work: impl FnOnce(Factor<'_, S>) -> R) -> R {
        // no row is kept
        in_memory::<WIDTH, 0, S, R>(false, work)
    }
}

/// Vectors.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug)]
pub enum Vectors {}

#[cfg(feature = "std")]
impl Memory for Vectors {
    const WIDTH: usize = usize::MAX;
    type PerNode<V: Copy + Debug> = std::vec::Vec<V>;
    type PerMember<V: Copy + Debug> = std::vec::Vec<V>;

    fn per_node<V: Copy + Debug>(nodes: usize, value: V) -> std::vec::Vec<V> {
        std::vec![value; nodes]
    }

    fn per_member<V: Copy + Debug>(members: usize, value: V) -> std::vec::Vec<V> {
        std::vec![value; members]
    }

    fn in_factor<S: Scalar, R>(width: usize, work: impl FnOnce(Factor<'_, S>) -> R) -> R {
        crate::structure::on_heap(width, true, work)
    }

    fn in_front<S: Scalar, R>(width: usize, work: impl FnOnce(Factor<'_, S>) -> R) -> R {
        crate::structure::on_heap(width, false, work)
    }
}
