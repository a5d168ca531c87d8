//! What can go wrong while the report is made.

use plotters::drawing::DrawingAreaErrorKind;
use std::io;

/// Why there is no report.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A picture cannot be drawn.
    #[error("a picture cannot be drawn: {0}")]
    Drawing(#[from] DrawingAreaErrorKind<io::Error>),
    /// A system or its mode cannot be drawn.
    #[error(transparent)]
    Sketch(#[from] mstmm_drawing::DrawingError),
    /// A height field has no contours.
    #[error("contours: {0}")]
    Contours(#[from] contour::Error),
    /// A model of the report is refused.
    #[error(transparent)]
    Parameter(#[from] mstmm::element::ParameterError),
    /// A list of steps is refused.
    #[error(transparent)]
    List(#[from] mstmm::list::ListError),
    /// A frame is refused.
    #[error(transparent)]
    Network(#[from] mstmm::network::NetworkError),
    /// Other programs cannot be measured.
    #[error(transparent)]
    Frames(#[from] frames_beside::BesideError),
    /// A search fails.
    #[error(transparent)]
    Search(#[from] mstmm::search::SearchError),
    /// A mode has no shape.
    #[error(transparent)]
    Energies(#[from] mstmm::motion::MotionError),
    /// The paper's data cannot be read or its examples not be solved.
    #[error("the paper's examples: {0}")]
    Paper(Box<dyn std::error::Error>),
    /// |Δ| has too few finite values for a trend.
    #[error("|Δ| has too few finite values for a trend")]
    NoTrend,
    /// A method without a place in the legend.
    #[error("the report has no style for the method `{0}`")]
    UnknownMethod(String),
    /// A text without the comments between which its table belongs.
    #[error("`{0}` is not in the text")]
    NoMarker(&'static str),
}
