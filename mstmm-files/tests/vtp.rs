//! A written file of lines against the model: read as XML, and by VTK, where Python has it.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

mod support;

use mstmm::prelude::*;
use mstmm_files::{FileError, Geometry, Mode, Polyline, write_vtp};
use roxmltree::{Document, Node};
use std::process::Command;
use support::mast::{HEIGHT, first_hertz, first_shape, modes};

/// The numbers of the only array of a name.
fn array(document: &Document<'_>, name: &str) -> Vec<f64> {
    let is_named = |node: &Node<'_, '_>| node.attribute("Name") == Some(name) && node.has_tag_name("DataArray");
    let mut nodes = document.descendants().filter(is_named);
    let node = nodes.next();
    assert!(node.is_some(), "there is no {name}");
    assert!(nodes.next().is_none(), "two are called {name}");
    node.unwrap().text().unwrap().split_whitespace().map(|field| field.parse().unwrap()).collect()
}

fn written<M: Into<Mode>>(geometry: &Geometry, modes: impl IntoIterator<Item = M>) -> Result<String, FileError> {
    let mut file = Vec::new();
    let result = write_vtp(&mut file, geometry, modes);
    assert!(result.is_ok() || file.is_empty());
    result.map(|()| String::from_utf8(file).unwrap())
}

fn root(omega: f64) -> NaturalFrequency {
    NaturalFrequency { omega, ..NaturalFrequency::default() }
}

/// Closed form: a cantilever.
#[test]
fn lines_and_modes_are_those_of_the_model() {
    let (lines, modes) = modes(4);
    let file = written(lines.geometry(), modes).unwrap();
    let document = Document::parse(&file).unwrap();
    let piece = document.descendants().find(|node| node.has_tag_name("Piece")).unwrap();
    assert_eq!((piece.attribute("NumberOfPoints"), piece.attribute("NumberOfLines")), (Some("40"), Some("2")));
    assert_eq!(array(&document, "offsets"), [20.0, 40.0]);
    assert_eq!(array(&document, "line"), [0.0, 1.0]);
    assert_eq!(array(&document, "connectivity"), (0..40).map(f64::from).collect::<Vec<_>>());
    let places = array(&document, "Points");
    let hertz = first_hertz();
    let first = array(&document, &format!("mode 1 ({hertz:.4} Hz)"));
    assert_eq!((places.len(), first.len()), (120, 120));
    let sign = first[58].signum();
    for (place, moved) in places.chunks(3).zip(first.chunks(3)).take(20) {
        assert_eq!(place[..2], [0.0; 2]);
        assert!((sign * moved[1] - first_shape(place[2])).abs() < 1e-12 && moved[0].abs() + moved[2].abs() < 1e-12);
    }
    // the spring is straight from the tip to the point that is held
    for (place, moved) in places.chunks(3).zip(first.chunks(3)).skip(20) {
        assert_eq!(place[1..], [0.0, HEIGHT]);
        assert!((sign * moved[1] - first_shape(HEIGHT) * (1.0 - place[0] / 3.0)).abs() < 1e-12);
    }
}

#[test]
fn numbers_names_and_complex_shapes_are_read_back() {
    let mut geometry = Geometry::default();
    geometry.add_line("a", [[0.1, -0.0, 1e-310], [1.0 / 3.0, -1e22, 2.0]]);
    geometry.lines.push(Polyline { name: String::from("back"), points: vec![1, 0, 1] });
    let real = Mode::from(root(0.0)).with_vectors([[1e-7, 0.0, 3.0], [4.0, 5.0, 6.0]]).named("<\"&\" µ>");
    let complex = [[0.0, 1.5], [0.0, 0.0], [-2.0, 0.5]].map(|[re, im]| Complex::new(re, im));
    let complex = Mode::from(Eigenvalue { lambda: Complex::new(-1.0, 12.5), ..Eigenvalue::default() })
        .with_vectors([complex, [Complex::new(0.0, 0.0); 3]]);
    let file = written(&geometry, [real, complex]).unwrap();
    let document = Document::parse(&file).unwrap();
    assert_eq!(array(&document, "Points"), [0.1, 0.0, 0.0, 1.0 / 3.0, -1e22, 2.0]);
    assert_eq!(array(&document, "connectivity"), [0.0, 1.0, 1.0, 0.0, 1.0]);
    assert_eq!(array(&document, "offsets"), [2.0, 5.0]);
    assert_eq!(array(&document, "<\"&\" µ>"), [1e-7, 0.0, 3.0, 4.0, 5.0, 6.0]);
    assert_eq!(array(&document, "mode 2 (1.9894 Hz), real part")[..3], [0.0, 0.0, -2.0]);
    assert_eq!(array(&document, "mode 2 (1.9894 Hz), imaginary part")[..3], [1.5, 0.0, 0.5]);
    let points = document.descendants().find(|node| node.has_tag_name("PointData")).unwrap();
    assert_eq!(points.attribute("Vectors"), Some("<\"&\" µ>"));
    // rotations are left out
    let turned = Mode::from(root(0.0)).with_vectors([[1.0, 2.0, 3.0, 9.0, 9.0, 9.0]; 2]);
    let file = written(&geometry, [turned]).unwrap();
    assert_eq!(array(&Document::parse(&file).unwrap(), "mode 1 (0 Hz)"), [1.0, 2.0, 3.0, 1.0, 2.0, 3.0]);
}

#[test]
fn what_is_no_figure_is_refused() {
    let refused = |geometry: &Geometry, mode: Mode| written(geometry, [mode]).unwrap_err();
    let none = || Mode::from(root(1.0));
    let mut line = Geometry::default();
    assert!(matches!(refused(&line, none()), FileError::NoPoints));
    line.add_line("a", [[0.0; 3], [1.0; 3]]);
    let vectors = refused(&line, none().with_vectors([[0.0; 3]]));
    assert!(matches!(vectors, FileError::Vectors { row: 0, values: 3, points: 2 }), "{vectors}");
    assert!(matches!(refused(&line, none().with_vectors([[f64::NAN; 3]; 2])), FileError::NotFinite { row: 0 }));
    let shape = || none().with_vectors([[0.0; 3]; 2]);
    assert!(matches!(refused(&line, shape().named("a\nb")), FileError::Name { .. }));
    let twice = written(&line, [shape().named("a"), shape().named("a")]).unwrap_err();
    assert!(matches!(twice, FileError::SameName { .. }), "{twice}");
    let with = |points: &[usize]| {
        let mut other = line.clone();
        other.lines.push(Polyline { name: String::new(), points: points.to_vec() });
        refused(&other, shape())
    };
    assert!(matches!(with(&[1]), FileError::ShortLine { line: 1 }));
    assert!(matches!(with(&[1, 2]), FileError::NoSuchPoint { line: 1, point: 2, points: 2 }));
    line.points[1][2] = f64::INFINITY;
    assert!(matches!(refused(&line, shape()), FileError::Place { point: 1 }));
}

/// Reads the file as ParaView does, warps it by a mode and prints what it has.
const SCRIPT: &str = "
import json, sys, vtk
reader = vtk.vtkXMLPolyDataReader()
reader.SetFileName(sys.argv[1])
reader.Update()
data = reader.GetOutput()
warp = vtk.vtkWarpVector()
warp.SetInputData(data)
warp.SetInputArrayToProcess(0, 0, 0, 0, data.GetPointData().GetArrayName(0))
warp.Update()
print(json.dumps({
    'names': [data.GetPointData().GetArrayName(k) for k in range(data.GetPointData().GetNumberOfArrays())],
    'lines': [data.GetCell(k).GetNumberOfPoints() for k in range(data.GetNumberOfLines())],
    'places': [data.GetPoint(k) for k in range(data.GetNumberOfPoints())],
    'warped': [warp.GetOutput().GetPoint(k) for k in range(data.GetNumberOfPoints())]}))
";

#[test]
fn another_program_reads_what_was_written() {
    if !Command::new("python3").args(["-c", "import vtk"]).output().is_ok_and(|run| run.status.success()) {
        use std::io::Write;
        let _ = writeln!(std::io::stderr(), "skipped: python3 has no vtk, which would read the file");
        return;
    }
    let (lines, modes) = modes(4);
    let path = std::env::temp_dir().join(format!("mstmm-files-{}.vtp", std::process::id()));
    std::fs::write(&path, written(lines.geometry(), modes).unwrap()).unwrap();
    let run = Command::new("python3").args(["-c", SCRIPT]).arg(&path).output().unwrap();
    std::fs::remove_file(&path).unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let read: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(read["names"].as_array().unwrap().len(), 4);
    assert_eq!(read["lines"], serde_json::json!([20, 20]));
    let tip = |key: &str| [0, 1, 2].map(|k| read[key][19][k].as_f64().unwrap());
    assert_eq!(tip("places"), [0.0, 0.0, HEIGHT]);
    // points of a warped figure are single
    assert!((tip("warped")[1].abs() - first_shape(HEIGHT)).abs() < 1e-6);
}
