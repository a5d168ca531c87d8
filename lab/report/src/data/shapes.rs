//! Drawings of the systems, and of the modes that the paper lists.

use crate::error::ReportError;
use frames_beside::steel;
use mstmm::prelude::*;
use mstmm_drawing::Drawing;
use paper::models::*;
use rivals::scenes::extremes::{FreeFixed, SoftAndStiff, Twins};
use rivals::scenes::{STIFF, WEAK};

/// A system as it is drawn.
#[derive(Clone, Debug)]
pub(crate) struct System {
    /// Its scene.
    pub(crate) id: &'static str,
    pub(crate) svg: String,
}

/// The modes of an example that the paper lists.
#[derive(Clone, Debug)]
pub(crate) struct Shapes {
    pub(crate) id: &'static str,
    pub(crate) modes: Vec<Mode>,
}

/// A mode over its system.
#[derive(Clone, Debug)]
pub(crate) struct Mode {
    /// Its frequency or eigenvalue.
    pub(crate) name: String,
    pub(crate) svg: String,
}

/// All systems of the scenes.
pub(crate) fn systems() -> Result<Vec<System>, ReportError> {
    macro_rules! drawn {
        ($($id:literal $model:expr),* $(,)?) => {
            vec![$(System { id: $id, svg: Drawing::of(&$model.build()?)?.to_string() }),*]
        };
    }
    Ok(drawn![
        "4.1a" light_tip_body(),
        "4.1b" heavy_tip_body(),
        "4.2" restrained_beam(),
        "4.3" spring_and_mass(),
        "4.4" two_spans(),
        "4.5" damped_oscillator(),
        "mode 100" FreeFixed {},
        "close pair" Twins { stiffness: WEAK },
        "stiff" SoftAndStiff { stiff: STIFF },
    ])
}

/// The modes of a system: a macro, since each system is a type of its own.
macro_rules! modes {
    ($id:literal, $model:expr, $roots:ident::<$count:literal>, $name:expr) => {{
        let system = $model.build()?;
        let mut modes = Vec::new();
        for root in &system.$roots::<$count>()? {
            let svg = Drawing::of(&system)?.mode(&system.mode_shape(root)?)?.to_string();
            modes.push(Mode { name: $name(root), svg });
        }
        Shapes { id: $id, modes }
    }};
}

/// Those of the paper's examples.
pub(crate) fn shapes() -> Result<Vec<Shapes>, ReportError> {
    Ok(vec![
        modes!("4.1a", light_tip_body(), first_frequencies::<5>, frequency),
        modes!("4.1b", heavy_tip_body(), first_frequencies::<5>, frequency),
        modes!("4.2", restrained_beam(), first_frequencies::<3>, frequency),
        modes!("4.3", spring_and_mass(), first_frequencies::<3>, frequency),
        modes!("4.4", two_spans(), first_frequencies::<5>, frequency),
        modes!("4.5", damped_oscillator(), first_eigenvalues::<5>, eigenvalue),
    ])
}

/// The portal's first four modes.
pub(crate) fn of_portal() -> Result<Shapes, ReportError> {
    Ok(modes!("portal", steel(), first_frequencies::<4>, hertz))
}

fn frequency(root: &NaturalFrequency) -> String {
    format!("{:.2} rad/s", root.omega)
}

fn hertz(root: &NaturalFrequency) -> String {
    format!("{:.2} Hz", root.hertz())
}

fn eigenvalue(root: &Eigenvalue) -> String {
    format!("{:.1} + {:.1}i 1/s", root.lambda.re, root.lambda.im).replace('-', "−")
}
