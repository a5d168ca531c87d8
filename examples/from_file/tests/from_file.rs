//! Two files in one program, and what is said of files that are wrong.

#[expect(dead_code, reason = "the example's main")]
#[path = "../from_file.rs"]
pub mod from_file;

use from_file::read;
use mstmm::prelude::*;

const SHED: &str = include_str!("../shed.json");

#[test]
fn two_files_are_two_structures() {
    // the second one is a cantilever, whose first frequency has a closed form
    let mast = r#"{
        "sections": { "tube": { "axial_stiffness": 1e9, "bending_stiffness": 2.0, "mass_per_length": 0.5 } },
        "points": [{ "name": "foot", "at": [0.0, 0.0], "support": "fixed" }, { "name": "top", "at": [3.0, 4.0] }],
        "members": [{ "name": "mast", "ends": ["foot", "top"], "section": "tube" }]
    }"#;
    let frames = [SHED, mast].map(|text| read(text).unwrap());
    let [shed, mast] = frames.map(|(frame, points)| (frame.build().unwrap(), points));
    let roots = shed.0.frequencies(5).unwrap();
    assert!(roots.iter().all(|root| root.is_proven && root.multiplicity == 1));
    let omega = mast.0.frequencies(1).unwrap()[0].omega;
    let exact = (1.875_104_068_711_961_f64 / 5.0).powi(2) * 2.0;
    assert!((omega / exact - 1.0).abs() < 1e-14, "{omega}");
    // points are known by their names: the ridge goes down under a load there
    let ridge = shed.1["ridge"];
    let sinks = shed.0.frequency_response(ridge.force_y(), ridge.displacement_y()).unwrap().at(0.0).unwrap();
    assert!(sinks > 0.0);
}

#[test]
fn what_is_wrong_is_named() {
    let told = |from: &str, to: &str| read(&SHED.replace(from, to)).unwrap_err().to_string();
    assert_eq!(told("\"pinned\"", "\"pined\""), "right foot: there is no support `pined`");
    assert_eq!(told("\"ends\": [\"ridge\"", "\"ends\": [\"rigde\""), "right rafter: there is no point `rigde`");
    assert_eq!(
        told(
            "\"section\": \"column\" },\n        { \"name\": \"left",
            "\"section\": \"post\" },\n        { \"name\": \"left"
        ),
        "left column: there is no section `post`"
    );
    let misspelt = told("shear_stiffness", "shear_stifness");
    assert_eq!(misspelt, "rafter: a section has no parameter `shear_stifness`: did you mean `shear_stiffness`?");
    let negative = SHED.replace("\"stiffness\": 2.0e7", "\"stiffness\": -1.0");
    let refused = read(&negative).unwrap().0.build().unwrap_err().to_string();
    assert_eq!(
        refused,
        "member \"tie\": stiffness is -1, but must be zero, or positive and finite, with a finite reciprocal"
    );
}
