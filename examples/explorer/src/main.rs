//! Makes the page: compiles the library to WebAssembly, and writes it with all that the page is made of into one file.

use base64::{Engine, engine::general_purpose::STANDARD};
use flate2::{Compression, write::GzEncoder};
use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

const TARGET: &str = "wasm32-unknown-unknown";

/// What the page has in files of its own: its name in the page, and its text.
macro_rules! files {
    ($($name:literal),* $(,)?) => { [$(($name, include_str!(concat!("../page/", $name)))),*] };
}

const PAGE: &str = include_str!("../page/page.html");

const FILES: [(&str, &str); 11] = files![
    "style.css",
    "engine.js",
    "svg.js",
    "chart.js",
    "drawing.js",
    "response.js",
    "roots.js",
    "results.js",
    "controls.js",
    "state.js",
    "main.js",
];

fn main() -> Result<(), Box<dyn Error>> {
    let target = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../target");
    let module = match env::args_os().nth(1) {
        Some(file) => PathBuf::from(file),
        None => compiled(&target)?,
    };
    let module = fs::read(&module).map_err(|error| format!("{}: {error}", module.display()))?;
    let page = page(&module)?;
    let file = target.join("explorer/explorer.html");
    fs::create_dir_all(target.join("explorer"))?;
    fs::write(&file, &page)?;
    println!(
        "{} kB, of which the module takes {} kB unpacked: {}",
        page.len() / 1000,
        module.len() / 1000,
        file.canonicalize()?.display()
    );
    Ok(())
}

/// Compiles the library to WebAssembly.
fn compiled(target: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let status = Command::new(cargo)
        .args(["build", "--package", "explorer", "--lib", "--profile", "explorer", "--target", TARGET, "--target-dir"])
        .arg(target)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .status()?;
    if !status.success() {
        return Err(format!(
            "the library does not compile for {TARGET}: `rustup target add {TARGET}` installs what it needs"
        )
        .into());
    }
    Ok(target.join(TARGET).join("explorer/explorer.wasm"))
}

/// The page with the module, its style and its scripts inside.
fn page(module: &[u8]) -> Result<String, Box<dyn Error>> {
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    packed.write_all(module)?;
    let module = format!("const MODEL = \"{}\";", STANDARD.encode(packed.finish()?));
    let mut page = put(PAGE, r#"<script src="model.wasm"></script>"#, &script(&module))?;
    for (name, text) in FILES {
        page = match name.strip_suffix(".css") {
            Some(_) => {
                put(&page, &format!(r#"<link rel="stylesheet" href="{name}">"#), &format!("<style>\n{text}</style>"))?
            }
            None => put(&page, &format!(r#"<script src="{name}"></script>"#), &script(text))?,
        };
    }
    Ok(page)
}

fn script(text: &str) -> String {
    format!("<script>\n{text}</script>")
}

/// The page with a tag replaced, which it has to have.
fn put(page: &str, tag: &str, content: &str) -> Result<String, Box<dyn Error>> {
    if page.matches(tag).count() != 1 {
        return Err(format!("the page has not got {tag} once").into());
    }
    Ok(page.replacen(tag, content, 1))
}
