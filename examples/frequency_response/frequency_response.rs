//! How a damped beam responds to a harmonic force: static deflection, resonances, and a plot; `--uff FILE` and `--csv FILE` write the
//! response for other programs.

use mstmm::prelude::*;
use mstmm_files::{Direction, Dof, Function, write_response, write_uff58};
use plotters::prelude::*;
use std::{env, error::Error, fs::File};

system! {
    /// Simply supported beam with a spring, a damped oscillator and a torsion spring (section 4.5 of the paper).
    #[derive(Clone, Copy, Debug)]
    pub struct Beam {
        /// Length of the beam [m]
        pub length: f64,
        /// Bending stiffness [N m²]
        pub ei: f64,
        /// Mass per length [kg/m]
        pub m: f64,
    }

    let (k, mass, damping) = (ei / (length * length * length), m * length, (ei * m).sqrt() / length);

    pinned -> beam 1 { length: 0.2 * length, bending_stiffness: ei, mass_per_length: m }
           -> conn 2 -> beam 4 { length: 0.4 * length, bending_stiffness: ei, mass_per_length: m }
           -> conn 5 -> beam 8 { length: 0.15 * length, bending_stiffness: ei, mass_per_length: m }
           -> conn 9 -> beam 11 { length: 0.25 * length, bending_stiffness: ei, mass_per_length: m }
           -> pinned;
    conn 2 <- spring 3 { stiffness: 5.0 * k } <- fixed;
    conn 5 <- spring 6 { stiffness: 4.0 * k, damping } <- mass 7 { mass: 0.12 * mass } <- free;
    conn 9 <- torsion_spring 10 { stiffness: 10.0 * ei / length } <- fixed;
}

/// The paper's parameters: a steel bar of 50 mm diameter.
pub fn steel_bar() -> Beam {
    Beam { length: 1.0, ei: 2.069e11 * 3.06796e-7, m: 7800.0 * 1.96349e-3 }
}

/// Frequencies ω [rad/s] and deflections per force [m/N].
pub type Samples = Vec<(f64, Complex<f64>)>;

/// The response from 10 to 8000 rad/s where the spring is, with more samples where the curve bends.
pub fn receptance(system: &BeamSystem) -> Result<Samples, Box<dyn Error>> {
    let response = system.frequency_response(Beam::conn_2.force(), Beam::conn_2.deflection())?;
    let curve = response.curve::<4096, _>(10.0..=8000.0, &resonances(system)?, 1e-3)?;
    Ok(curve.iter().map(|sample| (sample.omega, sample.value)).collect())
}

/// The eigenvalues whose resonances are in that range; none is left out.
pub fn resonances(system: &BeamSystem) -> Result<Vec<mstmm::search::Eigenvalue>, Box<dyn Error>> {
    Ok(system.eigenvalues::<16>(Region { re: -1000.0..=1.0, im: 10.0..=8000.0 })?.to_vec())
}

/// Draws the size of the response, both axes logarithmic.
fn draw(samples: &Samples, file: &str) -> Result<(), Box<dyn Error>> {
    let area = SVGBackend::new(file, (900, 500)).into_drawing_area();
    area.fill(&WHITE)?;
    let (omegas, sizes) = ((10.0..8000.0).log_scale(), (1e-9..2e-6).log_scale());
    let mut chart = ChartBuilder::on(&area);
    let mut chart = chart.margin(20).x_label_area_size(45).y_label_area_size(70).build_cartesian_2d(omegas, sizes)?;
    chart.configure_mesh().x_desc("ω [rad/s]").y_desc("deflection per force [m/N]").draw()?;
    let curve = samples.iter().map(|(omega, value)| (*omega, value.norm()));
    chart.draw_series(LineSeries::new(curve, BLUE.stroke_width(2)))?;
    Ok(area.present()?)
}

/// Writes the response to the files that the command line names.
pub fn write(samples: &Samples, arguments: &[String]) -> Result<(), Box<dyn Error>> {
    for pair in arguments.chunks(2) {
        let [format, file] = pair else { return Err(format!("{} needs a file", pair[0]).into()) };
        match format.as_str() {
            "--uff" => {
                let spring = Dof { node: 2, direction: Direction::Y };
                let head = Function::receptance("simply supported beam, at its spring", spring, spring);
                write_uff58(File::create(file)?, &head, samples.iter().copied())?;
            }
            "--csv" => write_response(File::create(file)?, samples.iter().copied())?,
            other => return Err(format!("`{other}` is neither --uff nor --csv").into()),
        }
        println!("the response is written to {file}");
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let system = steel_bar().build()?;
    let response = system.frequency_response(Beam::conn_2.force(), Beam::conn_2.deflection())?;
    println!("static deflection per force: {:.6e} m/N\n", response.at(Complex::new(0.0, 0.0))?.re);
    println!("resonance [rad/s]    [Hz]   damping ratio   deflection per force [m/N]   phase [°]");
    for root in &resonances(&system)? {
        let omega = root.lambda.im;
        let value = response.at(Complex::new(0.0, omega))?;
        let (hertz, ratio, phase) = (root.hertz(), root.damping_ratio(), value.arg().to_degrees());
        println!("{omega:17.4} {hertz:7.1} {ratio:15.6} {:28.4e} {phase:11.2}", value.norm());
    }
    let (samples, file) = (receptance(&system)?, "target/frequency_response.svg");
    std::fs::create_dir_all("target")?;
    draw(&samples, file)?;
    println!("\n{} samples of the response are drawn in {file}", samples.len());
    write(&samples, &env::args().skip(1).collect::<Vec<_>>())
}
