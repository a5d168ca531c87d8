//! The shapes and receptances of tests/data/frames.json.
