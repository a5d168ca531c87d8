use mstmm::prelude::*;

fn area(width: f64, height: f64) -> f64 {
    width * height
}

system! {
    #[derive(Debug)]
    struct Model { width: f64, height: f64, length: f64 }

    let double = 2.0 * height;
    let section = area(width, double);
//                ^^^^ `area` has no derivative that mstmm knows: write the formula here, or mark `width` and `height` with
    let rounded = length.round();
//                       ^^^^^ or mark `length` with `#[no_sensitivity]`
    let single = (width * height) as f32;
//                                ^^ a cast has no derivative
    fixed -> spring 1 { stiffness: section * f64::from(single) } -> mass 2 { mass: rounded } -> free
}

fn main() {}
