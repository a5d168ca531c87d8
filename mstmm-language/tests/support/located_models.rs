//! Models with locations: every node that they have.
#![expect(clippy::unwrap_used, reason = "what is written here lexes")]

use proc_macro2::TokenStream;

const MODELS: [&str; 2] = [
    "struct Frame { a: f64, k: f64 }
     let half = 0.5 * a;
     fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k }
         -> conn b at (half, a) -> pin 2 {} -> slider 3 { along: (a, 1.0) } -> conn c
         <- beam 4 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } <- conn d;
     conn b -> rigid_body 5 { mass: k, inertia: k, centre: (a, -a) } <- conn d at (a, 0.0) <- held(x, rz);
     rigid_body 5 <- hinge 6 { stiffness_x: k, stiffness_y: k, stiffness_rz: k } <- conn e at (a, a);
     conn e <- roller along (1.0, half);
     conn b <- along (0.0, 1.0) <- spring 7 { stiffness: k } <- mass 8 { mass: k } <- conn u;
     conn u <- damper 9 { damping: k } <- along (1.0, 0.0) <- conn c;
     conn e -> torsion_spring 10 { stiffness: k } -> inertia 11 { inertia: k } -> free;
     conn b -> spring 12 { stiffness: k, damping: k } -> conn e -> point_mass 13 { mass: k };
     conn d -> beam 14 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } -> free at (k, k);
     conn b -> bar 15 { axial_stiffness: k, bending_stiffness: k, mass_per_length: k } -> pinned at (a, -1.0)",
    "struct Line { l: f64 }
     fixed at 0.0 -> beam 1 { bending_stiffness: l, mass_per_length: l } -> conn a at 0.3 * l
         <- beam 2 { bending_stiffness: l, mass_per_length: l } <- guided at l;
     conn a -> hinge 3 { stiffness_y: l, stiffness_rz: l } -> rigid_body 4 { mass: l, inertia: l, centre: l };
     conn a <- spring 5 { stiffness: l } <- mass 6 { mass: l } <- free",
];

/// The models.
///
/// # Panics
/// If one does not lex.
pub(crate) fn located_models() -> Vec<TokenStream> {
    MODELS.iter().map(|model| model.parse().unwrap()).collect()
}
