//! Every method over its knob on every scene, timed.

use crate::elements::solver::Problem;
use crate::error::Error;
use crate::found::Found;
use crate::run::{ROUNDS, Run, median, span};
use crate::scenes::{self, Scene};
use serde::Serialize;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Time for a run in one round.
const BUDGET: Duration = Duration::from_millis(12);

/// The clock is read after repeated calls of at least so long: it has its own cost.
const SAMPLE: Duration = Duration::from_micros(50);

/// Name of the certified search.
pub const CERTIFIED: &str = "certified search";

/// Name of the finite elements refined in degree.
pub const P_VERSION: &str = "p-version elements";

/// What is timed.
type Solve<'a> = Box<dyn Fn() -> Found + 'a>;

/// A method at one setting of its knob on a scene.
struct Job<'a> {
    scene: &'a Scene,
    method: &'static str,
    knob: &'static str,
    setting: f64,
    /// What is not timed: assembly, and the choice of a Krylov space.
    prepare: Box<dyn FnOnce() -> Solve<'a> + 'a>,
}

/// Relative tolerances of iterations.
const TOLERANCES: [f64; 7] = [1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Relative tolerances of scans, which end where rounding begins to show.
const SCAN_TOLERANCES: [f64; 5] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11];

/// Quadrature nodes on half of the contour.
const NODES: [usize; 10] = [6, 8, 10, 12, 14, 16, 18, 22, 28, 36];

/// Settings of the finite elements: elements per beam, then degrees.
fn refinements(scene: &Scene) -> (Vec<usize>, Vec<usize>) {
    match scene.name {
        "mode 100" => {
            (vec![64, 128, 256, 512, 1024, 2048, 4096], vec![160, 165, 170, 175, 180, 185, 190, 195, 200, 210, 220])
        }
        // all eigenvalues at once: the cost grows with the third power
        "close pair" => (vec![1, 2, 4, 8, 16, 32], vec![3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13]),
        _ => (vec![1, 2, 4, 8, 16, 32, 64, 128], (5..=17).collect()),
    }
}

fn jobs<'a>(scene: &'a Scene) -> Vec<Job<'a>> {
    let mut jobs = Vec::new();
    let mut add = |method, knob, setting, prepare: Box<dyn FnOnce() -> Solve<'a> + 'a>| {
        jobs.push(Job { scene, method, knob, setting, prepare });
    };
    add(CERTIFIED, "certificate", 1.0, Box::new(|| Box::new(|| (scene.certified)())));
    for tolerance in TOLERANCES {
        let prepare = move || -> Solve { Box::new(move || (scene.plain)(tolerance)) };
        add("plain method", "tolerance", tolerance, Box::new(prepare));
    }
    for tolerance in SCAN_TOLERANCES {
        let prepare = move || -> Solve { Box::new(move || (scene.scan)(tolerance)) };
        add("scan for minima", "tolerance", tolerance, Box::new(prepare));
    }
    let (parts, degrees) = refinements(scene);
    for parts in parts {
        add("Hermite elements", "elements per beam", parts as f64, Box::new(move || elements(scene, parts, 3)));
    }
    for degree in degrees {
        add(P_VERSION, "degree", degree as f64, Box::new(move || elements(scene, 1, degree)));
    }
    if let Some(contour) = &scene.contour {
        for nodes in NODES {
            let prepare = move || -> Solve { Box::new(move || contour(nodes)) };
            add("contour integral", "quadrature nodes", nodes as f64, Box::new(prepare));
        }
    }
    jobs
}

/// Finite elements, assembled.
fn elements(scene: &Scene, parts: usize, degree: usize) -> Solve<'_> {
    let (problem, wanted) = (Problem::new(scene, parts, degree), scene.exact.len());
    Box::new(move || problem.solve(wanted))
}

/// A job that is ready to be timed, with what it found.
struct Ready<'a> {
    run: Run,
    solve: Solve<'a>,
    /// Calls between two readings of the clock.
    calls: u32,
}

impl<'a> Job<'a> {
    fn ready(self) -> Ready<'a> {
        let solve = (self.prepare)();
        let found = solve();
        let start = Instant::now();
        black_box(solve());
        let once = start.elapsed().max(Duration::from_nanos(50));
        let run = Run {
            scene: self.scene.name.to_owned(),
            method: self.method.to_owned(),
            knob: self.knob.to_owned(),
            setting: self.setting,
            seconds: 0.0,
            rounds: [0.0; ROUNDS],
            evaluations: found.evaluations,
            error: found.error(&self.scene.exact),
        };
        Ready { run, solve, calls: (SAMPLE.as_secs_f64() / once.as_secs_f64()).ceil() as u32 }
    }
}

impl Ready<'_> {
    /// Median time of a call [s] in one round.
    fn time(&self) -> f64 {
        let begin = Instant::now();
        let mut samples = Vec::new();
        while samples.is_empty() || begin.elapsed() < BUDGET {
            let start = Instant::now();
            for _ in 0..self.calls {
                black_box((self.solve)());
            }
            samples.push(start.elapsed().as_secs_f64() / f64::from(self.calls));
        }
        median(&samples)
    }
}

/// Every method over its knob on every scene, in rounds. `progress` hears what is about to be timed, how many times were taken, and how
/// many there are.
///
/// # Errors
/// [`Error`] if a scene cannot be made.
pub fn all(mut progress: impl FnMut(&str, usize, usize)) -> Result<Vec<Run>, Error> {
    let scenes = scenes::all()?;
    let mut ready: Vec<Ready<'_>> = scenes.iter().flat_map(jobs).map(Job::ready).collect();
    let total = ROUNDS * ready.len();
    for round in 0..ROUNDS {
        let before = round * ready.len();
        for (place, job) in ready.iter_mut().enumerate() {
            let Run { scene, method, knob, setting, .. } = &job.run;
            progress(&format!("{scene}, {method}, {knob} {setting}"), before + place, total);
            job.run.rounds[round] = job.time();
        }
    }
    progress("", total, total);
    let finished = ready.into_iter().map(|job| Run { seconds: median(&job.run.rounds), ..job.run });
    Ok(finished.collect())
}

/// The runs as a JSON list. An infinite error is `null`, as JSON has no other word for it.
///
/// # Errors
/// [`Error::Json`].
pub fn to_json(runs: &[Run]) -> Result<String, Error> {
    Ok(serde_json::to_string_pretty(runs)?)
}

/// A run as a line of CSV, which has no lists.
#[derive(Serialize)]
struct Line<'a> {
    scene: &'a str,
    method: &'a str,
    knob: &'a str,
    setting: f64,
    seconds: f64,
    least_seconds: f64,
    most_seconds: f64,
    evaluations: u64,
    error: f64,
}

impl<'a> From<&'a Run> for Line<'a> {
    fn from(run: &'a Run) -> Self {
        let Run { scene, method, knob, setting, seconds, evaluations, error, .. } = run;
        let [least_seconds, most_seconds] = span(&run.rounds);
        Line {
            scene,
            method,
            knob,
            setting: *setting,
            seconds: *seconds,
            least_seconds,
            most_seconds,
            evaluations: *evaluations,
            error: *error,
        }
    }
}

/// The runs as CSV with a heading: of the rounds the least and the most.
///
/// # Errors
/// [`Error::Csv`].
pub fn to_csv(runs: &[Run], writer: impl std::io::Write) -> Result<(), Error> {
    let mut writer = csv::Writer::from_writer(writer);
    for run in runs {
        writer.serialize(Line::from(run))?;
    }
    Ok(writer.flush().map_err(csv::Error::from)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_scene_has_every_method_that_applies() {
        let scenes = scenes::all().unwrap();
        for scene in &scenes {
            let methods: BTreeSet<_> = jobs(scene).iter().map(|job| job.method).collect();
            assert_eq!(methods.contains("contour integral"), scene.name == "4.5");
            assert_eq!(methods.len(), if scene.name == "4.5" { 6 } else { 5 });
        }
    }

    #[test]
    fn runs_are_written_with_their_fields() {
        let (scene, method, knob) = ("4.2".to_owned(), "plain method".to_owned(), "tolerance".to_owned());
        let (rounds, error) = ([0.25, 0.125, 0.25, 0.5, 0.25], f64::INFINITY);
        let run = Run { scene, method, knob, setting: 0.5, seconds: 0.25, rounds, evaluations: 3, error };
        let json: serde_json::Value = serde_json::from_str(&to_json(std::slice::from_ref(&run)).unwrap()).unwrap();
        assert_eq!(json[0]["method"], "plain method");
        assert_eq!(json[0]["evaluations"], 3);
        assert_eq!(json[0]["rounds"][3], 0.5);
        assert!(json[0]["error"].is_null());
        let mut text = Vec::new();
        to_csv(&[run], &mut text).unwrap();
        let expected = "scene,method,knob,setting,seconds,least_seconds,most_seconds,evaluations,error\n\
                        4.2,plain method,tolerance,0.5,0.25,0.125,0.5,3,inf\n";
        assert_eq!(String::from_utf8(text).unwrap(), expected);
    }
}
