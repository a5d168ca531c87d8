use mstmm::prelude::*;
#[path = "paper/models.rs"]
pub mod models;
use models::*;
fn main() {
    let a = light_tip_body().build().unwrap();
    let b = restrained_beam().build().unwrap();
    let c = spring_and_mass().build().unwrap();
    let d = two_spans().build().unwrap();
    let e = damped_oscillator().build().unwrap();
    for w in [0.1, 3.0, 100.0, 500.0, 1500.0] {
        let r = |x: mstmm::Scaled<f64>, y: mstmm::Scaled<f64>| {
            x.mantissa() / y.mantissa() * 2f64.powi((x.exponent() - y.exponent()) as i32)
        };
        println!(
            "{} {} {} {}",
            r(a.characteristic(w), a.overall_determinant(w)),
            r(b.characteristic(w), b.overall_determinant(w)),
            r(c.characteristic(w), c.overall_determinant(w)),
            r(d.characteristic(w), d.overall_determinant(w))
        );
        let z = Complex::new(-0.3 * w, w);
        let (x, y) = (e.characteristic(z), e.overall_determinant(z));
        println!("   {}", x.mantissa() / y.mantissa() * 2f64.powi((x.exponent() - y.exponent()) as i32));
    }
}
