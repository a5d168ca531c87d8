//! Rules that need the states of paths, where the macro knows them all.

use crate::diagnostics::Errors;
use crate::plan::Plan;

/// Checks that states fit at each step of the plan. Where elements are the user's own, whose states the compiler alone knows, it does that.
pub(crate) fn states(plan: &Plan<'_>) -> syn::Result<()> {
    let mut errors = Errors::default();
    if !plan.has_own_types() {
        for (step, misfit) in plan.misfits() {
            errors.push(step.place(), misfit);
        }
    }
    errors.propagate()
}
