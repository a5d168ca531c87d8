use mstmm::prelude::*;
use mstmm::*;
#[path="paper/models.rs"] pub mod models;
use models::*;
type D = DoubleDouble;
macro_rules! check { ($m:expr, $max:expr) => {{
    let s = $m.build_as::<D>().unwrap();
    let mut r0 = None; let mut worst = 0.0f64;
    for i in 1..100 {
        let w = D::from_f64($max * (i as f64 * 0.6180339887) .fract());
        let (a, b) = (s.characteristic(w), s.overall_determinant(w));
        let r = a.mantissa() / b.mantissa() * D::from_f64(2f64.powi((a.exponent() - b.exponent()) as i32));
        let r0 = *r0.get_or_insert(r);
        worst = worst.max(((r / r0) - D::from_f64(1.0)).to_f64().abs());
    }
    println!("{worst:e}");
    let s32 = $m.build_as::<f32>().unwrap();
    let s64 = $m.build().unwrap();
    let (a, b) = (s32.first_frequencies::<3>().unwrap(), s64.first_frequencies::<3>().unwrap());
    for (a, b) in a.iter().zip(&b) { print!(" {:.1e}", a.omega as f64 / b.omega - 1.0); }
    println!(" {} {}", a.evaluations(), b.evaluations());
    let d = s.first_frequencies::<3>().unwrap();
    for (a, b) in d.iter().zip(&b) { print!(" {} {:.1e}", a.omega, a.omega.to_f64() / b.omega - 1.0); }
    println!(" {}", d.evaluations());
}} }
fn main() {
    check!(light_tip_body(), 1557.0);
    check!(heavy_tip_body(), 1557.0);
    check!(restrained_beam(), 2400.0);
    check!(spring_and_mass(), 1262.0);
    check!(two_spans(), 15848.0);
}
