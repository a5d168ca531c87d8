//! Bounds for what sums over modes leave out: values of the file, that they hold, and that they are attained.
#![expect(clippy::unwrap_used, reason = "a model that is refused fails the test")]

use crate::models::{Cantilever, Portal, assert_close, cantilever, number, reference};
use crate::numbers::Random;
use crate::random::frame;
use mstmm::Complex;
use mstmm::frame::{Frame, PointMass, RigidBody, Section};
use mstmm::motion::{MotionError, TruncationError, Variation};
use mstmm::network::Support;
use mstmm::prelude::*;
use serde_json::Value;

/// The bounds and what is left out, at each frequency of a table of the file.
fn assert_as_in_the_file(part: &Value, mut left_out: impl FnMut(f64) -> f64, bound: impl Fn(f64) -> f64) {
    let reach = number(&part["Omega"]);
    let at_rest = |name: &str| part[name].as_str().unwrap().parse::<f64>().ok();
    let product = at_rest("rho_aa").zip(at_rest("rho_bb")).map(|(load, entry)| (load * entry).sqrt());
    for row in part["rows"].as_array().unwrap() {
        let omega = number(&row["omega"]);
        let square = (omega / reach).powi(2);
        let by_rest = product.map_or(f64::INFINITY, |product| square / (1.0 - square) * product);
        let expected = number(&row["bound"]).min(if square < 0.99 { by_rest } else { f64::INFINITY });
        assert_close(bound(omega), expected, 1e-7);
        let (found, known) = (left_out(omega), number(&row["left_out"]));
        assert!((found.abs() - known.abs()).abs() < 1e-5 * known.abs(), "{found} {known}");
        assert!(found.abs() <= bound(omega) * (1.0 + 1e-9), "{found} {}", bound(omega));
    }
}

#[test]
fn bounds_are_those_of_the_file() {
    let file = reference("truncation")["frequency"].clone();
    let cantilever = Cantilever {}.build().unwrap();
    let roots = cantilever.first_frequencies::<3>().unwrap();
    let load = Cantilever::conn_tip.force();
    let entries = [
        ("cantilever force tip -> deflection tip", Cantilever::conn_tip.deflection()),
        ("cantilever force tip -> base moment", Cantilever::beam_1.input().moment()),
    ];
    for (name, entry) in entries {
        let part = &file[name];
        let reach = number(&part["Omega"]);
        let truncation = cantilever.truncation::<3>(&roots, load, entry, reach).unwrap();
        let sum = cantilever.modal_response::<3, _>(&roots, load, entry).unwrap();
        let exact = cantilever.frequency_response(load, entry).unwrap();
        assert_as_in_the_file(
            part,
            |omega| exact.at(omega).unwrap() - sum.at(omega).unwrap(),
            |omega| truncation.at(omega),
        );
        assert_eq!(truncation.at(reach * 1.001), f64::INFINITY);
        assert_eq!(truncation.at(0.0), 0.0);
        assert!(truncation.at(f64::NAN).is_infinite());
    }
    let portal = Portal {}.build().unwrap();
    let roots = portal.first_frequencies::<4>().unwrap();
    let load = Portal::conn_b.force_x();
    let entries = [
        ("portal force x B -> foot moment", Portal::beam_1.input().moment()),
        ("portal force x B -> displacement y B", Portal::conn_b.displacement_y()),
    ];
    for (name, entry) in entries {
        let part = &file[name];
        let truncation = portal.truncation::<4>(&roots, load, entry, number(&part["Omega"])).unwrap();
        let sum = portal.modal_response::<4, _>(&roots, load, entry).unwrap();
        let exact = portal.frequency_response(load, entry).unwrap();
        assert_as_in_the_file(
            part,
            |omega| exact.at(omega).unwrap() - sum.at(omega).unwrap(),
            |omega| truncation.at(omega),
        );
    }
}

system! {
    /// A rod of the length 1, in which waves run with the speed 1.
    struct Rod {}
    fixed -> rod 1 { length: 1.0, axial_stiffness: 1.0, mass_per_length: 1.0 } -> conn tip -> free;
}

/// Under a step the bound is attained: where the wave comes back from the clamp, all modes that are left out are at their largest together.
#[test]
fn the_bound_of_a_step_is_attained_by_a_rod() {
    let file = reference("truncation")["rod_step"].clone();
    let rod = Rod {}.build().unwrap();
    let roots = rod.first_frequencies::<41>().unwrap();
    let (load, entry) = (Rod::conn_tip.force(), Rod::conn_tip.deflection());
    let reach = 0.999 * roots[40].omega;
    let truncation = rod.truncation::<40>(&roots[..40], load, entry, reach).unwrap();
    let sum = rod.modal_response::<40, _>(&roots[..40], load, entry).unwrap();
    let bound = truncation.after_step().unwrap();
    assert_close(bound, number(&file["bound"]), 1e-10);
    // the tip moves with the speed 1 until the wave is back
    let largest =
        (0..=400).map(|n| 0.005 * f64::from(n)).map(|time| (sum.to_step(time) - time).abs()).fold(0.0, f64::max);
    assert_close(largest, bound, 1e-10);
    assert_close(sum.to_step(2.0), number(&file["at_2"][1]), 1e-12);
}

#[test]
fn bounds_of_a_record_hold() {
    let file = reference("truncation")["time_record"].clone();
    let base = reference("base_acceleration");
    let record: Vec<f64> = base["a_g"].as_array().unwrap().iter().map(number).collect();
    let dt = number(&base["dt"]);
    let variation = Variation::of(&record, dt);
    assert_eq!(variation.first, 0.0);
    assert_close(variation.total, number(&file["variation"]), 1e-14);
    assert_close(variation.of_slope, number(&file["variation_of_slope"]), 1e-13);

    let (model, [_, tip], beam) = cantilever();
    let all = model.first_frequencies::<16>().unwrap();
    let ground = PlaneLoad::base_acceleration(Direction::y());
    let ratio = number(&file["ratio_left_out"]);
    let ratios = |count: usize| -> Vec<f64> {
        [0.02, 0.015, 0.03, 0.04].into_iter().chain(core::iter::repeat(ratio)).take(count).collect()
    };
    let errors = |entry| {
        let few =
            model.modal_response::<4, _>(&all[..4], ground, entry).unwrap().with_damping_ratios(&ratios(4)).unwrap();
        let many =
            model.modal_response::<16, _>(&all, ground, entry).unwrap().with_damping_ratios(&ratios(16)).unwrap();
        let (one, other) = (few.history(dt).unwrap().all(&record), many.history(dt).unwrap().all(&record));
        one.iter().zip(other).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max)
    };
    // just below the fifth frequency
    let reach = number(&file["omega_5"]) * (1.0 - 1e-9);
    let truncation = model.truncation::<4>(&all[..4], ground, tip.displacement_y(), reach).unwrap();
    assert_close(truncation.over(variation, ratio).unwrap(), number(&file["tip"]["bound_by_slope"]), 1e-6);
    // by the changes of the record alone
    let jumps = Variation { of_slope: f64::INFINITY, ..variation };
    assert_close(truncation.over(jumps, ratio).unwrap(), number(&file["tip"]["bound_by_variation"]), 1e-6);
    let error = errors(tip.displacement_y());
    assert!(error > 1e-9 && error <= truncation.over(variation, ratio).unwrap(), "{error:e}");

    let moment = beam.input().moment();
    let truncation = model.truncation::<4>(&all[..4], ground, moment, 0.8 * reach).unwrap();
    let (error, bound) = (errors(moment), truncation.over(variation, ratio).unwrap());
    assert!(error > 1e-4 && error <= bound, "{error:e} {bound:e}");
    assert!(bound < 0.02, "{bound:e}");
    assert_eq!(truncation.over(Variation { first: 0.1, ..variation }, ratio), None);
    assert_eq!(truncation.after_step(), None);
}

#[test]
fn lists_that_miss_a_mode_and_loads_without_a_bound_are_refused() {
    let cantilever_of_paths = Cantilever {}.build().unwrap();
    let roots = cantilever_of_paths.first_frequencies::<4>().unwrap();
    let (load, entry) = (Cantilever::conn_tip.force(), Cantilever::conn_tip.deflection());
    let of = |roots: &[NaturalFrequency<f64>], load, reach| {
        cantilever_of_paths.truncation::<4>(roots, load, entry, reach).map(|_| ())
    };
    assert_eq!(of(&roots[..3], load, 700.0), Err(TruncationError::Missing { counted: 4, listed: 3 }));
    assert_eq!(of(&roots[1..3], load, 500.0), Err(TruncationError::Missing { counted: 3, listed: 0 }));
    // as many modes, and not these
    for wrong in [[0, 1, 3], [0, 1, 1], [1, 2, 3], [0, 2, 1]] {
        let list = wrong.map(|root: usize| roots[root]);
        assert!(matches!(of(&list, load, 500.0), Err(TruncationError::Missing { counted: 3, .. })), "{wrong:?}");
    }
    for reach in [0.0, -5.0, f64::INFINITY, f64::NAN] {
        assert!(matches!(of(&roots[..3], load, reach), Err(TruncationError::Reach { .. })), "{reach}");
    }
    assert_eq!(of(&roots, load, 500.0), Err(TruncationError::Missing { counted: 3, listed: 4 }));
    assert_eq!(of(&roots[..3], Load::self_weight(), 500.0), Err(TruncationError::Spread));
    let (model, [foot, tip], _) = cantilever();
    let roots = model.first_frequencies::<3>().unwrap();
    let refused = model.truncation::<3>(&roots, tip.force_y(), foot.reaction_y(), 500.0);
    assert!(matches!(refused, Err(TruncationError::Motion(_))));
}

/// Bounds hold for loads and entries of all kinds: of a frame with a body, of one that floats, in space.
#[test]
fn bounds_hold_for_all_kinds_of_loads_and_entries() {
    let mut frame = Frame::new();
    let [a, b, c] = [[0.0, 0.0], [0.2, 2.0], [1.7, 2.4]].map(|place| frame.point(place));
    let steel = Section::new().axial_stiffness(6e3).bending_stiffness(30.0).mass_per_length(0.9).shear_stiffness(2e3);
    let members = [frame.member(a, b, steel), frame.member(b, c, steel)];
    frame.body([b], RigidBody { mass: 0.6, inertia: 0.05, centre: [0.4, 2.3] });
    frame.body([c], PointMass { mass: 0.2, inertia: 0.01 });
    let floating = frame.build().unwrap();
    frame.hold(a, Support::Fixed);
    frame.hold(c, Support::Roller);
    let held = frame.build().unwrap();
    let loads = [
        b.force_x(),
        b.torque_z(),
        members[1].input().kink(),
        members[0].output().stretch(),
        members[1].uniform_load_y(),
        PlaneLoad::self_weight_x(),
        PlaneLoad::base_acceleration(Direction::y()),
    ];
    let entries = [
        b.displacement_y(),
        c.displacement_x(),
        c.rotation_z(),
        members[0].output().moment(),
        members[1].input().shear(),
        members[1].input().axial_force(),
    ];
    for (name, system, count) in [("held", &held, 5_usize), ("floating", &floating, 7)] {
        let all = system.frequencies(count + 1).unwrap();
        let shapes = |roots: &[NaturalFrequency<f64>]| roots.iter().map(|root| root.multiplicity).sum::<u64>();
        let last = all.len() - 1;
        let roots = &all[..last];
        assert_eq!(shapes(roots) as usize, count, "{name}");
        let many = system.frequencies(count + 12).unwrap();
        let reach = 0.4 * roots[last - 1].omega + 0.6 * all[last].omega;
        for (load_number, load) in loads.into_iter().enumerate() {
            for (entry_number, entry) in entries.into_iter().enumerate() {
                let truncation = system.truncation::<8>(roots, load, entry, reach);
                if name == "floating" && load_number >= 4 {
                    let refused = TruncationError::Motion(MotionError::Resonance { frequency: 0.0 });
                    assert_eq!(truncation.map(|_| ()), Err(refused));
                    continue;
                }
                let truncation =
                    truncation.unwrap_or_else(|error| panic!("{name} {load_number} {entry_number}: {error}"));
                let sum = system.modal_response::<8, _>(roots, load, entry).unwrap();
                let exact = system.frequency_response(load, entry).unwrap();
                for part in [0.03, 0.3, 0.55, 0.77, 0.93, 1.0] {
                    let omega = part * reach;
                    let (sum, exact) = (sum.at(omega).unwrap(), exact.at(omega).unwrap());
                    let (error, bound) = ((exact - sum).abs(), truncation.at(omega));
                    let noise = 1e-9 * exact.abs();
                    assert!(error <= bound + noise, "{name} {load_number} {entry_number} {part}: {error:e} {bound:e}");
                }
                // with ratios and in time, beside a sum of many more modes, for some of them
                if (load_number + 2 * entry_number) % 5 != 0 {
                    continue;
                }
                if let Some(bound) = truncation.at_with_ratio(0.6 * reach, 0.05) {
                    let damped = |roots: &[NaturalFrequency<f64>]| {
                        let sum = system.modal_response::<32, _>(roots, load, entry).unwrap();
                        let sum = sum.with_damping_ratio(0.05).unwrap();
                        sum.at(Complex::new(0.0, 0.6 * reach)).unwrap()
                    };
                    let error = (damped(roots) - damped(&many)).norm();
                    assert!(error <= bound * (1.0 + 1e-6), "{name} {load_number} {entry_number}: {error:e} {bound:e}");
                }
                if let Some(bound) = truncation.after_step() {
                    let more = system.modal_response::<32, _>(&many, load, entry).unwrap();
                    for time in [0.0, 0.01, 0.2, 1.3] {
                        let error = (more.to_step(time) - sum.to_step(time)).abs();
                        assert!(
                            error <= bound * (1.0 + 1e-6) + 1e-9 * sum.to_step(time).abs(),
                            "{name}: {error:e} {bound:e}"
                        );
                    }
                }
            }
        }
    }
}

/// For the entry that works with the load the bound is what is left out, at the reach: nothing smaller would do.
#[test]
fn bounds_are_attained_at_the_reach() {
    let (model, [_, tip], beam) = cantilever();
    let roots = model.first_frequencies::<3>().unwrap();
    let reach = 520.0;
    let pairs = [
        (tip.force_y(), tip.displacement_y()),
        (beam.input().kink(), beam.input().moment()),
        (tip.torque_z(), tip.rotation_z()),
    ];
    for (load, entry) in pairs {
        let truncation = model.truncation::<3>(&roots, load, entry, reach).unwrap();
        let sum = model.modal_response::<3, _>(&roots, load, entry).unwrap();
        let exact = model.frequency_response(load, entry).unwrap();
        let error = exact.at(reach).unwrap() - sum.at(reach).unwrap();
        assert_close(truncation.at(reach), error, 1e-8);
    }
    // the work of the weight on the motion under it, by many modes: 3 of them leave out as much
    let weight = PlaneLoad::self_weight_y();
    let many = model.first_frequencies::<40>().unwrap();
    let left: f64 = many[3..]
        .iter()
        .map(|root| {
            let work = model.mode_shape(root).unwrap().work(weight).unwrap();
            (work * reach / root.omega).powi(2) / (root.omega.powi(2) - reach.powi(2))
        })
        .sum();
    let own = model.truncation::<3>(&roots, tip.force_y(), tip.displacement_y(), reach).unwrap().at(reach);
    let mixed = model.truncation::<3>(&roots, weight, tip.displacement_y(), reach).unwrap().at(reach);
    assert_close(mixed * mixed / own, left, 1e-6);
}

/// Just above the last root of the list the response and its mode nearly cancel: the bound grows by what is known of the root, and holds.
#[test]
fn bounds_hold_just_above_a_listed_root() {
    let (model, [_, tip], beam) = cantilever();
    let roots = model.first_frequencies::<3>().unwrap();
    let last = roots[2].omega;
    for (load, entry) in [(tip.force_y(), tip.displacement_y()), (beam.input().slip(), beam.input().shear())] {
        let sum = model.modal_response::<3, _>(&roots, load, entry).unwrap();
        let exact = model.frequency_response(load, entry).unwrap();
        for apart in [1e-15, 1e-13, 1e-12, 1e-11, 1e-9, 1e-8, 1e-7, 1e-5, 1e-3] {
            let Ok(truncation) = model.truncation::<3>(&roots, load, entry, last * (1.0 + apart)) else {
                assert!(apart < 1e-14);
                continue;
            };
            for part in [0.3, 0.7, 0.95] {
                let omega = part * last;
                let error = (exact.at(omega).unwrap() - sum.at(omega).unwrap()).abs();
                let bound = truncation.at(omega);
                assert!(error <= bound * (1.0 + 1e-9), "{apart:e} {part}: {error:e} {bound:e}");
            }
        }
    }
    // at a root itself there is none
    let truncation = model.truncation::<3>(&roots, tip.force_y(), tip.displacement_y(), last);
    assert!(truncation.is_err());
    // what cannot be bounds nothing
    let truncation = model.truncation::<3>(&roots, tip.force_y(), tip.displacement_y(), 500.0).unwrap();
    assert!(truncation.at_with_ratio(-250.0, 0.5).unwrap() > truncation.at(250.0));
    assert_eq!(truncation.at_with_ratio(250.0, -0.5), None);
    assert_eq!(truncation.at_with_ratio(250.0, f64::NAN), None);
    let record = [0.0, 1.0, 0.5];
    let jumps = truncation.over(Variation::of(&record, -0.1), 0.02).unwrap();
    assert_close(jumps, truncation.after_step().unwrap() * 1.5, 1e-14);
    assert_eq!(truncation.over(Variation::of(&[0.0, f64::NAN], 0.1), 0.02), None);
}

/// The bounds of random frames, of all kinds of loads and entries; prints how much of them is used.
fn assert_bounds_hold(seeds: core::ops::Range<u64>) {
    let (mut most, mut sum, mut count, mut tried) = (0.0_f64, 0.0, 0.0, 0);
    for seed in seeds {
        let own = frame(seed, 0.0, || 0.0);
        let system = own.frame.build().unwrap();
        let mut random = Random(seed + 1000);
        let modes = 3 + (6.0 * random.unit()) as usize;
        let Ok(all) = system.frequencies(modes + 1) else { continue };
        let roots = &all[..all.len() - 1];
        let reach = roots[roots.len() - 1].omega * (1.0 - random.unit()) + all[all.len() - 1].omega * random.unit();
        let reach = reach.clamp(roots[roots.len() - 1].omega * (1.0 + 1e-6), all[all.len() - 1].omega * (1.0 - 1e-9));
        let mut pick = |count: usize| random.below(count);
        let (point, other) = (own.points[1 + pick(own.points.len() - 1)], own.points[1 + pick(own.points.len() - 1)]);
        let member = own.members[pick(own.members.len())];
        let twin = own.members[pick(own.members.len())];
        let loads = [
            point.force_x(),
            point.torque_z(),
            member.input().kink(),
            member.output().stretch(),
            PlaneLoad::self_weight_y(),
        ];
        let entries = [other.displacement_y(), twin.input().moment(), twin.output().shear(), other.rotation_z()];
        for (load, entry) in loads.iter().flat_map(|load| entries.iter().map(move |entry| (*load, *entry))) {
            let Ok(truncation) = system.truncation::<16>(roots, load, entry, reach) else { continue };
            let sum_of_modes = system.modal_response::<16, _>(roots, load, entry).unwrap();
            let exact = system.frequency_response(load, entry).unwrap();
            tried += 1;
            for part in [0.2, 0.5, 0.8, 0.97, 1.0] {
                let omega = part * reach;
                let truth = exact.at(omega).unwrap();
                let (error, bound) = ((truth - sum_of_modes.at(omega).unwrap()).abs(), truncation.at(omega));
                assert!(error <= bound + 1e-11 * truth.abs(), "{seed} {load:?} {entry:?} {part}: {error:e} {bound:e}");
                if error > 1e-9 * truth.abs() {
                    most = most.max(error / bound);
                    sum += error / bound;
                    count += 1.0;
                }
            }
        }
    }
    println!("{tried} pairs of loads and entries: {:.2} of the bound on the average, {most:.3} at most", sum / count);
    assert!(tried > 0);
}

#[test]
fn bounds_of_random_frames_hold() {
    assert_bounds_hold(0..6);
}

#[test]
#[ignore = "long: .ci/long"]
fn bounds_of_three_hundred_random_frames_hold() {
    assert_bounds_hold(0..300);
}
