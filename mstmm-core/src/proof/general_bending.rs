use crate::proof::ball::Ball;
use crate::proof::bending::Bending;
use crate::proof::functions::Level;
pub(crate) struct GeneralSection { pub bending_stiffness: [f64;2], pub mass_per_length: [f64;2], pub shear_flexibility: [f64;2], pub shear_stiffness: [f64; 2], pub rotary_inertia: [f64;2], pub axial_force: [f64;2], pub shear_layer: [f64;2], pub foundation_stiffness: [f64;2] }
pub(crate) struct General<N: Level> { pub member: Bending<N>, pub is_beside_pole: bool }
pub(crate) fn general_bending<N: Level>(_section: &GeneralSection, _length: Ball<N>, _square: Ball<N>) -> General<N> { todo!() }
