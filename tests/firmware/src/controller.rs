//! The step of a controller's plant in single precision, for the count of its instructions.

use vibrations::motion::DiscreteStateSpace;

/// A step of ten modes with one input and one output.
#[unsafe(no_mangle)]
pub fn step_of_ten_modes(plant: &mut DiscreteStateSpace<f32, 10, 1, 1>, input: f32) -> f32 {
    let [output] = plant.step(&[input]);
    output
}
