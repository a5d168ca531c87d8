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
    conn 18 -> body 19 { mass: 4.91, inertia: 1.991779, output_x: 0.395, centre_x: 0.63 } -> fixed;
}

system! {
    pub(crate) struct Undamped6;

    fixed -> spring 1 { stiffness: 6.1 } -> spring 2 { stiffness: 2.5 } -> conn 10;
    pinned -> elastic_hinge 4 { stiffness_y: 3.1, stiffness_theta: 0.61 } -> beam 5 { length: 0.7, bending_stiffness: 0.69, mass_per_length: 0.21 } -> conn 10;
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

    free -> body 1 { mass: 0.28, inertia: 0.13974299999999998, output_x: 1.55, centre_x: 0.285 } -> conn 2;
    conn 2 -> spring 3 { stiffness: 15.700000000000001 } -> fixed;
}

system! {
    pub(crate) struct Undamped14;

    pinned -> body 3 { mass: 1.23, inertia: 1.5260726875, output_x: 0.555, centre_x: 1.1025 } -> beam 4 { length: 0.93, bending_stiffness: 3.56, mass_per_length: 0.32 } -> conn 6;
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
    conn 8 -> body 9 { mass: 3.71, inertia: 0.24525118750000002, output_x: 0.395, centre_x: 0.0825 } -> conn 21;
    conn 18 -> body 19 { mass: 3.71, inertia: 0.24525118750000002, output_x: 0.395, centre_x: 0.0825 } -> conn 21;
    free -> conn 21;
    conn 21 -> body 22 { mass: 1.96, inertia: 0.46236900000000003, output_x: 0.33, centre_x: 0.205 } -> body 23 { mass: 0.88, inertia: 0.17046550000000002, output_x: 1.305, centre_x: 0.1525 } -> free;
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

    guided -> elastic_hinge 1 { stiffness_y: 11.399999999999999, stiffness_theta: 0.21 } -> conn 3;
    free -> conn 3;
    conn 3 -> beam 4 { length: 0.28, bending_stiffness: 3.41, mass_per_length: 0.28 } -> beam 5 { length: 2.24, bending_stiffness: 0.39, mass_per_length: 0.51 } -> pinned;
}

system! {
    pub(crate) struct Undamped22;

    guided -> beam 4 { length: 3.98, bending_stiffness: 0.49, mass_per_length: 0.26 } -> conn 7;
    guided -> beam 6 { length: 3.98, bending_stiffness: 0.49, mass_per_length: 0.26 } -> conn 7;
    pinned -> beam 1 { length: 1.62, bending_stiffness: 0.85, mass_per_length: 0.95 } -> beam 2 { length: 0.33, bending_stiffness: 0.85, mass_per_length: 1.11 } -> conn 10;
    conn 7 -> point_mass 8 { mass: 0.21, inertia: 0.24300000000000002 } -> body 9 { mass: 2.04, inertia: 0.27625275, output_x: 0.1, centre_x: 0.0775 } -> conn 10;
    conn 10 -> fixed;
}

system! {
    pub(crate) struct Undamped31;

    pinned -> beam 1 { length: 2.44, bending_stiffness: 1.79, mass_per_length: 4.63 } -> conn 9;
    fixed -> spring 3 { stiffness: 31.0 } -> spring 4 { stiffness: 11.799999999999999 } -> conn 9;
    fixed -> spring 6 { stiffness: 31.0 } -> spring 7 { stiffness: 11.799999999999999 } -> conn 9;
    pinned -> conn 9;
    conn 9 -> body 10 { mass: 0.23, inertia: 0.50084575, output_x: 0.49, centre_x: 0.555 } -> beam 11 { length: 0.23, bending_stiffness: 1.08, mass_per_length: 1.0 } -> free;
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
    pub(crate) struct Undamped44;

    pinned -> beam 4 { length: 1.12, bending_stiffness: 0.41, mass_per_length: 2.25 } -> beam 5 { length: 0.98, bending_stiffness: 1.08, mass_per_length: 2.54 } -> conn 7;
    pinned -> conn 7;
    free -> beam 1 { length: 0.55, bending_stiffness: 1.62, mass_per_length: 3.1 } -> body 2 { mass: 2.02, inertia: 0.02905, output_x: 0.495, centre_x: 0.05 } -> conn 10;
    conn 7 -> body 8 { mass: 0.69, inertia: 0.5047143125, output_x: 0.525, centre_x: 0.6775 } -> body 9 { mass: 0.42, inertia: 0.0435625, output_x: 1.15, centre_x: 0.125 } -> conn 10;
    conn 10 -> guided;
}

system! {
    pub(crate) struct Undamped45;

    guided -> beam 1 { length: 4.45, bending_stiffness: 1.47, mass_per_length: 1.97 } -> body 2 { mass: 0.24, inertia: 0.0349375, output_x: 1.06, centre_x: 0.0625 } -> conn 5;
    pinned -> beam 4 { length: 0.4, bending_stiffness: 0.52, mass_per_length: 0.95 } -> conn 5;
    conn 5 -> fixed;
}

system! {
    pub(crate) struct Undamped48;

    pinned -> body 1 { mass: 3.35, inertia: 0.18713500000000002, output_x: 0.72, centre_x: 0.09 } -> conn 3;
    free -> conn 3;
    conn 3 -> point_mass 4 { mass: 0.25, inertia: 0.15600000000000003 } -> conn 5;
    conn 5 -> inertia 6 { inertia: 2.89 } -> conn 13;
    pinned -> beam 8 { length: 0.7, bending_stiffness: 0.58, mass_per_length: 1.18 } -> point_mass 9 { mass: 1.83, inertia: 0.296 } -> conn 13;
    fixed -> beam 11 { length: 3.09, bending_stiffness: 0.62, mass_per_length: 0.26 } -> body 12 { mass: 0.39, inertia: 0.29031975, output_x: 1.615, centre_x: 0.655 } -> conn 13;
    conn 13 -> mass 14 { mass: 3.89 } -> mass 15 { mass: 0.2 } -> free;
}

system! {
    pub(crate) struct Undamped51;

    pinned -> body 1 { mass: 0.22, inertia: 0.048321375, output_x: 0.645, centre_x: 0.0775 } -> conn 3;
    free -> conn 3;
    conn 3 -> beam 4 { length: 3.21, bending_stiffness: 0.37, mass_per_length: 2.14 } -> free;
}

system! {
    pub(crate) struct Undamped53;

    pinned -> elastic_hinge 1 { stiffness_y: 2.6, stiffness_theta: 0.22 } -> conn 5;
    fixed -> point_mass 3 { mass: 0.23, inertia: 0.095 } -> beam 4 { length: 4.14, bending_stiffness: 0.5, mass_per_length: 0.48 } -> conn 5;
    pinned -> elastic_hinge 9 { stiffness_y: 2.6, stiffness_theta: 0.22 } -> conn 13;
    fixed -> point_mass 11 { mass: 0.23, inertia: 0.095 } -> beam 12 { length: 4.14, bending_stiffness: 0.5, mass_per_length: 0.48 } -> conn 13;
    conn 5 -> torsion_spring 6 { stiffness: 0.5 } -> inertia 7 { inertia: 3.75 } -> conn 17;
    conn 13 -> torsion_spring 14 { stiffness: 0.5 } -> inertia 15 { inertia: 3.75 } -> conn 17;
    guided -> conn 17;
    conn 17 -> body 18 { mass: 3.4, inertia: 0.12639125, output_x: 1.605, centre_x: 0.1675 } -> body 19 { mass: 0.95, inertia: 0.1350559375, output_x: 1.055, centre_x: 0.1975 } -> conn 21;
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
    guided -> beam 4 { length: 0.29, bending_stiffness: 0.56, mass_per_length: 0.84 } -> body 5 { mass: 0.22, inertia: 0.2532655, output_x: 0.41, centre_x: 0.695 } -> conn 6;
    conn 6 -> guided;
}

system! {
    pub(crate) struct Undamped64;

    free -> inertia 1 { inertia: 3.0 } -> torsion_spring 2 { stiffness: 1.63 } -> conn 8;
    free -> mass 4 { mass: 0.65 } -> conn 8;
    free -> mass 6 { mass: 0.65 } -> conn 8;
    free -> conn 8;
    conn 8 -> beam 9 { length: 0.27, bending_stiffness: 0.4, mass_per_length: 0.64 } -> point_mass 10 { mass: 0.23, inertia: 0.118 } -> conn 17;
    free -> body 12 { mass: 0.25, inertia: 0.06425156250000001, output_x: 0.735, centre_x: 0.2025 } -> conn 17;
    fixed -> spring 14 { stiffness: 9.5 } -> spring 15 { stiffness: 2.2 } -> mass 16 { mass: 0.25 } -> conn 17;
    conn 17 -> inertia 18 { inertia: 2.09 } -> inertia 19 { inertia: 4.89 } -> conn 25;
    fixed -> spring 21 { stiffness: 26.6 } -> spring 22 { stiffness: 2.6 } -> spring 23 { stiffness: 14.8 } -> conn 25;
    guided -> conn 25;
    conn 25 -> beam 26 { length: 1.28, bending_stiffness: 3.02, mass_per_length: 1.05 } -> free;
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

system! {
    pub(crate) struct Undamped81;

    free -> spring 1 { stiffness: 33.8 } -> mass 2 { mass: 0.23 } -> conn 4;
    fixed -> conn 4;
    conn 4 -> beam 5 { length: 2.9, bending_stiffness: 0.87, mass_per_length: 1.58 } -> body 6 { mass: 1.25, inertia: 0.5390078125, output_x: 0.25, centre_x: 0.6425 } -> conn 8;
    free -> conn 8;
    conn 8 -> point_mass 9 { mass: 0.29, inertia: 0.033 } -> body 10 { mass: 0.97, inertia: 0.7873080000000001, output_x: 0.115, centre_x: 0.58 } -> guided;
}

system! {
    pub(crate) struct Undamped88;

    fixed -> torsion_spring 1 { stiffness: 2.84 } -> torsion_spring 2 { stiffness: 2.14 } -> inertia 3 { inertia: 0.84 } -> conn 5;
    free -> conn 5;
    fixed -> beam 8 { length: 4.29, bending_stiffness: 3.91, mass_per_length: 0.65 } -> conn 14;
    guided -> beam 10 { length: 4.29, bending_stiffness: 3.91, mass_per_length: 0.65 } -> conn 14;
    guided -> point_mass 12 { mass: 0.33, inertia: 0.46799999999999997 } -> elastic_hinge 13 { stiffness_y: 6.8999999999999995, stiffness_theta: 3.8 } -> conn 14;
    conn 5 -> beam 6 { length: 0.2, bending_stiffness: 1.2, mass_per_length: 0.76 } -> conn 16;
    conn 14 -> body 15 { mass: 0.3, inertia: 0.36830187500000006, output_x: 0.105, centre_x: 0.2025 } -> conn 16;
    conn 16 -> fixed;
}

/// Calls a function with the seed and the system of each model.
macro_rules! for_each_undamped {
    ($check:ident) => {
        $check(2, $crate::written_models::Undamped2.build());
        $check(6, $crate::written_models::Undamped6.build());
        $check(7, $crate::written_models::Undamped7.build());
        $check(14, $crate::written_models::Undamped14.build());
        $check(15, $crate::written_models::Undamped15.build());
        $check(16, $crate::written_models::Undamped16.build());
        $check(17, $crate::written_models::Undamped17.build());
        $check(18, $crate::written_models::Undamped18.build());
        $check(22, $crate::written_models::Undamped22.build());
        $check(31, $crate::written_models::Undamped31.build());
        $check(35, $crate::written_models::Undamped35.build());
        $check(36, $crate::written_models::Undamped36.build());
        $check(39, $crate::written_models::Undamped39.build());
        $check(44, $crate::written_models::Undamped44.build());
        $check(45, $crate::written_models::Undamped45.build());
        $check(48, $crate::written_models::Undamped48.build());
        $check(51, $crate::written_models::Undamped51.build());
        $check(53, $crate::written_models::Undamped53.build());
        $check(55, $crate::written_models::Undamped55.build());
        $check(63, $crate::written_models::Undamped63.build());
        $check(64, $crate::written_models::Undamped64.build());
        $check(70, $crate::written_models::Undamped70.build());
        $check(81, $crate::written_models::Undamped81.build());
        $check(88, $crate::written_models::Undamped88.build());
    };
}
pub(crate) use for_each_undamped;

system! {
    pub(crate) struct Damped2;

    guided -> beam 13 { length: 0.25, bending_stiffness: 0.53, mass_per_length: 2.17 } -> beam 14 { length: 0.25, bending_stiffness: 0.53, mass_per_length: 2.17 } -> conn 16;
    free -> conn 16;
    free -> mass 1 { mass: 1.26 } -> spring_damper 2 { stiffness: 31.9, damping: 0.76 } -> conn 18;
    free -> mass 4 { mass: 1.26 } -> spring_damper 5 { stiffness: 31.9, damping: 0.76 } -> conn 18;
    free -> mass 7 { mass: 1.26 } -> spring_damper 8 { stiffness: 31.9, damping: 0.76 } -> conn 18;
    fixed -> damper 10 { damping: 3.9 } -> spring 11 { stiffness: 3.7 } -> conn 18;
    conn 16 -> beam 17 { length: 1.67, bending_stiffness: 0.2, mass_per_length: 3.05 } -> conn 18;
    conn 18 -> body 19 { mass: 4.91, inertia: 1.991779, output_x: 0.395, centre_x: 0.63 } -> fixed;
}

system! {
    pub(crate) struct Damped7;

    free -> body 1 { mass: 0.28, inertia: 0.13974299999999998, output_x: 1.55, centre_x: 0.285 } -> conn 2;
    conn 2 -> damper 3 { damping: 3.63 } -> fixed;
}

system! {
    pub(crate) struct Damped16;

    free -> mass 1 { mass: 0.42 } -> mass 2 { mass: 0.96 } -> conn 8;
    fixed -> spring_damper 4 { stiffness: 2.3000000000000003, damping: 1.69 } -> damper 5 { damping: 4.02 } -> mass 6 { mass: 0.98 } -> conn 8;
    free -> conn 8;
    conn 8 -> spring 9 { stiffness: 5.0 } -> fixed;
}

system! {
    pub(crate) struct Damped31;

    pinned -> beam 1 { length: 2.44, bending_stiffness: 1.79, mass_per_length: 4.63 } -> conn 9;
    fixed -> damper 3 { damping: 0.3 } -> spring 4 { stiffness: 11.799999999999999 } -> conn 9;
    fixed -> damper 6 { damping: 0.3 } -> spring 7 { stiffness: 11.799999999999999 } -> conn 9;
    pinned -> conn 9;
    conn 9 -> body 10 { mass: 0.23, inertia: 0.50084575, output_x: 0.49, centre_x: 0.555 } -> beam 11 { length: 0.23, bending_stiffness: 1.08, mass_per_length: 1.0 } -> free;
}

system! {
    pub(crate) struct Damped35;

    fixed -> damper 1 { damping: 3.59 } -> mass 2 { mass: 0.57 } -> spring 3 { stiffness: 40.0 } -> conn 5;
    free -> conn 5;
    conn 5 -> beam 6 { length: 1.86, bending_stiffness: 0.37, mass_per_length: 1.3 } -> free;
}

system! {
    pub(crate) struct Damped39;

    free -> torsion_spring_damper 1 { stiffness: 0.24, damping: 0.098 } -> inertia 2 { inertia: 3.57 } -> conn 4;
    free -> conn 4;
    conn 4 -> inertia 5 { inertia: 4.63 } -> inertia 6 { inertia: 1.07 } -> fixed;
}

system! {
    pub(crate) struct Damped53;

    pinned -> elastic_hinge 1 { stiffness_y: 2.6, stiffness_theta: 0.22 } -> conn 5;
    fixed -> point_mass 3 { mass: 0.23, inertia: 0.095 } -> beam 4 { length: 4.14, bending_stiffness: 0.5, mass_per_length: 0.48 } -> conn 5;
    pinned -> elastic_hinge 9 { stiffness_y: 2.6, stiffness_theta: 0.22 } -> conn 13;
    fixed -> point_mass 11 { mass: 0.23, inertia: 0.095 } -> beam 12 { length: 4.14, bending_stiffness: 0.5, mass_per_length: 0.48 } -> conn 13;
    conn 5 -> torsion_damper 6 { damping: 0.025 } -> inertia 7 { inertia: 3.75 } -> conn 17;
    conn 13 -> torsion_damper 14 { damping: 0.025 } -> inertia 15 { inertia: 3.75 } -> conn 17;
    guided -> conn 17;
    conn 17 -> body 18 { mass: 3.4, inertia: 0.12639125, output_x: 1.605, centre_x: 0.1675 } -> body 19 { mass: 0.95, inertia: 0.1350559375, output_x: 1.055, centre_x: 0.1975 } -> conn 21;
    free -> conn 21;
    conn 21 -> torsion_spring 22 { stiffness: 0.53 } -> free;
}

system! {
    pub(crate) struct Damped90;

    free -> beam 4 { length: 0.29, bending_stiffness: 1.8, mass_per_length: 0.2 } -> body 5 { mass: 0.23, inertia: 0.1290734375, output_x: 1.775, centre_x: 0.1625 } -> conn 11;
    fixed -> spring_damper 7 { stiffness: 2.6, damping: 0.27 } -> mass 8 { mass: 3.09 } -> conn 11;
    free -> spring_damper 10 { stiffness: 16.0, damping: 4.51 } -> conn 11;
    pinned -> beam 1 { length: 0.89, bending_stiffness: 0.2, mass_per_length: 0.27 } -> beam 2 { length: 0.39, bending_stiffness: 1.09, mass_per_length: 0.2 } -> conn 14;
    conn 11 -> body 12 { mass: 2.09, inertia: 0.15538399999999997, output_x: 0.63, centre_x: 0.24 } -> body 13 { mass: 0.66, inertia: 0.376504, output_x: 0.275, centre_x: 0.12 } -> conn 14;
    conn 14 -> pinned;
}

system! {
    pub(crate) struct Damped116;

    pinned -> point_mass 1 { mass: 1.79, inertia: 0.20099999999999998 } -> conn 2;
    conn 2 -> torsion_damper 3 { damping: 0.342 } -> conn 5;
    free -> conn 5;
    conn 5 -> beam 6 { length: 2.29, bending_stiffness: 3.78, mass_per_length: 1.67 } -> free;
}

system! {
    pub(crate) struct Damped119;

    fixed -> damper 1 { damping: 2.97 } -> mass 2 { mass: 0.94 } -> mass 3 { mass: 4.81 } -> conn 5;
    free -> conn 5;
    conn 5 -> beam 6 { length: 0.36, bending_stiffness: 0.21, mass_per_length: 0.81 } -> conn 10;
    guided -> body 8 { mass: 0.52, inertia: 0.20431325, output_x: 0.215, centre_x: 0.1475 } -> body 9 { mass: 0.37, inertia: 0.432125, output_x: 0.34, centre_x: 0.75 } -> conn 10;
    conn 10 -> pinned;
}

system! {
    pub(crate) struct Damped124;

    fixed -> torsion_spring_damper 3 { stiffness: 2.93, damping: 0.27599999999999997 } -> inertia 4 { inertia: 4.16 } -> torsion_spring_damper 5 { stiffness: 0.5, damping: 0.06 } -> conn 9;
    fixed -> torsion_spring_damper 7 { stiffness: 4.2, damping: 0.05500000000000001 } -> torsion_spring 8 { stiffness: 1.85 } -> conn 9;
    free -> inertia 1 { inertia: 2.18 } -> conn 12;
    conn 9 -> inertia 10 { inertia: 1.71 } -> conn 12;
    free -> conn 12;
    conn 12 -> torsion_spring 13 { stiffness: 2.14 } -> torsion_spring 14 { stiffness: 1.72 } -> conn 16;
    free -> conn 16;
    conn 16 -> torsion_spring_damper 17 { stiffness: 0.75, damping: 0.427 } -> torsion_spring_damper 18 { stiffness: 0.94, damping: 0.09300000000000001 } -> fixed;
}

system! {
    pub(crate) struct Damped132;

    fixed -> spring_damper 3 { stiffness: 4.699999999999999, damping: 0.44 } -> mass 4 { mass: 4.34 } -> spring_damper 5 { stiffness: 13.100000000000001, damping: 0.3 } -> conn 12;
    fixed -> body 7 { mass: 0.8, inertia: 1.0974800000000002, output_x: 0.61, centre_x: 1.09 } -> beam 8 { length: 1.42, bending_stiffness: 3.28, mass_per_length: 0.78 } -> conn 12;
    fixed -> torsion_spring 10 { stiffness: 0.25 } -> inertia 11 { inertia: 2.54 } -> conn 12;
    guided -> beam 1 { length: 1.42, bending_stiffness: 3.28, mass_per_length: 0.78 } -> conn 14;
    conn 12 -> point_mass 13 { mass: 0.5, inertia: 0.22400000000000003 } -> conn 14;
    conn 14 -> pinned;
}

system! {
    pub(crate) struct Damped141;

    fixed -> torsion_damper 1 { damping: 0.163 } -> inertia 2 { inertia: 2.25 } -> torsion_spring 3 { stiffness: 0.39 } -> conn 15;
    fixed -> torsion_damper 5 { damping: 0.163 } -> inertia 6 { inertia: 2.25 } -> torsion_spring 7 { stiffness: 0.39 } -> conn 15;
    fixed -> torsion_damper 9 { damping: 0.163 } -> inertia 10 { inertia: 2.25 } -> torsion_spring 11 { stiffness: 0.39 } -> conn 15;
    free -> beam 13 { length: 0.2, bending_stiffness: 1.73, mass_per_length: 3.06 } -> body 14 { mass: 0.43, inertia: 0.04154800000000001, output_x: 0.815, centre_x: 0.06 } -> conn 15;
    conn 15 -> mass 16 { mass: 0.26 } -> free;
}

system! {
    pub(crate) struct Damped151;

    free -> point_mass 1 { mass: 3.49, inertia: 0.025 } -> conn 3;
    free -> conn 3;
    conn 3 -> damper 4 { damping: 0.23 } -> mass 5 { mass: 0.21 } -> fixed;
}

system! {
    pub(crate) struct Damped158;

    fixed -> beam 1 { length: 1.43, bending_stiffness: 0.38, mass_per_length: 0.65 } -> body 2 { mass: 0.72, inertia: 0.174392, output_x: 0.64, centre_x: 0.44 } -> conn 3;
    conn 3 -> torsion_spring 4 { stiffness: 1.24 } -> torsion_damper 5 { damping: 0.026000000000000002 } -> fixed;
}

system! {
    pub(crate) struct Damped170;

    free -> torsion_spring_damper 3 { stiffness: 0.32, damping: 0.08100000000000002 } -> inertia 4 { inertia: 0.52 } -> conn 11;
    pinned -> beam 6 { length: 1.9, bending_stiffness: 2.26, mass_per_length: 1.99 } -> conn 11;
    pinned -> beam 8 { length: 1.9, bending_stiffness: 2.26, mass_per_length: 1.99 } -> conn 11;
    pinned -> beam 10 { length: 1.9, bending_stiffness: 2.26, mass_per_length: 1.99 } -> conn 11;
    free -> body 15 { mass: 0.64, inertia: 0.10891600000000001, output_x: 1.055, centre_x: 0.0675 } -> body 16 { mass: 1.67, inertia: 0.3936929375, output_x: 1.25, centre_x: 0.1725 } -> conn 19;
    pinned -> body 18 { mass: 1.29, inertia: 0.2548330625, output_x: 0.445, centre_x: 0.3775 } -> conn 19;
    conn 11 -> beam 12 { length: 0.56, bending_stiffness: 3.57, mass_per_length: 0.79 } -> beam 13 { length: 1.9, bending_stiffness: 2.26, mass_per_length: 1.99 } -> conn 21;
    conn 19 -> mass 20 { mass: 0.76 } -> conn 21;
    free -> inertia 1 { inertia: 0.67 } -> conn 25;
    conn 21 -> body 22 { mass: 0.21, inertia: 0.09206900000000001, output_x: 0.13, centre_x: 0.17 } -> body 23 { mass: 1.37, inertia: 0.047406250000000004, output_x: 1.505, centre_x: 0.125 } -> conn 25;
    pinned -> conn 25;
    conn 25 -> body 26 { mass: 1.55, inertia: 0.5585549999999999, output_x: 0.625, centre_x: 0.41 } -> guided;
}

/// Calls a function with the seed and the system of each model.
macro_rules! for_each_damped {
    ($check:ident) => {
        $check(2, $crate::written_models::Damped2.build());
        $check(7, $crate::written_models::Damped7.build());
        $check(16, $crate::written_models::Damped16.build());
        $check(31, $crate::written_models::Damped31.build());
        $check(35, $crate::written_models::Damped35.build());
        $check(39, $crate::written_models::Damped39.build());
        $check(53, $crate::written_models::Damped53.build());
        $check(90, $crate::written_models::Damped90.build());
        $check(116, $crate::written_models::Damped116.build());
        $check(119, $crate::written_models::Damped119.build());
        $check(124, $crate::written_models::Damped124.build());
        $check(132, $crate::written_models::Damped132.build());
        $check(141, $crate::written_models::Damped141.build());
        $check(151, $crate::written_models::Damped151.build());
        $check(158, $crate::written_models::Damped158.build());
        $check(170, $crate::written_models::Damped170.build());
    };
}
pub(crate) use for_each_damped;
