//! What is written one after the other while a structure is eliminated: in a slice, or in a vector that grows.

/// Values in the order in which they were written.
#[derive(Debug)]
pub(super) enum Tape<'r, V> {
    /// Memory for so many, and how many there are.
    Slice(&'r mut [V], usize),
    /// As many as there are.
    #[cfg(feature = "std")]
    Vector(&'r mut std::vec::Vec<V>),
}

impl<V: Copy> Tape<'_, V> {
    /// Writes a value. Returns whether there was room for it.
    #[inline(always)]
    pub(super) fn push(&mut self, value: V) -> bool {
        match self {
            Tape::Slice(slice, count) => match slice.get_mut(*count) {
                Some(place) => {
                    *place = value;
                    *count += 1;
                    true
                }
                None => false,
            },
            #[cfg(feature = "std")]
            Tape::Vector(vector) => {
                vector.push(value);
                true
            }
        }
    }

    /// Forgets all values.
    pub(super) fn clear(&mut self) {
        match self {
            Tape::Slice(_, count) => *count = 0,
            #[cfg(feature = "std")]
            Tape::Vector(vector) => vector.clear(),
        }
    }

    /// Writes one value so many times, as far as there is room.
    pub(super) fn fill(&mut self, value: V, count: usize) {
        self.clear();
        for _ in 0..count {
            self.push(value);
        }
    }

    /// The values.
    #[inline(always)]
    pub(super) fn get(&self) -> &[V] {
        match self {
            Tape::Slice(slice, count) => &slice[..*count],
            #[cfg(feature = "std")]
            Tape::Vector(vector) => vector,
        }
    }

    /// The values, to be changed.
    #[inline(always)]
    pub(super) fn get_mut(&mut self) -> &mut [V] {
        match self {
            Tape::Slice(slice, count) => &mut slice[..*count],
            #[cfg(feature = "std")]
            Tape::Vector(vector) => vector,
        }
    }
}
