//! A vehicle on two axles over an uneven road: how its modes decay, what the driver feels, what the road does to the wheels.

use mstmm::Complex;
use mstmm::motion::PlaneEntry;
use mstmm::prelude::*;
use mstmm_drawing::Drawing;
use std::error::Error;

system! {
    /// A body on two axles, with a driver on a seat. The supports under the tyres are the road.
    #[derive(Clone, Copy, Debug)]
    pub struct Vehicle {
        /// Distance of the axles [m]
        pub wheelbase: f64,
        /// Where the mass centre of the body is behind the front axle [m]
        pub centre: f64,
        /// Mass of the body [kg]
        pub mass: f64,
        /// Moment of inertia of the body about its mass centre [kg m²]
        pub inertia: f64,
        /// Mass of an axle with its wheels [kg]
        pub axle: f64,
        /// Stiffness of the springs of an axle [N/m]
        pub spring: f64,
        /// Damping of the shock absorbers of an axle [N s/m]
        pub shock_absorber: f64,
        /// Stiffness of the tyres of an axle [N/m]
        pub tyre: f64,
        /// Damping of the tyres of an axle [N s/m]
        pub rubber: f64,
        /// Mass of the driver [kg]
        pub driver: f64,
        /// Stiffness of the seat [N/m]
        pub seat: f64,
        /// Damping of the seat [N s/m]
        pub cushion: f64,
    }

    conn front at (0.0, 0.6) -> rigid_body 1 { mass, inertia, centre: (centre, 0.7) } <- conn rear at (wheelbase, 0.6);
    rigid_body 1 <- conn middle at (centre, 0.7) <- held(x);
    conn road_front at (0.0, 0.0) -> spring 2 { stiffness: tyre, damping: rubber } -> mass 3 { mass: axle }
        -> spring 4 { stiffness: spring, damping: shock_absorber } -> conn front;
    conn road_rear at (wheelbase, 0.0) -> spring 5 { stiffness: tyre, damping: rubber } -> mass 6 { mass: axle }
        -> spring 7 { stiffness: spring, damping: shock_absorber } -> conn rear;
    rigid_body 1 -> conn floor at (1.2, 0.5);
    conn floor <- along (0.0, 1.0) <- spring 8 { stiffness: seat, damping: cushion } <- mass 9 { mass: driver } <- free;
    fixed -> conn road_front;
    fixed -> conn road_rear;
}

/// A saloon car.
pub fn saloon() -> Vehicle {
    Vehicle {
        wheelbase: 2.7,
        centre: 1.25,
        mass: 1300.0,
        inertia: 2100.0,
        axle: 90.0,
        spring: 42e3,
        shock_absorber: 2800.0,
        tyre: 380e3,
        rubber: 300.0,
        driver: 75.0,
        seat: 16e3,
        cushion: 400.0,
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let vehicle = saloon().build()?;

    println!("Modes: frequency and part of the critical damping, each certified within its circle");
    println!("mode    f [Hz]   damping [%]   circle [1/s]");
    let roots = vehicle.first_eigenvalues::<5>()?;
    for (mode, root) in roots.iter().enumerate() {
        let (hertz, damping) = (root.hertz(), -root.lambda.re / root.lambda.norm());
        println!("{:4} {hertz:9.4} {:13.2} {:14.1e}", mode + 1, 100.0 * damping, root.error);
    }

    let body = Vehicle::conn_middle;
    let entries = [body.displacement_y(), body.rotation_z(), Vehicle::conn_floor.displacement_y()];
    println!("\nAmplitudes over a wavy road of 1 m, at 90 km/h; the rear axle meets each wave later");
    println!("wave [m]   f [Hz]   body [m]   pitch [rad]   floor [m]   tyre, front [kN]");
    for wave in [100.0, 50.0, 20.0, 10.0, 5.0, 2.5, 2.0, 1.5] {
        let hertz = 25.0 / wave;
        let mut row = [0.0; 4];
        for (amplitude, entry) in row.iter_mut().zip(entries) {
            *amplitude = over_waves(&vehicle, entry, wave)?.norm();
        }
        row[3] = over_waves(&vehicle, Vehicle::spring_2.output().axial_force(), wave)?.norm() / 1e3;
        let [bounce, pitch, floor, tyre] = row;
        println!("{wave:8} {hertz:8.3} {bounce:10.4} {pitch:13.4} {floor:11.4} {tyre:18.2}");
    }

    println!("\nA kerb of 0.1 m under the front axle: the body in time");
    let kerb = vehicle.modal_response::<5, _>(&roots, Vehicle::conn_road_front.motion_y(), body.displacement_y())?;
    println!("t [s]   body [m]");
    for tenth in 0..=10 {
        let time = 0.1 * f64::from(tenth);
        println!("{time:5.1} {:10.5}", 0.1 * kerb.to_step(time));
    }
    println!("  ... {:10.5}  at rest", 0.1 * kerb.static_value()?);
    draw(&vehicle)
}

/// The amplitude of an entry over a wave of the road of 1 m, at 25 m/s: both axles move, the rear one later.
fn over_waves(vehicle: &VehicleSystem, entry: PlaneEntry<Vehicle>, wave: f64) -> Result<Complex<f64>, Box<dyn Error>> {
    let lambda = Complex::new(0.0, std::f64::consts::TAU * 25.0 / wave);
    let at = |load| vehicle.frequency_response(load, entry)?.at(lambda);
    let later = (-lambda * (saloon().wheelbase / 25.0)).exp();
    Ok(at(Vehicle::conn_road_front.motion_y())? + at(Vehicle::conn_road_rear.motion_y())? * later)
}

/// With `-- --svg FILE`: a picture of the mode in which the body pitches.
fn draw(system: &VehicleSystem) -> Result<(), Box<dyn Error>> {
    let Some(file) = std::env::args().skip_while(|argument| argument != "--svg").nth(1) else { return Ok(()) };
    let shape = system.mode_shape(&system.first_eigenvalues::<2>()?[1])?;
    Ok(Drawing::of(system)?.mode(&shape)?.write(file)?)
}
