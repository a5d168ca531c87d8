//! A list of fixed capacity, for results without allocation.

use core::fmt;
use core::ops::Deref;

/// A list of up to `CAP` values in an array; dereferences to the slice of its values.
#[derive(Clone, Copy)]
pub struct List<V, const CAP: usize> {
    values: [V; CAP],
    length: usize,
}

impl<V: Copy + Default, const CAP: usize> List<V, CAP> {
    /// The empty list.
    #[inline]
    pub(crate) fn new() -> Self {
        List { values: [V::default(); CAP], length: 0 }
    }

    /// Appends a value; gives it back if the list is full.
    #[inline]
    pub(crate) fn push(&mut self, value: V) -> Result<(), V> {
        match self.values.get_mut(self.length) {
            None => Err(value),
            Some(place) => {
                *place = value;
                self.length += 1;
                Ok(())
            }
        }
    }
}

impl<V: Copy, const CAP: usize> List<V, CAP> {
    /// Takes the last value off.
    #[inline]
    pub(crate) fn pop(&mut self) -> Option<V> {
        let last = self.last().copied();
        self.length = self.length.saturating_sub(1);
        last
    }

    /// The values, to be changed or put in order.
    #[inline]
    pub(crate) fn as_mut_slice(&mut self) -> &mut [V] {
        &mut self.values[..self.length]
    }

    /// The list of a function of each value.
    pub(crate) fn map<W>(self, to: impl FnMut(V) -> W) -> List<W, CAP> {
        List { values: self.values.map(to), length: self.length }
    }

    /// Turns the order round.
    #[inline]
    pub(crate) fn reverse(&mut self) {
        self.as_mut_slice().reverse();
    }
}

/// Sorts by insertion; `before` tells whether one value stands strictly before another.
#[inline]
pub(crate) fn sort_by<V>(values: &mut [V], before: impl Fn(&V, &V) -> bool) {
    for end in 1..values.len() {
        let mut place = end;
        while place > 0 && before(&values[place], &values[place - 1]) {
            values.swap(place, place - 1);
            place -= 1;
        }
    }
}

/// Shows the values, not the unused memory.
impl<V: fmt::Debug, const CAP: usize> fmt::Debug for List<V, CAP> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

impl<V, const CAP: usize> Deref for List<V, CAP> {
    type Target = [V];

    #[inline]
    fn deref(&self) -> &[V] {
        &self.values[..self.length]
    }
}

impl<'a, V, const CAP: usize> IntoIterator for &'a List<V, CAP> {
    type Item = &'a V;
    type IntoIter = core::slice::Iter<'a, V>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn takes_no_more_than_its_capacity() {
        let mut list = List::<u8, 2>::new();
        assert_eq!((list.push(1), list.push(2), list.push(3)), (Ok(()), Ok(()), Err(3)));
        assert_eq!(&*list, [1, 2]);
    }

    #[test]
    fn shows_only_what_is_there() {
        let mut list = List::<u8, 3>::new();
        assert_eq!(std::format!("{list:?}"), "[]");
        assert_eq!(list.push(7), Ok(()));
        assert_eq!(std::format!("{list:?}"), "[7]");
    }
}
