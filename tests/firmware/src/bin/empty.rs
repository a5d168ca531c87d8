//! What a program costs that finds nothing: the C start-up and the way out.
#![no_std]
#![no_main]

use core::hint::black_box;

#[unsafe(no_mangle)]
extern "C" fn main() -> i32 {
    firmware::send(black_box(0.0));
    0
}
