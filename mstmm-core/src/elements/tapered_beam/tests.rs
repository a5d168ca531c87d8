//! The tapered beam.
