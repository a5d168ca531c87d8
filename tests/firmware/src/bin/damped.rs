//! Certified eigenvalues; sends the centres and radii of their circles.
#![no_std]
#![no_main]

use core::hint::black_box;
use firmware::damped::{Controller, PAPER};
use firmware::send;

#[unsafe(no_mangle)]
extern "C" fn main() -> i32 {
    // the box hides the numbers: what comes from a sensor or a memory card cannot be computed by the compiler
    let Ok(controller) = Controller::new(black_box(PAPER)) else { return 1 };
    let Ok(modes) = controller.modes() else { return 2 };
    for mode in &modes {
        send(mode.lambda.re);
        send(mode.lambda.im);
        send(mode.error);
    }
    0
}
