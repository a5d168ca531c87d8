//! Pictures of frames in space: where things are, what hides what, how it moves.

use crate::space_frames::{joints, mast, platform, row};
use mstmm::prelude::*;
use mstmm_drawing::{Drawing, Force, View};
use std::path::Path;

#[test]
fn the_gallery_in_space_is_written() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("drawings");
    std::fs::create_dir_all(&folder).unwrap();
    for (name, frame) in [("space_row", row()), ("space_joints", joints()), ("space_mast", mast())] {
        let shape = frame.mode_shape(&frame.frequencies(3).unwrap()[2]).unwrap();
        let file = |kind: &str| folder.join(format!("{name}{kind}.svg"));
        Drawing::of(&frame).unwrap().write(file("")).unwrap();
        for (kind, view) in [("_front", View::front()), ("_side", View::side()), ("_plan", View::plan())] {
            Drawing::of(&frame).unwrap().view(view).unwrap().write(file(kind)).unwrap();
        }
        Drawing::of(&frame).unwrap().mode(&shape).unwrap().write(file("_mode")).unwrap();
        for force in [Force::Axial, Force::Shear, Force::Moment, Force::Torque] {
            let drawing = Drawing::of(&frame).unwrap().forces(&shape, force).unwrap();
            drawing.write(file(&format!("_{force:?}").to_lowercase())).unwrap();
        }
    }
    let platform = platform();
    let shape = platform.mode_shape(&platform.first_eigenvalues::<3>().unwrap()[1]).unwrap();
    Drawing::of(&platform).unwrap().write(folder.join("space_platform.svg")).unwrap();
    Drawing::of(&platform).unwrap().mode(&shape).unwrap().write(folder.join("space_platform_mode.svg")).unwrap();
}
