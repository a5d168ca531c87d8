//! The names of the units of a drawing.

use crate::diagram::Force;

/// The names of the unit of force and of that of length, in which the numbers of a model are.
#[derive(Clone, Debug)]
pub(crate) struct Units {
    pub(crate) force: String,
    pub(crate) length: String,
}

impl Default for Units {
    fn default() -> Self {
        Units { force: String::from("N"), length: String::from("m") }
    }
}

impl Units {
    /// Of a moment.
    pub(crate) fn moment(&self) -> String {
        format!("{} {}", self.force, self.length)
    }

    /// Of a load along a member.
    pub(crate) fn per_length(&self) -> String {
        format!("{}/{}", self.force, self.length)
    }

    /// Of an acceleration.
    pub(crate) fn acceleration(&self) -> String {
        format!("{}/s²", self.length)
    }

    /// Of an internal force.
    pub(crate) fn of(&self, force: Force) -> String {
        match force {
            Force::Axial | Force::Shear => self.force.clone(),
            Force::Moment | Force::Torque => self.moment(),
        }
    }
}
