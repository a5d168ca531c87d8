//! Deflation: known eigenvalues are divided out of Δ. The rest is smooth where all roots nearby are known.

use crate::model::SearchError;
use crate::number::{Real, Scalar, Scaled, Store, argument, modulus};
use crate::search::damped::found::Eigenvalue;
use crate::search::damped::point::Point;
use crate::search::room::add;
use core::marker::PhantomData;
use num_complex::Complex;

/// Certified eigenvalues in the closed upper half plane; each stands for its mirror image, too.
///
/// With a loss factor there are no mirror images, and Δ is continued below the real axis, where its roots are those of no motion.
pub(super) struct KnownRoots<T, K> {
    roots: K,
    number: PhantomData<T>,
    /// Whether `Δ(conj λ) = conj Δ(λ)`.
    pub(super) have_images: bool,
}

impl<T: Real, K: Store<Eigenvalue<T>>> KnownRoots<T, K> {
    /// The empty list.
    pub(super) fn new(have_images: bool) -> Self {
        KnownRoots { roots: K::empty(), number: PhantomData, have_images }
    }

    /// The roots in the order in which they were found.
    pub(super) fn roots(&self) -> &[Eigenvalue<T>] {
        &self.roots
    }

    /// The roots and their mirror images.
    pub(super) fn with_images(&self) -> impl Iterator<Item = Eigenvalue<T>> {
        self.roots.iter().flat_map(|root| self.with_image(root))
    }

    /// A root and its mirror image; a real one has none. Not inlined, since each place would take some hundred bytes of firmware.
    #[inline(never)]
    pub(super) fn with_image(&self, root: &Eigenvalue<T>) -> impl Iterator<Item = Eigenvalue<T>> + use<T, K> {
        let image = root.image();
        let has_image = self.have_images && !root.lambda.im.is_zero();
        [*root, image].into_iter().take(if has_image { 2 } else { 1 })
    }

    /// Whether there is no room for another.
    pub(super) fn is_full(&self) -> bool {
        self.roots.is_full()
    }

    /// Puts another eigenvalue in the place of one.
    pub(super) fn replace(&mut self, place: usize, root: Eigenvalue<T>) {
        self.roots.values()[place] = root;
    }

    /// Adds an eigenvalue, or says for how many there is room.
    pub(super) fn push(&mut self, root: Eigenvalue<T>) -> Result<(), SearchError> {
        add(&mut self.roots, root)
    }

    /// Whether the circle of an eigenvalue meets that of a known one.
    pub(super) fn holds(&self, root: &Eigenvalue<T>) -> bool {
        meets_any(root, &self.roots)
    }
}

/// Whether the circle of a root meets the circle of another.
pub(super) fn meets_any<T: Real>(root: &Eigenvalue<T>, others: &[Eigenvalue<T>]) -> bool {
    others.iter().any(|other| modulus(other.lambda - root.lambda) <= other.error + root.error)
}

impl<T: Real, K: Store<Eigenvalue<T>>> KnownRoots<T, K> {
    /// Δ and its logarithmic derivative with roots and their mirror images divided out.
    pub(super) fn divided(&self, point: &Point<T>, roots: &[Eigenvalue<T>]) -> Point<T> {
        let mut divisor = Scaled::new(Complex::from(T::one()), 0);
        let mut rate = point.rate;
        for root in roots {
            let from = point.lambda - root.lambda;
            let (mut factor, mut slope) = (from, Complex::from(T::one()));
            if self.have_images && !root.lambda.im.is_zero() {
                let from_image = point.lambda - root.lambda.conj();
                (factor, slope) = (from * from_image, from + from_image);
            }
            rate -= slope / factor * T::from_f64(root.multiplicity as f64);
            // distances are far from the ends of the range: it is enough to normalise the product
            (0..root.multiplicity).for_each(|_| divisor = Scaled::new(divisor.mantissa() * factor, divisor.exponent()));
        }
        let is_root = point.is_root || !rate.size().is_finite();
        Point { lambda: point.lambda, value: point.value.over(divisor), rate, is_root }
    }

    /// Growth along a polygon of the argument of the factors that are divided out for a root. Each side sees a root under less
    /// than half a turn.
    pub(super) fn turning(&self, root: &Eigenvalue<T>, polygon: impl Iterator<Item = Complex<T>> + Clone) -> f64 {
        // lest the product of small or large distances leave the range of the type
        let unit = |from: Complex<T>| from * T::from_f64(from.size().recip());
        let mut angle = 0.0;
        for root in self.with_image(root) {
            let mut before: Option<Complex<T>> = None;
            for direction in polygon.clone().map(|corner| unit(corner - root.lambda)) {
                if let Some(before) = before.replace(direction) {
                    let turn = direction * before.conj();
                    angle += argument(turn.re.to_f64(), turn.im.to_f64());
                }
            }
        }
        angle * root.multiplicity as f64
    }
}
