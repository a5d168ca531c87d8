//! Eigenvalues in regions: counted by the argument principle, found by Newton's method; a rectangle in which not all of
//! them are found is cut in two.

use super::contour::{Evaluation, Point, Walk};
use super::rectangle::Rectangle;
use super::region::{Eigenvalue, EigenvalueList, Region};
use crate::characteristic::{Characteristic, System};
use crate::error::SearchError;
use crate::list::List;
use crate::scalar::{Dual, Real, modulus};
use num_complex::Complex;

/// Room for the eigenvalues of a search while it runs.
const ROOM: usize = 256;

/// Room for rectangles that wait: each is at most cut about 64 times.
const WAITING: usize = 128;

/// Where steps would be shorter than the first of these as part of the shorter side, the contour passes so close to a root
/// that it is moved; the second, a part of the longer side, bounds the first step.
const STEPS: [f64; 2] = [1e-7, 0.05];

/// Shares by which a contour that meets a root is moved outwards, one after the other.
const MOVES: [f64; 5] = [0.0, 1e-5, 2.7e-4, 3.1e-3, 1.3e-2];

/// Where a rectangle is cut, one after the other if the cut meets a root.
const CUTS: [f64; 5] = [0.5, 0.47, 0.54, 0.42, 0.59];

/// Points of a contour from which Newton's method starts.
const STARTS: usize = 24;

/// Radius, in roots of eps, of a circle that the rounding of a double root explains.
const BLUR: f64 = 64.0;

/// Size of a rectangle, in radii of such a circle, from whose contour the roots within are told apart.
const NEAR: f64 = 8.0;

/// A search in progress.
pub(super) struct EigenvalueSearch<'a, Y: System + ?Sized> {
    pub(super) evaluation: Evaluation<'a, Y>,
    bounds: crate::bounds::FrequencyBounds,
}

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
            // what is too much here is left to smaller rectangles
        }
        self.last = [self.last[1], Some((point.lambda, rate))];
    }
}

/// Eigenvalues found so far; in symmetric rectangles an upper one stands for its mirror image, too.
pub(super) type Found<T> = List<Eigenvalue<T>, ROOM>;

impl<'a, T, Y> EigenvalueSearch<'a, Y>
where
    T: Real,
    Y: System<Parameter = T> + Characteristic<Dual<Complex<T>>> + ?Sized,
{
    pub(super) fn new(system: &'a Y) -> Self {
        EigenvalueSearch { evaluation: Evaluation::new(system), bounds: system.bounds() }
    }

    /// Frequencies of this size are as good as zero.
    pub(super) fn smallest(&self) -> T {
        T::one().times_power_of_two(self.bounds.negligible_exponent())
    }

    /// Number of eigenvalues in a closed region.
    pub(super) fn count(mut self, region: &Region<T>) -> Result<u64, SearchError> {
        let rectangle = enclosing(region)?;
        let exact = rectangle.low == *region.im.start() && rectangle.high == *region.im.end();
        if exact && let Some(counted) = self.counted(rectangle)? {
            return Ok(counted.roots);
        }
        let mut count = 0;
        self.roots(rectangle)?.iter().for_each(|root| {
            count += members(root, rectangle)
                .filter(|root| belongs(root, region))
                .map(|root| root.multiplicity)
                .sum::<u64>();
        });
        Ok(count)
    }

    /// All eigenvalues in a closed region.
    pub(super) fn in_region<const CAP: usize>(
        mut self,
        region: &Region<T>,
    ) -> Result<EigenvalueList<T, CAP>, SearchError> {
        let rectangle = enclosing(region)?;
        let found = self.roots(rectangle)?;
        let mut eigenvalues = List::new();
        for root in found.iter().flat_map(|root| members(root, rectangle)) {
            if belongs(&root, region) {
                eigenvalues.push(root).map_err(|_| SearchError::Capacity { capacity: CAP })?;
            }
        }
        eigenvalues.sort_by(|a: &Eigenvalue<T>, b| {
            (a.lambda.im < b.lambda.im) || (a.lambda.im == b.lambda.im && a.lambda.re < b.lambda.re)
        });
        Ok(EigenvalueList { eigenvalues, evaluations: self.evaluation.evaluations })
    }

    /// The eigenvalues of least modulus in the closed upper half plane.
    pub(super) fn first<const N: usize>(mut self) -> Result<EigenvalueList<T, N>, SearchError> {
        let wanted = N as u64;
        let mut exponent = self.bounds.lowest_exponent() + 3;
        let (mut radius, mut most) = (T::one().times_power_of_two(exponent), 0);
        loop {
            let next = T::one().times_power_of_two(exponent);
            // `None` where the contour meets a root: then there is one more to find
            let count = self.counted(square(next))?.map_or(most + 1, |counted| counted.roots);
            if count > most {
                (radius, most) = (next, count);
            }
            let is_last = !self.bounds.is_continuous() && exponent > self.bounds.highest_exponent() + 30;
            // each but the real ones has a mirror image
            if is_last || (count == most && most >= 2 * wanted && radius == next) {
                let eigenvalues = self.within(radius)?;
                let found = eigenvalues.iter().map(|root: &Eigenvalue<T>| root.multiplicity).sum();
                if found >= wanted {
                    return Ok(EigenvalueList { eigenvalues, evaluations: self.evaluation.evaluations });
                }
                if is_last {
                    return Err(SearchError::TooFewRoots { found });
                }
            }
            exponent += 1;
        }
    }

    /// The fewest eigenvalues of least modulus, up to a radius, whose multiplicities add up to `N`; or all there are.
    fn within<const N: usize>(&mut self, radius: T) -> Result<List<Eigenvalue<T>, N>, SearchError> {
        let mut found = self.roots(square(radius))?;
        found.sort_by(|a: &Eigenvalue<T>, b| a.frequency() < b.frequency());
        let (mut eigenvalues, mut settled) = (List::new(), 0);
        for root in found.iter().filter(|root| root.frequency() <= radius) {
            if settled < N as u64 {
                settled += root.multiplicity;
                eigenvalues.push(*root).map_err(|_| SearchError::Capacity { capacity: N })?;
            }
        }
        Ok(eigenvalues)
    }

    /// All eigenvalues in a rectangle or close to its contour.
    fn roots(&mut self, rectangle: Rectangle<T>) -> Result<Found<T>, SearchError> {
        let mut found = Found::new();
        let mut waiting = List::<Counted<T>, WAITING>::new();
        let mut moves = MOVES.iter();
        let outer = loop {
            let Some(&share) = moves.next() else { return Err(unresolved(rectangle)) };
            if let Some(counted) = self.counted(rectangle.grown(share))? {
                break counted;
            }
        };
        wait(&mut waiting, outer)?;
        while let Some(next) = waiting.pop() {
            if self.find_all(&next, &mut found)? {
                continue;
            }
            for part in self.cut(&next)? {
                wait(&mut waiting, part)?;
            }
        }
        Ok(found)
    }

    /// A rectangle with the number of its roots; `None` if its contour meets one.
    fn counted(&mut self, rectangle: Rectangle<T>) -> Result<Option<Counted<T>>, SearchError> {
        let mut starts = Starts::default();
        let steps = [STEPS[0] * rectangle.slenderness(), STEPS[1]];
        let walk = self.evaluation.walk(&rectangle.contour(), steps, |point| starts.visit(point))?;
        let Walk::Argument(argument) = walk else { return Ok(None) };
        let roots = rectangle.roots(argument).ok_or(unresolved(rectangle))?;
        Ok(Some(Counted { rectangle, roots, starts }))
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

    /// Finds and certifies all roots of a rectangle, or gives up and leaves `found` as it was.
    fn find_all(&mut self, counted: &Counted<T>, found: &mut Found<T>) -> Result<bool, SearchError> {
        let Counted { rectangle, roots, starts } = counted;
        let before = found.len();
        let mut missing = *roots;
        let tiny = self.is_tiny(rectangle);
        if missing > 0 && tiny {
            let (lambda, error) = (rectangle.centre(), rectangle.size());
            return keep(found, Eigenvalue { lambda, error, multiplicity: missing }).map(|()| true);
        }
        for &start in starts.points.iter().chain(&rectangle.inner_points()) {
            if missing == 0 {
                break;
            }
            let Some(root) = self.newton(start, rectangle, found)? else { continue };
            let Some(root) = self.certify(root, rectangle.is_symmetric())? else { continue };
            let known = found.iter().any(|old| modulus(old.lambda - root.lambda) <= old.error + root.error);
            let count = members(&root, *rectangle).map(|member| member.multiplicity).sum::<u64>();
            let settled = !self.may_be_a_cluster(&root, rectangle);
            if settled && !known && count <= missing && rectangle.contains(root.lambda, T::zero()) {
                keep(found, root)?;
                missing -= count;
            }
        }
        if missing > 0 {
            found.truncate(before);
        }
        Ok(missing == 0)
    }

    /// Whether a circle with several roots is so wide that rounding alone need not have blurred a double one, while the
    /// rectangle is wide beside it: from nearer by, the roots may be told apart.
    fn may_be_a_cluster(&self, root: &Eigenvalue<T>, rectangle: &Rectangle<T>) -> bool {
        let scale = super::contour::larger(modulus(root.lambda), self.smallest());
        let is_wide = root.multiplicity > 1 && root.error > scale * T::from_f64(BLUR) * T::from_f64(T::EPSILON).sqrt();
        is_wide && rectangle.size() > root.error * T::from_f64(NEAR)
    }

    /// Whether a rectangle is as small as a certified circle: what it holds cannot be told apart.
    fn is_tiny(&self, rectangle: &Rectangle<T>) -> bool {
        let scale = super::contour::larger(modulus(rectangle.centre()), self.smallest());
        rectangle.size() <= scale * T::from_f64(64.0 * T::EPSILON)
    }
}

/// A symmetric square, or nearly so, that holds all eigenvalues up to a modulus: motions of passive systems do not grow, so
/// nothing lies far on the right.
fn square<T: Real>(radius: T) -> Rectangle<T> {
    Rectangle { left: -radius, right: radius * T::from_f64(0.0625), low: -radius, high: radius }
}

/// The rectangle to search for a region: where it meets the real axis, one symmetric to it.
fn enclosing<T: Real>(region: &Region<T>) -> Result<Rectangle<T>, SearchError> {
    for range in [&region.re, &region.im] {
        let (start, end) = (*range.start(), *range.end());
        let valid = start < end && start.size().is_finite() && end.size().is_finite();
        if !valid {
            return Err(SearchError::Range { start: start.to_f64(), end: end.to_f64() });
        }
    }
    let (left, right, low, high) = (*region.re.start(), *region.re.end(), *region.im.start(), *region.im.end());
    if low > T::zero() || high < T::zero() {
        return Ok(Rectangle { left, right, low, high });
    }
    let high = super::contour::larger(-low, high);
    Ok(Rectangle { left, right, low: -high, high })
}

/// A root, and its mirror image where it stands for both.
fn members<T: Real>(root: &Eigenvalue<T>, rectangle: Rectangle<T>) -> impl Iterator<Item = Eigenvalue<T>> {
    let mirrored = rectangle.is_symmetric() && !root.lambda.im.is_zero();
    let image = mirrored.then_some(Eigenvalue { lambda: root.lambda.conj(), ..*root });
    [Some(*root), image].into_iter().flatten()
}

/// Whether an eigenvalue belongs to a closed region, as far as its certified circle tells.
fn belongs<T: Real>(root: &Eigenvalue<T>, region: &Region<T>) -> bool {
    let Region { re, im } = region;
    let rectangle = Rectangle { left: *re.start(), right: *re.end(), low: *im.start(), high: *im.end() };
    rectangle.contains(root.lambda, root.error)
}

fn keep<T: Real>(found: &mut Found<T>, root: Eigenvalue<T>) -> Result<(), SearchError> {
    found.push(root).map_err(|_| SearchError::Capacity { capacity: ROOM })
}

fn wait<T: Real>(waiting: &mut List<Counted<T>, WAITING>, part: Counted<T>) -> Result<(), SearchError> {
    waiting.push(part).map_err(|lost| unresolved(lost.rectangle))
}

fn unresolved<T: Real>(rectangle: Rectangle<T>) -> SearchError {
    SearchError::Unresolved { near: modulus(rectangle.centre()).to_f64() }
}
