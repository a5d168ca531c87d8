//! Natural frequencies of a structure counted by its dynamic stiffness matrix in double-double arithmetic.
//!
//! All displacements are forms of one list of unknowns: those of the nodes that are free, and one for each released
//! displacement of an end. Wittrick and Williams count the negative eigenvalues of the matrix and the frequencies of
//! the members with held ends.

mod complex;
mod global_matrix;
mod kinematics;
mod monotony;
mod response;
mod rod;
mod roots;

use crate::stiffness_matrix::Form;
use crate::structure::Structure;
use global_matrix::GlobalMatrix;
use mstmm::number::DoubleDouble;
use rod::Rod;

/// A spring between the ends of a form; of a dashpot, its damping.
#[derive(Debug)]
struct Link {
    form: Form,
    stiffness: DoubleDouble,
}

/// A mass that moves with a form.
#[derive(Debug)]
struct Inertia {
    form: Form,
    mass: DoubleDouble,
}

/// The bending of a member: `[Y, Θ]` at both ends, and its length, bending stiffness and mass per length.
#[derive(Debug)]
struct Bending {
    ends: [Form; 4],
    parameters: [DoubleDouble; 3],
}

/// A structure as forms of unknowns, and what joins them.
#[derive(Debug, Default)]
pub(crate) struct Oracle {
    unknowns: usize,
    links: Vec<Link>,
    dashpots: Vec<Link>,
    masses: Vec<Inertia>,
    bendings: Vec<Bending>,
    rods: Vec<Rod>,
    /// The displacements x, y and the rotation of each node.
    nodes: Vec<[Form; 3]>,
}

fn double(value: f64) -> DoubleDouble {
    DoubleDouble::from(value)
}

impl Oracle {
    /// The model of a structure without dashpots.
    pub(crate) fn of(structure: &Structure) -> Self {
        let model = kinematics::model(structure);
        assert!(model.dashpots.is_empty(), "a damped structure has no natural frequencies");
        model
    }

    /// The model of a structure with dashpots.
    pub(crate) fn damped(structure: &Structure) -> Self {
        kinematics::model(structure)
    }

    /// Number of natural frequencies below ω, with repetition; `None` where rounding may have changed the sign of a pivot.
    ///
    /// A second form takes over where stiffnesses differ so much that rounding hides the soft ones: the forces of springs and
    /// members are unknowns there, and flexibilities stand in the matrix.
    pub(crate) fn count_below(&self, omega: DoubleDouble) -> Option<u64> {
        [false, true].into_iter().find_map(|with_forces| self.counted(omega, with_forces))
    }

    /// The same in both forms: with stiffnesses alone, and with forces.
    pub(crate) fn counts(&self, omega: DoubleDouble) -> [Option<u64>; 2] {
        [false, true].map(|with_forces| self.counted(omega, with_forces))
    }

    fn counted(&self, omega: DoubleDouble, with_forces: bool) -> Option<u64> {
        let mut matrix = GlobalMatrix::new(self.unknowns, with_forces);
        for Link { form, stiffness } in &self.links {
            matrix.spring(form, *stiffness);
        }
        for Inertia { form, mass } in &self.masses {
            matrix.mass(form, *mass, omega);
        }
        for Bending { ends, parameters } in &self.bendings {
            matrix.bending(ends, *parameters, omega)?;
        }
        for rod in &self.rods {
            rod.add_to(&mut matrix, omega);
        }
        matrix.count()
    }
}
