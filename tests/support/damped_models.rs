//! Random trees as models, named after their seeds; `macro_equals_list.rs` says how to write this file again.

use mstmm::prelude::*;

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
        $check(2, $crate::damped_models::Damped2.build());
        $check(7, $crate::damped_models::Damped7.build());
        $check(16, $crate::damped_models::Damped16.build());
        $check(31, $crate::damped_models::Damped31.build());
        $check(35, $crate::damped_models::Damped35.build());
        $check(39, $crate::damped_models::Damped39.build());
        $check(53, $crate::damped_models::Damped53.build());
        $check(90, $crate::damped_models::Damped90.build());
        $check(116, $crate::damped_models::Damped116.build());
        $check(119, $crate::damped_models::Damped119.build());
        $check(124, $crate::damped_models::Damped124.build());
        $check(132, $crate::damped_models::Damped132.build());
        $check(141, $crate::damped_models::Damped141.build());
        $check(151, $crate::damped_models::Damped151.build());
        $check(158, $crate::damped_models::Damped158.build());
        $check(170, $crate::damped_models::Damped170.build());
    };
}
pub(crate) use for_each_damped;
