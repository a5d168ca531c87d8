//! Error against run time, as a page that can be looked at.
