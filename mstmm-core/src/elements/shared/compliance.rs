//! What gives way, by a stiffness that may be infinite.

use crate::number::Parameter;

/// `1/K`, which vanishes for a stiffness that is infinite. Pairs of words have no quotient of it; each lane is a number that has.
#[inline]
pub(crate) fn compliance<T: Parameter>(stiffness: T) -> T {
    if is_rigid(stiffness) { T::zero() } else { T::one() / stiffness }
}

/// Whether a stiffness is infinite, outside of lanes, where proofs do not ask.
#[inline]
pub(crate) fn is_rigid<T: Parameter>(stiffness: T) -> bool {
    !T::IN_LANES && stiffness.to_f64() == f64::INFINITY
}

#[cfg(test)]
mod tests {
    use super::compliance;
    use crate::DoubleDouble;
    use crate::number::Scalar;

    #[test]
    fn an_infinite_stiffness_does_not_give_way() {
        assert_eq!([4.0, f64::INFINITY].map(compliance), [0.25, 0.0]);
        assert_eq!(compliance(f32::INFINITY), 0.0);
        let pair = DoubleDouble::from_f64;
        assert_eq!([pair(4.0), pair(f64::INFINITY)].map(compliance), [pair(0.25), pair(0.0)]);
    }
}
