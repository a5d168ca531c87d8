//! Classes of things that are joined.

/// A partition of `0..n`; each class is known by its least member.
#[derive(Clone)]
pub(crate) struct Classes(Vec<usize>);

impl Classes {
    /// Puts each thing into a class of its own.
    pub(crate) fn new(count: usize) -> Self {
        Classes((0..count).collect())
    }

    /// The class of a thing.
    pub(crate) fn of(&self, thing: usize) -> usize {
        self.0[thing]
    }

    /// Makes one class of the classes of two things.
    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.of(a), self.of(b));
        let (least, other) = (a.min(b), a.max(b));
        for class in self.0.iter_mut().filter(|class| **class == other) {
            *class = least;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Classes;

    #[test]
    fn a_class_is_known_by_its_least_member() {
        let mut classes = Classes::new(6);
        for (a, b) in [(5, 4), (1, 2), (4, 2)] {
            classes.join(a, b);
        }
        assert_eq!([0, 1, 2, 3, 4, 5].map(|thing| classes.of(thing)), [0, 1, 1, 3, 1, 1]);
    }
}
