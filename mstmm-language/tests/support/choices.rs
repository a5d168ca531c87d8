//! Bytes as choices: a test makes them at random, a fuzzer as it learns.

/// Choices still to be made. When there are no more bytes, the first alternative is taken.
#[derive(Debug)]
pub(crate) struct Choices<'a>(pub(crate) &'a [u8]);

impl Choices<'_> {
    /// One of `count` alternatives.
    pub(crate) fn below(&mut self, count: usize) -> usize {
        // two bytes where one has too few values
        let bytes = if count > 256 { 2 } else { 1 };
        let number = (0..bytes).fold(0, |number, _| 256 * number + usize::from(self.byte()));
        number % count.max(1)
    }

    /// One of the values, which are not empty.
    pub(crate) fn pick<'v, V: ?Sized>(&mut self, values: &[&'v V]) -> &'v V {
        values[self.below(values.len())]
    }

    /// Whether bytes are left.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }
}
