//! Results find room in a list, or the search says for how many there is.

use crate::model::SearchError;
use crate::number::Store;

/// Adds a result to a list.
#[inline]
pub(crate) fn add<V>(list: &mut impl Store<V>, result: V) -> Result<(), SearchError> {
    list.append(result).map_err(|_| SearchError::Capacity { capacity: list.len() })
}
