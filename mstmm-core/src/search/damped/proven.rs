//! Simple eigenvalues are proven where a search has left them.

use crate::element::OwnPart;
use crate::model::Spot;
use crate::number::{Real, Scalar, modulus};
use crate::pass::characteristic::System;
use crate::proof::disc::eigenvalue::{ProvenDisc, proven_disc};
use crate::proof::visit::{Visited, Visitor};
use crate::search::damped::found::Eigenvalue;
use num_complex::Complex;

/// The parts of a system.
pub(crate) struct Parts<'a, Y: ?Sized>(pub(crate) &'a Y);

impl<Y: System + ?Sized> Visited for Parts<'_, Y> {
    fn visit(&self, visitor: &mut dyn Visitor) {
        self.0.name_parts(visitor);
    }

    fn is_flat(&self) -> bool {
        self.0.is_flat()
    }

    fn spot(&self, place: usize) -> Spot {
        self.0.spot_of(place)
    }

    fn own_part(&self, _: usize, _: [f64; 2]) -> Option<OwnPart> {
        None
    }
}

/// Proves those of some eigenvalues that can be proven. Each stays in its circle.
pub(super) fn prove_all<Y: System + ?Sized>(system: &Y, roots: &mut [Eigenvalue<Y::Parameter>]) {
    // discs are proven in two words, which say enough of an f64 alone
    let is_double = <Y::Parameter as Scalar>::EPSILON == f64::EPSILON;
    if !cfg!(feature = "proof") || !is_double {
        return;
    }
    let have_images = system.frequency_estimates().have_images();
    // those of the upper half plane are last
    for place in (0..roots.len()).rev() {
        let root = roots[place];
        let is_image_of = |other: &&Eigenvalue<Y::Parameter>| {
            have_images && other.is_proven && modulus(other.lambda.conj() - root.lambda) <= root.error
        };
        if let Some(other) = roots[place + 1..].iter().find(is_image_of) {
            roots[place] = other.image();
        } else if root.multiplicity == 1 {
            prove(&Parts(system), &mut roots[place]);
        }
    }
}

/// Proves a simple eigenvalue, if that can be.
fn prove<T: Real>(model: &dyn Visited, root: &mut Eigenvalue<T>) {
    let estimate = Complex::new(root.lambda.re.to_f64(), root.lambda.im.to_f64());
    if let Some(ProvenDisc { centre, radius }) = proven_disc(model, estimate, root.error.to_f64()) {
        let [re, im, error] = [centre.re, centre.im, radius].map(T::from_f64);
        *root = Eigenvalue { lambda: Complex::new(re, im), error, multiplicity: 1, is_proven: true };
    }
}
