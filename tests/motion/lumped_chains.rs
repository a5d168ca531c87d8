//! Random chains of masses, springs and dampers in time, against inverse Laplace transforms of linear equations in twice the digits.
//!
//! Some points have no mass, some masses nothing but dampers to hold them, some chains nothing at all.
#![expect(clippy::panic, clippy::unwrap_used, reason = "a failing chain is shown as a whole")]

use crate::support::list_of_tree::{any, point};
use crate::support::random_tree::Random;
use crate::support::tree::{Part, Tree};
use core::ops::Range;
use mstmm::Complex;
use mstmm::element::Support;
use mstmm::elements::{Damper, Mass, Spring, SpringDamper};
use mstmm::list::{InList, ListStep};
use mstmm::motion::{Entry, Load, ModalAnalysis, MotionError};
use mstmm::number::{DoubleDouble, Parameter, Real, Scalar};
use mstmm::search::{Eigenvalues, Region};

type Wide = Complex<DoubleDouble>;

/// All eigenvalues of chains of these parameters.
const REGION: Region = Region { re: -1000.0..=1.0, im: 0.0..=50.0 };
const MODES: usize = 24;
/// Points of the contour of the inverse transform.
const POINTS: u32 = 80;

fn number(value: f64) -> Wide {
    Wide::from_f64(value)
}

/// A chain, and the node that each step ends in; node 0 is the ground.
#[derive(Clone, Debug, Default)]
struct Chain {
    tree: Tree,
    node_behind: Vec<usize>,
    nodes: usize,
}

impl Chain {
    fn random(seed: u64) -> Self {
        let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let mut value = move || 5.0_f64.powf(2.0 * random.unit() - 1.0);
        let mut chance = {
            let mut random = Random(seed ^ 0x5555);
            move |probability: f64| random.unit() < probability
        };
        let held = [chance(0.4), chance(0.4)];
        let mut chain = Chain { nodes: 1, ..Chain::default() };
        let start = if held[0] { 0 } else { chain.new_node() };
        chain.push(ListStep::Tip(if held[0] { Support::Fixed } else { Support::Free }), start);
        let links = if chance(0.5) { 3 } else { 5 };
        for link in 0..links {
            let node = chain.node_behind[chain.tree.len() - 1];
            if node != 0 && chance(0.7) {
                chain.push(ListStep::Element(Part::Mass(Mass { mass: value() })), node);
            }
            let part = match (chance(0.45), chance(0.6)) {
                (true, _) => Part::Spring(Spring { stiffness: value() }),
                (_, true) => Part::Damper(Damper { damping: value() }),
                _ => Part::SpringDamper(SpringDamper { stiffness: value(), damping: value() }),
            };
            let node = if link + 1 == links && held[1] { 0 } else { chain.new_node() };
            chain.push(ListStep::Element(part), node);
        }
        let last = chain.node_behind[chain.tree.len() - 1];
        if last != 0 {
            chain.push(ListStep::Element(Part::Mass(Mass { mass: value() })), last);
        }
        chain.push(ListStep::Root(if held[1] { Support::Fixed } else { Support::Free }), last);
        chain
    }

    fn new_node(&mut self) -> usize {
        self.nodes += 1;
        self.nodes - 1
    }

    fn push(&mut self, step: ListStep<Part>, node: usize) {
        self.tree.push(step);
        self.node_behind.push(node);
    }

    /// Displacements of the nodes under a force at one of them: `(M s² + C s + K) u = f`.
    fn displacements(&self, s: Wide, loaded: usize) -> Option<Vec<Wide>> {
        let count = self.nodes - 1;
        let mut rows = vec![vec![number(0.0); count + 1]; count];
        rows[loaded - 1][count] = number(1.0);
        for (step, part) in self.tree.iter().enumerate() {
            let ListStep::Element(part) = part else { continue };
            let (from, to) = (self.node_behind[step - 1], self.node_behind[step]);
            let stiffness = stiffness(part, s);
            if let Part::Mass(Mass { mass }) = part {
                rows[to - 1][to - 1] += s * s * number(*mass);
                continue;
            }
            for (own, other) in [(from, to), (to, from)] {
                if own != 0 {
                    rows[own - 1][own - 1] += stiffness;
                    if other != 0 {
                        rows[own - 1][other - 1] -= stiffness;
                    }
                }
            }
        }
        solved(rows)
    }

    /// A response: of the displacement behind a step, or of the force in its element.
    fn response(&self, s: Wide, loaded: usize, step: usize, force: bool) -> Option<Wide> {
        let displacements = self.displacements(s, loaded)?;
        let at = |step: usize| match self.node_behind[step] {
            0 => number(0.0),
            node => displacements[node - 1],
        };
        match &self.tree[step] {
            ListStep::Element(part) if force => Some(stiffness(part, s) * (at(step - 1) - at(step))),
            _ => Some(at(step)),
        }
    }
}

/// The dynamic stiffness of a link.
fn stiffness(part: &Part, s: Wide) -> Wide {
    match part {
        Part::Spring(Spring { stiffness }) => number(*stiffness),
        Part::Damper(Damper { damping }) => s * number(*damping),
        Part::SpringDamper(SpringDamper { stiffness, damping }) => number(*stiffness) + s * number(*damping),
        _ => number(0.0),
    }
}

/// Gauss's elimination; `None` for equations that do not determine anything.
fn solved(mut rows: Vec<Vec<Wide>>) -> Option<Vec<Wide>> {
    let count = rows.len();
    for column in 0..count {
        let size = |row: usize| rows[row][column].size();
        let pivot = (column..count).fold(column, |best, row| if size(row) > size(best) { row } else { best });
        if size(pivot) == 0.0 {
            return None;
        }
        rows.swap(column, pivot);
        let own = rows[column].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(row, _)| *row != column) {
            let factor = row[column] / own[column];
            row.iter_mut().zip(&own).for_each(|(entry, own)| *entry -= factor * *own);
        }
    }
    Some((0..count).map(|row| rows[row][count] / rows[row][row]).collect())
}

/// The function of time with a Laplace transform: Talbot's contour, by the midpoint rule of Abate and Valkó.
fn inverse(time: f64, transform: impl Fn(Wide) -> Wide) -> f64 {
    let wide = DoubleDouble::from_f64;
    let (time, points) = (wide(time), wide(f64::from(POINTS)));
    let r = (points + points) / (wide(5.0) * time);
    let mut sum = (transform(Wide::new(r, wide(0.0))).re * Real::exp(r * time)) * wide(0.5);
    for k in 1..POINTS {
        let theta = wide(std::f64::consts::PI) * wide(f64::from(k)) / points;
        let (sin, cos) = Scalar::sin_cos(theta);
        let cot = cos / sin;
        let s = Wide::new(r * theta * cot, r * theta);
        let (sin, cos) = Scalar::sin_cos(s.im * time);
        let growth = Wide::new(cos, sin) * Real::exp(s.re * time);
        let slope = Wide::new(wide(1.0), theta + (theta * cot - wide(1.0)) * cot);
        sum += (growth * transform(s) * slope).re;
    }
    (r / points * sum).to_f64()
}

/// What was compared, and the largest errors relative to their scales.
#[derive(Clone, Copy, Debug, Default)]
struct Compared {
    chains: usize,
    responses: usize,
    at_once: usize,
    drifting: usize,
    defective: usize,
    worst: [f64; 3],
}

/// Compares the responses of a chain to a load at one step.
fn check(seed: u64, chain: &Chain, loaded: usize, compared: &mut Compared) {
    let system = any::<f64>(&chain.tree);
    let roots = system.eigenvalues::<MODES>(REGION).unwrap();
    let load: Load<InList> = point(loaded, true).force();
    let slowest = roots.iter().map(|root| root.lambda.norm()).filter(|size| *size > 0.0).fold(1.0, f64::min);
    let places = (1..chain.tree.len() - 1).flat_map(|step| [(step, false), (step, true)]);
    for (step, force) in places {
        let entry: Entry<InList> = if force { point(step, false).shear() } else { point(step, false).deflection() };
        if force && matches!(chain.tree[step], ListStep::Element(Part::Mass(_))) {
            continue;
        }
        let context =
            || format!("seed {seed}, load {loaded}, entry {step} {force}\n{:?}\nvec!{:?}", &*roots, chain.tree);
        let response = match system.modal_response::<MODES, _>(&roots, load, entry) {
            Err(MotionError::Defective { root, .. }) if root > 0.0 => {
                compared.defective += 1;
                continue;
            }
            other => other.unwrap_or_else(|error| panic!("{error:?}, {}", context())),
        };
        let node = chain.node_behind[loaded];
        let transform = |s: Wide| chain.response(s, node, step, force).unwrap();
        let mut expect = |place: usize, actual: f64, expected: f64, scale: f64, limit: f64| {
            let error = (actual - expected).abs() / scale;
            assert!(error <= limit, "{place}: {actual} {expected} {error:e}, {}", context());
            compared.worst[place] = compared.worst[place].max(error);
        };
        let unit = if force { 1.0 } else { 10.0 };
        // at once and at rest, extrapolated from four real frequencies near these limits, each at twice the distance
        let extrapolated = |values: [Wide; 4]| {
            let weights = [64.0, -56.0, 14.0, -1.0].map(number);
            let sum = values.iter().zip(weights).fold(number(0.0), |sum, (value, weight)| sum + *value * weight);
            (sum / number(21.0)).re.to_f64()
        };
        let at_once = extrapolated([1.6e6, 8e5, 4e5, 2e5].map(|s| transform(number(s))));
        expect(0, response.to_step(0.0), at_once, unit, LIMIT);
        let mut history = response.history(0.5).unwrap();
        expect(0, history.next(0.0), 0.0, 1.0, 0.0);
        for n in 1..=6_u32 {
            let t = 0.5 * f64::from(n);
            let by_step = inverse(t, |s| transform(s) / s);
            let by_ramp = inverse(t, |s| transform(s) / (s * s));
            expect(0, response.to_step(t), by_step, unit * (1.0 + t * t), LIMIT);
            expect(1, history.next(t), by_ramp, unit * (1.0 + t * t * t), LIMIT);
        }
        let near_rest = [1.0, 2.0, 4.0, 8.0].map(|part| transform(number(part * 2e-4 * slowest)));
        let moves = near_rest[0].size() > 1.5 * near_rest[1].size() && near_rest[0].size() > 1e3;
        match response.static_value() {
            Ok(value) => expect(2, value, extrapolated(near_rest), unit, LIMIT),
            Err(_) => assert!(moves, "{}", context()),
        }
        compared.responses += 1;
        compared.at_once += usize::from(at_once.abs() > 1e-6);
        compared.drifting += usize::from(moves);
    }
}

/// Relative to 10 m/N, or 1 for forces, as compliances of these parameters are; extrapolated limits have as many digits.
const LIMIT: f64 = 1e-12;

fn compared(seeds: Range<u64>) -> Compared {
    let mut compared = Compared::default();
    for seed in seeds {
        let chain = Chain::random(seed);
        let loads: Vec<usize> = (0..chain.tree.len() - 1).filter(|&step| chain.node_behind[step] != 0).collect();
        check(seed, &chain, loads[seed as usize % loads.len()], &mut compared);
        compared.chains += 1;
    }
    compared
}

#[test]
fn some_chains_move_as_their_equations_say() {
    let compared = compared(0..6);
    assert!(compared.at_once > 3 && compared.drifting > 5, "{compared:?}");
}

#[test]
#[ignore = "long: .ci/long"]
fn chains_move_as_their_equations_say() {
    let compared = compared(0..60);
    assert!(compared.at_once > 30 && compared.drifting > 50, "{compared:?}");
}
