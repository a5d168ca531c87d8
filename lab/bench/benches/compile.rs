//! Time to expand and to compile models of 10, 100 and 500 elements, for a program that evaluates and searches them with
//! every scalar. Prints a Markdown table.
//!
//! `cargo bench --bench compile`. Each model is a crate of its own below the target directory, built as a user's would be,
//! with cargo's own release profile; the times are those of this last crate, its dependencies being built before. With
//! arguments, only models whose names contain one of them: `cargo bench --bench compile -- chain`.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, fs, io};

type Failure = Box<dyn core::error::Error>;

const SIZES: [usize; 3] = [10, 100, 500];

/// Rounds of an expansion; the least counts, since other work on the machine only ever adds.
const ROUNDS: usize = 3;

/// What writes the paths of a model of so many elements.
type Paths = fn(usize) -> String;

/// Each kind, and whether its program evaluates the overall determinant.
const KINDS: [(&str, Paths, bool); 3] =
    [("chain of distinct beams", chain, true), ("tree", tree, true), ("frame with loops", frame, false)];

fn beam(label: usize) -> String {
    format!("beam {label} {{ length: {label}.5 * length, bending_stiffness, mass_per_length }}")
}

/// Beams that all differ, one behind the other.
fn chain(elements: usize) -> String {
    let beams: Vec<String> = (0..elements).map(beam).collect();
    format!("fixed -> {} -> free;", beams.join(" -> "))
}

/// A beam that carries a grounded spring, a mass on a spring, a torsion spring and a body, as often as there are elements
/// for it: one element in five is a beam.
fn tree(elements: usize) -> String {
    let (mut trunk, mut branches) = (String::from("fixed"), String::new());
    for group in 0..elements / 5 {
        let (first, point) = (5 * group, format!("conn c{group}"));
        let _ = write!(
            trunk,
            " -> {} -> {point} -> body {} {{ mass, inertia: {group}.1 * mass, output_x: length, centre_x: 0.1 }}",
            beam(first),
            first + 1
        );
        let [spring, oscillator, tip] = [first + 2, first + 3, first + 4];
        let _ = writeln!(
            branches,
            "{point} <- spring {spring} {{ stiffness: {group}.2 * stiffness }} <- fixed;\n\
             {point} <- spring {oscillator} {{ stiffness: {group}.3 * stiffness }} <- mass {tip} {{ mass: {group}.4 * mass }} <- free;"
        );
    }
    format!("{trunk} -> free;\n{branches}")
}

/// A storey of two columns, a girder with a mass, and a brace, as often as there are elements for it.
fn frame(elements: usize) -> String {
    let mut paths = String::from("fixed -> conn a0 at (0.0, 0.0); fixed -> conn b0 at (length, 0.0);\n");
    for storey in 0..elements / 5 {
        let (first, above) = (5 * storey, storey + 1);
        let beam =
            |label: usize| format!("beam {label} {{ axial_stiffness: stiffness, bending_stiffness, mass_per_length }}");
        let [left, right, girder] = [0, 1, 2].map(|k| beam(first + k));
        let _ = writeln!(
            paths,
            "conn a{storey} -> {left} -> conn a{above} at (0.0, {above}.0 * length);\n\
             conn b{storey} -> {right} -> conn b{above} at (length, {above}.0 * length);\n\
             conn a{above} -> {girder} -> conn b{above};\n\
             conn a{storey} -> spring {} {{ stiffness: {storey}.2 * stiffness }} -> conn b{above};\n\
             conn b{above} -> point_mass {} {{ mass: {storey}.1 * mass }};",
            first + 3,
            first + 4,
        );
    }
    paths
}

/// What stands in `system!`.
fn model(paths: &str) -> String {
    let fields =
        ["length", "bending_stiffness", "mass_per_length", "mass", "stiffness"].map(|name| format!("{name}: f64"));
    format!("struct Model {{ {} }}\n{paths}", fields.join(", "))
}

/// A program that needs the model over f64, its dual numbers, double-double, its dual numbers, and complex numbers.
fn program(model: &str, has_matrix: bool) -> String {
    let matrix = "println!(\"{:?}\", system.overall_determinant(1.0));
    println!(\"{:?}\", system.overall_determinant(Complex::new(0.5, 1.0)));";
    let matrix = if has_matrix { matrix } else { "" };
    format!(
        "use mstmm::prelude::*;
system! {{ {model} }}
fn main() -> Result<(), Box<dyn std::error::Error>> {{
    let model = Model {{ length: 0.1, bending_stiffness: 1.0, mass_per_length: 1.0, mass: 1.0, stiffness: 1.0 }};
    let system = model.build()?;
    println!(\"{{}} below 1 rad/s\", system.count_below(1.0)?);
    println!(\"{{:?}}\", system.first_frequencies::<3>()?);
    println!(\"{{:?}}\", system.natural_frequencies::<64>(0.0..=1.0)?);
    println!(\"{{:?}}\", system.eigenvalues::<64>(Region {{ re: -1.0..=1.0, im: -1.0..=1.0 }})?);
    {matrix}
    Ok(())
}}
"
    )
}

/// Time of the expansion, optimised and outside the compiler.
fn expansion(model: &str) -> Result<Duration, Failure> {
    let input = format!("(::mstmm) {model}").parse::<proc_macro2::TokenStream>()?;
    let round = |_| {
        let start = Instant::now();
        std::hint::black_box(mstmm_language::expand(input.clone()));
        start.elapsed()
    };
    Ok((0..ROUNDS).map(round).min().unwrap_or_default())
}

/// A crate to measure; all share their dependencies.
struct Scratch {
    folder: PathBuf,
}

impl Scratch {
    fn new() -> io::Result<Self> {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("compile");
        fs::create_dir_all(folder.join("src"))?;
        let library = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");
        let manifest = format!(
            "[package]\nname = \"scratch\"\nedition = \"2024\"\n\n[workspace]\n\n[dependencies]\nmstmm = {{ path = {library:?} }}\n"
        );
        fs::write(folder.join("Cargo.toml"), manifest)?;
        fs::copy(Path::new(library).join("Cargo.lock"), folder.join("Cargo.lock"))?;
        Ok(Scratch { folder })
    }

    /// Time of a cargo command on a new version of the program.
    fn time(&self, command: &[&str], program: &str) -> Result<Duration, Failure> {
        fs::write(self.folder.join("src/main.rs"), program)?;
        let start = Instant::now();
        let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        // all is compiled, and in a target directory of its own
        let output = cargo
            .args(command)
            .args(["--offline", "--quiet"])
            .current_dir(&self.folder)
            .env_remove("CARGO_TARGET_DIR")
            .env("CARGO_INCREMENTAL", "0")
            .output()?;
        let time = start.elapsed();
        match output.status.success() {
            true => Ok(time),
            false => Err(String::from_utf8_lossy(&output.stderr).into()),
        }
    }
}

fn main() -> Result<(), Failure> {
    let wanted: Vec<String> = env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let scratch = Scratch::new()?;
    let commands: [&[&str]; 2] = [&["check"], &["build", "--release"]];
    for command in commands {
        scratch.time(command, "fn main() {}")?;
    }
    println!("| model | elements | expansion [ms] | `cargo check` [s] | `cargo build --release` [s] |");
    println!("|---|---|---|---|---|");
    for (name, paths, has_matrix) in KINDS {
        for size in SIZES {
            if !wanted.is_empty() && !wanted.iter().any(|wanted| format!("{name} {size}").contains(wanted)) {
                continue;
            }
            let model = model(&paths(size));
            let expansion = expansion(&model)?.as_secs_f64() * 1e3;
            let program = program(&model, has_matrix);
            print!("| {name} | {size} | {expansion:.1} |");
            for command in commands {
                let time = scratch.time(command, &program)?;
                print!(" {:.1} |", time.as_secs_f64());
            }
            println!();
        }
    }
    Ok(())
}
