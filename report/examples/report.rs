//! `cargo run --release --example report`

fn main() {}
