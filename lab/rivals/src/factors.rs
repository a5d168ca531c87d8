//! How many times as long each rival takes as the certified search.

use crate::run::{Run, median, span};
use crate::runs::{CERTIFIED, P_VERSION};
use serde::Serialize;

/// Error that a rival must reach.
pub const RIVAL_ERROR: f64 = 1e-6;

/// Error that the certified search must reach.
pub const CERTIFIED_ERROR: f64 = 1e-12;

/// Times in µs of hand-written C++ to an error of 1e-12 by p-version finite elements, on a like machine.
pub const CPP_MICROSECONDS: [(&str, f64); 5] =
    [("4.1a", 9.0), ("4.2", 7.0), ("4.3", 38.0), ("4.4", 46.0), ("4.5", 1220.0)];

/// A rival beside the certified search on one scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Factor {
    /// The scene.
    pub scene: String,
    /// The rival.
    pub method: String,
    /// Least time in which the certified search reaches 1e-12, in seconds; `None` if it does not.
    pub certified_seconds: Option<f64>,
    /// Least time in which the rival reaches 1e-6, in seconds; `None` if it does not.
    pub seconds: Option<f64>,
    /// Least time in which the rival reaches 1e-12, too, in seconds.
    pub seconds_to_all_digits: Option<f64>,
    /// How many times as long the rival takes to 1e-6 as the certified search to 1e-12: the median of the rounds.
    pub factor: Option<f64>,
    /// The least and the largest factor of a round.
    pub spread: Option<[f64; 2]>,
    /// Whether the rival is faster.
    pub wins: bool,
    /// What hand-written C++ takes to 1e-12 by p-version elements, in seconds.
    pub cpp_seconds: Option<f64>,
}

/// The cheapest run in which a method reaches an error on a scene.
fn cheapest<'a>(runs: &'a [Run], scene: &str, method: &str, error: f64) -> Option<&'a Run> {
    let reaching = runs.iter().filter(|run| run.scene == scene && run.method == method && run.error <= error);
    reaching.min_by(|one, other| one.seconds.total_cmp(&other.seconds))
}

/// How many times as long one run takes as another, round by round.
fn ratios([rival, certified]: [&Run; 2]) -> Vec<f64> {
    rival.rounds.iter().zip(&certified.rounds).map(|(rival, certified)| rival / certified).collect()
}

/// Every rival on every scene where it was run, in the order of the runs.
pub fn factors(runs: &[Run]) -> Vec<Factor> {
    let mut factors: Vec<Factor> = Vec::new();
    for Run { scene, method, .. } in runs.iter().filter(|run| run.method != CERTIFIED) {
        if factors.iter().any(|known| known.scene == *scene && known.method == *method) {
            continue;
        }
        let certified = cheapest(runs, scene, CERTIFIED, CERTIFIED_ERROR);
        let rival = cheapest(runs, scene, method, RIVAL_ERROR);
        let ratios = rival.zip(certified).map(|(rival, certified)| ratios([rival, certified]));
        let factor = ratios.as_deref().map(median);
        let cpp = CPP_MICROSECONDS.iter().find(|entry| entry.0 == scene && method == P_VERSION);
        factors.push(Factor {
            scene: scene.clone(),
            method: method.clone(),
            certified_seconds: certified.map(|run| run.seconds),
            seconds: rival.map(|run| run.seconds),
            seconds_to_all_digits: cheapest(runs, scene, method, CERTIFIED_ERROR).map(|run| run.seconds),
            factor,
            spread: ratios.as_deref().map(span),
            wins: rival.is_some() && factor.is_none_or(|factor| factor < 1.0),
            cpp_seconds: cpp.map(|entry| entry.1 * 1e-6),
        });
    }
    factors
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(method: &str, seconds: f64, error: f64) -> Run {
        let (scene, knob) = ("4.2".to_owned(), "tolerance".to_owned());
        // as the machine slows down and recovers
        let rounds = [1.0, 2.0, 4.0, 1.0, 1.0].map(|slower| slower * seconds);
        Run { scene, method: method.to_owned(), knob, setting: 1.0, seconds, rounds, evaluations: 1, error }
    }

    #[test]
    fn a_factor_is_of_the_cheapest_runs_that_reach_the_error() {
        let runs = [
            run(CERTIFIED, 2.0, 1e-15),
            run("plain method", 1.0, 1e-3),
            run("plain method", 6.0, 1e-13),
            run("plain method", 5.0, 1e-7),
            run(P_VERSION, 1.0, 1e-7),
            run("scan for minima", 1.0, f64::INFINITY),
        ];
        let [plain, elements, scan] = factors(&runs).try_into().unwrap();
        assert_eq!((plain.seconds, plain.seconds_to_all_digits), (Some(5.0), Some(6.0)));
        assert_eq!((plain.factor, plain.wins, plain.cpp_seconds), (Some(2.5), false, None));
        assert_eq!((elements.factor, elements.wins, elements.seconds_to_all_digits), (Some(0.5), true, None));
        assert_eq!(elements.cpp_seconds, Some(7.0 * 1e-6));
        assert_eq!((scan.seconds, scan.factor, scan.wins), (None, None, false));
    }

    #[test]
    fn what_slows_a_round_of_both_cancels_and_what_slows_one_is_spread() {
        let (certified, mut rival) = (run(CERTIFIED, 2.0, 1e-15), run("plain method", 6.0, 1e-7));
        rival.rounds[4] *= 2.0;
        rival.rounds[0] *= 0.5;
        let [factor] = factors(&[certified, rival]).try_into().unwrap();
        assert_eq!((factor.factor, factor.spread), (Some(3.0), Some([1.5, 6.0])));
    }

    /// Where the certified search fails, whoever succeeds wins.
    #[test]
    fn a_certified_search_without_digits_loses() {
        let [factor] = factors(&[run(CERTIFIED, 1e-6, 1e-9), run("plain method", 1.0, 1e-7)]).try_into().unwrap();
        assert_eq!((factor.certified_seconds, factor.factor, factor.wins), (None, None, true));
    }
}
