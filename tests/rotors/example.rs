//! The example of the book.

#[allow(dead_code, unreachable_pub, reason = "an example is a program of its own")]
#[path = "../../examples/rotor.rs"]
mod rotor;

use mstmm::prelude::*;

/// Oracle: six elements of ROSS at 4000 rpm, which are up to 5e-4 too stiff.
#[test]
fn the_rotor_of_the_book_whirls_as_elements_do() {
    let rotor = rotor::two_discs().build().unwrap();
    let lists = [Whirl::Backward, Whirl::Forward].map(|whirl| rotor.whirl(whirl).first_frequencies::<3>().unwrap());
    let of_elements = [[85.389467, 251.78460413, 600.17936195], [87.7958637, 294.71333087, 827.07536193]];
    for (list, of_elements) in lists.iter().zip(of_elements) {
        for (root, of_elements) in list.iter().zip(of_elements) {
            let error = of_elements / root.omega - 1.0;
            assert!(root.is_proven && (0.0..6e-4).contains(&error), "{} {error:e}", root.omega);
        }
    }
}
