//! Eigenvalues in regions: counted by the argument principle, found by Newton's method; a rectangle in which not all of
//! them are found is cut in two.

use crate::model::SearchError;
use crate::number::{Dual, List, Real, Store, modulus, sort_by};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::damped::circles::belongs;
use crate::search::damped::contour::{Polygon, Traversal};
use crate::search::damped::found::{Eigenvalue, Found, Region};
use crate::search::damped::growth::Growth;
use crate::search::damped::point::Point;
use crate::search::damped::rectangle::Rectangle;
use crate::search::damped::session::EigenvalueSearch;
use crate::search::room::add;
use num_complex::Complex;

/// Room for rectangles that wait: each is at most cut about 64 times.
const WAITING: usize = 128;

/// Lengths of steps: the shortest as a part of the shorter side, below which the contour passes so close to a root that it is
/// moved, and the longest first and second ones as parts of the longer side.
const STEPS: [f64; 3] = [1e-7, 1e-6, 0.05];

/// Slenderness below which the first steps are parts of the shorter side.
const SLENDER: f64 = 1e-2;

/// Shares by which a contour that meets a root is moved outwards, one after the other.
const MOVES: [f64; 5] = [0.0, 1e-5, 2.7e-4, 3.1e-3, 1.3e-2];

/// Shares at which a rectangle is cut, one after the other if the cut meets a root.
const CUTS: [f64; 5] = [0.5, 0.47, 0.54, 0.42, 0.59];

/// Points of a contour from which Newton's method starts.
const STARTS: usize = 24;

/// A rectangle, the number of its roots, and points from which some of them seem near.
#[derive(Clone, Copy, Debug, Default)]
struct Counted<T: Real> {
    rectangle: Rectangle<T>,
    roots: u64,
    starts: Starts<T>,
}

/// Points of a contour where Δ'/Δ is larger than at both neighbours.
#[derive(Clone, Copy, Debug)]
struct Starts<T: Real> {
    points: List<Complex<T>, STARTS>,
    last: [Option<(Complex<T>, T)>; 2],
}

impl<T: Real> Default for Starts<T> {
    fn default() -> Self {
        Starts { points: List::new(), last: [None; 2] }
    }
}

impl<T: Real> Starts<T> {
    fn visit(&mut self, point: &Point<T>) {
        let rate = modulus(point.rate);
        if let [Some((_, before)), Some((middle, peak))] = self.last
            && peak >= before
            && peak > rate
            && self.points.push(middle).is_err()
        {
            // further starts are left to smaller rectangles
        }
        self.last = [self.last[1], Some((point.lambda, rate))];
    }
}

impl<'a, T, Y, K> EigenvalueSearch<'a, Y, T, K>
where
    T: Real,
    K: Store<Eigenvalue<T>>,
    Y: System + Characteristic<Dual<Complex<T>>> + Characteristic<Dual<Complex<T::Extended>>> + ?Sized,
{
    /// Number of eigenvalues in a closed region.
    pub(super) fn count(&mut self, region: &Region<T>) -> Result<u64, SearchError> {
        let rectangle = self.enclosing(region)?;
        let exact = rectangle.low == *region.im.start() && rectangle.high == *region.im.end();
        if exact && let Some(roots) = self.counted_in_pieces(&rectangle)? {
            self.settle(|_| true);
            return Ok(roots);
        }
        self.find_in(rectangle)?;
        self.settle(|root| belongs(root, region) || belongs(&root.image(), region));
        self.check_circles(Some(region))?;
        let found = self.known.with_images();
        Ok(found.filter(|root| belongs(root, region)).map(|root| root.multiplicity).sum())
    }

    /// The number of roots in a rectangle, piece by piece; `None` if a contour meets one.
    fn counted_in_pieces(&mut self, rectangle: &Rectangle<T>) -> Result<Option<u64>, SearchError> {
        let mut roots = 0;
        for piece in rectangle.pieces() {
            if piece.left < piece.right {
                let Some(counted) = self.counted(piece)? else { return Ok(None) };
                roots += counted.roots;
            }
        }
        Ok(Some(roots))
    }

    /// All eigenvalues in a closed region.
    pub(super) fn in_region<L>(&mut self, region: &Region<T>) -> Result<Found<L>, SearchError>
    where
        L: Store<Eigenvalue<T>>,
    {
        let rectangle = self.enclosing(region)?;
        self.find_in(rectangle)?;
        self.settle(|root| belongs(root, region) || belongs(&root.image(), region));
        self.check_circles(Some(region))?;
        let mut eigenvalues = L::empty();
        for root in self.known.with_images() {
            if belongs(&root, region) {
                add(&mut eigenvalues, root)?;
            }
        }
        sort_by(eigenvalues.values(), |a, b| {
            (a.lambda.im < b.lambda.im) || (a.lambda.im == b.lambda.im && a.lambda.re < b.lambda.re)
        });
        Ok(Found { eigenvalues, evaluations: self.evaluation.evaluations })
    }

    /// The eigenvalues of least modulus in the closed upper half plane.
    pub(super) fn first<const N: usize>(&mut self) -> Result<Found<List<Eigenvalue<T>, N>>, SearchError> {
        let wanted = N as u64;
        let mut exponent = self.estimates.lowest_exponent() + 3;
        let (mut radius, mut most) = (T::one().times_power_of_two(exponent), 0);
        let end = self.end_of_reach();
        loop {
            let next = T::one().times_power_of_two(exponent);
            if let Some((end, error)) = end
                && next > end
            {
                let eigenvalues = self.within(end)?;
                let is_enough = number_of(&eigenvalues) >= wanted;
                let evaluations = self.evaluation.evaluations;
                return if is_enough { Ok(Found { eigenvalues, evaluations }) } else { Err(error) };
            }
            // `None` where the contour meets a root: then there is one more to find
            let count = self.counted(self.square(next))?.map_or(most + 1, |counted| counted.roots);
            if count > most {
                (radius, most) = (next, count);
            }
            let is_last = !self.estimates.is_continuous() && exponent > self.estimates.highest_exponent() + 30;
            // a square holds roots beyond its radius in its corners: those the next one has within
            let is_new = radius == next || radius + radius == next;
            // each but the real ones has a mirror image
            if is_last || (is_new && most >= 2 * wanted) {
                let eigenvalues = self.within(if is_last { radius + radius } else { next })?;
                let found = number_of(&eigenvalues);
                if found >= wanted {
                    return Ok(Found { eigenvalues, evaluations: self.evaluation.evaluations });
                }
                if is_last {
                    return Err(SearchError::TooFewRoots { found, wanted });
                }
            }
            exponent += 1;
        }
    }

    /// The fewest eigenvalues of least modulus, up to a radius, whose multiplicities add up to `N`; all of them if there are fewer.
    fn within<const N: usize>(&mut self, radius: T) -> Result<List<Eigenvalue<T>, N>, SearchError> {
        let square = self.square(radius);
        self.find_in(square)?;
        let is_whirl = self.estimates.is_whirl();
        // a real eigenvalue of a whirl may be found below the axis by rounding
        let is_upper =
            |root: &Eigenvalue<T>| root.lambda.im >= T::zero() || (is_whirl && root.lambda.im >= -root.error);
        self.settle(is_upper);
        self.check_circles(None)?;
        let mut found = K::empty();
        for &root in self.known.roots() {
            if is_upper(&root) && root.frequency() <= radius && square.contains(root.lambda, root.error) {
                add(&mut found, root)?;
            }
        }
        sort_by(found.values(), |a, b| a.frequency() < b.frequency());
        let (mut eigenvalues, mut settled) = (List::new(), 0);
        for root in found.iter() {
            if settled < N as u64 {
                settled += root.multiplicity;
                add(&mut eigenvalues, *root)?;
            }
        }
        Ok(eigenvalues)
    }

    /// Finds all eigenvalues in a rectangle or close to its contour.
    fn find_in(&mut self, rectangle: Rectangle<T>) -> Result<(), SearchError> {
        for piece in rectangle.pieces() {
            if piece.left < piece.right {
                self.find_in_piece(piece)?;
            }
        }
        Ok(())
    }

    fn find_in_piece(&mut self, rectangle: Rectangle<T>) -> Result<(), SearchError> {
        for share in MOVES {
            if let Some(counted) = self.counted(rectangle.grown(share))? {
                return if self.find_all(&counted)? { Ok(()) } else { self.find_in_parts(&counted) };
            }
        }
        Err(unresolved(rectangle))
    }

    /// Finds the roots of a rectangle by cutting it until each part shows its roots.
    #[inline(never)]
    fn find_in_parts(&mut self, whole: &Counted<T>) -> Result<(), SearchError> {
        let mut waiting = List::<Counted<T>, WAITING>::new();
        for part in self.cut(whole)? {
            wait(&mut waiting, part)?;
        }
        while let Some(next) = waiting.pop() {
            if !self.find_all(&next)? {
                for part in self.cut(&next)? {
                    wait(&mut waiting, part)?;
                }
            }
        }
        Ok(())
    }

    /// A rectangle with the number of its roots; `None` if its contour meets one.
    fn counted(&mut self, rectangle: Rectangle<T>) -> Result<Option<Counted<T>>, SearchError> {
        let slenderness = rectangle.slenderness();
        let first = if slenderness < SLENDER { slenderness } else { 1.0 };
        let steps = [STEPS[0] * slenderness, STEPS[1] * first, STEPS[2] * first];
        let growth = Growth::far_from_axis(&rectangle, T::from_f64(self.estimates.wave_sum()));
        let passed = rectangle.far_side().is_none().then_some(&rectangle);
        let polygon = Polygon { corners: &rectangle.contour(), steps, rectangle: passed, growth };
        for _ in 0..2 {
            let mut starts = Starts::default();
            let traversal = self.traverse(&polygon, |point| starts.visit(point))?;
            let Traversal::Argument(argument) = traversal else { return Ok(None) };
            let roots = rectangle.roots(argument).ok_or(unresolved(rectangle))?;
            // a traversal that counts fewer roots than are known is repeated, now with all of them divided out
            if self.known_in(&rectangle) <= roots {
                return Ok(Some(Counted { rectangle, roots, starts }));
            }
        }
        Err(unresolved(rectangle))
    }

    /// Number of known roots in a rectangle.
    fn known_in(&self, rectangle: &Rectangle<T>) -> u64 {
        let found = self.known.with_images();
        found.filter(|root| rectangle.contains(root.lambda, T::zero())).map(|root| root.multiplicity).sum()
    }

    /// Two parts whose counts add up.
    fn cut(&mut self, whole: &Counted<T>) -> Result<[Counted<T>; 2], SearchError> {
        for share in CUTS {
            let [first, second] = whole.rectangle.parts(share);
            let Some(first) = self.counted(first)? else { continue };
            let Some(second) = self.counted(second)? else { continue };
            let mirrored = if whole.rectangle.is_symmetric() && !first.rectangle.is_symmetric() { 2 } else { 1 };
            if mirrored * first.roots + second.roots != whole.roots {
                return Err(unresolved(whole.rectangle));
            }
            return Ok([first, second]);
        }
        Err(unresolved(whole.rectangle))
    }

    /// Finds the roots of a rectangle from points of its contour and inside; false if some are missing.
    fn find_all(&mut self, counted: &Counted<T>) -> Result<bool, SearchError> {
        let Counted { rectangle, roots, starts } = counted;
        let missing = |search: &Self| roots.checked_sub(search.known_in(rectangle)).ok_or(unresolved(*rectangle));
        for &start in starts.points.iter().chain(&rectangle.inner_points()) {
            let multiplicity = missing(self)?;
            if multiplicity == 0 {
                return Ok(true);
            }
            if self.is_tiny(rectangle) {
                let (lambda, error) = (rectangle.centre(), rectangle.size());
                let root = Eigenvalue { lambda, error, multiplicity, is_proven: false };
                return self.known.push(root).map(|()| true);
            }
            if self.known.is_full() {
                return Err(SearchError::Capacity { capacity: self.known.roots().len() });
            }
            let point = self.evaluation.at(start)?;
            self.find(&self.known.divided(&point, self.known.roots()), rectangle)?;
        }
        Ok(missing(self)? == 0)
    }

    /// Whether a rectangle is as small as a certified circle, so that its roots cannot be told apart.
    fn is_tiny(&self, rectangle: &Rectangle<T>) -> bool {
        let scale = self.scale(rectangle.centre());
        rectangle.size() <= scale * T::from_f64(64.0 * self.precision)
    }
}

/// Number of eigenvalues with their multiplicities.
fn number_of<T: Real>(eigenvalues: &[Eigenvalue<T>]) -> u64 {
    eigenvalues.iter().map(|root| root.multiplicity).sum()
}

fn wait<T: Real>(waiting: &mut List<Counted<T>, WAITING>, part: Counted<T>) -> Result<(), SearchError> {
    waiting.push(part).map_err(|lost| unresolved(lost.rectangle))
}

fn unresolved<T: Real>(rectangle: Rectangle<T>) -> SearchError {
    SearchError::Unresolved { near: modulus(rectangle.centre()).to_f64() }
}
