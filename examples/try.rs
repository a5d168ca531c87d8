use mstmm::prelude::*;
#[path = "paper/models.rs"]
pub mod models;
use models::*;
fn main() {
    let e = damped_oscillator().build().unwrap();
    let u = (2.069e11f64 * 3.06796e-7 / (7800.0 * 1.96349e-3)).sqrt();
    let r = Region { re: -300.0..=5.0, im: -10.0..=12000.0 };
    println!("{:?}", e.count_in(r.clone()));
    let f = e.eigenvalues::<16>(r).unwrap();
    println!("{} evaluations", f.evaluations());
    for f in &f {
        println!("   {:?} {} {:.1e}", f.lambda / u, f.multiplicity, f.error / f.frequency());
    }
    let r = Region { re: -300.0..=5.0, im: 1.0..=12000.0 };
    println!("{:?}", e.count_in(r.clone()));
    let f = e.eigenvalues::<16>(r).unwrap();
    println!("{} evaluations", f.evaluations());
    for f in &f {
        println!("   {:?} {} {:.1e}", f.lambda / u, f.multiplicity, f.error / f.frequency());
    }
    let f = e.first_eigenvalues::<5>().unwrap();
    println!("{} evaluations", f.evaluations());
    for f in &f {
        println!("   {:?} {} {:.1e}", f.lambda / u, f.multiplicity, f.error / f.frequency());
    }
}
