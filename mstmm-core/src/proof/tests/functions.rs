//! Functions and members against many digits: nothing is outside of its ball.

use crate::proof::ball::Ball;
use crate::proof::bending::bending;
use crate::proof::line::line;
use crate::proof::number::{OneWord, TwoWords};

#[test]
fn quick_look() {
    for x in [0.3, 1.0, 4.0, 700.3, 123456.789] {
        let [s, c] = Ball::<TwoWords<f64>>::of(x).sin_cos();
        std::println!("{x}: {:e} {:e} rad {:e}; {:e}", s.mid.hi - x.sin(), c.mid.hi - x.cos(), s.rad, c.rad);
        let e = Ball::<TwoWords<f64>>::of(x).decay();
        std::println!("decay {:e} {:e} rad {:e}", e.mid.hi, (-x).exp(), e.rad);
        let m = bending(Ball::<TwoWords<f64>>::of(x));
        std::println!("{:?}", m.stiffness.map(|b| (b.mid.hi, b.rad / b.mid.hi)));
        std::println!("{:?} {:?}", m.held, m.border.map(|b| (b.forces, b.flexibility)));
        let m = line(Ball::<OneWord>::of(x));
        std::println!("{:?} {:?}", m.stiffness.map(|b| (b.mid.0, b.rad)), m.held);
    }
}
