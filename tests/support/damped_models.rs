//! Random trees as models, named after their seeds; `macro_equals_list.rs` says how to write this file again.

use mstmm::prelude::*;

system! {
    pub(crate) struct Damped2;

    guided -> beam 13 { length: 0.25, bending_stiffness: 0.53, mass_per_length: 2.17 } -> beam 14 { length: 0.25, bending_stiffness: 0.53, mass_per_length: 2.17 } -> conn 16;
    free -> conn 16;
    free -> mass 1 { mass: 1.26 } -> spring 2 { stiffness: 31.9, damping: 0.76 } -> conn 18;
    free -> mass 4 { mass: 1.26 } -> spring 5 { stiffness: 31.9, damping: 0.76 } -> conn 18;
    free -> mass 7 { mass: 1.26 } -> spring 8 { stiffness: 31.9, damping: 0.76 } -> conn 18;
    fixed -> damper 10 { damping: 3.9 } -> spring 11 { stiffness: 3.7 } -> conn 18;
    conn 16 -> beam 17 { length: 1.67, bending_stiffness: 0.2, mass_per_length: 3.05 } -> conn 18;
    conn 18 -> body 19 { mass: 4.91, inertia_about_input: 1.991779, output_x: 0.395, centre_x: 0.63 } -> fixed;
}

system! {
    pub(crate) struct Damped7;

    free -> body 1 { mass: 0.28, inertia_about_input: 0.13974299999999998, output_x: 1.55, centre_x: 0.285 } -> conn 2;
    conn 2 -> damper 3 { damping: 3.63 } -> fixed;
}

system! {
    pub(crate) struct Damped16;

    free -> mass 1 { mass: 0.42 } -> mass 2 { mass: 0.96 } -> conn 8;
    fixed -> spring 4 { stiffness: 2.3000000000000003, damping: 1.69 } -> damper 5 { damping: 4.02 } -> mass 6 { mass: 0.98 } -> conn 8;
    free -> conn 8;
    conn 8 -> spring 9 { stiffness: 5.0 } -> fixed;
}

system! {
    pub(crate) struct Damped31;

    pinned -> beam 1 { length: 2.44, bending_stiffness: 1.79, mass_per_length: 4.63 } -> conn 9;
    fixed -> damper 3 { damping: 0.3 } -> spring 4 { stiffness: 11.799999999999999 } -> conn 9;
    fixed -> damper 6 { damping: 0.3 } -> spring 7 { stiffness: 11.799999999999999 } -> conn 9;
    pinned -> conn 9;
    conn 9 -> body 10 { mass: 0.23, inertia_about_input: 0.50084575, output_x: 0.49, centre_x: 0.555 } -> beam 11 { length: 0.23, bending_stiffness: 1.08, mass_per_length: 1.0 } -> free;
}

system! {
    pub(crate) struct Damped35;

    fixed -> damper 1 { damping: 3.59 } -> mass 2 { mass: 0.57 } -> spring 3 { stiffness: 40.0 } -> conn 5;
    free -> conn 5;
    conn 5 -> beam 6 { length: 1.86, bending_stiffness: 0.37, mass_per_length: 1.3 } -> free;
}

system! {
    pub(crate) struct Damped39;

    free -> torsion_spring 1 { stiffness: 0.24, damping: 0.098 } -> inertia 2 { inertia: 3.57 } -> conn 4;
    free -> conn 4;
    conn 4 -> inertia 5 { inertia: 4.63 } -> inertia 6 { inertia: 1.07 } -> fixed;
}

system! {
    pub(crate) struct Damped43;

    fixed -> torsion_spring 1 { stiffness: 0.36, damping: 0.164 } -> inertia 2 { inertia: 0.36 } -> torsion_spring 3 { stiffness: 0.94, damping: 0.066 } -> conn 7;
    free -> mass 5 { mass: 2.3 } -> conn 7;
    free -> conn 7;
    fixed -> torsion_spring 11 { stiffness: 1.16 } -> torsion_spring 12 { stiffness: 3.75, damping: 0.034999999999999996 } -> inertia 13 { inertia: 2.31 } -> conn 15;
    guided -> conn 15;
    conn 15 -> mass 16 { mass: 1.36 } -> conn 22;
    fixed -> torsion_spring 18 { stiffness: 0.21 } -> inertia 19 { inertia: 1.61 } -> inertia 20 { inertia: 3.48 } -> conn 22;
    fixed -> conn 22;
    conn 7 -> hinge 8 { stiffness_y: 22.9, stiffness_rz: 0.51 } -> beam 9 { length: 3.02, bending_stiffness: 0.32, mass_per_length: 0.32 } -> conn 25;
    conn 22 -> body 23 { mass: 3.93, inertia_about_input: 2.63340425, output_x: 1.88, centre_x: 0.815 } -> beam 24 { length: 1.87, bending_stiffness: 1.98, mass_per_length: 0.65 } -> conn 25;
    conn 25 -> point_mass 26 { mass: 0.24, inertia: 0.34400000000000003 } -> beam 27 { length: 1.28, bending_stiffness: 0.27, mass_per_length: 0.28 } -> fixed;
}

system! {
    pub(crate) struct Damped53;

    pinned -> hinge 1 { stiffness_y: 2.6, stiffness_rz: 0.22 } -> conn 5;
    fixed -> point_mass 3 { mass: 0.23, inertia: 0.095 } -> beam 4 { length: 4.14, bending_stiffness: 0.5, mass_per_length: 0.48 } -> conn 5;
    pinned -> hinge 9 { stiffness_y: 2.6, stiffness_rz: 0.22 } -> conn 13;
    fixed -> point_mass 11 { mass: 0.23, inertia: 0.095 } -> beam 12 { length: 4.14, bending_stiffness: 0.5, mass_per_length: 0.48 } -> conn 13;
    conn 5 -> torsion_damper 6 { damping: 0.025 } -> inertia 7 { inertia: 3.75 } -> conn 17;
    conn 13 -> torsion_damper 14 { damping: 0.025 } -> inertia 15 { inertia: 3.75 } -> conn 17;
    guided -> conn 17;
    conn 17 -> body 18 { mass: 3.4, inertia_about_input: 0.12639125, output_x: 1.605, centre_x: 0.1675 } -> body 19 { mass: 0.95, inertia_about_input: 0.1350559375, output_x: 1.055, centre_x: 0.1975 } -> conn 21;
    free -> conn 21;
    conn 21 -> torsion_spring 22 { stiffness: 0.53 } -> free;
}

system! {
    pub(crate) struct Damped90;

    free -> beam 4 { length: 0.29, bending_stiffness: 1.8, mass_per_length: 0.2 } -> body 5 { mass: 0.23, inertia_about_input: 0.1290734375, output_x: 1.775, centre_x: 0.1625 } -> conn 11;
    fixed -> spring 7 { stiffness: 2.6, damping: 0.27 } -> mass 8 { mass: 3.09 } -> conn 11;
    free -> spring 10 { stiffness: 16.0, damping: 4.51 } -> conn 11;
    pinned -> beam 1 { length: 0.89, bending_stiffness: 0.2, mass_per_length: 0.27 } -> beam 2 { length: 0.39, bending_stiffness: 1.09, mass_per_length: 0.2 } -> conn 14;
    conn 11 -> body 12 { mass: 2.09, inertia_about_input: 0.15538399999999997, output_x: 0.63, centre_x: 0.24 } -> body 13 { mass: 0.66, inertia_about_input: 0.376504, output_x: 0.275, centre_x: 0.12 } -> conn 14;
    conn 14 -> pinned;
}

system! {
    pub(crate) struct Damped102;

    free -> mass 1 { mass: 0.28 } -> conn 3;
    guided -> conn 3;
    conn 3 -> inertia 4 { inertia: 3.86 } -> torsion_spring 5 { stiffness: 0.31, damping: 0.263 } -> conn 10;
    fixed -> torsion_spring 7 { stiffness: 0.73, damping: 0.451 } -> inertia 8 { inertia: 0.95 } -> conn 10;
    free -> conn 10;
    conn 10 -> beam 11 { length: 1.62, bending_stiffness: 0.26, mass_per_length: 1.61 } -> hinge 12 { stiffness_y: 45.599999999999994, stiffness_rz: 4.49 } -> fixed;
}

system! {
    pub(crate) struct Damped116;

    pinned -> point_mass 1 { mass: 1.79, inertia: 0.20099999999999998 } -> conn 2;
    conn 2 -> torsion_damper 3 { damping: 0.342 } -> conn 5;
    free -> conn 5;
    conn 5 -> beam 6 { length: 2.29, bending_stiffness: 3.78, mass_per_length: 1.67 } -> free;
}

system! {
    pub(crate) struct Damped118;

    fixed -> torsion_damper 1 { damping: 0.034999999999999996 } -> inertia 2 { inertia: 2.28 } -> inertia 3 { inertia: 0.22 } -> conn 8;
    fixed -> torsion_spring 5 { stiffness: 1.69 } -> torsion_spring 6 { stiffness: 0.46, damping: 0.041 } -> conn 8;
    fixed -> conn 8;
    conn 8 -> torsion_spring 9 { stiffness: 0.32 } -> conn 11;
    pinned -> conn 11;
    conn 11 -> mass 12 { mass: 0.41 } -> damper 13 { damping: 2.13 } -> conn 15;
    guided -> conn 15;
    conn 15 -> beam 16 { length: 0.96, bending_stiffness: 0.26, mass_per_length: 0.21 } -> fixed;
}

system! {
    pub(crate) struct Damped119;

    fixed -> damper 1 { damping: 2.97 } -> mass 2 { mass: 0.94 } -> mass 3 { mass: 4.81 } -> conn 5;
    free -> conn 5;
    conn 5 -> beam 6 { length: 0.36, bending_stiffness: 0.21, mass_per_length: 0.81 } -> conn 10;
    guided -> body 8 { mass: 0.52, inertia_about_input: 0.20431325, output_x: 0.215, centre_x: 0.1475 } -> body 9 { mass: 0.37, inertia_about_input: 0.432125, output_x: 0.34, centre_x: 0.75 } -> conn 10;
    conn 10 -> pinned;
}

system! {
    pub(crate) struct Damped124;

    fixed -> torsion_spring 3 { stiffness: 2.93, damping: 0.27599999999999997 } -> inertia 4 { inertia: 4.16 } -> torsion_spring 5 { stiffness: 0.5, damping: 0.06 } -> conn 9;
    fixed -> torsion_spring 7 { stiffness: 4.2, damping: 0.05500000000000001 } -> torsion_spring 8 { stiffness: 1.85 } -> conn 9;
    free -> inertia 1 { inertia: 2.18 } -> conn 12;
    conn 9 -> inertia 10 { inertia: 1.71 } -> conn 12;
    free -> conn 12;
    conn 12 -> torsion_spring 13 { stiffness: 2.14 } -> torsion_spring 14 { stiffness: 1.72 } -> conn 16;
    free -> conn 16;
    conn 16 -> torsion_spring 17 { stiffness: 0.75, damping: 0.427 } -> torsion_spring 18 { stiffness: 0.94, damping: 0.09300000000000001 } -> fixed;
}

system! {
    pub(crate) struct Damped132;

    fixed -> spring 3 { stiffness: 4.699999999999999, damping: 0.44 } -> mass 4 { mass: 4.34 } -> spring 5 { stiffness: 13.100000000000001, damping: 0.3 } -> conn 12;
    fixed -> body 7 { mass: 0.8, inertia_about_input: 1.0974800000000002, output_x: 0.61, centre_x: 1.09 } -> beam 8 { length: 1.42, bending_stiffness: 3.28, mass_per_length: 0.78 } -> conn 12;
    fixed -> torsion_spring 10 { stiffness: 0.25 } -> inertia 11 { inertia: 2.54 } -> conn 12;
    guided -> beam 1 { length: 1.42, bending_stiffness: 3.28, mass_per_length: 0.78 } -> conn 14;
    conn 12 -> point_mass 13 { mass: 0.5, inertia: 0.22400000000000003 } -> conn 14;
    conn 14 -> pinned;
}

system! {
    pub(crate) struct Damped141;

    fixed -> torsion_damper 1 { damping: 0.163 } -> inertia 2 { inertia: 2.25 } -> torsion_spring 3 { stiffness: 0.39 } -> conn 13;
    fixed -> torsion_damper 5 { damping: 0.163 } -> inertia 6 { inertia: 2.25 } -> torsion_spring 7 { stiffness: 0.39 } -> conn 13;
    fixed -> torsion_damper 9 { damping: 0.163 } -> inertia 10 { inertia: 2.25 } -> torsion_spring 11 { stiffness: 0.39 } -> conn 13;
    free -> conn 13;
    conn 13 -> spring 14 { stiffness: 6.2 } -> spring 15 { stiffness: 7.7 } -> fixed;
}

/// Calls a function with the seed and the system of each model.
macro_rules! for_each_damped {
    ($check:ident) => {
        $check(2, $crate::damped_models::Damped2.build());
        $check(7, $crate::damped_models::Damped7.build());
        $check(16, $crate::damped_models::Damped16.build());
        $check(31, $crate::damped_models::Damped31.build());
        $check(35, $crate::damped_models::Damped35.build());
        $check(39, $crate::damped_models::Damped39.build());
        $check(43, $crate::damped_models::Damped43.build());
        $check(53, $crate::damped_models::Damped53.build());
        $check(90, $crate::damped_models::Damped90.build());
        $check(102, $crate::damped_models::Damped102.build());
        $check(116, $crate::damped_models::Damped116.build());
        $check(118, $crate::damped_models::Damped118.build());
        $check(119, $crate::damped_models::Damped119.build());
        $check(124, $crate::damped_models::Damped124.build());
        $check(132, $crate::damped_models::Damped132.build());
        $check(141, $crate::damped_models::Damped141.build());
    };
}
pub(crate) use for_each_damped;
