//! Mode shapes, judged by laws, quadratures and closed forms of their own.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]
#![expect(clippy::panic, reason = "the same")]

#[path = "mode_shapes/checks.rs"]
mod checks;
#[path = "mode_shapes/closed_forms.rs"]
mod closed_forms;
#[path = "mode_shapes/energy.rs"]
mod energy;
#[path = "mode_shapes/errors.rs"]
mod errors;
#[path = "mode_shapes/long.rs"]
mod long;
#[path = "mode_shapes/models.rs"]
mod models;
#[path = "mode_shapes/multiple.rs"]
mod multiple;
#[path = "mode_shapes/nodes.rs"]
mod nodes;
#[path = "mode_shapes/paper.rs"]
mod paper;
#[path = "mode_shapes/parts.rs"]
mod parts;
#[path = "mode_shapes/random.rs"]
mod random;
#[path = "support/damped_models.rs"]
#[allow(unused_macros, unused_imports, reason = "the shapes go through the models by name")]
mod random_damped;
#[path = "support/undamped_models.rs"]
#[allow(unused_macros, unused_imports, reason = "the same")]
mod random_undamped;
#[path = "mode_shapes/recorded.rs"]
mod recorded;
#[path = "mode_shapes/residuals.rs"]
mod residuals;
#[path = "mode_shapes/single_beams.rs"]
mod single_beams;
#[path = "mode_shapes/sketch.rs"]
mod sketch;
#[path = "mode_shapes/varied.rs"]
mod varied;
#[path = "mode_shapes/waves.rs"]
mod waves;

use ::paper::models as paper_models;
