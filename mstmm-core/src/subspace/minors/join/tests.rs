//! Connections against the addition of stiffnesses: of a plane `[[p_ΘQ, -w], [-w, p_YM]]/p_YΘ`, of a line `-q/y`.

use super::*;
use crate::number::{DoubleDouble, Parameter, Scaled, assert_close};
use crate::subspace::connecting::{Connecting, connection};
use crate::subspace::count::{NoCount, WittrickWilliams};
use mstmm_plan::Support;
use proptest::option;
use proptest::prelude::*;
use std::vec::Vec;

/// Entries (Y, Y), (Y, Θ) and (Θ, Θ) of a symmetric stiffness matrix.
type Stiffness = [f64; 3];

/// A path that arrives at a connection: what it is, and its stiffness there.
#[derive(Clone, Copy, Debug)]
struct Path {
    subspace: Subspace<f64>,
    stiffness: Stiffness,
}

impl Path {
    /// A path with the given stiffness, its coordinates times `factor`.
    fn plane([k, b, d]: Stiffness, factor: f64) -> Self {
        let minors = [1.0, d, -b, k, k * d - b * b].map(|minor| minor * factor);
        Path { subspace: Subspace::Plane(Plane::new(minors, 0)), stiffness: [k, b, d] }
    }

    fn line(k: f64, space: Space, factor: f64) -> Self {
        let subspace = Subspace::Line(Line::new(factor, -k * factor, 0), space);
        Path { subspace, stiffness: placed(k, space) }
    }

    fn springs(y: Option<f64>, theta: Option<f64>) -> Self {
        let stiffness = [y.unwrap_or(0.0), 0.0, theta.unwrap_or(0.0)];
        Path { subspace: Subspace::Springs { y, theta }, stiffness }
    }

    fn grounded(k: f64, space: Space) -> Self {
        Path { subspace: Subspace::Grounded(k, space), stiffness: placed(k, space) }
    }
}

/// The stiffness of a line where it meets a bending state.
fn placed(k: f64, space: Space) -> Stiffness {
    if space.is(Space::Translation) { [k, 0.0, 0.0] } else { [0.0, 0.0, k] }
}

fn sum(paths: &[Path]) -> Stiffness {
    core::array::from_fn(|entry| paths.iter().map(|path| path.stiffness[entry]).sum())
}

/// Sum of the moduli, at least 1: what roundings are relative to.
fn scale(paths: &[Path]) -> f64 {
    paths.iter().flat_map(|path| path.stiffness).map(f64::abs).sum::<f64>().max(1.0)
}

fn joined_at(paths: &[Path], supports: &[Support], output: Option<Space>) -> Subspace<f64> {
    let tips = supports.iter().map(|&support| Subspace::Tip(support, Space::Bending));
    let inputs: Vec<_> = paths.iter().map(|path| path.subspace).chain(tips).collect();
    connection(inputs.iter().copied(), output, &mut NoCount)
}

/// Asserts the stiffness of a subspace and, of a plane, `p_YΘ p_MQ = p_YM p_ΘQ - w²`.
fn assert_stiffness(subspace: Subspace<f64>, expected: Stiffness, scale: f64) {
    // a join has at most five products of five factors, and there are up to four joins
    const ROUNDINGS: f64 = 100.0;
    match subspace {
        Subspace::Plane(_) | Subspace::OnPin(_) | Subspace::Springs { .. } => {
            let p = subspace.plane();
            let actual = [p.theta_q / p.y_theta, -p.w / p.y_theta, p.y_m / p.y_theta];
            for (actual, expected) in actual.into_iter().zip(expected) {
                assert_close(actual, expected, scale, ROUNDINGS);
            }
            let determinant = expected[0] * expected[2] - expected[1] * expected[1];
            assert_close(p.m_q / p.y_theta, determinant, scale * scale, ROUNDINGS);
        }
        Subspace::Line(..) | Subspace::Grounded(..) => {
            let (line, own) = (subspace.line(), if subspace.space().is(Space::Rotation) { 2 } else { 0 });
            assert_close(-line.q / line.y, expected[own], scale, ROUNDINGS);
        }
        Subspace::Tip(..) => panic!("a tip"),
    }
}

fn stiffness() -> impl Strategy<Value = Stiffness> {
    proptest::array::uniform3(-5.0..5.0f64)
}

fn factor() -> impl Strategy<Value = f64> {
    prop_oneof![0.5..2.0f64, -2.0..-0.5f64]
}

fn narrow_path(space: Space) -> impl Strategy<Value = Path> {
    (-5.0..5.0f64, factor(), any::<bool>()).prop_map(move |(k, factor, grounded)| {
        if grounded { Path::grounded(k, space) } else { Path::line(k, space, factor) }
    })
}

fn path() -> impl Strategy<Value = Path> {
    prop_oneof![
        (stiffness(), factor()).prop_map(|(k, factor)| Path::plane(k, factor)),
        (option::of(-5.0..5.0f64), option::of(-5.0..5.0f64)).prop_map(|(y, theta)| Path::springs(y, theta)),
        narrow_path(Space::Translation),
        narrow_path(Space::Rotation),
    ]
}

proptest! {
    /// Stiffnesses add up, whatever meets, in any order.
    #[test]
    fn stiffnesses_add_up(paths in proptest::collection::vec(path(), 1..5)) {
        let joined = joined_at(&paths, &[], Some(Space::Bending));
        prop_assert!(joined.space().is(Space::Bending));
        assert_stiffness(joined, sum(&paths), scale(&paths));
        let reversed: Vec<_> = paths.iter().rev().copied().collect();
        assert_stiffness(joined_at(&reversed, &[], Some(Space::Bending)), sum(&paths), scale(&paths));
    }

    /// Paths of one narrow space stay lines.
    #[test]
    fn stiffnesses_of_lines_add_up(
        translations in proptest::collection::vec(narrow_path(Space::Translation), 1..5),
        rotations in proptest::collection::vec(narrow_path(Space::Rotation), 1..5),
    ) {
        for (paths, space) in [(translations, Space::Translation), (rotations, Space::Rotation)] {
            for output in [Some(space), None] {
                let joined = joined_at(&paths, &[], output);
                prop_assert!(joined.space().is(space) && !matches!(joined, Subspace::Plane(_)));
                assert_stiffness(joined, sum(&paths), scale(&paths));
            }
        }
    }

    /// A free support holds nothing; the others add their own plane, which the general rule joins like any other.
    #[test]
    fn a_support_joins_its_own_plane(paths in proptest::collection::vec(path(), 1..4)) {
        let sum = joined_at(&paths, &[], Some(Space::Bending)).plane();
        for support in [Support::Free, Support::Pinned, Support::Guided, Support::Fixed] {
            let held = joined_at(&paths, &[support], Some(Space::Bending)).plane();
            prop_assert_eq!(held, sum.with_plane(Plane::of_tip(support), &mut NoCount));
        }
    }

    /// A support is the limit of a stiff spring: behind a stiffness of 1e200, the coordinates divided by it are the held
    /// ones, to the last bit but for the joined terms that vanish.
    #[test]
    fn a_support_is_a_very_stiff_spring(paths in proptest::collection::vec(path(), 1..4)) {
        const STIFF: f64 = 1e200;
        for (support, space) in [(Support::Pinned, Space::Translation), (Support::Guided, Space::Rotation)] {
            let mut sprung = paths.clone();
            sprung.push(Path::grounded(STIFF, space));
            let minors = |subspace| {
                let Plane { y_theta, y_m, w, theta_q, m_q, exponent } = Subspace::plane(subspace);
                [y_theta, y_m, w, theta_q, m_q].map(|minor| Scaled::new(minor, i64::from(exponent)))
            };
            let held = minors(joined_at(&paths, &[support], Some(Space::Bending)));
            let sprung = minors(joined_at(&sprung, &[], Some(Space::Bending)));
            let largest = held.iter().map(|minor| minor.value().abs()).fold(0.0, f64::max);
            for (held, sprung) in held.iter().zip(sprung) {
                assert_close(sprung.times(1.0 / STIFF).value(), held.value(), largest, 16.0);
            }
        }
    }

    /// A line that is fixed where it arrives has no displacement; its force is as free as it was.
    #[test]
    fn a_fixed_line_does_not_move(path in narrow_path(Space::Translation)) {
        let held = joined_at(&[path], &[Support::Fixed], Some(Space::Translation)).line();
        prop_assert_eq!(held.y, 0.0);
        prop_assert!(held.q != 0.0);
        let free = joined_at(&[path], &[Support::Free], Some(Space::Translation));
        prop_assert_eq!(free, path.subspace);
    }

    /// A bending path that goes on as a line leaves an entry behind without force: static condensation, the Schur
    /// complement of the stiffness. The count gains the sign of what is condensed.
    #[test]
    fn narrowing_condenses_what_does_not_go_on(k in stiffness(), factor in factor()) {
        let [kept, coupling, left] = k;
        prop_assume!(left.abs() > 0.01);
        for (space, k) in [(Space::Translation, k), (Space::Rotation, [left, coupling, kept])] {
            let mut count = WittrickWilliams::<f64>::default();
            let narrow = connection([Path::plane(k, factor).subspace].into_iter(), Some(space), &mut count);
            prop_assert!(narrow.space().is(space));
            let expected = kept - coupling * coupling / left;
            // the sum and the determinant in p_MQ, divided by what was left behind
            let size = (kept * left).abs() + coupling * coupling;
            assert_stiffness(narrow, placed(expected, space), size / left.abs());
            prop_assert_eq!(count.below(), u64::from(left < 0.0));
        }
    }

    /// A translation that goes on as a rotation, or the other way round, is left behind as a whole: what goes on is free, or
    /// held by a support, and the count gains the sign of the stiffness behind.
    #[test]
    fn a_line_that_goes_on_otherwise_is_left_behind(k in prop_oneof![0.01..5.0f64, -5.0..-0.01f64], factor in factor()) {
        for (space, other) in [(Space::Translation, Space::Rotation), (Space::Rotation, Space::Translation)] {
            for path in [Path::line(k, space, factor), Path::grounded(k, space)] {
                let mut count = WittrickWilliams::<f64>::default();
                let free = connection([path.subspace, Subspace::Tip(Support::Free, Space::Bending)].into_iter(), Some(other), &mut count);
                prop_assert!(free.space().is(other) && free.line().y != 0.0 && free.line().q == 0.0, "{free:?}");
                prop_assert_eq!(count.below(), u64::from(k < 0.0));
                let own_support = if space.is(Space::Translation) { Support::Guided } else { Support::Pinned };
                let held = joined_at(&[path], &[own_support], Some(other));
                prop_assert!(held.space().is(other) && held.line().y == 0.0 && held.line().q != 0.0, "{held:?}");
            }
        }
    }

    /// Two planes near a common clamped frequency, their ratios w/p_YM equal to a part in 1e9: oracle is the plain formula in
    /// double-double, on planes that obey `w² = p_YM p_ΘQ - p_YΘ p_MQ` to its last digit. Of the plain formula in `f64`
    /// nothing is left there.
    #[test]
    fn nearly_equal_planes_keep_their_digits(
        ratio in 0.5..2.0f64, factor in factor(), [a, b, c, d, offset] in proptest::array::uniform5(0.5..2.0f64),
    ) {
        let exact = |y_m: f64, ratio: f64, y_theta: f64, m_q: f64| {
            let [y_m, ratio, y_theta, m_q] = [y_m, ratio, y_theta, m_q].map(DoubleDouble::from_f64);
            let w = ratio * y_m;
            Plane::unscaled([y_theta, y_m, w, (w * w + y_theta * m_q) / y_m, m_q], 0)
        };
        let (p, r) = (exact(1.0, ratio, 1e-9 * a, 1e-9 * b), exact(factor, ratio + 1e-9 * offset, 1e-9 * c, 1e-9 * d));
        let rounded = |p: Plane<DoubleDouble>| {
            Plane::unscaled([p.y_theta, p.y_m, p.w, p.theta_q, p.m_q].map(Parameter::to_f64), 0)
        };
        let expected = p.with_plane(r, &mut NoCount).m_q.to_f64();
        // the offset of 1e-9 is known to 1e-7 of itself
        assert_close(rounded(p).with_plane(rounded(r), &mut NoCount).m_q, expected, 1e-18, 1e-5 / f64::EPSILON);
    }

    /// At the root of a joined line or plane the count is the number of negative eigenvalues of the sum.
    #[test]
    fn a_free_root_counts_the_inertia_of_the_sum(paths in proptest::collection::vec(path(), 2..5)) {
        let [a, b, d] = sum(&paths);
        let determinant = a * d - b * b;
        prop_assume!(determinant.abs() > 1e-9 * scale(&paths) * scale(&paths));
        let joined = joined_at(&paths, &[], Some(Space::Bending));
        let mut count = WittrickWilliams::<f64>::default();
        joined.at_root(Support::Free, &mut count);
        let expected = if determinant < 0.0 { 1 } else if a + d < 0.0 { 2 } else { 0 };
        prop_assert_eq!(count.below(), expected);
    }
}

/// Two supports at one point hold as much as the stiffer; pinned and guided make fixed.
#[test]
fn supports_at_one_point_hold_together() {
    let path = Path::plane([3.0, 1.0, 2.0], 1.0);
    let both = joined_at(&[path], &[Support::Pinned, Support::Guided], Some(Space::Bending));
    assert_eq!(both, joined_at(&[path], &[Support::Fixed], Some(Space::Bending)));
}
