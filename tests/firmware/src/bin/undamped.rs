//! Certified natural frequencies; sends the ends of their intervals.
#![no_std]
#![no_main]

use core::hint::black_box;
use firmware::send;
use firmware::undamped::{Controller, LIGHT};

#[unsafe(no_mangle)]
extern "C" fn main() -> i32 {
    // the box hides the numbers: what comes from a sensor or a memory card cannot be computed by the compiler
    let Ok(controller) = Controller::new(black_box(LIGHT)) else { return 1 };
    let Ok(modes) = controller.modes() else { return 2 };
    for mode in &modes {
        send(mode.lower);
        send(mode.upper);
    }
    0
}
