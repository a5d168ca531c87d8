//! The portal by this library and by programs of finite elements.

use crate::error::ReportError;
use frames_beside::{Figures, measure};

/// Figures of one machine and hour, never some of one and some of another.
#[derive(Clone, Debug)]
pub(crate) struct Frames {
    pub(crate) figures: Figures,
    /// What is not on this machine, so that the figures are those of the repository; nothing where all was measured now.
    pub(crate) missing: Vec<String>,
}

/// Those that are measured now where all programs are there, else the recorded ones.
pub(crate) fn frames(measures: bool) -> Result<Frames, ReportError> {
    let missing = if measures {
        let (figures, missing) = measure()?;
        if missing.is_empty() {
            return Ok(Frames { figures, missing: Vec::new() });
        }
        missing.into_iter().map(|program| program.0).collect()
    } else {
        vec!["nothing was measured".to_owned()]
    };
    let figures = Figures::recorded().map_err(frames_beside::BesideError::from)?;
    Ok(Frames { figures, missing })
}
