//! Charts beside transfer matrices: both are relations of the states at the two ends.

use super::*;
use crate::element::Charted;
use crate::elements::joint::Joint;
use crate::number::{DoubleDouble, FrequencyPowers, Parameter, Scalar, Single, Size};
use crate::structure::Chart;
use crate::structure::chart::MOST_FREEDOMS;
use mstmm_plan::Freedoms;

/// Where the displacements and the forces of the freedoms stand in a state, and the sign of each force on the input end.
struct Entries {
    displacements: &'static [usize],
    forces: &'static [(usize, f64)],
}

fn entries_of(space: Space) -> Entries {
    match space.size() {
        6 => Entries { displacements: &[0, 1, 2], forces: &[(4, 1.0), (5, 1.0), (3, -1.0)] },
        4 => Entries { displacements: &[0, 1], forces: &[(3, 1.0), (2, -1.0)] },
        _ if space.is(Space::Translation) => Entries { displacements: &[0], forces: &[(1, 1.0)] },
        _ => Entries { displacements: &[0], forces: &[(1, -1.0)] },
    }
}

/// Whether the states of a transfer matrix, each column with its input state, are in the relation of a chart, within a share of
/// the terms of each row.
pub(super) fn assert_in_relation<S: Scalar>(chart: &Chart<S>, columns: &[Vec<S>], space: Space, tolerance: f64) {
    let Entries { displacements, forces } = entries_of(space);
    let count = displacements.len();
    let freedoms: Vec<usize> = (0..MOST_FREEDOMS).filter(|k| chart.freedoms.contains(Freedoms::SINGLE[*k])).collect();
    assert_eq!(freedoms.len(), count);
    let units: Vec<i32> =
        (0..2 * count).map(|place| chart.units.of(freedoms[place % count] + 1 == MOST_FREEDOMS)).collect();
    for (input, output) in columns.iter().enumerate() {
        let state = |end: usize, k: usize| match end {
            0 if k == input => S::one(),
            0 => S::zero(),
            _ => output[k],
        };
        let force = |end: usize, (k, sign): (usize, f64)| {
            let outwards = if end == 0 { sign } else { -sign };
            S::from_f64(outwards) * state(end, k)
        };
        // the value of a variable and of the other kind, both in units
        let values: Vec<[S; 2]> = (0..2 * count)
            .map(|place| {
                let (end, k) = (place / count, place % count);
                let displacement = state(end, displacements[k]).times_power_of_two(-units[place]);
                let force = force(end, forces[k]).times_power_of_two(units[place]);
                if chart.is_force(place) { [force, -displacement] } else { [displacement, force] }
            })
            .collect();
        for (row, [_, expected]) in values.iter().enumerate() {
            let terms = (0..2 * count).map(|column| chart.entry(row, column) * values[column][0]);
            let mut scale = expected.size().first();
            let mut rest = -*expected;
            for term in terms {
                scale = scale.max(term.size().first());
                rest += term;
            }
            assert!(
                rest.size().first() <= tolerance * scale,
                "row {row}, state {input}: {:e}",
                rest.size().first() / scale
            );
        }
    }
}

/// The columns of a transfer matrix, which are the output states of the unit states.
pub(super) fn columns<E, S>(built: &E::Built, x: S) -> Vec<Vec<S>>
where
    E: TransferMatrix<S>,
    S: Scalar + Single,
    MatrixOf<E, S>: Index<(usize, usize), Output = S>,
{
    let matrix = E::transfer_matrix(built, x);
    let size = <E::State as StateSpace>::SPACE.size();
    (0..size).map(|column| (0..size).map(|row| matrix[(row, column)]).collect()).collect()
}

/// A chart and the transfer matrix of an element tell the same, at any λ.
fn charts_are_transfer_matrices<E>()
where
    E: Sample + Charted<C> + TransferMatrix<C>,
    MatrixOf<E, C>: Index<(usize, usize), Output = C>,
{
    check::<E>(|element, lambda| {
        let built = built(element);
        let chart = E::chart(&built, &FrequencyPowers::new::<f64>(lambda, true), C::from(element.length()));
        assert_in_relation(&chart, &columns::<E, C>(&built, lambda), <E::State as StateSpace>::SPACE, 1e-12);
    });
}

#[test]
fn charts_are_transfer_matrices_of_all_charted_elements() {
    charts_are_transfer_matrices::<Spring<f64>>();
    charts_are_transfer_matrices::<TorsionSpring<f64>>();
    charts_are_transfer_matrices::<Damper<f64>>();
    charts_are_transfer_matrices::<TorsionDamper<f64>>();
    charts_are_transfer_matrices::<SpringDamper<f64>>();
    charts_are_transfer_matrices::<TorsionSpringDamper<f64>>();
    charts_are_transfer_matrices::<TautString<f64>>();
    charts_are_transfer_matrices::<Rod<f64>>();
    charts_are_transfer_matrices::<Shaft<f64>>();
    charts_are_transfer_matrices::<Beam<f64>>();
    charts_are_transfer_matrices::<InPlane<Beam<f64>>>();
    charts_are_transfer_matrices::<TaperedBeam<f64>>();
    charts_are_transfer_matrices::<GeneralBeam<f64>>();
    charts_are_transfer_matrices::<InPlane<GeneralBeam<f64>>>();
    charts_are_transfer_matrices::<DampedSpring<f64>>();
    charts_are_transfer_matrices::<DampedTorsionSpring<f64>>();
    charts_are_transfer_matrices::<DampedString<f64>>();
    charts_are_transfer_matrices::<DampedRod<f64>>();
    charts_are_transfer_matrices::<DampedShaft<f64>>();
    charts_are_transfer_matrices::<DampedBeam<f64>>();
    charts_are_transfer_matrices::<InPlane<DampedBeam<f64>>>();
}

#[test]
fn joints_are_hinges() {
    check::<PlanarHinge<f64>>(|hinge, lambda| {
        let chart = Joint::chart(&Joint::from(hinge), &FrequencyPowers::new::<f64>(lambda, true), C::from(0.0));
        let columns = columns::<PlanarHinge<f64>, C>(&hinge, lambda);
        assert_in_relation(&chart, &columns, Space::Planar, 1e-14);
    });
    check::<ElasticHinge<f64>>(|hinge, lambda| {
        let chart = Joint::chart(&Joint::from(hinge), &FrequencyPowers::new::<f64>(lambda, true), C::from(0.0));
        let columns = columns::<ElasticHinge<f64>, C>(&hinge, lambda);
        assert_in_relation(&chart, &columns, Space::Bending, 1e-14);
    });
}

/// Frequencies at which waves are short, long, and near the poles of one form or of the other.
pub(super) fn frequencies() -> impl Iterator<Item = f64> {
    (0..400).map(|k| 1.09_f64.powi(k - 240))
}

#[test]
fn charts_of_short_waves_keep_all_digits() {
    let across = Beam { length: 1.3, bending_stiffness: 0.7, mass_per_length: 2.1 };
    let built = built(InPlane { axial_stiffness: 60.0, across });
    for omega in frequencies().filter(|omega| *omega < 90.0) {
        // states grow as e^z, to 1e7 here: their squares leave half of the digits
        let exactly = DoubleDouble::from(omega);
        let length = DoubleDouble::from(across.length);
        let exact = InPlane::<Beam<f64>>::chart(&built, &FrequencyPowers::new::<f64>(exactly, true), length);
        assert_in_relation(&exact, &columns::<InPlane<Beam<f64>>, DoubleDouble>(&built, exactly), Space::Planar, 1e-14);
        let at = FrequencyPowers::new::<f64>(omega, true);
        let chart: Chart<f64> = InPlane::<Beam<f64>>::chart(&built, &at, across.length);
        assert_eq!((chart.forces, chart.below), (exact.forces, exact.below), "{omega}");
        // an inertia below the rounding of a stiffness in f64 enters the units of the longer number alone
        if omega * omega * 2.1 * 1.3_f64.powi(4) / 0.7 < f64::EPSILON {
            continue;
        }
        assert_eq!(chart.units, exact.units, "{omega}");
        // wave numbers carry four roundings
        let phase = 1.0 + (2.1_f64 / 0.7).sqrt().sqrt() * 1.3 * omega.sqrt() + omega * 1.3 * (2.1_f64 / 60.0).sqrt();
        for (entry, other) in chart.entries.iter().zip(&exact.entries) {
            let error = (*entry - other.to_f64()).abs();
            assert!(error <= 16.0 * phase * f64::EPSILON * other.to_f64().abs().max(1.0), "{omega}: {entry} {other:?}");
        }
    }
}

#[test]
fn entries_of_charts_are_bounded() {
    for omega in frequencies() {
        // an axis that is softer than bending would have units of its own
        let across = Beam { length: 1.3, bending_stiffness: 0.7, mass_per_length: 2.1 };
        let (built, at) = (built(InPlane { axial_stiffness: 6e9, across }), FrequencyPowers::new::<f64>(omega, true));
        let chart: Chart<f64> = InPlane::<Beam<f64>>::chart(&built, &at, across.length);
        let waves = [1, 2, 4, 5].map(|row| [1, 2, 4, 5].map(|column| chart.entry(row, column)));
        assert!(waves.as_flattened().iter().all(|entry| entry.abs() < 8.0), "{omega}: {waves:?}");
    }
}

/// The number of sign changes of a function of the frequency.
fn sign_changes(values: impl Iterator<Item = f64>) -> u64 {
    let mut last = 1.0_f64;
    values.filter(|value| core::mem::replace(&mut last, value.signum()) != value.signum()).count() as u64
}

#[test]
fn counts_of_charts_are_roots_of_their_minors() {
    let beam = Beam { length: 1.3, bending_stiffness: 0.7, mass_per_length: 2.1 };
    let built = built(beam);
    let at = |omega: f64| Beam::chart(&built, &FrequencyPowers::new::<f64>(omega, true), beam.length);
    for end in frequencies().filter(|omega| (1.0..1e4).contains(omega)) {
        let kinds = |omega| {
            let chart: Chart<f64> = at(omega);
            chart.forces
        };
        // roots of the minor for the kinds at the end: of the transfer matrix, z_in = [0, e], columns M and Q, for held ends
        let forces = kinds(end);
        let minor = |omega: f64| {
            let u = Beam::transfer_matrix(&built, omega);
            // input and output variables that are displacements vanish, and so do forces where the other kind is a force
            match forces {
                // both deflections and both moments: unknown are Θ and Q
                0b1010 => u[(0, 1)] * u[(2, 3)] - u[(0, 3)] * u[(2, 1)],
                // clamped and free: unknown are M and Q
                _ => u[(2, 2)] * u[(3, 3)] - u[(2, 3)] * u[(3, 2)],
            }
        };
        if end > 300.0 {
            break;
        }
        let below = sign_changes((1..=4000).map(|k| minor(end * f64::from(k) / 4000.0) * minor(1e-3).signum()));
        assert_eq!(at(end).below, below as f64 - 2.0, "{end} {forces:b}");
    }
}
