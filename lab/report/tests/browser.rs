//! The page in a browser: no errors, and nothing overlaps or leaves its place, neither on a desktop nor on a telephone;
//! what scrolls says so.
//!
//! Skipped where there is no Chromium: it is sought in the variable `CHROMIUM`, then in the path.
#![expect(clippy::unwrap_used, reason = "a failure here is one of the test")]

mod support;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

const NAMES: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

const OPTIONS: [&str; 9] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    // messages between frames come after loading
    "--virtual-time-budget=10000",
];

/// Collects what the pages in its frames say. Windows have a least width, frames have none.
const HARNESS: &str = r#"<!DOCTYPE html>
<script>addEventListener("message", ({ data }) => document.body.append(`${JSON.stringify(data)}\n`));</script>
<body>
<iframe src="page.html" width="1280" height="900"></iframe>
<iframe src="page.html" width="760" height="900"></iframe>
<iframe src="page.html" width="400" height="900"></iframe>
</body>
"#;

fn chromium() -> Option<PathBuf> {
    let named = env::var_os("CHROMIUM").map(PathBuf::from);
    let path = env::var_os("PATH").unwrap_or_default();
    let folders: Vec<PathBuf> = env::split_paths(&path).collect();
    let installed = NAMES.iter().flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    named.into_iter().chain(installed).find(|file| file.is_file())
}

/// The harness after its frames have been checked.
fn checked(chromium: &Path, page: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("browser");
    fs::create_dir_all(&folder).unwrap();
    let script = concat!("<script>", include_str!("support/check.js"), "</script></head>");
    fs::write(folder.join("page.html"), page.replacen("</head>", script, 1)).unwrap();
    fs::write(folder.join("harness.html"), HARNESS).unwrap();
    let profile = format!("--user-data-dir={}", folder.join("profile").display());
    let address = format!("file://{}", folder.join("harness.html").display());
    let output = Command::new(chromium).args(OPTIONS).args([&profile, "--dump-dom", &address]).output().unwrap();
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn nothing_overlaps_or_is_cut_at_any_width() {
    let Some(chromium) = chromium() else {
        eprintln!("skipped: no Chromium in CHROMIUM or in the path");
        return;
    };
    let page = report::page(support::measurements()).unwrap();
    let said = checked(&chromium, &page);
    let figures = page.matches("<figure").count();
    for width in [1280, 760, 400] {
        let fine = format!(r#"{{"width":{width},"figures":{figures},"faults":[]}}"#);
        assert!(said.contains(&fine), "{}", said.replace("\",", "\",\n"));
    }
}
