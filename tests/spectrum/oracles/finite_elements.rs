//! A tree as a finite element model, assembled by degrees of freedom: energies and rigid constraints, no transfer.

use super::legendre_beam::LegendreBeam;
use crate::support::tree::{Part, Tree, next_space};
use mstmm::element::{Space, Support};
use mstmm::list::ListStep;

/// Whether a support holds the deflection, and whether it holds the rotation.
fn holds(support: Support) -> (bool, bool) {
    match support {
        Support::Fixed => (true, true),
        Support::Pinned => (true, false),
        Support::Guided => (false, true),
        Support::Free | Support::Roller => (false, false),
    }
}

/// A square matrix by rows.
pub(crate) type Square = Vec<Vec<f64>>;

/// A linear form of the degrees of freedom: index and factor of what is not zero.
pub(crate) type Form = Vec<(usize, f64)>;

/// A beam among the degrees of freedom.
pub(crate) struct BeamElement {
    /// `Y` and `dY/ds` at both ends.
    pub(crate) ends: [Form; 4],
    /// `EI (2/l)³`.
    pub(crate) stiffness: f64,
    /// `m (l/2)⁴/EI`: `λ²` times this is dimensionless.
    pub(crate) wave_fourth: f64,
}

/// Energies of a tree: `q (K + λC + λ²M) q / 2`, and the inner functions of its beams.
pub(crate) struct Model<'a> {
    pub(crate) stiffness: Square,
    pub(crate) damping: Square,
    pub(crate) mass: Square,
    pub(crate) beams: Vec<BeamElement>,
    pub(crate) element: &'a LegendreBeam,
}

/// The same energy before the constraints are eliminated: coefficients of squares of linear forms.
#[derive(Default)]
struct Energies {
    size: usize,
    constraints: Vec<Form>,
    stiffness: Vec<(f64, Form)>,
    damping: Vec<(f64, Form)>,
    mass: Vec<(f64, Form)>,
    beams: Vec<BeamElement>,
}

/// The free end of a path: its deflection and rotation, where it has them; or a support that holds a connection.
#[derive(Clone, Copy)]
enum End {
    Point { y: Option<usize>, theta: Option<usize> },
    Held(Support),
}

impl Energies {
    fn freedom(&mut self) -> usize {
        self.size += 1;
        self.size - 1
    }

    fn point(&mut self, space: Space) -> (Option<usize>, Option<usize>) {
        let y = (!space.is(Space::Rotation)).then(|| self.freedom());
        let theta = (!space.is(Space::Translation)).then(|| self.freedom());
        (y, theta)
    }

    fn hold(&mut self, y: Option<usize>, theta: Option<usize>, support: Support) {
        let (holds_y, holds_theta) = holds(support);
        self.constraints.extend(y.filter(|_| holds_y).map(|y| vec![(y, 1.0)]));
        self.constraints.extend(theta.filter(|_| holds_theta).map(|theta| vec![(theta, 1.0)]));
    }

    /// One displacement for all inputs of a connection; a new one if it is needed and none is there.
    fn join(&mut self, inputs: impl Iterator<Item = Option<usize>>, needed: bool) -> Option<usize> {
        let all: Vec<usize> = inputs.flatten().collect();
        self.constraints.extend(all.iter().skip(1).map(|&other| vec![(all[0], 1.0), (other, -1.0)]));
        all.first().copied().or_else(|| needed.then(|| self.freedom()))
    }

    fn connection(&mut self, inputs: &[End], next: Option<Space>) -> End {
        let points = inputs.iter().filter_map(|end| match *end {
            End::Point { y, theta } => Some((y, theta)),
            End::Held(_) => None,
        });
        let y = self.join(points.clone().map(|point| point.0), next.is_some_and(|space| !space.is(Space::Rotation)));
        let theta = self.join(points.map(|point| point.1), next.is_some_and(|space| !space.is(Space::Translation)));
        for end in inputs {
            if let End::Held(support) = *end {
                self.hold(y, theta, support);
            }
        }
        End::Point { y, theta }
    }

    fn beam(&mut self, [y, theta, y_out, theta_out]: [usize; 4], length: f64, ei: f64, m: f64) {
        let half = length / 2.0;
        self.beams.push(BeamElement {
            ends: [vec![(y, 1.0)], vec![(theta, half)], vec![(y_out, 1.0)], vec![(theta_out, half)]],
            stiffness: ei / (half * half * half),
            wave_fourth: m * half * half * half * half / ei,
        });
    }

    /// A path of two displacements goes through an element.
    fn bending(&mut self, part: Part, y: usize, theta: usize) -> End {
        if let Part::PointMass(p) = part {
            self.mass.push((p.mass, vec![(y, 1.0)]));
            self.mass.push((p.inertia, vec![(theta, 1.0)]));
            return End::Point { y: Some(y), theta: Some(theta) };
        }
        let (y_out, theta_out) = (self.freedom(), self.freedom());
        match part {
            Part::Beam(b) => self.beam([y, theta, y_out, theta_out], b.length, b.bending_stiffness, b.mass_per_length),
            Part::Body(b) => {
                self.constraints.push(vec![(y_out, -1.0), (y, 1.0), (theta, b.output_x)]);
                self.constraints.push(vec![(theta_out, -1.0), (theta, 1.0)]);
                self.mass.push((b.mass, vec![(y, 1.0), (theta, b.centre_x)]));
                self.mass.push((b.inertia - b.mass * b.centre_x * b.centre_x, vec![(theta, 1.0)]));
            }
            Part::ElasticHinge(h) => {
                self.stiffness.push((h.stiffness_y, vec![(y, 1.0), (y_out, -1.0)]));
                self.stiffness.push((h.stiffness_theta, vec![(theta, 1.0), (theta_out, -1.0)]));
            }
            Part::RotationalHinge(h) => {
                self.constraints.push(vec![(y_out, -1.0), (y, 1.0)]);
                self.stiffness.push((h.stiffness, vec![(theta, 1.0), (theta_out, -1.0)]));
            }
            Part::ShearHinge(h) => {
                self.constraints.push(vec![(theta_out, -1.0), (theta, 1.0)]);
                self.stiffness.push((h.stiffness, vec![(y, 1.0), (y_out, -1.0)]));
            }
            Part::Lever(l) => {
                self.constraints.push(vec![(y_out, -1.0), (y, 1.0), (theta, l.output_x)]);
                self.constraints.push(vec![(theta_out, -1.0), (theta, 1.0)]);
            }
            _ => {}
        }
        End::Point { y: Some(y_out), theta: Some(theta_out) }
    }

    /// A path of one displacement goes through an element.
    fn line(&mut self, part: Part, q: usize) -> usize {
        match part {
            Part::Mass(p) => {
                self.mass.push((p.mass, vec![(q, 1.0)]));
                return q;
            }
            Part::Inertia(p) => {
                self.mass.push((p.inertia, vec![(q, 1.0)]));
                return q;
            }
            _ => {}
        }
        let Some([stiffness, damping]) = part.link() else { return q };
        let out = self.freedom();
        self.stiffness.push((stiffness, vec![(q, 1.0), (out, -1.0)]));
        self.damping.push((damping, vec![(q, 1.0), (out, -1.0)]));
        out
    }

    fn of(tree: &Tree) -> Energies {
        let mut energies = Energies::default();
        let mut open: Vec<End> = Vec::new();
        for (index, step) in tree.iter().enumerate() {
            let next = next_space(tree, index);
            let end = match (step, next) {
                (ListStep::Tip(support), None) => End::Held(*support),
                (ListStep::Tip(support), Some(space)) => {
                    let (y, theta) = energies.point(space);
                    energies.hold(y, theta, *support);
                    End::Point { y, theta }
                }
                (ListStep::Connection(inputs), _) => {
                    let inputs = open.split_off(open.len() - inputs);
                    energies.connection(&inputs, next)
                }
                (ListStep::Element(part), _) => match (open.pop(), part.space()) {
                    (Some(End::Point { y: Some(y), theta: Some(theta) }), Space::Bending) => {
                        energies.bending(*part, y, theta)
                    }
                    (Some(End::Point { y: Some(y), .. }), Space::Translation) => {
                        End::Point { y: Some(energies.line(*part, y)), theta: None }
                    }
                    (Some(End::Point { theta: Some(theta), .. }), Space::Rotation) => {
                        End::Point { y: None, theta: Some(energies.line(*part, theta)) }
                    }
                    _ => unreachable!("{part:?} does not fit its path"),
                },
                (ListStep::Root(support), _) => {
                    if let Some(End::Point { y, theta }) = open.pop() {
                        energies.hold(y, theta, *support);
                    }
                    return energies;
                }
            };
            open.push(end);
        }
        energies
    }

    /// Every degree of freedom as a form of the independent ones; `None` if a constraint follows from the others.
    fn independent(&self) -> Option<Square> {
        let mut forms: Square =
            (0..self.size).map(|i| (0..self.size).map(|j| f64::from(u8::from(i == j))).collect()).collect();
        for constraint in &self.constraints {
            let width = forms.first().map_or(0, Vec::len);
            let mut row = vec![0.0; width];
            for &(freedom, factor) in constraint {
                row.iter_mut().zip(&forms[freedom]).for_each(|(sum, entry)| *sum += factor * entry);
            }
            let pivot = (0..width).max_by(|&i, &j| row[i].abs().total_cmp(&row[j].abs()))?;
            if row[pivot].abs() < 1e-9 {
                return None;
            }
            for form in forms.iter_mut().filter(|form| form[pivot] != 0.0) {
                let factor = form[pivot] / row[pivot];
                form.iter_mut().zip(&row).for_each(|(entry, row)| *entry -= factor * row);
            }
            for form in &mut forms {
                form.swap_remove(pivot);
            }
        }
        Some(forms)
    }
}

/// A form of all degrees of freedom as one of the independent ones.
fn reduced(form: &Form, independent: &Square) -> Form {
    let width = independent.first().map_or(0, Vec::len);
    let entry =
        |column: usize| form.iter().map(|&(freedom, factor)| factor * independent[freedom][column]).sum::<f64>();
    (0..width).map(|column| (column, entry(column))).filter(|(_, entry)| *entry != 0.0).collect()
}

/// Adds `factor · a bᵀ`.
pub(crate) fn add_product<T>(matrix: &mut [Vec<T>], a: &Form, b: &Form, factor: T)
where
    T: Copy + core::ops::AddAssign + core::ops::Mul<f64, Output = T>,
{
    for &(i, a) in a {
        for &(j, b) in b {
            matrix[i][j] += factor * (a * b);
        }
    }
}

impl<'a> Model<'a> {
    /// The model of a tree; `None` if a displacement is held twice.
    pub(crate) fn of(tree: &Tree, element: &'a LegendreBeam) -> Option<Self> {
        let energies = Energies::of(tree);
        let independent = energies.independent()?;
        let size = independent.first().map_or(0, Vec::len);
        let sum = |squares: &[(f64, Form)]| {
            let mut matrix = vec![vec![0.0; size]; size];
            for (factor, form) in squares {
                let form = reduced(form, &independent);
                add_product(&mut matrix, &form, &form, *factor);
            }
            matrix
        };
        let (mut stiffness, mut mass) = (sum(&energies.stiffness), sum(&energies.mass));
        let damping = sum(&energies.damping);
        let beams: Vec<BeamElement> = energies
            .beams
            .iter()
            .map(|beam| BeamElement { ends: beam.ends.each_ref().map(|end| reduced(end, &independent)), ..*beam })
            .collect();
        for beam in &beams {
            for (a, end) in beam.ends.iter().enumerate() {
                for (b, other) in beam.ends.iter().enumerate() {
                    add_product(&mut stiffness, end, other, beam.stiffness * element.stiffness[a][b]);
                    add_product(&mut mass, end, other, beam.stiffness * beam.wave_fourth * element.mass[a][b]);
                }
            }
        }
        Some(Model { stiffness, damping, mass, beams, element })
    }

    /// Number of independent degrees of freedom, those of the inner functions apart.
    pub(crate) fn size(&self) -> usize {
        self.stiffness.len()
    }
}
