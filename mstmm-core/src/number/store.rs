//! What results are collected in: a list of fixed capacity, or with `std` a vector that grows.

use crate::number::fixed_list::List;
use core::ops::Deref;

/// A list to which values are added as long as there is room.
pub(crate) trait Store<V>: Deref<Target = [V]> {
    /// A list of the same kind for values of another type.
    type Of<U: Copy + Default>: Store<U>;

    /// The empty list.
    fn empty() -> Self;

    /// Appends a value; gives it back if there is no room.
    fn append(&mut self, value: V) -> Result<(), V>;

    /// Whether there is no room for another value.
    fn is_full(&self) -> bool;

    /// The values, to be changed or put in order.
    fn values(&mut self) -> &mut [V];
}

impl<V: Copy + Default, const CAP: usize> Store<V> for List<V, CAP> {
    type Of<U: Copy + Default> = List<U, CAP>;

    #[inline]
    fn empty() -> Self {
        List::new()
    }

    #[inline]
    fn append(&mut self, value: V) -> Result<(), V> {
        self.push(value)
    }

    #[inline]
    fn is_full(&self) -> bool {
        self.len() == CAP
    }

    #[inline]
    fn values(&mut self) -> &mut [V] {
        self.as_mut_slice()
    }
}

/// A vector is full where memory is.
#[cfg(feature = "std")]
impl<V: Copy + Default> Store<V> for std::vec::Vec<V> {
    type Of<U: Copy + Default> = std::vec::Vec<U>;

    fn empty() -> Self {
        std::vec::Vec::new()
    }

    fn append(&mut self, value: V) -> Result<(), V> {
        if self.try_reserve(1).is_err() {
            return Err(value);
        }
        self.push(value);
        Ok(())
    }

    fn is_full(&self) -> bool {
        false
    }

    fn values(&mut self) -> &mut [V] {
        self
    }
}
