//! What every list of shapes must keep.

use crate::mode_shapes::energy::forms;
use crate::mode_shapes::recorded::{C, Recordable, Sketched, record};
use crate::mode_shapes::residuals::{Worst, worst_residual};
use mstmm::motion::Root;
use mstmm::number::Oscillation;
use mstmm::prelude::*;
use mstmm::search::System;

/// The limit of residuals and products.
pub(crate) const LIMIT: f64 = 1e-10;

/// The limit of Rayleigh's quotient.
pub(crate) const RAYLEIGH: f64 = 1e-12;

/// The worst residual of the shapes of some roots, and asserts that none is above the limit.
pub(crate) fn check_laws<M, Y, S, R>(model: &M, system: &Y, roots: &[R]) -> Worst
where
    M: Sketched,
    S: Oscillation<f64>,
    Y: Recordable<S> + System<Parameter = f64>,
    R: Root<f64, Frequency = S> + core::fmt::Debug,
{
    let sketch = model.sketch();
    let mut worst = Worst::default();
    for root in roots.iter().filter(|root| root.multiplicity() == 1) {
        let shape = system.mode_shape(root).unwrap();
        let residual = worst_residual(&sketch, &record(system, &shape, root));
        assert!(residual.size <= LIMIT, "{root:?}: {residual:?}");
        if residual.size > worst.size {
            worst = residual;
        }
    }
    worst
}

/// The worst product of two different shapes, given those of simple roots.
pub(crate) fn check_orthogonality<Y, S, R>(system: &Y, roots: &[R]) -> f64
where
    S: Oscillation<f64>,
    Y: Recordable<S> + System<Parameter = f64>,
    R: Root<f64, Frequency = S> + core::fmt::Debug,
{
    let simple = roots.iter().filter(|root| root.multiplicity() == 1);
    let shapes: Vec<_> = simple.map(|root| system.mode_shape(root).unwrap()).collect();
    let mut worst = 0.0_f64;
    for (i, first) in shapes.iter().enumerate() {
        for (j, second) in shapes.iter().enumerate() {
            let expected = if i == j { 1.0 } else { 0.0 };
            let product = first.product(second).to_complex() - expected;
            let size = C::new(product.re, product.im).norm();
            assert!(size <= LIMIT, "modes {i} and {j}: {product}");
            worst = worst.max(size);
        }
    }
    worst
}

/// The worst imbalance of the energies of the shapes by quadrature, and of their own modal mass and stiffness.
pub(crate) fn check_energies<M, Y, S, R>(model: &M, system: &Y, roots: &[R]) -> f64
where
    M: Sketched,
    S: Oscillation<f64>,
    Y: Recordable<S> + System<Parameter = f64>,
    R: Root<f64, Frequency = S> + core::fmt::Debug,
{
    let sketch = model.sketch();
    let mut worst = 0.0_f64;
    // strain of a motion without frequency, zero to rounding, is compared with that of the others
    let sizes = || roots.iter().map(|root| root.frequency().size());
    let is_zero = |size: f64| size < 1e-12 * sizes().fold(0.0, f64::max);
    let usual = sizes().filter(|size| !is_zero(*size)).fold(f64::INFINITY, f64::min).powi(2);
    for root in roots.iter().filter(|root| root.multiplicity() == 1) {
        let shape = system.mode_shape(root).unwrap();
        let recorded = record(system, &shape, root);
        let forms = forms(&sketch, &recorded, &recorded);
        let imbalance = forms.imbalance(&recorded, if is_zero(root.frequency().size()) { usual } else { 0.0 });
        assert!(imbalance <= 2.0 * RAYLEIGH, "{root:?}: {imbalance:e}");
        let mass = forms.product(&recorded, &recorded);
        assert!((mass - 1.0).norm() <= LIMIT, "{root:?}: {mass}");
        let own = shape.modal_stiffness().to_complex() - forms.stiffness;
        let size =
            forms.stiffness.norm().max((recorded.lambda_squared * forms.mass).norm()).max(usual * forms.mass.norm());
        assert!(own.norm() <= RAYLEIGH * size, "{root:?}: {own}");
        worst = worst.max(imbalance);
    }
    worst
}

/// The first natural frequencies.
pub(crate) fn first<const N: usize>(system: &impl Undamped<Parameter = f64>) -> Box<[NaturalFrequency]> {
    system.first_frequencies::<N>().unwrap().iter().copied().collect()
}
