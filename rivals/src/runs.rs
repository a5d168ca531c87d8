//! Every method over its knob on every scene, timed.

use crate::elements::solver::Problem;
use crate::error::Error;
use crate::found::Found;
use crate::run::Run;
use crate::scenes::{self, Scene};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Time for all rounds of one run.
const BUDGET: Duration = Duration::from_millis(25);

/// A round is repeated calls of at least so long: the clock has its own cost.
const ROUND: Duration = Duration::from_micros(50);

/// Name of the certified search.
pub const CERTIFIED: &str = "certified search";

/// Name of the finite elements refined in degree.
pub const P_VERSION: &str = "p-version elements";

/// A method at one setting, ready to be timed.
struct Job<'a> {
    scene: &'a Scene,
    method: &'static str,
    knob: &'static str,
    setting: f64,
    solve: Box<dyn Fn() -> Found + 'a>,
}

/// Relative tolerances of iterations.
const TOLERANCES: [f64; 7] = [1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// Relative tolerances of scans, which end where rounding begins to show.
const SCAN_TOLERANCES: [f64; 5] = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11];

/// Quadrature nodes on half of the contour.
const NODES: [usize; 9] = [6, 8, 10, 12, 16, 20, 26, 34, 44];

/// Settings of the finite elements: elements per beam, then degrees.
fn refinements(scene: &Scene) -> (Vec<usize>, Vec<usize>) {
    match scene.name {
        "mode 100" => (vec![64, 128, 256, 512, 1024, 2048, 4096], vec![180, 190, 200, 205, 210, 215, 220, 230, 240]),
        // all eigenvalues at once: the cost grows with the third power
        "close pair" => (vec![1, 2, 4, 8, 16, 32], vec![3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13]),
        _ => (vec![1, 2, 4, 8, 16, 32, 64, 128], (5..=17).collect()),
    }
}

fn jobs<'a>(scene: &'a Scene) -> Vec<Job<'a>> {
    let mut jobs = Vec::new();
    let mut add = |method, knob, setting, solve: Box<dyn Fn() -> Found + 'a>| {
        jobs.push(Job { scene, method, knob, setting, solve });
    };
    add(CERTIFIED, "certificate", 1.0, Box::new(|| (scene.certified)()));
    for tolerance in TOLERANCES {
        add("plain method", "tolerance", tolerance, Box::new(move || (scene.plain)(tolerance)));
    }
    for tolerance in SCAN_TOLERANCES {
        add("scan for minima", "tolerance", tolerance, Box::new(move || (scene.scan)(tolerance)));
    }
    let (parts, degrees) = refinements(scene);
    let wanted = scene.exact.len();
    for parts in parts {
        let problem = Problem::new(scene, parts, 3);
        add("Hermite elements", "elements per beam", parts as f64, Box::new(move || problem.solve(wanted)));
    }
    for degree in degrees {
        let problem = Problem::new(scene, 1, degree);
        add(P_VERSION, "degree", degree as f64, Box::new(move || problem.solve(wanted)));
    }
    if let Some(contour) = &scene.contour {
        for nodes in NODES {
            add("contour integral", "quadrature nodes", nodes as f64, Box::new(move || contour(nodes)));
        }
    }
    jobs
}

/// Median time of a call [s] over rounds that fill the budget.
fn seconds(call: impl Fn()) -> f64 {
    let start = Instant::now();
    call();
    let once = start.elapsed().max(Duration::from_nanos(50));
    let repeats = (ROUND.as_secs_f64() / once.as_secs_f64()).ceil() as u32;
    let begin = Instant::now();
    let mut rounds = Vec::new();
    while rounds.len() < 3 || begin.elapsed() < BUDGET {
        let start = Instant::now();
        (0..repeats).for_each(|_| call());
        rounds.push(start.elapsed().as_secs_f64() / f64::from(repeats));
    }
    rounds.sort_by(f64::total_cmp);
    rounds[rounds.len() / 2]
}

impl Job<'_> {
    fn run(&self) -> Run {
        let found = (self.solve)();
        Run {
            scene: self.scene.name.to_owned(),
            method: self.method.to_owned(),
            knob: self.knob.to_owned(),
            setting: self.setting,
            seconds: seconds(|| {
                black_box((self.solve)());
            }),
            evaluations: found.evaluations,
            error: found.error(&self.scene.exact),
        }
    }
}

/// Every method over its knob on every scene. `progress` hears what is about to run, how many runs are done, and how many
/// there are.
///
/// # Errors
/// [`Error`] if a scene cannot be made.
pub fn all(mut progress: impl FnMut(&str, usize, usize)) -> Result<Vec<Run>, Error> {
    let scenes = scenes::all()?;
    let jobs: Vec<Job> = scenes.iter().flat_map(jobs).collect();
    let mut runs = Vec::with_capacity(jobs.len());
    for (done, job) in jobs.iter().enumerate() {
        progress(&format!("{}, {}, {} {}", job.scene.name, job.method, job.knob, job.setting), done, jobs.len());
        runs.push(job.run());
    }
    progress("", jobs.len(), jobs.len());
    Ok(runs)
}

/// The runs as a JSON list. An infinite error is `null`, as JSON has no other word for it.
///
/// # Errors
/// [`Error::Json`].
pub fn to_json(runs: &[Run]) -> Result<String, Error> {
    Ok(serde_json::to_string_pretty(runs)?)
}

/// The runs as CSV with a heading.
///
/// # Errors
/// [`Error::Csv`].
pub fn to_csv(runs: &[Run], writer: impl std::io::Write) -> Result<(), Error> {
    let mut writer = csv::Writer::from_writer(writer);
    for run in runs {
        writer.serialize(run)?;
    }
    Ok(writer.flush().map_err(csv::Error::from)?)
}
