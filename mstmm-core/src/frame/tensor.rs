//! The inertia of a rigid body in space.

/// The inertia of a rigid body about its mass centre [kg m²], in the axes of the structure.
///
/// The product entries are those of the tensor, `xy = -∫ x y dm`. A tensor that rounding has made indefinite gets the least addition on its
/// diagonal; one that is indefinite beyond 1e-12 of its trace is refused by `build`.
///
/// ```
/// use mstmm_core::frame::Tensor;
/// let disc = Tensor::principal([0.5, 0.25, 0.25]);
/// assert_eq!(disc, Tensor::new([0.5, 0.25, 0.25, 0.0, 0.0, 0.0]));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tensor {
    entries: [f64; 6],
}

impl Tensor {
    /// The entries xx, yy, zz, xy, yz and zx.
    pub const fn new(entries: [f64; 6]) -> Self {
        Tensor { entries }
    }

    /// The moments of inertia about x, y and z, which are principal axes.
    pub const fn principal([x, y, z]: [f64; 3]) -> Self {
        Tensor { entries: [x, y, z, 0.0, 0.0, 0.0] }
    }

    /// The same moment of inertia about all axes.
    pub const fn of_sphere(moment: f64) -> Self {
        Tensor::principal([moment; 3])
    }

    pub(crate) fn entries(self) -> [f64; 6] {
        self.entries
    }
}
