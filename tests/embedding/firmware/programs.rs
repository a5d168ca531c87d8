//! The programs of tests/firmware: built once, run, and read.

use object::{Object, ObjectSection, ObjectSymbol};
use serde_json::Value as Json;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::LazyLock;

/// The programs by name.
pub(crate) static PROGRAMS: LazyLock<BTreeMap<String, Program>> = LazyLock::new(built);

/// A program that has been built.
pub(crate) struct Program {
    path: PathBuf,
}

/// Sizes of a program's sections, in bytes.
pub(crate) struct Size {
    pub(crate) code: u64,
    pub(crate) constants: u64,
}

/// Builds in release, with the features and versions that the programs name, beside the results of other builds.
fn built() -> BTreeMap<String, Program> {
    let output = Command::new(env!("CARGO"))
        .args(["build", "--release", "--locked", "--message-format=json", "--manifest-path"])
        .arg(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/firmware/Cargo.toml"))
        .args(["--target-dir", concat!(env!("CARGO_TARGET_TMPDIR"), "/firmware")])
        .stderr(Stdio::inherit())
        .output()
        .unwrap();
    assert!(output.status.success(), "the programs do not compile: {}", output.status);
    let messages = String::from_utf8(output.stdout).unwrap();
    let messages = messages.lines().map(|line| serde_json::from_str::<Json>(line).unwrap());
    let program = |message: Json| {
        let path = PathBuf::from(message["executable"].as_str()?);
        Some((message["target"]["name"].as_str()?.to_owned(), Program { path }))
    };
    messages.filter_map(program).collect()
}

impl Program {
    /// Runs it; the numbers that it sends.
    pub(crate) fn sent(&self) -> Vec<f64> {
        let output = Command::new(&self.path).output().unwrap();
        assert!(output.status.success(), "{}: {}", self.path.display(), output.status);
        let (numbers, rest) = output.stdout.as_chunks::<8>();
        assert!(rest.is_empty(), "{rest:?}");
        numbers.iter().copied().map(f64::from_le_bytes).collect()
    }

    /// Names that it defines or imports.
    pub(crate) fn symbols(&self) -> Vec<String> {
        self.read(|file| {
            let symbols = file.symbols().chain(file.dynamic_symbols());
            symbols.map(|symbol| symbol.name().unwrap().to_owned()).collect()
        })
    }

    /// What a processor would have to keep, without the tables for debuggers and for the dynamic linker of a host.
    pub(crate) fn size(&self) -> Size {
        self.read(|file| {
            let size = |name| file.section_by_name(name).map_or(0, |section| section.size());
            Size { code: size(".text"), constants: size(".rodata") + size(".data.rel.ro") + size(".data") }
        })
    }

    fn read<R>(&self, reading: impl FnOnce(&object::File<'_>) -> R) -> R {
        let bytes = std::fs::read(&self.path).unwrap();
        reading(&object::File::parse(bytes.as_slice()).unwrap())
    }
}
