//! All drawings of these tests, written for those who want to see them.

use crate::frames::for_each_frame;
use crate::trees;
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, Force};
use std::path::Path;

/// Writes each model, and its second mode with its moments where it has them.
#[test]
fn the_gallery_is_written() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("drawings");
    std::fs::create_dir_all(&folder).unwrap();
    for_each_frame!(|name, frame| Drawing::of(frame).unwrap().write(folder.join(format!("{name}.svg"))).unwrap());
    for (name, drawing) in [
        ("chain", Drawing::of(&trees::chain()).unwrap().to_string()),
        ("fork", Drawing::of(&trees::fork()).unwrap().to_string()),
        ("shafts", Drawing::of(&trees::shafts()).unwrap().to_string()),
        ("wire", Drawing::of(&trees::wire()).unwrap().to_string()),
        ("plane", Drawing::of(&trees::plane()).unwrap().to_string()),
    ] {
        std::fs::write(folder.join(format!("{name}.svg")), drawing).unwrap();
    }
    let truss = crate::frames::truss();
    let shape = truss.mode_shape(&truss.first_frequencies::<2>().unwrap()[1]).unwrap();
    Drawing::of(&truss).unwrap().mode(&shape).unwrap().write(folder.join("truss_mode.svg")).unwrap();
    Drawing::of(&truss).unwrap().forces(&shape, Force::Axial).unwrap().write(folder.join("truss_axial.svg")).unwrap();
    let vehicle = crate::frames::vehicle();
    let shape = vehicle.mode_shape(&vehicle.first_eigenvalues::<3>().unwrap()[1]).unwrap();
    Drawing::of(&vehicle).unwrap().mode(&shape).unwrap().write(folder.join("vehicle_mode.svg")).unwrap();
    let fork = trees::fork();
    let shape = fork.mode_shape(&fork.first_frequencies::<3>().unwrap()[2]).unwrap();
    let drawing = Drawing::of(&fork).unwrap().mode(&shape).unwrap();
    drawing.forces(&shape, Force::Moment).unwrap().write(folder.join("fork_mode.svg")).unwrap();
    let attached = crate::frames::attached();
    let shape = attached.mode_shape(&attached.first_frequencies::<2>().unwrap()[1]).unwrap();
    Drawing::of(&attached).unwrap().mode(&shape).unwrap().write(folder.join("attached_mode.svg")).unwrap();
    let double = crate::frames::double_beam();
    let shape = double.mode_shape(&double.first_frequencies::<2>().unwrap()[1]).unwrap();
    Drawing::of(&double).unwrap().mode(&shape).unwrap().write(folder.join("double_mode.svg")).unwrap();
}
