//! Responses, shapes, energies and sensitivities of trees whose materials are damped, or that move in a medium.

use crate::complex_beam::{C, ComplexBeam, product};
use mstmm::motion::MotionError;
use mstmm::prelude::*;
use mstmm::search::Eigenvalue;

system! {
    /// Two beams with all that they may have, on a spring.
    struct Row { l: f64, ei: f64, m: f64, f: f64, r: f64, n: f64, k: f64, eta: f64, c: f64, medium: f64, shear: f64, spring: f64 }
    fixed -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m, shear_stiffness: 1.0 / f, rotary_inertia: r, axial_force: n,
            foundation_stiffness: k, loss_factor: eta, kelvin_voigt_time: c, external_damping: medium } -> conn 2
        -> beam 3 { length: 0.8, bending_stiffness: 25.0, mass_per_length: 1.1, shear_stiffness: shear, rotary_inertia: r,
            loss_factor: 0.3 * eta, external_damping: 0.5 * medium } -> free;
    conn 2 <- spring 4 { stiffness: spring, kelvin_voigt_time: 2.0 * c } <- fixed
}

const ROW: Row = Row {
    l: 1.1,
    ei: 30.0,
    m: 1.4,
    f: 3e-3,
    r: 0.03,
    n: -9.0,
    k: 20.0,
    eta: 0.15,
    c: 1e-3,
    medium: 1.7,
    shear: 700.0,
    spring: 55.0,
};

/// Oracle: the exponential of the equations of both beams, and the four conditions at the ends.
#[test]
fn responses_are_those_of_the_exponential() {
    let Row { l, ei, m, f, r, n, k, eta, c, medium, shear, spring } = ROW;
    let first = ComplexBeam {
        length: l,
        bending_stiffness: ei,
        mass_per_length: m,
        shear_stiffness: Some(1.0 / f),
        rotary_inertia: r,
        axial_force: n,
        foundation_stiffness: k,
        loss_factor: eta,
        kelvin_voigt_time: c,
        external_damping: medium,
    };
    let second = ComplexBeam {
        length: 0.8,
        bending_stiffness: 25.0,
        mass_per_length: 1.1,
        shear_stiffness: Some(shear),
        axial_force: 0.0,
        foundation_stiffness: 0.0,
        loss_factor: 0.3 * eta,
        kelvin_voigt_time: 0.0,
        external_damping: 0.5 * medium,
        ..first
    };
    let system = ROW.build().unwrap();
    let deflection = system.frequency_response(Row::conn_2.force(), Row::beam_3.output().deflection()).unwrap();
    let moment = system.frequency_response(Row::conn_2.force(), Row::beam_1.input().moment()).unwrap();
    for lambda in [C::ZERO, C::new(0.0, 4.0), C::new(0.0, 31.0), C::new(-2.0, 90.0), C::new(0.0, -31.0)] {
        let above = if lambda.im < 0.0 { lambda.conj() } else { lambda };
        let (one, two) = (first.transfer(above), second.transfer(above));
        // the spring, and the load of 1 N, act on Q behind the connection
        let stiffness = spring * (1.0 + 2.0 * c * above);
        let mut joined = one;
        joined[3] = core::array::from_fn(|column| one[3][column] - stiffness * one[0][column]);
        let whole = product(&two, &joined);
        let of_load = two.map(|row| row[3]);
        let [a, b] = [whole[2], whole[3]].map(|row| [row[2], row[3]]);
        let determinant = a[0] * b[1] - a[1] * b[0];
        let m0 = (-of_load[2] * b[1] + of_load[3] * a[1]) / determinant;
        let q0 = (-of_load[3] * a[0] + of_load[2] * b[0]) / determinant;
        let tip = whole[0][2] * m0 + whole[0][3] * q0 + of_load[0];
        for (response, exact) in [(&deflection, tip), (&moment, m0)] {
            let exact = if lambda.im < 0.0 { exact.conj() } else { exact };
            let value = response.at(lambda).unwrap();
            assert!((value - exact).norm() <= 1e-11 * exact.norm(), "{lambda}: {value} beside {exact}");
        }
    }
}

/// Oracle: differences of the roots of models with fields a little larger and smaller.
#[test]
fn sensitivities_are_differences_of_roots() {
    let system = ROW.build().unwrap();
    let roots = system.first_eigenvalues::<3>().unwrap();
    type Field = (&'static str, fn(&mut Row) -> &mut f64);
    let fields: [Field; 12] = [
        ("l", |row| &mut row.l),
        ("ei", |row| &mut row.ei),
        ("m", |row| &mut row.m),
        ("f", |row| &mut row.f),
        ("r", |row| &mut row.r),
        ("n", |row| &mut row.n),
        ("k", |row| &mut row.k),
        ("eta", |row| &mut row.eta),
        ("c", |row| &mut row.c),
        ("medium", |row| &mut row.medium),
        ("shear", |row| &mut row.shear),
        ("spring", |row| &mut row.spring),
    ];
    for (k, root) in roots.iter().enumerate() {
        let sensitivity = system.sensitivity(root).unwrap();
        for (name, field) in fields {
            let mut row = ROW;
            let size = *field(&mut row);
            let [above, below] = [1e-4, -1e-4].map(|part| {
                let mut row = ROW;
                *field(&mut row) = size * (1.0 + part);
                row.build().unwrap().first_eigenvalues::<3>().unwrap()[k].lambda
            });
            let difference = (above - below) / 2e-4;
            let value = sensitivity.get(name).unwrap() * size;
            // the truncation of central differences
            assert!((difference - value).norm() <= 2e-7 * root.frequency(), "{name} of {k}: {value} {difference}");
        }
    }
}

system! {
    /// A cantilever of Kelvin and Voigt with a lossless one of the same numbers beside it, by fields.
    struct Cantilever { eta: f64, c: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, loss_factor: eta, kelvin_voigt_time: c } -> free
}

system! {
    struct Lossless {}
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free
}

/// Closed form: modes of a beam of Kelvin and Voigt are those without damping, each with `ζ = cω/2`.
#[test]
fn modes_in_time_decay_with_their_ratios() {
    let (c, times) = (2e-3, [0.05, 0.4, 1.3]);
    let (damped, plain) = (Cantilever { eta: 0.0, c }.build().unwrap(), Lossless {}.build().unwrap());
    let tip = Cantilever::beam_1.output();
    let roots = damped.first_eigenvalues::<4>().unwrap();
    let response = damped.modal_response::<8, _>(&roots, tip.force(), tip.deflection()).unwrap();
    let frequencies = plain.first_frequencies::<4>().unwrap();
    for time in times {
        let mut exact = 0.0;
        for root in &frequencies {
            let shape = plain.mode_shape(root).unwrap();
            let y = shape.state(Lossless::beam_1.output()).y;
            let ratio = 0.5 * c * root.omega;
            let slowed = root.omega * (1.0 - ratio * ratio).sqrt();
            exact += y * y * (-ratio * root.omega * time).exp() * (slowed * time).sin() / slowed;
        }
        let value = response.to_impulse(time);
        assert!((value - exact).abs() <= 1e-11, "{time}: {value} beside {exact}");
    }
    // 1/(3 EI), whatever the modes
    assert!((response.static_value().unwrap() - 1.0 / 3.0).abs() < 1e-12);
    let lossy = Cantilever { eta: 0.1, c: 0.0 }.build().unwrap();
    let roots = lossy.first_eigenvalues::<2>().unwrap();
    let refused = lossy.modal_response::<8, _>(&roots, tip.force(), tip.deflection());
    assert!(matches!(refused, Err(MotionError::LossFactor)));
}

/// Closed form: the shapes of damping in proportion are those without damping, and so is the strain; the modal stiffness has the loss.
#[test]
fn shapes_of_damping_in_proportion_are_real() {
    let plain = Lossless {}.build().unwrap();
    let frequencies = plain.first_frequencies::<3>().unwrap();
    for (eta, c) in [(0.3, 0.0), (0.0, 1e-3)] {
        let damped = Cantilever { eta, c }.build().unwrap();
        let roots = damped.first_eigenvalues::<3>().unwrap();
        for (root, frequency) in roots.iter().zip(&frequencies) {
            let (shape, exact) = (damped.mode_shape(root).unwrap(), plain.mode_shape(frequency).unwrap());
            let at = |x: f64| shape.along(Cantilever::beam_1, x).unwrap();
            let factor = at(1.0).y / exact.state(Lossless::beam_1.output()).y;
            for x in [0.1, 0.45, 0.8] {
                let exact = exact.along(Lossless::beam_1, x).unwrap();
                assert!((at(x).y - factor * exact.y).norm() <= 1e-11 * factor.norm(), "{x}");
                let moment = factor * C::new(1.0, eta) * (1.0 + c * root.lambda) * exact.m;
                assert!((at(x).m - moment).norm() <= 1e-10 * moment.norm(), "{x}: {} {moment}", at(x).m);
            }
            // of unit modal mass, to which the damping form belongs
            let whole = shape.modal_mass();
            assert!((whole - 1.0).norm() < 1e-11, "{whole}");
            let stiffness = factor * factor * C::new(1.0, eta) * frequency.omega * frequency.omega;
            assert!((shape.modal_stiffness() - stiffness).norm() <= 1e-10 * stiffness.norm());
        }
        let (one, other) = (damped.mode_shape(&roots[0]).unwrap(), damped.mode_shape(&roots[2]).unwrap());
        assert!(one.product(&other).norm() < 1e-10);
    }
}

system! {
    /// Two masses on springs with losses of their own, one of them viscous.
    struct Chain { first: f64, second: f64, time: f64 }
    fixed -> spring 1 { stiffness: 40.0, loss_factor: first } -> mass 2 { mass: 1.0 }
        -> spring 3 { stiffness: 25.0, loss_factor: second, kelvin_voigt_time: time } -> mass 4 { mass: 0.7 } -> free
}

/// Closed form: a cycle takes `π η K |u|²` in a lossy spring and `π ω C |u|²` in a viscous one.
#[test]
fn energies_are_dissipated_where_losses_are() {
    for (first, second, time) in [(0.2, 0.05, 0.0), (0.1, 0.0, 4e-3), (0.0, 0.3, 0.0)] {
        let chain = Chain { first, second, time }.build().unwrap();
        for root in &chain.first_eigenvalues::<2>().unwrap() {
            let shape = chain.mode_shape(root).unwrap();
            let [a, b] = [Chain::mass_2.output(), Chain::mass_4.output()].map(|point| shape.state(point).y);
            let (one, two) = (40.0 * a.norm_sqr(), 25.0 * (b - a).norm_sqr());
            let [lost_one, lost_two] = [one * first, two * (second + time * root.lambda.im)];
            let [shares, others] = [shape.energy_shares(Chain::spring_1), shape.energy_shares(Chain::spring_3)];
            assert!((shares.strain - one / (one + two)).abs() < 1e-12, "{shares:?}");
            assert!((shares.dissipated - lost_one / (lost_one + lost_two)).abs() < 1e-12, "{shares:?}");
            assert!((shares.dissipated + others.dissipated - 1.0).abs() < 1e-12);
        }
    }
}

/// A root below the axis is none of a system with a loss factor.
#[test]
fn conjugate_roots_have_no_shapes_with_a_loss_factor() {
    let chain = Chain { first: 0.2, second: 0.1, time: 0.0 }.build().unwrap();
    let root = chain.first_eigenvalues::<1>().unwrap()[0];
    let conjugate = Eigenvalue { lambda: root.lambda.conj(), ..root };
    assert!(matches!(chain.mode_shape(&conjugate), Err(MotionError::LossFactor)));
    assert!(matches!(chain.sensitivity(&conjugate), Err(MotionError::LossFactor)));
}
