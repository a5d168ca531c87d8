//! A page of few measurements and invented runs.
#![expect(clippy::unwrap_used, reason = "the examples can be solved")]

use report::{Extent, Measurements};
use rivals::Run;
use std::sync::OnceLock;

const SCENES: [&str; 8] = ["4.1a", "4.2", "4.3", "4.4", "4.5", "mode 100", "close pair", "stiff"];

/// Methods with time and error of their first run, and by what a run differs from the one before.
const METHODS: [(&str, [f64; 2], [f64; 2]); 6] = [
    ("certified search", [3e-6, 0.0], [1.0, 1.0]),
    ("plain method", [2e-6, 1e-4], [1.2, 1e-3]),
    ("scan for minima", [1e-5, 1e-2], [1.5, 1e-2]),
    ("Hermite elements", [2e-6, 1e-1], [5.0, 0.06]),
    ("p-version elements", [5e-6, 1e-2], [3.0, 1e-4]),
    ("contour integral", [4e-5, 1e-3], [2.0, 1e-3]),
];

/// Runs as they could be: one of the certified search in each scene, some of each rival, and one that loses a root.
pub(crate) fn runs() -> Vec<Run> {
    let mut runs = Vec::new();
    for (place, scene) in SCENES.iter().enumerate() {
        for (method, [seconds, error], [slower, better]) in METHODS {
            let count = if error == 0.0 { 1 } else { 5 };
            for n in 0..count {
                let is_lost = n == 0 && method == "scan for minima";
                let seconds = seconds * (1.0 + place as f64) * slower.powi(n);
                runs.push(Run {
                    scene: (*scene).to_owned(),
                    method: method.to_owned(),
                    knob: "tolerance".to_owned(),
                    setting: f64::from(n),
                    seconds,
                    rounds: [0.9, 1.0, 1.1, 1.0, 1.0].map(|share| share * seconds),
                    evaluations: 10,
                    error: if is_lost { f64::INFINITY } else { (error * better.powi(n)).max(1e-15) },
                });
            }
        }
    }
    runs
}

/// Few measurements of everything, taken once for all tests of a file.
pub(crate) fn measurements() -> &'static Measurements {
    static MEASUREMENTS: OnceLock<Measurements> = OnceLock::new();
    MEASUREMENTS.get_or_init(|| measurements_of(runs()))
}

/// Few measurements of everything, with other runs.
pub(crate) fn measurements_of(runs: Vec<Run>) -> Measurements {
    let extent = Extent {
        samples: 41,
        modes: vec![1, 2, 3, 6, 10, 30, 100, 300, 1000],
        stiffness: vec![-15, -9, -3, 0, 3, 9, 15],
        elements: vec![1, 3, 10, 30],
        storeys: vec![1, 3],
        roots: 10,
        programs: false,
    };
    Measurements::take(runs, &extent, |_| ()).unwrap()
}
