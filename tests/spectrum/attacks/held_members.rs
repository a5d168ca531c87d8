//! Counts a number at a time about frequencies of members with both ends held, where stiffnesses have poles: sines that are zero but for
//! rounding, beams between clamps whole and in parts.

use super::exact::{Double, count_is_right, double, moved, pi, square, wave_of_mode};
use super::in_full;
use crate::support::random_tree::Random;
use mstmm::element::Support;
use mstmm::elements::{AnyUndamped, Beam, Rod};
use mstmm::list::{ListStep, StepList};
use mstmm::number::Parameter;
use mstmm::prelude::*;

const ABOUT: i64 = 20;

fn clamped(part: AnyUndamped<f64>, parts: usize) -> Vec<ListStep<AnyUndamped<f64>>> {
    let inner = std::iter::repeat_n(ListStep::Element(part), parts);
    [ListStep::Tip(Support::Fixed)].into_iter().chain(inner).chain([ListStep::Root(Support::Fixed)]).collect()
}

fn beam(length: f64) -> AnyUndamped<f64> {
    Beam { length, bending_stiffness: 1.0, mass_per_length: 1.0 }.try_into().unwrap()
}

/// Both bounds and the count about a frequency, whose exact count is that of the modes below it.
fn check(
    steps: &[ListStep<AnyUndamped<f64>>],
    about: f64,
    squares: &[Double],
    model: &dyn std::fmt::Debug,
) -> [u64; 2] {
    let list = StepList::new(steps).unwrap();
    let mut asked = [0, 0];
    for omega in (-ABOUT..=ABOUT).map(|by| moved(about, by)) {
        let expected = squares.iter().filter(|mode| **mode < square(omega)).count() as u64;
        let (bounds, count) = (list.count_bounds(omega), list.count_below(omega));
        assert!(count_is_right(bounds, &count, expected), "{expected} {bounds:?} {count:?} below {omega}: {model:?}");
        asked = [asked[0] + 1, asked[1] + u64::from(count.is_err())];
    }
    asked
}

/// Closed form: `cos z cosh z = 1`, in two words; a beam in two or four parts is the same, at frequencies of its parts as well, and several on
/// one pair of clamps are as many.
fn clamped_beams(modes: u32) {
    let mut asked = [0, 0];
    let mut add = |one: [u64; 2]| asked = [asked[0] + one[0], asked[1] + one[1]];
    for length in [1.0, 0.7, 1.3, 2.0, 0.1] {
        let squares: Vec<_> = (1..=2 * modes + 2)
            .map(|mode| {
                let wave = wave_of_mode(mode, true) / double(length);
                wave * wave * wave * wave
            })
            .collect();
        for mode in 0..modes as usize {
            let about = squares[mode].to_f64().sqrt();
            for parts in [1, 2, 4] {
                // powers of two divide without rounding
                add(check(&clamped(beam(length / parts as f64), parts), about, &squares, &(length, mode, parts)));
            }
            // the frequencies of one half with its ends held, four times as high
            if mode < modes as usize / 2 {
                add(check(&clamped(beam(0.5 * length), 2), 4.0 * about, &squares, &(length, mode, "half")));
            }
        }
    }
    println!("| clamped beams | {} | {} |", asked[0], asked[1]);
}

/// Equal arms that meet at a joint.
fn star(part: AnyUndamped<f64>, arms: usize) -> Vec<ListStep<AnyUndamped<f64>>> {
    let inner = std::iter::repeat_n([ListStep::Tip(Support::Fixed), ListStep::Element(part)], arms).flatten();
    inner.chain([ListStep::Connection(arms), ListStep::Root(Support::Free)]).collect()
}

/// Closed form: all arms move as one whose end is free, or the joint rests and all but one are free to move with held ends.
fn equal_arms(modes: u32) {
    let mut asked = [0, 0];
    for arms in 2..6 {
        let waves = |is_held: bool| (1..=modes + 2).map(move |mode| wave_of_mode(mode, is_held));
        let fourth = |wave: Double| wave * wave * (wave * wave);
        let held = waves(true).flat_map(|wave| vec![fourth(wave); arms - 1]);
        let squares: Vec<_> = waves(false).map(fourth).chain(held).collect();
        let rod = Rod { length: 1.0, axial_stiffness: 1.0, mass_per_length: 1.0, foundation_stiffness: 0.0 };
        let half = |waves: u32| pi(waves) * double(0.5) * (pi(waves) * double(0.5));
        let phases: Vec<_> =
            (1..2 * modes + 4).flat_map(|waves| vec![half(waves); if waves % 2 == 1 { 1 } else { arms - 1 }]).collect();
        for mode in 1..=modes {
            let wave = wave_of_mode(mode, true);
            let points = [
                (star(beam(1.0), arms), (wave * wave).to_f64(), &squares),
                (star(rod.try_into().unwrap(), arms), pi(mode).to_f64(), &phases),
            ];
            for (steps, about, squares) in points {
                let one = check(&steps, about, squares, &(arms, mode));
                asked = [asked[0] + one[0], asked[1] + one[1]];
            }
        }
    }
    println!("| equal arms | {} | {} |", asked[0], asked[1]);
}

/// Closed form: a rod between two walls has the phases `nπ`, in two words; in equal parts a phase of the whole is one of the parts, now and then.
fn held_rods(models: usize) {
    let random = &mut Random(0x5e);
    let mut asked = [0, 0];
    for model in 0..models {
        let mut number = || if model == 0 { 1.0 } else { 10_f64.powf(4.0 * random.unit() - 2.0) };
        let [length, stiffness, mass] = [number(), number(), number()];
        let squares: Vec<_> = (1..80)
            .map(|waves| {
                let wave = pi(waves) / double(length);
                wave * wave * double(stiffness) / double(mass)
            })
            .collect();
        for waves in [1, 2, 3, 4, 5, 7, 8, 16, 31, 64] {
            for parts in [1, 2, 4] {
                let rod = Rod {
                    length: length / parts as f64,
                    axial_stiffness: stiffness,
                    mass_per_length: mass,
                    foundation_stiffness: 0.0,
                };
                let about = squares[waves - 1].to_f64().sqrt();
                let one = check(&clamped(rod.try_into().unwrap(), parts), about, &squares, &(rod, parts, waves));
                asked = [asked[0] + one[0], asked[1] + one[1]];
            }
        }
    }
    println!("| held rods | {} | {} |", asked[0], asked[1]);
}

in_full! {
    clamped_beams(6, 40) = some_clamped_beams, all_clamped_beams;
    equal_arms(4, 40) = some_equal_arms, all_equal_arms;
    held_rods(3, 60) = some_held_rods, all_held_rods;
}
