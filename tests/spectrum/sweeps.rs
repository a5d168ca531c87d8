//! Sweeps: many models of one topology give, in their order, what each gives alone.
//!
//! In release builds with AVX-512 eight models share the lanes of a vector; `.ci/long` runs these tests there, too.

use crate::support::random_tree::Random;
use crate::support::roots::assert_same_intervals;
use core::f64::consts::PI;
use mstmm::prelude::*;
use mstmm::search::{Lanewise, Model, SweepError};

system! {
    /// A beam on two pins.
    #[derive(Clone, Copy, Debug)]
    struct Pinned { length: f64, bending_stiffness: f64, mass_per_length: f64 }
    pinned -> beam 1 { length, bending_stiffness, mass_per_length } -> pinned;
}

system! {
    /// A beam in three parts on two pins, with a spring to the ground and a mass.
    #[derive(Clone, Copy, Debug)]
    struct Parts { first: f64, second: f64, third: f64, stiffness: f64, mass: f64 }
    pinned -> beam 1 { length: first, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2
           -> beam 3 { length: second, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 4
           -> beam 5 { length: third, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned;
    conn 2 <- spring 6 { stiffness } <- fixed;
    conn 4 <- mass 7 { mass } <- free;
}

system! {
    /// A clamped beam with all that a bending path may hold, whose body hangs on a lever.
    #[derive(Clone, Copy, Debug)]
    struct Mixed { length: f64, hinge: f64, mass: f64, arm: f64, torsion: f64 }
    fixed -> beam 1 { length, bending_stiffness: 2.0, mass_per_length: 0.5 }
          -> hinge 2 { stiffness_y: hinge, stiffness_rz: 3.0 * hinge }
          -> body 3 { mass, inertia_about_input: mass * (0.01 + arm * arm), output_x: 2.0 * arm, centre_x: arm } -> conn 4
          -> point_mass 5 { mass: 0.3, inertia: 0.001 }
          -> beam 6 { length: 0.5 * length, bending_stiffness: 1.0, mass_per_length: 0.5 } -> free;
    conn 4 <- torsion_spring 7 { stiffness: torsion } <- inertia 8 { inertia: 0.02 } <- free;
}

system! {
    /// Two beams between which a lever leads far away and back: sums cancel.
    #[derive(Clone, Copy, Debug)]
    struct Levers { arm: f64, mass: f64, length: f64 }
    fixed -> beam 1 { length, bending_stiffness: 1.0, mass_per_length: 1.0 }
          -> body 2 { mass, inertia_about_input: mass * (1.0 + arm * arm), output_x: arm, centre_x: arm }
          -> body 3 { mass: 0.0, inertia_about_input: 0.0, output_x: -arm, centre_x: 0.0 }
          -> beam 4 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

system! {
    /// A beam in the air with a mass: two frequencies are zero.
    #[derive(Clone, Copy, Debug)]
    struct Free { first: f64, second: f64, mass: f64 }
    free -> beam 1 { length: first, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2
         -> beam 3 { length: second, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
    conn 2 <- mass 4 { mass } <- free;
}

system! {
    /// Two arms on a trunk: their frequencies coincide or nearly do, if they are as long.
    #[derive(Clone, Copy, Debug)]
    struct Arms { one: f64, other: f64, trunk: f64 }
    fixed -> beam 1 { length: one, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 3;
    fixed -> beam 2 { length: other, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 3;
    conn 3 -> beam 4 { length: trunk, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

system! {
    /// Springs and masses, without a wave.
    #[derive(Clone, Copy, Debug)]
    struct Lumped { stiffness: f64, mass: f64 }
    fixed -> spring 1 { stiffness } -> mass 2 { mass } -> spring 3 { stiffness: 2.0 } -> mass 4 { mass: 1.0 } -> free;
}

system! {
    /// Beams with hinges of one freedom, the last of them without stiffness, and a mass on a lever.
    #[derive(Clone, Copy, Debug)]
    struct Hinged { crack: f64, slide: f64, arm: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 2.0, mass_per_length: 1.0 } -> hinge 2 { stiffness_rz: crack }
          -> beam 3 { length: 0.5, bending_stiffness: 1.0, mass_per_length: 1.5 } -> conn 4 -> hinge 5 { stiffness_y: slide }
          -> beam 6 { length: 0.75, bending_stiffness: 1.0, mass_per_length: 1.0 } -> hinge 7 { stiffness_rz: 0.0 }
          -> beam 8 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> fixed;
    conn 4 <- rigid_link 9 { output_x: arm } <- point_mass 10 { mass: 0.5, inertia: 0.1 } <- free;
}

/// Random numbers, even in their logarithms over so many powers of ten to both sides of 1.
fn numbers() -> impl FnMut(f64) -> f64 {
    let mut random = Random(0);
    move |powers| 10_f64.powf(powers * (2.0 * random.unit() - 1.0))
}

/// Searches models beside each other and one by one.
fn check<const N: usize, M>(models: &[M])
where
    M: core::fmt::Debug + Lanewise<System<f64>: Undamped<Parameter = f64>>,
{
    let mut count = 0;
    for (found, model) in models.iter().first_frequencies::<N>().zip(models) {
        let alone = Model::build(model).map_err(SweepError::Parameter);
        let alone = alone.and_then(|system| system.first_frequencies::<N>().map_err(SweepError::Search));
        match (&found, &alone) {
            (Ok(found), Ok(alone)) => assert_same_intervals(found, alone, model),
            _ => assert_eq!(found.err(), alone.err(), "{model:?}"),
        }
        count += 1;
    }
    assert_eq!(count, models.len());
}

/// Oracle: `ω = (nπ/l)² sqrt(EI/m)`, with the rounding of that formula.
#[test]
fn pinned_beams_have_their_closed_form_in_the_order_of_the_models() {
    let mut next = numbers();
    for count in [0, 1, 2, 3, 7, 8, 9, 16, 50] {
        let models: Vec<_> = (0..count)
            .map(|_| Pinned { length: next(3.0), bending_stiffness: next(6.0), mass_per_length: next(6.0) })
            .collect();
        let found = models.iter().first_frequencies::<5>();
        assert_eq!(found.size_hint(), (count, Some(count)));
        assert_eq!(models.iter().first_frequencies::<5>().count(), count);
        for (roots, model) in found.zip(&models) {
            let roots = roots.unwrap();
            assert_eq!(roots.len(), 5);
            for (n, root) in (1..).zip(&roots) {
                let exact = (f64::from(n) * PI / model.length).powi(2)
                    * (model.bending_stiffness / model.mass_per_length).sqrt();
                assert!((root.omega - exact).abs() <= 8.0 * f64::EPSILON * exact, "{model:?}: {root:?}, not {exact}");
                let room = 8.0 * f64::EPSILON * exact;
                assert!(
                    root.is_proven && root.lower < exact + room && exact - room < root.upper,
                    "{model:?}: {root:?}"
                );
            }
        }
    }
}

#[test]
fn usual_and_extreme_models_give_what_each_gives_alone() {
    let mut next = numbers();
    for powers in [0.3, 1.0, 3.0, 6.0] {
        let mut parts = || Parts {
            first: next(powers),
            second: next(powers),
            third: next(powers),
            stiffness: next(2.0 * powers),
            mass: next(2.0 * powers),
        };
        let models: Vec<_> = (0..101).map(|_| parts()).collect();
        check::<3, _>(&models);
        check::<1, _>(&models[..20]);
        check::<10, _>(&models[..20]);
        check::<11, _>(&models[..10]);
        let mut mixed = || Mixed {
            length: next(powers),
            hinge: next(2.0 * powers),
            mass: next(powers),
            arm: next(powers),
            torsion: next(2.0 * powers),
        };
        let models: Vec<_> = (0..101).map(|_| mixed()).collect();
        check::<4, _>(&models);
        let levers = (0..101).map(|_| Levers { arm: next(powers), mass: next(powers), length: next(0.5 * powers) });
        check::<4, _>(&levers.collect::<Vec<_>>());
        let hinged =
            (0..101).map(|_| Hinged { crack: next(2.0 * powers), slide: next(2.0 * powers), arm: next(powers) });
        check::<4, _>(&hinged.collect::<Vec<_>>());
    }
}

#[test]
fn zeros_pairs_and_models_without_waves_give_what_each_gives_alone() {
    let mut next = numbers();
    let free: Vec<_> = (0..41).map(|_| Free { first: next(1.0), second: next(1.0), mass: next(2.0) }).collect();
    check::<2, _>(&free);
    check::<4, _>(&free);
    // the second arm is longer by up to a tenth, or not at all
    let arms = (0..41).map(|k| Arms {
        one: 1.0,
        other: if k % 3 == 0 { 1.0 } else { 1.0 + 0.1 * next(8.0).min(1.0) },
        trunk: next(1.0),
    });
    check::<5, _>(&arms.collect::<Vec<_>>());
    let lumped: Vec<_> = (0..11).map(|_| Lumped { stiffness: next(3.0), mass: next(3.0) }).collect();
    check::<2, _>(&lumped);
    check::<3, _>(&lumped);
}

/// A bad parameter is the error of its model alone, wherever it stands.
#[test]
fn a_model_out_of_its_range_leaves_the_others_as_they_are() {
    let model = |mass_per_length| Pinned { length: 1.0, bending_stiffness: 1.0, mass_per_length };
    for bad in 0..8 {
        let models: Vec<_> = (0..8).map(|k| model(if k == bad { -1.0 } else { 1.0 + f64::from(k) })).collect();
        for (k, roots) in (0..).zip(models.into_iter().first_frequencies::<1>()) {
            if k == bad {
                let error = roots.unwrap_err();
                assert_eq!(
                    error.to_string(),
                    "beam 1: mass_per_length is -1, but must be zero or positive, and finite"
                );
                continue;
            }
            let exact = PI * PI / (1.0 + f64::from(k)).sqrt();
            assert!((roots.unwrap()[0].omega - exact).abs() < 1e-14 * exact);
        }
    }
    let all_bad = [model(f64::NAN); 5];
    assert!(all_bad.iter().first_frequencies::<1>().all(|roots| matches!(roots, Err(SweepError::Parameter(_)))));
}

/// Estimates are beside the frequencies that are proven, and say that nobody has proven them.
#[test]
fn estimates_of_usual_models_are_beside_their_frequencies() {
    let models = (0..20).map(|k| Arms { one: 1.0 + 0.05 * f64::from(k), other: 1.3, trunk: 0.7 });
    for (estimates, proven) in models.clone().estimates::<4>().zip(models.first_frequencies::<4>()) {
        for (estimate, root) in estimates.unwrap().iter().zip(&proven.unwrap()) {
            assert!(!estimate.is_proven && root.is_proven);
            assert!((estimate.omega / root.omega - 1.0).abs() < 1e-13, "{estimate:?} and {root:?}");
        }
    }
}
