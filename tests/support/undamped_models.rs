//! Random trees as models, named after their seeds; `macro_equals_list.rs` says how to write this file again.

use mstmm::prelude::*;

system! {
    pub(crate) struct Undamped2;

    guided -> beam 13 { length: 0.25, bending_stiffness: 0.53, mass_per_length: 2.17 } -> beam 14 { length: 0.25, bending_stiffness: 0.53, mass_per_length: 2.17 } -> conn 16;
    free -> conn 16;
    free -> mass 1 { mass: 1.26 } -> spring 2 { stiffness: 31.9 } -> conn 18;
    free -> mass 4 { mass: 1.26 } -> spring 5 { stiffness: 31.9 } -> conn 18;
    free -> mass 7 { mass: 1.26 } -> spring 8 { stiffness: 31.9 } -> conn 18;
    fixed -> spring 10 { stiffness: 6.3 } -> spring 11 { stiffness: 3.7 } -> conn 18;
    conn 16 -> beam 17 { length: 1.67, bending_stiffness: 0.2, mass_per_length: 3.05 } -> conn 18;
    conn 18 -> body 19 { mass: 4.91, inertia_about_input: 1.991779, output_x: 0.395, centre_x: 0.63 } -> fixed;
}

system! {
    pub(crate) struct Undamped6;

    fixed -> spring 1 { stiffness: 6.1 } -> spring 2 { stiffness: 2.5 } -> conn 10;
    pinned -> hinge 4 { stiffness_y: 3.1, stiffness_rz: 0.61 } -> beam 5 { length: 0.7, bending_stiffness: 0.69, mass_per_length: 0.21 } -> conn 10;
    fixed -> spring 7 { stiffness: 12.8 } -> spring 8 { stiffness: 13.3 } -> spring 9 { stiffness: 32.1 } -> conn 10;
    conn 10 -> point_mass 11 { mass: 2.34, inertia: 0.071 } -> conn 20;
    fixed -> torsion_spring 13 { stiffness: 0.29 } -> inertia 14 { inertia: 4.76 } -> conn 20;
    fixed -> spring 16 { stiffness: 38.1 } -> spring 17 { stiffness: 5.699999999999999 } -> mass 18 { mass: 0.78 } -> conn 20;
    free -> conn 20;
    conn 20 -> mass 21 { mass: 1.09 } -> conn 25;
    free -> spring 23 { stiffness: 16.599999999999998 } -> spring 24 { stiffness: 8.5 } -> conn 25;
    conn 25 -> spring 26 { stiffness: 5.0 } -> free;
}

system! {
    pub(crate) struct Undamped7;

    free -> body 1 { mass: 0.28, inertia_about_input: 0.13974299999999998, output_x: 1.55, centre_x: 0.285 } -> conn 2;
    conn 2 -> spring 3 { stiffness: 15.700000000000001 } -> fixed;
}

system! {
    pub(crate) struct Undamped14;

    pinned -> body 3 { mass: 1.23, inertia_about_input: 1.5260726875, output_x: 0.555, centre_x: 1.1025 } -> beam 4 { length: 0.93, bending_stiffness: 3.56, mass_per_length: 0.32 } -> conn 6;
    pinned -> conn 6;
    pinned -> point_mass 1 { mass: 0.81, inertia: 0.377 } -> conn 9;
    conn 6 -> point_mass 7 { mass: 1.68, inertia: 0.29700000000000004 } -> beam 8 { length: 0.4, bending_stiffness: 0.5, mass_per_length: 0.36 } -> conn 9;
    conn 9 -> free;
}

system! {
    pub(crate) struct Undamped15;

    free -> inertia 1 { inertia: 0.28 } -> conn 8;
    fixed -> beam 3 { length: 1.13, bending_stiffness: 1.24, mass_per_length: 0.32 } -> point_mass 4 { mass: 0.34, inertia: 0.05500000000000001 } -> conn 8;
    fixed -> beam 6 { length: 1.13, bending_stiffness: 1.24, mass_per_length: 0.32 } -> point_mass 7 { mass: 0.34, inertia: 0.05500000000000001 } -> conn 8;
    free -> inertia 11 { inertia: 0.28 } -> conn 18;
    fixed -> beam 13 { length: 1.13, bending_stiffness: 1.24, mass_per_length: 0.32 } -> point_mass 14 { mass: 0.34, inertia: 0.05500000000000001 } -> conn 18;
    fixed -> beam 16 { length: 1.13, bending_stiffness: 1.24, mass_per_length: 0.32 } -> point_mass 17 { mass: 0.34, inertia: 0.05500000000000001 } -> conn 18;
    conn 8 -> body 9 { mass: 3.71, inertia_about_input: 0.24525118750000002, output_x: 0.395, centre_x: 0.0825 } -> conn 21;
    conn 18 -> body 19 { mass: 3.71, inertia_about_input: 0.24525118750000002, output_x: 0.395, centre_x: 0.0825 } -> conn 21;
    free -> conn 21;
    conn 21 -> body 22 { mass: 1.96, inertia_about_input: 0.46236900000000003, output_x: 0.33, centre_x: 0.205 } -> body 23 { mass: 0.88, inertia_about_input: 0.17046550000000002, output_x: 1.305, centre_x: 0.1525 } -> free;
}

system! {
    pub(crate) struct Undamped16;

    free -> mass 1 { mass: 0.42 } -> mass 2 { mass: 0.96 } -> conn 8;
    fixed -> spring 4 { stiffness: 2.3000000000000003 } -> spring 5 { stiffness: 32.5 } -> mass 6 { mass: 0.98 } -> conn 8;
    free -> conn 8;
    conn 8 -> spring 9 { stiffness: 5.0 } -> fixed;
}

system! {
    pub(crate) struct Undamped17;

    free -> spring 1 { stiffness: 2.6 } -> spring 2 { stiffness: 30.5 } -> conn 6;
    pinned -> beam 4 { length: 1.55, bending_stiffness: 2.46, mass_per_length: 0.69 } -> conn 6;
    fixed -> conn 6;
    conn 6 -> inertia 7 { inertia: 4.14 } -> conn 9;
    free -> conn 9;
    conn 9 -> torsion_spring 10 { stiffness: 4.68 } -> conn 12;
    free -> conn 12;
    conn 12 -> torsion_spring 13 { stiffness: 0.96 } -> free;
}

system! {
    pub(crate) struct Undamped18;

    guided -> hinge 1 { stiffness_y: 11.399999999999999, stiffness_rz: 0.21 } -> conn 3;
    free -> conn 3;
    conn 3 -> beam 4 { length: 0.28, bending_stiffness: 3.41, mass_per_length: 0.28 } -> beam 5 { length: 2.24, bending_stiffness: 0.39, mass_per_length: 0.51 } -> pinned;
}

system! {
    pub(crate) struct Undamped22;

    guided -> beam 4 { length: 3.98, bending_stiffness: 0.49, mass_per_length: 0.26 } -> conn 7;
    guided -> beam 6 { length: 3.98, bending_stiffness: 0.49, mass_per_length: 0.26 } -> conn 7;
    pinned -> beam 1 { length: 1.62, bending_stiffness: 0.85, mass_per_length: 0.95 } -> beam 2 { length: 0.33, bending_stiffness: 0.85, mass_per_length: 1.11 } -> conn 10;
    conn 7 -> point_mass 8 { mass: 0.21, inertia: 0.24300000000000002 } -> body 9 { mass: 2.04, inertia_about_input: 0.27625275, output_x: 0.1, centre_x: 0.0775 } -> conn 10;
    conn 10 -> fixed;
}

system! {
    pub(crate) struct Undamped31;

    pinned -> beam 1 { length: 2.44, bending_stiffness: 1.79, mass_per_length: 4.63 } -> conn 9;
    fixed -> spring 3 { stiffness: 31.0 } -> spring 4 { stiffness: 11.799999999999999 } -> conn 9;
    fixed -> spring 6 { stiffness: 31.0 } -> spring 7 { stiffness: 11.799999999999999 } -> conn 9;
    pinned -> conn 9;
    conn 9 -> body 10 { mass: 0.23, inertia_about_input: 0.50084575, output_x: 0.49, centre_x: 0.555 } -> beam 11 { length: 0.23, bending_stiffness: 1.08, mass_per_length: 1.0 } -> free;
}

system! {
    pub(crate) struct Undamped35;

    fixed -> spring 1 { stiffness: 12.9 } -> mass 2 { mass: 0.57 } -> spring 3 { stiffness: 40.0 } -> conn 5;
    free -> conn 5;
    conn 5 -> beam 6 { length: 1.86, bending_stiffness: 0.37, mass_per_length: 1.3 } -> free;
}

system! {
    pub(crate) struct Undamped36;

    free -> torsion_spring 1 { stiffness: 4.91 } -> conn 7;
    free -> torsion_spring 3 { stiffness: 4.91 } -> conn 7;
    free -> torsion_spring 5 { stiffness: 4.91 } -> conn 7;
    guided -> conn 7;
    conn 7 -> beam 8 { length: 0.9, bending_stiffness: 0.41, mass_per_length: 0.37 } -> conn 11;
    pinned -> beam 10 { length: 0.9, bending_stiffness: 0.41, mass_per_length: 0.37 } -> conn 11;
    conn 11 -> guided;
}

system! {
    pub(crate) struct Undamped39;

    free -> torsion_spring 1 { stiffness: 0.24 } -> inertia 2 { inertia: 3.57 } -> conn 4;
    free -> conn 4;
    conn 4 -> inertia 5 { inertia: 4.63 } -> inertia 6 { inertia: 1.07 } -> fixed;
}

system! {
    pub(crate) struct Undamped43;

    fixed -> torsion_spring 1 { stiffness: 0.36 } -> inertia 2 { inertia: 0.36 } -> torsion_spring 3 { stiffness: 0.94 } -> conn 7;
    free -> mass 5 { mass: 2.3 } -> conn 7;
    free -> conn 7;
    fixed -> torsion_spring 11 { stiffness: 1.16 } -> torsion_spring 12 { stiffness: 3.75 } -> inertia 13 { inertia: 2.31 } -> conn 15;
    guided -> conn 15;
    conn 15 -> mass 16 { mass: 1.36 } -> conn 22;
    fixed -> torsion_spring 18 { stiffness: 0.21 } -> inertia 19 { inertia: 1.61 } -> inertia 20 { inertia: 3.48 } -> conn 22;
    fixed -> conn 22;
    conn 7 -> hinge 8 { stiffness_y: 22.9, stiffness_rz: 0.51 } -> beam 9 { length: 3.02, bending_stiffness: 0.32, mass_per_length: 0.32 } -> conn 25;
    conn 22 -> body 23 { mass: 3.93, inertia_about_input: 2.63340425, output_x: 1.88, centre_x: 0.815 } -> beam 24 { length: 1.87, bending_stiffness: 1.98, mass_per_length: 0.65 } -> conn 25;
    conn 25 -> point_mass 26 { mass: 0.24, inertia: 0.34400000000000003 } -> beam 27 { length: 1.28, bending_stiffness: 0.27, mass_per_length: 0.28 } -> fixed;
}

system! {
    pub(crate) struct Undamped44;

    pinned -> beam 4 { length: 1.12, bending_stiffness: 0.41, mass_per_length: 2.25 } -> beam 5 { length: 0.98, bending_stiffness: 1.08, mass_per_length: 2.54 } -> conn 7;
    pinned -> conn 7;
    free -> beam 1 { length: 0.55, bending_stiffness: 1.62, mass_per_length: 3.1 } -> body 2 { mass: 2.02, inertia_about_input: 0.02905, output_x: 0.495, centre_x: 0.05 } -> conn 10;
    conn 7 -> body 8 { mass: 0.69, inertia_about_input: 0.5047143125, output_x: 0.525, centre_x: 0.6775 } -> body 9 { mass: 0.42, inertia_about_input: 0.0435625, output_x: 1.15, centre_x: 0.125 } -> conn 10;
    conn 10 -> guided;
}

system! {
    pub(crate) struct Undamped45;

    guided -> beam 1 { length: 4.45, bending_stiffness: 1.47, mass_per_length: 1.97 } -> body 2 { mass: 0.24, inertia_about_input: 0.0349375, output_x: 1.06, centre_x: 0.0625 } -> conn 5;
    pinned -> beam 4 { length: 0.4, bending_stiffness: 0.52, mass_per_length: 0.95 } -> conn 5;
    conn 5 -> fixed;
}

system! {
    pub(crate) struct Undamped48;

    pinned -> body 1 { mass: 3.35, inertia_about_input: 0.18713500000000002, output_x: 0.72, centre_x: 0.09 } -> conn 3;
    free -> conn 3;
    conn 3 -> point_mass 4 { mass: 0.25, inertia: 0.15600000000000003 } -> conn 5;
    conn 5 -> inertia 6 { inertia: 2.89 } -> conn 13;
    pinned -> beam 8 { length: 0.7, bending_stiffness: 0.58, mass_per_length: 1.18 } -> point_mass 9 { mass: 1.83, inertia: 0.296 } -> conn 13;
    fixed -> beam 11 { length: 3.09, bending_stiffness: 0.62, mass_per_length: 0.26 } -> body 12 { mass: 0.39, inertia_about_input: 0.29031975, output_x: 1.615, centre_x: 0.655 } -> conn 13;
    conn 13 -> mass 14 { mass: 3.89 } -> mass 15 { mass: 0.2 } -> free;
}

system! {
    pub(crate) struct Undamped51;

    pinned -> body 1 { mass: 0.22, inertia_about_input: 0.048321375, output_x: 0.645, centre_x: 0.0775 } -> conn 3;
    free -> conn 3;
    conn 3 -> beam 4 { length: 3.21, bending_stiffness: 0.37, mass_per_length: 2.14 } -> free;
}

system! {
    pub(crate) struct Undamped53;

    pinned -> hinge 1 { stiffness_y: 2.6, stiffness_rz: 0.22 } -> conn 5;
    fixed -> point_mass 3 { mass: 0.23, inertia: 0.095 } -> beam 4 { length: 4.14, bending_stiffness: 0.5, mass_per_length: 0.48 } -> conn 5;
    pinned -> hinge 9 { stiffness_y: 2.6, stiffness_rz: 0.22 } -> conn 13;
    fixed -> point_mass 11 { mass: 0.23, inertia: 0.095 } -> beam 12 { length: 4.14, bending_stiffness: 0.5, mass_per_length: 0.48 } -> conn 13;
    conn 5 -> torsion_spring 6 { stiffness: 0.5 } -> inertia 7 { inertia: 3.75 } -> conn 17;
    conn 13 -> torsion_spring 14 { stiffness: 0.5 } -> inertia 15 { inertia: 3.75 } -> conn 17;
    guided -> conn 17;
    conn 17 -> body 18 { mass: 3.4, inertia_about_input: 0.12639125, output_x: 1.605, centre_x: 0.1675 } -> body 19 { mass: 0.95, inertia_about_input: 0.1350559375, output_x: 1.055, centre_x: 0.1975 } -> conn 21;
    free -> conn 21;
    conn 21 -> torsion_spring 22 { stiffness: 0.53 } -> free;
}

system! {
    pub(crate) struct Undamped55;

    pinned -> beam 1 { length: 1.69, bending_stiffness: 1.19, mass_per_length: 0.74 } -> conn 4;
    guided -> beam 3 { length: 2.1, bending_stiffness: 1.58, mass_per_length: 0.78 } -> conn 4;
    conn 4 -> free;
}

system! {
    pub(crate) struct Undamped63;

    pinned -> beam 1 { length: 2.81, bending_stiffness: 1.68, mass_per_length: 1.2 } -> point_mass 2 { mass: 0.48, inertia: 0.10200000000000001 } -> conn 6;
    guided -> beam 4 { length: 0.29, bending_stiffness: 0.56, mass_per_length: 0.84 } -> body 5 { mass: 0.22, inertia_about_input: 0.2532655, output_x: 0.41, centre_x: 0.695 } -> conn 6;
    conn 6 -> guided;
}

system! {
    pub(crate) struct Undamped64;

    free -> inertia 1 { inertia: 3.0 } -> torsion_spring 2 { stiffness: 1.63 } -> conn 8;
    free -> mass 4 { mass: 0.65 } -> conn 8;
    free -> mass 6 { mass: 0.65 } -> conn 8;
    free -> conn 8;
    conn 8 -> beam 9 { length: 0.27, bending_stiffness: 0.4, mass_per_length: 0.64 } -> point_mass 10 { mass: 0.23, inertia: 0.118 } -> conn 17;
    free -> body 12 { mass: 0.25, inertia_about_input: 0.06425156250000001, output_x: 0.735, centre_x: 0.2025 } -> conn 17;
    fixed -> spring 14 { stiffness: 9.5 } -> spring 15 { stiffness: 2.2 } -> mass 16 { mass: 0.25 } -> conn 17;
    conn 17 -> inertia 18 { inertia: 2.09 } -> inertia 19 { inertia: 4.89 } -> conn 25;
    fixed -> spring 21 { stiffness: 26.6 } -> spring 22 { stiffness: 2.6 } -> spring 23 { stiffness: 14.8 } -> conn 25;
    guided -> conn 25;
    conn 25 -> beam 26 { length: 1.28, bending_stiffness: 3.02, mass_per_length: 1.05 } -> free;
}

system! {
    pub(crate) struct Undamped67;

    guided -> beam 1 { length: 0.83, bending_stiffness: 0.28, mass_per_length: 2.54 } -> conn 3;
    free -> conn 3;
    conn 3 -> beam 4 { length: 0.48, bending_stiffness: 2.84, mass_per_length: 4.99 } -> conn 6;
    free -> conn 6;
    fixed -> spring 9 { stiffness: 25.8 } -> mass 10 { mass: 0.68 } -> mass 11 { mass: 0.33 } -> conn 17;
    free -> mass 13 { mass: 0.37 } -> conn 17;
    free -> mass 15 { mass: 4.27 } -> spring 16 { stiffness: 3.7 } -> conn 17;
    conn 17 -> mass 18 { mass: 1.22 } -> spring 19 { stiffness: 41.0 } -> conn 21;
    free -> conn 21;
    conn 6 -> beam 7 { length: 0.27, bending_stiffness: 1.5, mass_per_length: 0.78 } -> conn 25;
    conn 21 -> torsion_spring 22 { stiffness: 0.42 } -> torsion_spring 23 { stiffness: 0.28 } -> conn 25;
    free -> conn 25;
    conn 25 -> inertia 26 { inertia: 1.12 } -> torsion_spring 27 { stiffness: 0.33 } -> fixed;
}

system! {
    pub(crate) struct Undamped70;

    fixed -> beam 3 { length: 0.21, bending_stiffness: 1.35, mass_per_length: 0.31 } -> conn 10;
    free -> mass 5 { mass: 0.57 } -> mass 6 { mass: 0.24 } -> conn 10;
    free -> mass 8 { mass: 0.57 } -> mass 9 { mass: 0.24 } -> conn 10;
    fixed -> beam 1 { length: 1.67, bending_stiffness: 0.67, mass_per_length: 2.82 } -> conn 12;
    conn 10 -> point_mass 11 { mass: 0.83, inertia: 0.148 } -> conn 12;
    conn 12 -> pinned;
}

/// Calls a function with the seed and the system of each model.
macro_rules! for_each_undamped {
    ($check:ident) => {
        $check(2, $crate::undamped_models::Undamped2.build());
        $check(6, $crate::undamped_models::Undamped6.build());
        $check(7, $crate::undamped_models::Undamped7.build());
        $check(14, $crate::undamped_models::Undamped14.build());
        $check(15, $crate::undamped_models::Undamped15.build());
        $check(16, $crate::undamped_models::Undamped16.build());
        $check(17, $crate::undamped_models::Undamped17.build());
        $check(18, $crate::undamped_models::Undamped18.build());
        $check(22, $crate::undamped_models::Undamped22.build());
        $check(31, $crate::undamped_models::Undamped31.build());
        $check(35, $crate::undamped_models::Undamped35.build());
        $check(36, $crate::undamped_models::Undamped36.build());
        $check(39, $crate::undamped_models::Undamped39.build());
        $check(43, $crate::undamped_models::Undamped43.build());
        $check(44, $crate::undamped_models::Undamped44.build());
        $check(45, $crate::undamped_models::Undamped45.build());
        $check(48, $crate::undamped_models::Undamped48.build());
        $check(51, $crate::undamped_models::Undamped51.build());
        $check(53, $crate::undamped_models::Undamped53.build());
        $check(55, $crate::undamped_models::Undamped55.build());
        $check(63, $crate::undamped_models::Undamped63.build());
        $check(64, $crate::undamped_models::Undamped64.build());
        $check(67, $crate::undamped_models::Undamped67.build());
        $check(70, $crate::undamped_models::Undamped70.build());
    };
}
pub(crate) use for_each_undamped;
