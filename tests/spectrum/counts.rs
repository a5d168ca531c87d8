//! The count below a frequency, asked for in one place by the tests that attack it.

use mstmm::search::{NaturalFrequencies, Undamped};
use mstmm::search::{SearchError, System};

/// Number of natural frequencies below ω, or why there is none.
pub(crate) fn count_below<Y>(system: &Y, omega: f64) -> Result<u64, SearchError>
where
    Y: System<Parameter = f64> + Undamped + ?Sized,
{
    system.count_below(omega)
}
