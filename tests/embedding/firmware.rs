//! Programs without `std` and without `alloc`, in a crate of their own with mstmm under another name: they build a
//! model, hold the system in a struct, and send what they certify.
//!
//! `cargo test --test embedding firmware -- --ignored --nocapture` prints the sizes of their code.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

#[path = "../firmware/src/damped.rs"]
pub mod damped;
#[path = "../paper/decimal.rs"]
mod decimal;
mod programs;
#[path = "../firmware/src/undamped.rs"]
pub mod undamped;

use programs::PROGRAMS;
use serde_json::Value as Json;
use std::collections::BTreeSet;

/// Exact values of the first quantity of that name.
fn exact(example: &str, quantity: &str) -> Vec<Json> {
    let data: Json = serde_json::from_str(include_str!("../data/paper.json")).unwrap();
    let is_meant = |entry: &&Json, key: &str, text: &str| entry[key].as_str().unwrap().starts_with(text);
    let example = data["examples"].as_array().unwrap().iter().find(|entry| is_meant(entry, "id", example)).unwrap();
    let values = example["values"].as_array().unwrap();
    let values = values.iter().find(|entry| is_meant(entry, "quantity", quantity)).unwrap();
    values["exact"].as_array().unwrap().clone()
}

/// Oracle: the exact values of Table 2, which no transfer matrix has seen, digit by digit.
#[test]
#[ignore = "long: .ci/long, on Linux"]
fn frequencies_certified_without_std_are_the_exact_ones() {
    let sent = PROGRAMS["undamped"].sent();
    let intervals: Vec<_> = sent.as_chunks::<2>().0.iter().collect();
    let exact = exact("4.1a", "Omega");
    assert_eq!((intervals.len(), sent.len()), (exact.len(), 2 * exact.len()), "{sent:?}");
    for (&&[lower, upper], exact) in intervals.iter().zip(&exact) {
        assert!(decimal::is_within(exact.as_str().unwrap(), lower, upper), "{exact} in {lower:e}..{upper:e}");
        assert!(upper - lower < 1e-14 * upper, "{lower:e}..{upper:e} is wide");
    }
}

/// Oracle: the exact values of Table 6.
#[test]
#[ignore = "long: .ci/long, on Linux"]
fn eigenvalues_certified_without_std_are_the_exact_ones() {
    let sent = PROGRAMS["damped"].sent();
    let circles = sent.as_chunks::<3>().0;
    let exact = exact("4.5", "lambda");
    assert_eq!((circles.len(), sent.len()), (exact.len(), 3 * exact.len()), "{sent:?}");
    for (&[re, im, radius], exact) in circles.iter().zip(&exact) {
        let [exact_re, exact_im] = [0, 1].map(|part| exact[part].as_str().unwrap().parse::<f64>().unwrap());
        let distance = (re - exact_re).hypot(im - exact_im);
        assert!(distance <= radius, "{exact} is {distance:e} away from {re} + {im}i, circle {radius:e}");
        assert!(radius < 1e-14 * im.abs(), "{radius:e} around {re} + {im}i is wide");
    }
}

/// Oracle: the same controllers with `std`, whose functions are not those of `libm`. Beams at a real frequency need
/// neither, but for square roots.
#[test]
#[ignore = "long: .ci/long, on Linux"]
fn std_and_libm_agree() {
    let frequencies = undamped::Controller::new(undamped::LIGHT).unwrap().modes().unwrap();
    let sent = PROGRAMS["undamped"].sent();
    assert_eq!(sent.len(), 2 * frequencies.len());
    // an interval may be as narrow as two neighbouring numbers, of which the frequency is one: so it need not hold the middle of a wider one
    for (&[lower, upper], mode) in sent.as_chunks::<2>().0.iter().zip(&frequencies) {
        assert!(lower <= mode.omega && mode.omega <= upper, "{} is not in {lower}..={upper}", mode.omega);
        assert!(lower <= mode.upper && mode.lower <= upper, "{mode:?} and {lower}..={upper}");
        assert!(upper - lower < 1e-14 * lower, "{lower}..={upper} is wide");
    }

    let eigenvalues = damped::Controller::new(damped::PAPER).unwrap().modes().unwrap();
    for (&[re, im, radius], mode) in PROGRAMS["damped"].sent().as_chunks::<3>().0.iter().zip(&eigenvalues) {
        let distance = (re - mode.lambda.re).hypot(im - mode.lambda.im);
        assert!(distance <= radius + mode.error, "{re} + {im}i is {distance:e} away from {}", mode.lambda);
    }
}

/// The symbol table is there to be read (`main`), and holds neither Rust's allocator, nor C's, nor the formatting of
/// messages, which is larger than a search.
#[test]
#[ignore = "long: .ci/long, on Linux"]
fn no_program_knows_an_allocator_or_formats() {
    let unwanted = ["alloc", "4core3fmt", "__rust", "3std"];
    for (name, program) in PROGRAMS.iter() {
        let symbols = program.symbols();
        assert!(symbols.iter().any(|symbol| symbol == "main"), "{name}: {symbols:?}");
        let found: Vec<_> = symbols.iter().filter(|symbol| unwanted.iter().any(|part| symbol.contains(part))).collect();
        assert!(found.is_empty(), "{name}: {found:?}");
    }
}

/// Prints the model's own share: what the start-up and the way out of results take is in each program.
#[test]
#[ignore = "long: .ci/long, on Linux"]
fn a_model_with_its_search_takes_less_than_64_kib() {
    let start_up = PROGRAMS["empty"].size();
    println!("{:8} {:>12} {:>17}", "program", "code [bytes]", "constants [bytes]");
    for name in ["undamped", "damped"] {
        let size = PROGRAMS[name].size();
        let [code, constants] = [size.code - start_up.code, size.constants - start_up.constants];
        println!("{name:8} {code:>12} {constants:>17}");
        assert!(code + constants < 64 * 1024, "{name}");
    }
}

/// Name, version and checksum of each package of a lock file.
fn locked(file: &str) -> BTreeSet<Vec<&str>> {
    let is_identity = |line: &&str| ["name", "version", "checksum"].contains(&line.split(" = ").next().unwrap());
    file.split("[[package]]").skip(1).map(|package| package.lines().filter(is_identity).collect()).collect()
}

/// The programs are built of what the workspace was tested with, and nothing else is downloaded.
#[test]
fn the_programs_and_the_workspace_lock_the_same_versions() {
    let (programs, workspace) =
        (locked(include_str!("../firmware/Cargo.lock")), locked(include_str!("../../Cargo.lock")));
    let others: Vec<_> = programs.difference(&workspace).collect();
    assert_eq!(others, [&["name = \"firmware\"", "version = \"0.1.0\""]]);
}
