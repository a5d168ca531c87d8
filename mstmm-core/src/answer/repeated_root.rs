//! The shapes of a multiple root, from the residue of the response at its pole.
//!
//! Near a root x0 the motion caused by a jump f is `Σ φ (φᵀ f)/(x - x0)` over its shapes, up to a constant. A sum over points
//! around x0 gives this residue, for one jump per shape, each at the entry where the rest of the residue is largest.

use crate::answer::dominant_entry::Candidate;
use crate::answer::mode_shape::{ModeShape, ShapeList, simple};
use crate::answer::root::{Root, check_at_rest, is_below_losses};
use crate::answer::states::SystemStates;
use crate::model::MotionError;
use crate::number::{Oscillation, Scalar, Scaled, Single};
use crate::pass::both_ways::Passes;
use crate::pass::tree::{ExtendedTree, Tree};

/// All shapes of a root. Those of a multiple one are computed again in extended precision where their states do not fit together.
pub(crate) fn all_shapes<'a, const CAP: usize, S, Y, R>(
    system: &'a Y,
    root: &R,
) -> Result<ShapeList<'a, Y, S, CAP>, MotionError>
where
    S: Oscillation<Y::Parameter>,
    Y: ExtendedTree<S> + ?Sized,
    R: Root<Y::Parameter, Frequency = S>,
{
    if is_below_losses(system, root.frequency()) {
        return Err(MotionError::LossFactor);
    }
    check_at_rest(system, root.frequency())?;
    let mut list = ShapeList { shapes: [const { None }; CAP] };
    if root.multiplicity() > 1 {
        let plain = shapes(system, root.frequency(), root.multiplicity(), &mut list.shapes);
        if S::HAS_EXTENDED && (plain.is_err() || list.iter().any(ModeShape::is_doubtful)) {
            let mut judged = [const { None }; CAP];
            shapes(system, root.frequency().to_extended(), root.multiplicity(), &mut judged)?;
            list.shapes = judged.map(|shape| shape.map(|shape| ModeShape::of_extended(&shape)));
        } else {
            plain?;
        }
        list.iter().try_for_each(ModeShape::check)?;
        return Ok(list);
    }
    let place = list.shapes.first_mut().ok_or(MotionError::Capacity { capacity: CAP })?;
    *place = Some(simple(system, root.frequency())?);
    Ok(list)
}

/// Number of points around a root.
const POINTS: usize = 8;
/// Number of distances that are tried, each a quarter of the one before.
const DISTANCES: u32 = 24;
/// Relative change of residues from one ring to the next from which on there is no pole.
const UNSETTLED: f64 = 1e-3;
/// Relative error of residues near a root, in roundings divided by the relative distance.
const ROUNDING: f64 = 10.0;
/// Difference, in roundings, between roots that count as one.
const ROOT_DIFFERENCE: f64 = 32.0;
/// Ratio of the errors of a ring and of one a quarter as large, `4^8`: the rest of the response enters with the eighth power of
/// the distance.
const QUARTER_GAIN: f64 = 65_536.0;
/// Least ratio of the mean response on a ring to the largest one for a pole of the order in question.
const LEAST_MEAN: f64 = 0.5;
/// Largest rest of the residue when all shapes are found, relative to the residue. It leaves room for close roots.
const LARGEST_REST: f64 = 1e-5;

/// Passes around a root.
struct ContourRing<'a, Y: Tree<S> + ?Sized, S: Single> {
    passes: [Passes<'a, Y, S>; POINTS],
    /// Weights of the points, and `x - x0`.
    weights: [(S, S); POINTS],
    /// Whether the root is zero, where the pole is one in λ².
    at_zero: bool,
    /// Distance of the nearest points.
    distance: f64,
}

/// The order of a pole: the power of `x - x0` by which the response is multiplied.
#[derive(Clone, Copy, Debug)]
enum Order {
    Simple,
    /// The pole of two eigenvalues that share one shape.
    Double,
}

/// Finds the shapes of a root.
pub(crate) fn shapes<'a, Y, S>(
    system: &'a Y,
    x: S,
    multiplicity: u64,
    found: &mut [Option<ModeShape<'a, Y, S>>],
) -> Result<(), MotionError>
where
    Y: Tree<S> + ?Sized,
    S: Oscillation<Y::Parameter>,
{
    let mut widest = f64::INFINITY;
    for _ in 0..DISTANCES {
        let (ring, first) = ContourRing::of_best_distance(system, x, multiplicity, widest)?;
        if ring.find(system, x, multiplicity, &first, found)? {
            return Ok(());
        }
        // there are more shapes than the root has: other roots lie inside of the ring
        widest = 0.25 * ring.distance;
    }
    Err(MotionError::Unresolved { root: x.modulus(), misfit: widest / x.size() })
}

impl<'a, Y, S> ContourRing<'a, Y, S>
where
    Y: Tree<S> + ?Sized,
    S: Oscillation<Y::Parameter>,
{
    /// Finds the shapes in the residue; `false` if there are more of them than the root has.
    fn find(
        &self,
        system: &'a Y,
        x: S,
        multiplicity: u64,
        first: &Candidate,
        found: &mut [Option<ModeShape<'a, Y, S>>],
    ) -> Result<bool, MotionError> {
        let size = x.modulus();
        let capacity = found.len();
        let mut count = 0;
        let mut next = Some(*first);
        while let Some(candidate) = next.take() {
            if count as u64 == multiplicity {
                return Ok(false);
            }
            let mut shape = self.shape(system, x, &candidate).ok_or(MotionError::NotFinite { frequency: size })?;
            // twice: the second time removes the rounding of the first
            for _ in 0..2 {
                for other in found[..count].iter().flatten() {
                    let product = shape.product(other);
                    shape.add(other, -product);
                }
                shape = ModeShape::normalised((*shape).clone()).ok_or(MotionError::NotFinite { frequency: size })?;
            }
            *found.get_mut(count).ok_or(MotionError::Capacity { capacity })? = Some(shape);
            count += 1;
            next = self.most_left(&found[..count], Some(first));
        }
        // at zero λ² is the root, and counts twice as an eigenvalue λ
        let count = count as u64;
        if count == multiplicity || (size == 0.0 && 2 * count == multiplicity) {
            return Ok(true);
        }
        Err(MotionError::Defective { root: size, multiplicity, shapes: count })
    }

    fn new(system: &'a Y, x: S, distance: f64) -> Self {
        let points = x.around(Scalar::from_f64(distance));
        let passes = points.map(|(point, _)| Passes::whole(system, point));
        ContourRing {
            passes,
            weights: points.map(|(point, weight)| (weight, point - x)),
            at_zero: x.is_zero(),
            distance,
        }
    }

    /// The ring of the least error, by the change from the one before it and by rounding, and its dominant entry.
    fn of_best_distance(system: &'a Y, x: S, multiplicity: u64, widest: f64) -> Result<(Self, Candidate), MotionError> {
        let lowest = 1.0.times_power_of_two(system.frequency_estimates().lowest_exponent());
        let size = x.modulus();
        let scale = if x.is_zero() { lowest } else { size };
        let rounding = S::EPSILON * scale;
        // the roots themselves are rounded, and lie off the middle of the ring
        let of_root = |distance: f64| {
            let away = ROOT_DIFFERENCE * <Y::Parameter as Scalar>::EPSILON * scale / distance;
            let squared = away * away;
            squared * squared * squared * squared
        };
        let mut best: [Option<(f64, f64)>; 2] = [None; 2];
        let mut distance = widest.min(0.05 * scale);
        let mut before = ContourRing::new(system, x, distance);
        for _ in 0..DISTANCES {
            distance *= 0.25;
            let ring = ContourRing::new(system, x, distance);
            for (order, best) in [Order::Simple, Order::Double].into_iter().zip(&mut best) {
                let change = ring.change(&before, order);
                let from_others = if change < UNSETTLED { change / QUARTER_GAIN } else { change };
                let error = from_others.max(ROUNDING * rounding / distance).max(of_root(distance));
                if change.is_finite() && best.is_none_or(|(least, _)| error < least) {
                    *best = Some((error, distance));
                }
            }
            before = ring;
            // smaller rings are worse
            if best.iter().all(|best| best.is_some_and(|(least, _)| ROUNDING * rounding / distance > least)) {
                break;
            }
        }
        let [Some((error, distance)), double] = best else { return Err(MotionError::NotFinite { frequency: size }) };
        let ring = ContourRing::new(system, x, distance);
        let has_settled = error < UNSETTLED;
        let is_double = |ring: &Self| ring.part(Order::Double) > LEAST_MEAN;
        let settles_as_double = || {
            double
                .is_some_and(|(error, distance)| error < UNSETTLED && is_double(&ContourRing::new(system, x, distance)))
        };
        if is_double(&ring) || (!has_settled && settles_as_double()) {
            return Err(MotionError::Defective { root: size, multiplicity, shapes: multiplicity.saturating_sub(1) });
        }
        if !has_settled && x.is_zero() {
            // only dampers hold the system there: its motions drift, and none is a pole in λ²
            return Err(MotionError::Defective { root: size, multiplicity, shapes: 0 });
        }
        if !has_settled {
            return Err(MotionError::NotARoot { frequency: size, mismatch: error });
        }
        let candidate = ring.largest().ok_or(MotionError::NotFinite { frequency: size })?;
        Ok((ring, candidate))
    }

    /// The relative change of all residues, as energies, from another ring to this one. The change of a single entry may be small by
    /// chance.
    fn change(&self, before: &Self, order: Order) -> f64 {
        let (mut change, mut whole) = (0.0, 0.0);
        self.passes[0].for_each_candidate(|candidate| {
            let now = self.coefficient(&candidate, order);
            change += (now - before.coefficient(&candidate, order)).size() * candidate.unit;
            whole += now.size() * candidate.unit;
        });
        change / whole
    }

    /// The coefficient of a pole of some order, relative to the largest response on the ring: 1 near such a pole, and 0 near a pole
    /// of lower order.
    fn part(&self, order: Order) -> f64 {
        let (mut mean, mut largest) = (0.0, 0.0);
        self.passes[0].for_each_candidate(|candidate| {
            mean += self.coefficient(&candidate, order).size() * candidate.unit;
            let sizes = self.responses(&candidate, order).map(|(response, _)| response.size());
            largest += sizes.fold(0.0, f64::max) * candidate.unit;
        });
        mean / largest
    }

    /// The response of an entry to a jump in its dual, times the power of `x - x0` for a pole of some order; and the weights.
    fn responses(&self, candidate: &Candidate, order: Order) -> impl Iterator<Item = (S, S)> {
        self.passes.iter().zip(self.weights).map(move |(passes, (weight, away))| {
            let meeting = passes.meeting(candidate.step);
            let square = meeting.square(candidate.coordinate);
            (square.over(meeting.delta()).times(self.power(away, order)).value(), weight)
        })
    }

    fn power(&self, away: S, order: Order) -> S {
        let simple = if self.at_zero { away * away } else { away };
        match order {
            Order::Simple => simple,
            Order::Double => simple * away,
        }
    }

    /// The coefficient of a pole of some order in the response of an entry to a jump in its dual.
    fn coefficient(&self, candidate: &Candidate, order: Order) -> S {
        self.responses(candidate, order).fold(S::zero(), |sum, (response, weight)| sum + response * weight)
    }

    fn residue(&self, candidate: &Candidate) -> S {
        self.coefficient(candidate, Order::Simple)
    }

    /// The candidate with the largest residue as an energy.
    fn largest(&self) -> Option<Candidate> {
        self.most_left(&[], None)
    }

    /// The candidate with the largest residue left besides the known shapes; `None` if nothing is left.
    fn most_left(&self, known: &[Option<ModeShape<'a, Y, S>>], first: Option<&Candidate>) -> Option<Candidate> {
        // the constant between residue and squares of shapes is known at the entry of the first shape
        let squares = |candidate: &Candidate| {
            known.iter().flatten().fold(S::zero(), |sum, shape| {
                let entry = shape.at(candidate.step, false).entry(candidate.coordinate);
                sum + entry * entry
            })
        };
        let signed = |candidate: &Candidate| {
            let residue = self.residue(candidate);
            if candidate.coordinate.is_force() { -residue } else { residue }
        };
        let ratio = first.map_or(S::zero(), |first| signed(first) / squares(first));
        let mut most: Option<(f64, Candidate)> = None;
        let mut whole = 0.0_f64;
        self.passes[0].for_each_candidate(|candidate| {
            let own = signed(&candidate);
            let left = (own - squares(&candidate) * ratio).size() * candidate.unit;
            whole = whole.max(own.size() * candidate.unit);
            if left.is_finite() && most.is_none_or(|(size, _)| left > size) {
                most = Some((left, candidate));
            }
        });
        most.filter(|(left, _)| *left > whole * LARGEST_REST).map(|(_, candidate)| candidate)
    }

    /// The residue of the motion that a jump causes, as a shape.
    fn shape(&self, system: &'a Y, x: S, candidate: &Candidate) -> Option<ModeShape<'a, Y, S>> {
        let mut sum: Option<SystemStates<'a, Y, S>> = None;
        let mut shift = 0;
        for (passes, (weight, away)) in self.passes.iter().zip(self.weights) {
            let factor =
                Scaled::new(weight * self.power(away, Order::Simple), 0).over(passes.meeting(candidate.step).delta());
            let exponent = factor.exponent().clamp(-1 << 30, 1 << 30) as i32;
            let jump = passes.meeting(candidate.step).jump(candidate.coordinate.dual());
            let [upstream, downstream] =
                [jump.upstream, jump.downstream].map(|covector| covector.times(factor.mantissa(), exponent));
            let recovered = passes.recover(candidate.step, upstream, downstream);
            match &mut sum {
                None => {
                    shift = -recovered.states.as_ref().iter().filter_map(|state| state.magnitude()).max()?;
                    sum = Some(SystemStates::of(system, x, &recovered, shift));
                }
                Some(sum) => sum.add(&SystemStates::of(system, x, &recovered, shift), S::one()),
            }
        }
        ModeShape::normalised(sum?)
    }
}
