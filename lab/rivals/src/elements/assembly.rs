//! Stiffness, damping and mass matrix of a structure.

use super::reference::Entry;
use super::skyline::Skyline;
use crate::structure::{Matrix, Structure};
use std::collections::BTreeMap;

/// `(λ²M + λC + K) q = 0`.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrices {
    /// K
    pub stiffness: Skyline,
    /// C; `None` without dashpots.
    pub damping: Option<Skyline>,
    /// M
    pub mass: Skyline,
}

/// An entry of the lower triangle.
struct Term {
    matrix: Matrix,
    place: [usize; 2],
    value: f64,
}

/// Rows of all unknowns. Bubbles go before the nodes of their beam, high degrees first: they couple with few others.
struct Rows {
    nodal: BTreeMap<usize, usize>,
    /// Row of the bubble of degree 3 + bubbles of each span; lower degrees follow.
    bubbles: Vec<usize>,
    size: usize,
}

impl Rows {
    fn new(structure: &Structure, bubbles_per_span: usize) -> Self {
        let mut rows = Rows { nodal: BTreeMap::new(), bubbles: Vec::new(), size: 0 };
        for span in &structure.spans {
            rows.bubbles.push(rows.size);
            rows.size += bubbles_per_span;
            for unknown in span.nodes.into_iter().flatten().flatten() {
                rows.number(unknown);
                // what hangs on a node follows it
                let forms = structure.lumped.iter().filter(|form| form.factors.iter().any(|pair| pair.0 == unknown));
                forms.flat_map(|form| &form.factors).for_each(|pair| rows.number(pair.0));
            }
        }
        rows
    }

    fn number(&mut self, unknown: usize) {
        let next = self.size;
        if *self.nodal.entry(unknown).or_insert(next) == next {
            self.size += 1;
        }
    }
}

/// The matrices of a structure, with shape functions from `reference(degree)`.
pub fn assembled(structure: &Structure, degree: usize, reference: &[Entry]) -> Matrices {
    let rows = Rows::new(structure, degree - 3);
    let mut terms = beam_terms(structure, degree, reference, &rows);
    for form in &structure.lumped {
        for a in &form.factors {
            for b in &form.factors {
                let place = [rows.nodal[&a.0], rows.nodal[&b.0]];
                terms.push(Term { matrix: form.matrix, place, value: form.value * a.1 * b.1 });
            }
        }
    }
    terms.retain(|term| term.place[0] >= term.place[1]);
    let mut first: Vec<usize> = (0..rows.size).collect();
    for Term { place: [row, column], .. } in &terms {
        first[*row] = first[*row].min(*column);
    }
    let sum = |matrix: Matrix| {
        let mut sum = Skyline::zeros(first.clone());
        terms.iter().filter(|term| term.matrix == matrix).for_each(|t| sum.add(t.place[0], t.place[1], t.value));
        sum
    };
    let is_damped = terms.iter().any(|term| term.matrix == Matrix::Damping);
    Matrices {
        stiffness: sum(Matrix::Stiffness),
        damping: is_damped.then(|| sum(Matrix::Damping)),
        mass: sum(Matrix::Mass),
    }
}

/// Entries of the beams: with `x = l (1 + ξ)/2` stiffness is `8 EI/l³`, mass `m l/2` times the reference, slopes `l/2`.
fn beam_terms(structure: &Structure, degree: usize, reference: &[Entry], rows: &Rows) -> Vec<Term> {
    let mut terms = Vec::new();
    for (span, bubbles) in structure.spans.iter().zip(&rows.bubbles) {
        let half = span.length / 2.0;
        let row = |shape: usize| match shape {
            0..4 => span.nodes[shape / 2][shape % 2].map(|unknown| rows.nodal[&unknown]),
            _ => Some(bubbles + degree - shape),
        };
        let scale = |shape: usize| if shape < 4 && shape % 2 == 1 { half } else { 1.0 };
        for entry in reference {
            let [Some(a), Some(b)] = entry.pair.map(row) else { continue };
            let factor = scale(entry.pair[0]) * scale(entry.pair[1]);
            let place = [a.max(b), a.min(b)];
            let stiffness = factor * entry.stiffness * span.bending_stiffness / half.powi(3);
            let mass = factor * entry.mass * span.mass_per_length * half;
            // a zero widens the profile for nothing
            let values = [(Matrix::Stiffness, stiffness), (Matrix::Mass, mass)];
            terms.extend(values.iter().filter(|v| v.1 != 0.0).map(|&(matrix, value)| Term { matrix, place, value }));
        }
    }
    terms
}
