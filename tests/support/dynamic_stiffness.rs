//! A tree as a dynamic stiffness matrix in double-double arithmetic: assembled by degrees of freedom, no transfer.
//!
//! Every beam has the textbook's matrix for a frequency; a rigid body is its mass at the mass centre and its inertia about
//! that, on displacements that are forms of those of its input end. Nothing cancels that does not in the model.

#[path = "dynamic_stiffness/beam_matrix.rs"]
mod beam_matrix;
#[path = "dynamic_stiffness/constraints.rs"]
mod constraints;
#[path = "dynamic_stiffness/determinant.rs"]
mod determinant;
#[path = "dynamic_stiffness/freedoms.rs"]
mod freedoms;
#[path = "dynamic_stiffness/intervals.rs"]
mod intervals;
#[path = "dynamic_stiffness/pivots.rs"]
mod pivots;
#[path = "dynamic_stiffness/zeros.rs"]
mod zeros;

use crate::tree::Tree;
use beam_matrix::{BeamMatrix, Field};
use freedoms::Parts;
use mstmm::{DoubleDouble, Real};

/// A linear form of degrees of freedom: index and factor of what is not zero.
type Form = Vec<(usize, DoubleDouble)>;

/// Bound of the relative error of an operation in double-double arithmetic, `2^-103`: twice that of a quotient.
const UNIT: f64 = 2.0 * f64::EPSILON * f64::EPSILON;

/// What the model says of a certified root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Verdict {
    Holds,
    /// The root is so many half widths or radii from the middle; of intervals and clusters, up to a factor of two less.
    Misses(f64),
    /// Rounding may have changed a sign of the model itself.
    CannotTell,
}

/// A spring, a dashpot or both, between the ends of a form.
struct Link {
    form: Form,
    stiffness: f64,
    damping: f64,
}

/// A mass that moves with a form.
struct Inertia {
    form: Form,
    mass: DoubleDouble,
}

/// A beam between two points: `[Y, Θ]` at both.
#[derive(Clone)]
struct BeamEnds {
    ends: [Form; 4],
    length: f64,
    bending_stiffness: f64,
    mass_per_length: f64,
}

/// The degrees of freedom of a tree and what joins them.
pub(crate) struct Stiffness {
    size: usize,
    links: Vec<Link>,
    masses: Vec<Inertia>,
    beams: Vec<BeamEnds>,
    /// Whether a displacement is held by two constraints of which one follows from the others.
    pub(crate) is_held_twice: bool,
}

/// A symmetric matrix, and for each entry the sum of the sizes of what was added.
struct Assembled<S> {
    entries: Vec<Vec<S>>,
    sizes: Vec<Vec<f64>>,
}

impl<S: Field> Assembled<S> {
    fn zero(size: usize) -> Self {
        Assembled { entries: vec![vec![S::zero(); size]; size], sizes: vec![vec![0.0; size]; size] }
    }

    /// Adds `factor · a bᵀ`, where the rounding of the factor is that of a number of a `size`.
    fn add(&mut self, a: &Form, b: &Form, factor: S, size: f64) {
        for &(i, a) in a {
            for &(j, b) in b {
                let product = a * b;
                self.entries[i][j] += factor * S::of(product);
                self.sizes[i][j] += size * product.to_f64().abs();
            }
        }
    }
}

impl Stiffness {
    /// The model of a tree.
    pub(crate) fn of(tree: &Tree) -> Self {
        let parts = Parts::of(tree);
        let (independent, is_held_twice) = constraints::independent(parts.size, &parts.constraints);
        let reduced = |form: &Form| constraints::reduced(form, &independent);
        let link = |link: &Link| Link { form: reduced(&link.form), ..*link };
        let mass = |mass: &Inertia| Inertia { form: reduced(&mass.form), ..*mass };
        let beam = |beam: &BeamEnds| BeamEnds { ends: beam.ends.each_ref().map(reduced), ..*beam };
        Stiffness {
            size: independent.first().map_or(0, Vec::len),
            links: parts.links.iter().map(link).collect(),
            masses: parts.masses.iter().map(mass).collect(),
            beams: parts.beams.iter().map(beam).collect(),
            is_held_twice,
        }
    }

    /// The same, for a model that holds something twice and says no more than this one.
    #[allow(dead_code, reason = "not every test has such models")]
    pub(crate) fn held_twice(self) -> Self {
        Stiffness { is_held_twice: true, ..self }
    }

    /// The beams at a frequency, those of `is_cut` in two halves each: with every half's share of the matrix.
    fn pieces<S: Field>(
        &self,
        x: S,
        is_cut: impl Fn(&BeamMatrix<S>, usize) -> bool,
    ) -> (usize, Vec<(BeamEnds, BeamMatrix<S>)>) {
        let (mut size, mut pieces) = (self.size, Vec::new());
        for (index, beam) in self.beams.iter().enumerate() {
            let matrix = BeamMatrix::of(beam, x);
            if !is_cut(&matrix, index) {
                pieces.push((beam.clone(), matrix));
                continue;
            }
            let one = DoubleDouble::from(1.0);
            let middle = [vec![(size, one)], vec![(size + 1, one)]];
            size += 2;
            let [y, theta, y_out, theta_out] = beam.ends.clone();
            let half = BeamEnds { length: beam.length / 2.0, ..beam.clone() };
            let matrix = BeamMatrix::of(&half, x);
            let [y_middle, theta_middle] = middle;
            let ends = [y, theta, y_middle.clone(), theta_middle.clone()];
            pieces.push((BeamEnds { ends, ..half.clone() }, matrix));
            pieces.push((BeamEnds { ends: [y_middle, theta_middle, y_out, theta_out], ..half }, matrix));
        }
        (size, pieces)
    }

    /// The matrix of beams in pieces, links and masses.
    fn assembled<S: Field>(&self, x: S, size: usize, pieces: &[(BeamEnds, BeamMatrix<S>)]) -> Assembled<S> {
        let mut sum = Assembled::zero(size);
        for (beam, matrix) in pieces {
            for (i, a) in beam.ends.iter().enumerate() {
                for (j, b) in beam.ends.iter().enumerate() {
                    sum.add(a, b, matrix.entries[i][j], matrix.size(i, j));
                }
            }
        }
        for link in &self.links {
            let factor = S::of(DoubleDouble::from(link.stiffness)) + x.damping(link.damping);
            sum.add(&link.form, &link.form, factor, factor.size());
        }
        for inertia in &self.masses {
            let factor = x.lambda_squared() * S::of(inertia.mass);
            sum.add(&inertia.form, &inertia.form, factor, factor.size());
        }
        sum
    }

    /// Number of natural frequencies below ω, by Wittrick and Williams; `None` where rounding may have changed a sign.
    pub(crate) fn count_below(&self, omega: DoubleDouble) -> Option<u64> {
        // a beam that nearly vibrates with held ends is not a stiffness between them
        let (size, pieces) = self.pieces(omega, |matrix, _| matrix.is_near_a_pole());
        let held: Option<u64> = pieces.iter().map(|(_, matrix)| matrix.held_frequencies_below()).sum();
        let matrix = self.assembled(omega, size, &pieces);
        Some(held? + pivots::negative(matrix)?)
    }
}
