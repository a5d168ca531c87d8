//! Error against run time, and what else a picture tells better than a table: as a page that needs nothing but a browser.

mod axis;
mod canvas;
mod clock;
mod data;
mod error;
pub mod growth;
mod marker;
mod measurements;
mod method;
mod page;
mod palette;
mod placement;
mod plots;
mod readme;
mod scene;

pub use error::ReportError;
pub use measurements::{Extent, Measurements};
pub use page::{markdown, page};
pub use readme::{DOCUMENT, PICTURES, pictures, with_table};
