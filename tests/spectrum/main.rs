//! Counts, natural frequencies and eigenvalues: certified ones, those of trees that searches find hard, those of random trees.

mod attacks;
mod certified;
#[path = "../support/complex_beam.rs"]
mod complex_beam;
mod counts;
mod critical_loads;
mod damped_materials;
#[path = "../support/damped_models.rs"]
mod damped_models;
mod damped_regions;
mod defects;
mod directed_families;
mod dynamic_stiffness;
mod general_beams;
mod general_chains;
#[path = "../support/hinged_models.rs"]
mod hinged_models;
mod joints;
mod levers;
mod macro_equals_list;
mod once_wrong;
mod oracles;
mod own_weight;
mod planar_chain;
mod proportional_damping;
mod random_trees;
mod rigid_links;
mod scaled_trees;
mod shares;
mod stability;
#[path = "../support/stiffness_matrix/mod.rs"]
mod stiffness_matrix;
mod strips;
#[path = "../support/mod.rs"]
pub mod support;
mod sweeps;
mod tapered_beams;
mod tree_corners;
#[path = "../support/undamped_models.rs"]
mod undamped_models;
mod vectors;
mod wave_lines;
