//! The scenes as finite elements see them, from the same parameters as the transfer matrices.

use crate::structure::Matrix::{Damping, Mass, Stiffness};
use crate::structure::{FIXED, Lumped, Node, Span, Structure, free, pinned};
use paper::models::{DampedOscillator, RestrainedBeam, SpringAndMass, TipBody, TwoSpans};

/// Beams of equal section from the positions of their nodes.
fn spans(section: [f64; 2], positions: &[f64], nodes: &[Node]) -> Vec<Span> {
    let [bending_stiffness, mass_per_length] = section;
    let span = |(ends, nodes): (&[f64], &[Node])| Span {
        length: ends[1] - ends[0],
        bending_stiffness,
        mass_per_length,
        nodes: [nodes[0], nodes[1]],
    };
    positions.windows(2).zip(nodes.windows(2)).map(span).collect()
}

/// Section 4.1.
pub(super) fn tip_body(m: &TipBody) -> Structure {
    Structure {
        spans: spans([m.bending_stiffness, m.mass_per_length], &[0.0, m.length], &[FIXED, free(0)]),
        lumped: Lumped::body(0, m.mass, m.inertia, m.eccentricity).to_vec(),
    }
}

/// Section 4.2.
pub(super) fn restrained_beam(m: &RestrainedBeam) -> Structure {
    Structure {
        spans: spans([m.bending_stiffness, m.mass_per_length], &[0.0, m.length], &[free(0), free(2)]),
        lumped: vec![
            Lumped::at(Stiffness, 0, m.left_stiffness),
            Lumped::at(Stiffness, 1, m.left_torsion),
            Lumped::at(Stiffness, 2, m.right_stiffness),
            Lumped::at(Stiffness, 3, m.right_torsion),
        ],
    }
}

/// Section 4.3.
pub(super) fn spring_and_mass(m: &SpringAndMass) -> Structure {
    Structure {
        spans: spans(
            [m.bending_stiffness, m.mass_per_length],
            &[0.0, m.spring_position, m.mass_position, m.length],
            &[pinned(0), free(1), free(3), pinned(5)],
        ),
        lumped: vec![Lumped::at(Stiffness, 1, m.stiffness), Lumped::at(Mass, 3, m.mass)],
    }
}

/// Section 4.4.
pub(super) fn two_spans(m: &TwoSpans) -> Structure {
    Structure {
        spans: spans(
            [m.bending_stiffness, m.mass_per_length],
            &[0.0, m.support_position, m.spring_position, m.length],
            &[pinned(0), pinned(1), free(2), pinned(4)],
        ),
        lumped: vec![Lumped::between(Stiffness, [2, 5], m.stiffness), Lumped::at(Mass, 5, m.mass)],
    }
}

/// Section 4.5.
pub(super) fn damped_oscillator(m: &DampedOscillator) -> Structure {
    Structure {
        spans: spans(
            [m.bending_stiffness, m.mass_per_length],
            &[0.0, m.spring_position, m.oscillator_position, m.torsion_position, m.length],
            &[pinned(0), free(1), free(3), free(5), pinned(7)],
        ),
        lumped: vec![
            Lumped::at(Stiffness, 1, m.spring_stiffness),
            Lumped::between(Stiffness, [3, 8], m.oscillator_stiffness),
            Lumped::between(Damping, [3, 8], m.damping),
            Lumped::at(Mass, 8, m.mass),
            Lumped::at(Stiffness, 6, m.torsion_stiffness),
        ],
    }
}

/// One beam of EI = m = l = 1, clamped and free.
pub(super) fn cantilever() -> Structure {
    Structure { spans: spans([1.0, 1.0], &[0.0, 1.0], &[FIXED, free(0)]), lumped: Vec::new() }
}

/// Two of them, their tips joined by a spring.
pub(super) fn twins(stiffness: f64) -> Structure {
    let mut beams = cantilever().spans;
    beams.extend(spans([1.0, 1.0], &[0.0, 1.0], &[FIXED, free(2)]));
    Structure { spans: beams, lumped: vec![Lumped::between(Stiffness, [0, 2], stiffness)] }
}

/// Four beams of length 1, soft and stiff in turn.
pub(super) fn soft_and_stiff(stiff: f64) -> Structure {
    let nodes = [FIXED, free(0), free(2), free(4), free(6)];
    let mut beams = spans([1.0, 1.0], &[0.0, 1.0, 2.0, 3.0, 4.0], &nodes);
    beams.iter_mut().skip(1).step_by(2).for_each(|beam| beam.bending_stiffness = stiff);
    Structure { spans: beams, lumped: Vec::new() }
}
