//! Loads that coincide: struts on a foundation at a change of their half waves, equal columns that hardly know of each other.

use super::exact::{Double, double, moved, pi, sorted};
use super::in_full;
use crate::support::random_tree::Random;
use mstmm::prelude::*;
use mstmm::search::{CriticalLoad, critical_loads};

system! {
    struct Strut { foundation: f64, load: f64 }
    pinned -> beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -load, foundation_stiffness: foundation
    } -> pinned
}

/// That a list is complete in a range in which no load is at an end, and that intervals hold what they say, by bounds of each load.
fn check(loads: &[CriticalLoad], [start, end]: [f64; 2], bounds: &[[Double; 2]], model: &dyn std::fmt::Debug) {
    let below = |factor: f64| bounds.iter().take_while(|[_, most]| *most < double(factor)).count() as u64;
    let total: u64 = loads.iter().map(|load| load.multiplicity).sum();
    assert_eq!(total, below(end) - below(start), "{model:?} in {start}..={end}: {loads:?}");
    let mut next = below(start) + 1;
    let mut floor = 0.0;
    for load in loads {
        assert_eq!(load.index, next, "{model:?} in {start}..={end}: {loads:?}");
        next += load.multiplicity;
        let holds = bounds[load.index as usize - 1][1] >= double(load.lower)
            && bounds[next as usize - 2][0] < double(load.upper);
        assert!(holds && floor <= load.lower, "{model:?} in {start}..={end}: {load:?}");
        floor = load.upper;
    }
}

/// Whether an end of a range is clear of all loads.
fn is_clear(end: f64, bounds: &[[Double; 2]]) -> bool {
    bounds.iter().flatten().all(|load| (*load - double(end)).abs() > double(1e-9 * end))
}

/// A range whose end is anywhere, or beside a load.
fn range(random: &mut Random, about: f64, bounds: &[[Double; 2]]) -> [f64; 2] {
    loop {
        let mut end = || match random.below(3) {
            0 => about * (1.0 + random.pick([1.0, -1.0]) * 10_f64.powf(-8.0 * random.unit())),
            _ => 3.0 * about * random.unit(),
        };
        let [one, other] = [end(), end()];
        let range = if random.chance(0.7) { [0.0, one] } else { [one.min(other), one.max(other)] };
        if range[1] > range[0] && range.iter().all(|end| is_clear(*end, bounds)) {
            return range;
        }
    }
}

/// Closed form: in k half waves the strut buckles under `(kπ)² + f/(kπ)²`, in two words; with `f = m² n² π⁴` in m and n at once.
fn coincident_loads(ranges: usize) {
    for (m, n) in [(1, 2), (2, 3), (3, 4), (4, 5), (1, 3)] {
        let random = &mut Random(u64::from(10 * m + n));
        let product = (pi(m) * pi(n)).parts().0;
        for _ in 0..ranges {
            // the double next to it, or one beside it
            let foundation = moved(product * product, random.below(9) as i64 - 4);
            let load = |k: u32| pi(k) * pi(k) + double(foundation) / (pi(k) * pi(k));
            let bounds: Vec<_> = sorted((1..20).map(load).collect()).into_iter().map(|load| [load; 2]).collect();
            let [start, end] = range(random, load(n).parts().0, &bounds);
            let loads = critical_loads::<16, _>(start..=end, |load| Strut { foundation, load }.build()).unwrap();
            check(&loads, [start, end], &bounds, &(m, n, foundation));
        }
    }
}

system! {
    struct Twins { one: f64, other: f64, spring: f64, load: f64 }
    pinned at 0.0 -> beam 1 { bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -load } -> conn a at 0.5 * one
        -> beam 2 { bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -load } -> pinned at one;
    pinned at 0.0 -> beam 3 { bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -load } -> conn b at 0.5 * other
        -> beam 4 { bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -load } -> pinned at other;
    conn a -> spring 5 { stiffness: spring } -> conn b
}

/// Bounds by Rayleigh's quotient: a spring k between the middles raises no load `(nπ/l)²` by more than `k l/2`, since `y² <= l/4 ∫ y'²` there.
fn twin_columns(models: usize) {
    let random = &mut Random(0xb1);
    for _ in 0..models {
        let one = 0.5 + 1.5 * random.unit();
        let other = moved(one, random.below(9) as i64);
        let spring = 10_f64.powf(-16.0 + 6.0 * random.unit());
        let load = |k: u32| [one, other].map(|length| pi(k) * pi(k) / (double(length) * double(length)));
        let more = double(0.5 * other * spring);
        let bounds: Vec<_> =
            sorted((1..12).flat_map(load).collect()).into_iter().map(|load| [load, load + more]).collect();
        let about = load(1)[0].parts().0 * random.pick([1.0, 4.0]);
        let [start, end] = range(random, about, &bounds);
        let found = critical_loads::<16, _>(start..=end, |load| Twins { one, other, spring, load }.build()).unwrap();
        check(&found, [start, end], &bounds, &(one, other, spring));
    }
}

in_full! {
    coincident_loads(12, 500) = some_loads_that_coincide, all_loads_that_coincide;
    twin_columns(25, 1500) = some_loads_of_twin_columns, all_loads_of_twin_columns;
}
