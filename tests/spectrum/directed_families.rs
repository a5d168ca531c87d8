//! Families of models that are directed at what searches find hard, judged by the dynamic stiffness of the model in
//! double-double arithmetic.
//!
//! A sample of each runs with all tests. `cargo test --release --test spectrum directed_families -- --ignored --nocapture` runs
//! them in full and prints a row per family: models, entries, misses, the worst miss in half widths or radii, entries of
//! which the dynamic stiffness itself cannot tell, and refusals by their kind. A row of widths is as that of `shares`.
#![expect(clippy::unwrap_used, reason = "the trees here are valid")]

mod arms;
mod heavy_bodies;
mod joints;
mod levers;
mod lumped;
mod offsets;
mod orders;
mod parts;
mod random;
mod regions;
mod searches;
mod tally;

use tally::Tally;

/// All rows of a family are printed, then none of them is wrong.
fn all_right(rows: Vec<(String, Tally)>) {
    rows.iter().for_each(|(family, tally)| tally.print(family));
    rows.iter().for_each(|(family, tally)| tally.is_right(family));
}

/// The two rows of undamped trees.
fn intervals_and_discs(name: &str, [intervals, discs]: [Tally; 2]) -> [(String, Tally); 2] {
    [(format!("intervals, {name}"), intervals), (format!("discs, {name}"), discs)]
}

/// Levers are right, or nothing but `Zero`.
fn levers_are_right(models: u64) {
    let tally = levers::run(models);
    let refusals: Vec<String> = tally.refusals.keys().cloned().collect();
    all_right(vec![("levers on one axle".into(), tally)]);
    assert!(refusals.iter().all(|kind| kind == "Zero"), "{refusals:?}");
}

fn damped_arms(models: u64) {
    let rows = |central: f64| {
        let row = move |ratio: f64| {
            let name = format!("discs, damped arm of {ratio:e} beams, J_c = {central:e} m c²");
            (name, arms::run_damped(ratio, central, models))
        };
        arms::RATIOS.map(row)
    };
    all_right(arms::CENTRAL.into_iter().flat_map(rows).collect());
}

fn undamped_arms(models: u64) {
    let mut rows = Vec::new();
    for central in arms::CENTRAL {
        for ratio in arms::RATIOS {
            let name = format!("arm of {ratio:e} beams, J_c = {central:e} m c²");
            rows.extend(intervals_and_discs(&name, arms::run_undamped(ratio, central, models)));
        }
    }
    all_right(rows);
}

fn pinned_bodies(models: u64) {
    let rows = |central: f64| {
        let name = format!("pinned at the mass centre, J_c = {central:e} m c²");
        intervals_and_discs(&name, arms::run_pinned(central, models))
    };
    all_right(arms::PINNED.into_iter().flat_map(rows).collect());
}

fn levers_there_and_back(models: u64) {
    let rows = |decade: i32| {
        intervals_and_discs(&format!("levers of 1e{decade} m there and back"), offsets::run(decade, models))
    };
    all_right(offsets::DECADES.flat_map(rows).collect());
}

#[test]
fn some_levers_on_one_axle() {
    levers_are_right(12);
}

#[test]
#[ignore = "long: .ci/long"]
fn all_levers_on_one_axle() {
    levers_are_right(400);
}

#[test]
fn some_damped_arms() {
    damped_arms(3);
}

#[test]
#[ignore = "long: .ci/long"]
fn all_damped_arms() {
    damped_arms(30);
}

#[test]
fn some_undamped_arms() {
    undamped_arms(3);
}

#[test]
#[ignore = "long: .ci/long"]
fn all_undamped_arms() {
    undamped_arms(40);
}

#[test]
fn some_bodies_pinned_at_their_mass_centre() {
    pinned_bodies(3);
}

#[test]
#[ignore = "long: .ci/long"]
fn all_bodies_pinned_at_their_mass_centre() {
    pinned_bodies(40);
}

#[test]
fn some_levers_there_and_back() {
    levers_there_and_back(2);
}

#[test]
#[ignore = "long: .ci/long"]
fn all_levers_there_and_back() {
    levers_there_and_back(40);
}

/// Nothing that is heavy, and on a lever, is refused.
fn heavy_bodies_behind_levers(models: u64) {
    let tally = heavy_bodies::run(models);
    let shares = tally.shares.clone();
    all_right(vec![("heavy bodies behind levers, 10 to 1e8".into(), tally)]);
    shares.all_proven("heavy bodies");
}

#[test]
fn some_heavy_bodies_behind_levers() {
    heavy_bodies_behind_levers(25);
}

#[test]
#[ignore = "long: .ci/long"]
fn all_heavy_bodies_behind_levers() {
    heavy_bodies_behind_levers(1000);
}

fn jointed_paths(models: u64) {
    all_right(vec![("hinges of one freedom, 1e±12, and levers".into(), joints::run(0..models))]);
}

#[test]
fn some_jointed_paths() {
    jointed_paths(60);
}

#[test]
#[ignore = "long: .ci/long"]
fn all_jointed_paths() {
    jointed_paths(2000);
}

fn lumped_systems(cars: u64, stride: usize, chains: u64) {
    all_right(vec![
        ("quarter cars".into(), lumped::quarter_cars(cars)),
        ("oscillators".into(), lumped::oscillators(stride)),
        ("damped chains".into(), lumped::chains(chains)),
    ]);
}

#[test]
fn some_lumped_systems() {
    lumped_systems(40, 151, 40);
}

#[test]
#[ignore = "long: .ci/long"]
fn all_lumped_systems() {
    lumped_systems(2000, 1, 2000);
}

#[test]
fn some_orders_of_equal_parts() {
    all_right(vec![("equal parts in all orders".into(), orders::run(4))]);
}

#[test]
#[ignore = "long: .ci/long"]
fn all_orders_of_equal_parts() {
    all_right(vec![("equal parts in all orders".into(), orders::run(200))]);
}

#[test]
fn some_long_regions() {
    all_right(vec![("regions up to 1e5 long".into(), regions::run(3..=5))]);
}

#[test]
#[ignore = "long: .ci/long"]
fn all_long_regions() {
    all_right(vec![("regions up to 1e9 long".into(), regions::run(3..=9))]);
}

/// Rows of sound trees and of others.
fn rows(name: &str, sums: random::Sums) -> [(String, Tally); 2] {
    [(name.into(), sums.sound), (format!("{name}, nothing or something twice held"), sums.degenerate)]
}

/// Trees without bodies whose lowest frequency is far below those of their parts, and was outside of its interval.
const LOW: [u64; 2] = [7619, 17697];

#[test]
fn some_random_trees() {
    let damped = rows("random damped trees, 1e±6", random::damped(0..8, 6.0));
    let undamped = rows("random undamped trees, 1e±1", random::undamped(LOW.into_iter().chain(0..30), 1.0));
    all_right(damped.into_iter().chain(undamped).collect());
}

#[test]
#[ignore = "long: .ci/long"]
fn all_random_damped_trees() {
    let near = rows("random damped trees, 1e±1", random::damped(0..1000, 1.0));
    let far = rows("random damped trees, 1e±6", random::damped(0..5000, 6.0));
    all_right(near.into_iter().chain(far).collect());
}

#[test]
#[ignore = "long: .ci/long"]
fn all_random_undamped_trees() {
    let far = rows("random undamped trees, 1e±6", random::undamped(0..2000, 6.0));
    // printed alone: among these are frequencies so far below all others that 32 digits do not tell them from zero
    far.iter().for_each(|(family, tally)| tally.print(family));
    all_right(rows("random undamped trees, 1e±1", random::undamped(0..20_000, 1.0)).into());
}
