//! A tree as a dynamic stiffness matrix in double-double arithmetic: assembled by degrees of freedom, no transfer.
//!
//! Every beam has the textbook's matrix for a frequency; a rigid body is its mass at the mass centre and its inertia about
//! that, on displacements that are forms of those of its input end. Nothing cancels that does not in the model.

mod constraints;
mod freedoms;
mod intervals;
mod weights;
mod zeros;

use crate::stiffness_matrix::beam_matrix::{BeamMatrix, Field};
pub(crate) use crate::stiffness_matrix::discs::Verdict;
use crate::stiffness_matrix::{Assembled, Form, pivots};
use crate::support::tree::Tree;
use constraints::Independent;
use freedoms::{Parts, sum};
use mstmm::elements::Beam;
use mstmm::number::{DoubleDouble, Parameter};
use std::cell::RefCell;
use std::rc::Rc;

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

/// A beam between two points: `[Y, Θ]` at both, and what the output end is off a rigid continuation of the input.
#[derive(Clone)]
struct BeamEnds {
    ends: [Form; 4],
    bending: [Form; 2],
    beam: Beam<f64>,
}

/// Length, bending stiffness and mass per length.
fn parameters(beam: &Beam<f64>) -> [DoubleDouble; 3] {
    [beam.length, beam.bending_stiffness, beam.mass_per_length].map(DoubleDouble::from)
}

/// The degrees of freedom of a tree and what joins them.
pub(crate) struct Stiffness {
    parts: Parts,
    /// The last frequency at which the constraints were eliminated, and what was left.
    last: RefCell<Option<(f64, Rc<Reduced>)>>,
    /// Whether a displacement is held by two constraints of which one follows from the others.
    pub(crate) is_held_twice: bool,
}

/// The same in terms of independent degrees of freedom that suit a frequency.
struct Reduced {
    size: usize,
    links: Vec<Link>,
    masses: Vec<Inertia>,
    beams: Vec<BeamEnds>,
}

impl Stiffness {
    /// The model of a tree.
    pub(crate) fn of(tree: &Tree) -> Self {
        let parts = Parts::of(tree);
        let weights = vec![1.0; parts.weights.len()];
        let is_held_twice = Independent::of(&parts.constraints, &weights).is_held_twice;
        Stiffness { parts, last: RefCell::new(None), is_held_twice }
    }

    /// The same, for a model that holds something twice and says no more than this one.
    #[allow(dead_code, reason = "not every test has such models")]
    pub(crate) fn held_twice(self) -> Self {
        Stiffness { is_held_twice: true, ..self }
    }

    /// The model in terms of degrees of freedom that weigh most at a frequency, or did at one near by.
    fn at(&self, omega: f64) -> Rc<Reduced> {
        let mut last = self.last.borrow_mut();
        if let Some((other, reduced)) = &*last
            && (0.5..2.0).contains(&(omega / other))
        {
            return Rc::clone(reduced);
        }
        let reduced = Rc::new(self.reduced(omega));
        *last = Some((omega, Rc::clone(&reduced)));
        reduced
    }

    fn reduced(&self, omega: f64) -> Reduced {
        let Parts { weights, constraints, links, masses, beams } = &self.parts;
        let weights: Vec<f64> = weights.iter().map(|weight| weight.at(omega)).collect();
        let independent = Independent::of(constraints, &weights);
        let reduced = |form: &Form| independent.reduced(form);
        let link = |link: &Link| Link { form: reduced(&link.form), ..*link };
        let mass = |mass: &Inertia| Inertia { form: reduced(&mass.form), ..*mass };
        let beam = |beam: &BeamEnds| BeamEnds {
            ends: beam.ends.each_ref().map(reduced),
            bending: beam.bending.each_ref().map(reduced),
            ..*beam
        };
        Reduced {
            size: independent.size,
            links: links.iter().map(link).collect(),
            masses: masses.iter().map(mass).collect(),
            beams: beams.iter().map(beam).collect(),
        }
    }

    /// Number of natural frequencies below ω, by Wittrick and Williams; `None` where rounding may have changed a sign.
    pub(crate) fn count_below(&self, omega: DoubleDouble) -> Option<u64> {
        let model = self.at(omega.to_f64());
        // a beam that nearly vibrates with held ends is not a stiffness between them
        let (size, pieces) = model.pieces(omega, |matrix, _| matrix.is_near_a_pole());
        let held: Option<u64> = pieces.iter().map(|(_, matrix)| matrix.held_frequencies_below()).sum();
        Some(held? + pivots::negative(&model.assembled(omega, size, &pieces))?)
    }
}

impl Reduced {
    /// The beams at a frequency, those of `is_cut` in two halves each: with every half's share of the matrix.
    fn pieces<S: Field>(
        &self,
        x: S,
        is_cut: impl Fn(&BeamMatrix<S>, usize) -> bool,
    ) -> (usize, Vec<(BeamEnds, BeamMatrix<S>)>) {
        let (mut size, mut pieces) = (self.size, Vec::new());
        for (index, beam) in self.beams.iter().enumerate() {
            let matrix = BeamMatrix::of(parameters(&beam.beam), x);
            if !is_cut(&matrix, index) {
                pieces.push((beam.clone(), matrix));
                continue;
            }
            let one = DoubleDouble::from(1.0);
            let (y_middle, theta_middle) = (vec![(size, one)], vec![(size + 1, one)]);
            size += 2;
            let half = Beam { length: beam.beam.length / 2.0, ..beam.beam };
            let matrix = BeamMatrix::of(parameters(&half), x);
            let [y, theta, y_out, theta_out] = beam.ends.clone();
            for ends in [[y, theta, y_middle.clone(), theta_middle.clone()], [y_middle, theta_middle, y_out, theta_out]]
            {
                let [y, theta, y_out, theta_out] = &ends;
                let rigid = sum(y, half.length, theta);
                let bending = [sum(y_out, -1.0, &rigid), sum(theta_out, -1.0, theta)];
                pieces.push((BeamEnds { ends, bending, beam: half }, matrix));
            }
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
            for (a, row) in beam.bending.iter().zip(matrix.bending.iter().flatten()) {
                for (b, entry) in beam.bending.iter().zip(row) {
                    sum.add(a, b, S::of(*entry), entry.to_f64().abs());
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
}
