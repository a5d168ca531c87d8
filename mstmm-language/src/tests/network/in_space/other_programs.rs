//! Words that users of other programs write.

use super::assert_told;

#[test]
fn members_of_a_truss() {
    assert_told(
        "
        struct M { l: f64 }
        pinned at (0.0, 0.0, 0.0) -> truss 1 { axial_stiffness: l, mass_per_length: l }
            -> conn a at (l, 0.0, 0.0) -> rod 2 { axial_stiffness: l, mass_per_length: l }
            -> conn b at (l, l, 0.0)
        -> bar 3 { axial_stiffness: l, mass_per_length: l, torsional_stiffness: l } -> pinned at (l, l, l);",
        "
        truss: `truss` is not an element: did you mean `bar`?
        rod 2: `rod 2` lacks `length`: between two places take `bar`
        torsional_stiffness: `bar` has no parameter `torsional_stiffness`: both ends of a bar turn freely, so nothing twists it: remove it, or take `beam`
        bar 3: `bar 3` lacks `bending_stiffness`: it has its mass along it, so it bends between its ends",
    );
}

#[test]
fn names_of_finite_elements() {
    assert_told(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0, 0.0) -> beam 1 { EA: l, GJ: l, EIy: l, EIz: l, m: l, Ip: l, vecxz: (0.0, 0.0, 1.0) }
            -> conn a at (l, 0.0, 0.0);",
        "
        EA: `beam` has no parameter `EA`: did you mean `axial_stiffness`?
        GJ: `beam` has no parameter `GJ`: did you mean `torsional_stiffness`?
        EIy: `beam` has no parameter `EIy`: did you mean `bending_stiffness_y`?
        EIz: `beam` has no parameter `EIz`: did you mean `bending_stiffness_z`?
        m: `beam` has no parameter `m`: did you mean `mass_per_length`?
        Ip: `beam` has no parameter `Ip`: did you mean `polar_inertia_per_length`?
        vecxz: `beam` has no parameter `vecxz`: did you mean `up`?",
    );
}

#[test]
fn names_of_sections() {
    assert_told(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0, 0.0) -> beam 1 { A: l, Iyy: l, Izz: l, J: l, E: l, G: l, rho: l }
            -> conn a at (l, 0.0, 0.0);",
        "
        A: `beam` has no parameter `A`: it takes products, `axial_stiffness: e * area` and `mass_per_length: rho * area`
        Iyy: `beam` has no parameter `Iyy`: it takes products, `bending_stiffness_y: e * i_y`
        Izz: `beam` has no parameter `Izz`: it takes products, `bending_stiffness_z: e * i_z`
        J: `beam` has no parameter `J`: it takes products, `torsional_stiffness: g * j`
        E: `beam` has no parameter `E`: it takes products, `axial_stiffness: e * area` and `bending_stiffness: e * i`
        G: `beam` has no parameter `G`: it takes products, `torsional_stiffness: g * j`
        rho: `beam` has no parameter `rho`: it takes products, `mass_per_length: rho * area` and `polar_inertia_per_length: rho * (i_y + i_z)`",
    );
}

#[test]
fn names_of_members() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> elasticBeamColumn 1 { ..steel } -> conn a at (l, 0.0, 0.0)
            -> frame 2 { ..steel } -> node b at (l, l, 0.0);",
        "
        elasticBeamColumn: `elasticBeamColumn` is not an element: did you mean `beam`?
        frame: `frame` is not an element: did you mean `beam`?
        at: `node b` has no place of its own: points have places, so write `at` behind the connections around it
        node: `node` is not an element: did you mean `conn`?",
    );
}

#[test]
fn names_of_joints() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0) -> spherical_joint 2 {}
            -> beam 3 { ..steel } -> conn b at (l, l, 0.0) -> bushing 4 { stiffness_x: l } -> beam 5 { ..steel }
            -> conn c at (l, l, l) -> cardan 6 {} -> beam 7 { ..steel } -> fixed at (3.0, 3.0, 3.0);",
        "
        spherical_joint: `spherical_joint` is not an element: did you mean `ball_joint`?
        bushing: `bushing` is not an element: did you mean `hinge`?
        cardan: `cardan` is not an element: did you mean `universal_joint`?",
    );
}

#[test]
fn supports_of_other_programs() {
    assert_told(
        "
        clamped at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> encastre at (l, 0.0, 0.0) -> beam 2 { ..steel }
            -> fixed at (l, l, l);
        conn a at (0.0, l, 0.0) <- held(dx, uy, theta_z, ry);",
        "
        clamped: `clamped` is not a support: did you mean `fixed`?
        encastre: `encastre` is not a support: did you mean `fixed`?
        dx: `dx` is no freedom of this model: a point has `x`, `y`, `z`, `rx`, `ry` and `rz`
        uy: `uy` is no freedom of this model: a point has `x`, `y`, `z`, `rx`, `ry` and `rz`
        theta_z: `theta_z` is no freedom of this model: a point has `x`, `y`, `z`, `rx`, `ry` and `rz`
        encastre: `encastre` stands in the middle of a path, but a support ends one: hold a point in between by a connection, `support -> conn ..`
        conn a: `conn a` joins no element: let the path of an element end in it",
    );
}

#[test]
fn inertias_of_solids() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0)
            -> rigid_body 2 { mass: l, inertia_x: l, inertia_y: l, inertia_z: l, centre: (l, 0.0, 0.0) };
        conn a -> rigid_body 3 { mass: l, Ixx: l, center: (l, 0.0, 0.0) };",
        "
        inertia_x: `rigid_body` has no parameter `inertia_x`: did you mean `inertia`?
        inertia_y: `rigid_body` has no parameter `inertia_y`: did you mean `inertia`?
        inertia_z: `rigid_body` has no parameter `inertia_z`: did you mean `inertia`?
        Ixx: `rigid_body` has no parameter `Ixx`: did you mean `inertia`?
        center: `rigid_body` has no parameter `center`: did you mean `centre`?",
    );
}

#[test]
fn rolls_and_angles() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel, roll: 0.5 } -> conn a at (l, 0.0, 0.0)
            -> beam 2 { ..steel, orientation: (0.0, 0.0, 1.0) } -> conn b at (l, l, 0.0)
            -> beam 3 { ..steel, up: 0.5 } -> conn c at (l, l, l);",
        "
        roll: `beam` has no parameter `roll`: did you mean `up`?
        orientation: `beam` has no parameter `orientation`: did you mean `up`?
        0.5: `up` has three parts in space, which are written as a tuple, `up: (dx, dy, dz)`",
    );
}

#[test]
fn torsion_of_a_member() {
    assert_told(
        "
        struct M { l: f64 }
        fixed at (0.0, 0.0, 0.0)
            -> beam 1 { axial_stiffness: l, torsional_stifness: l, bending_stiffness: l, mass_per_length: l,
                polar_inertia: l }
            -> conn a at (l, 0.0, 0.0);",
        "
        torsional_stifness: `beam` has no parameter `torsional_stifness`: did you mean `torsional_stiffness`?
        polar_inertia: `beam` has no parameter `polar_inertia`: did you mean `polar_inertia_per_length`?",
    );
}

#[test]
fn own_words_in_space() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0) -> link 2 {}
            -> conn b at (l, l, 0.0) -> offset 3 {} -> conn c at (l, l, l)
            -> cable 4 { tension: l, mass_per_length: l } -> pinned at (3.0, 3.0, 3.0);",
        "
        link: `link` is not an element: did you mean `rigid_link`?
        offset: `offset` is not an element: did you mean `rigid_link`?
        cable: `cable` is not an element: did you mean `string`?",
    );
}

#[test]
fn shafts_and_torsion_between_places() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0)
            -> shaft 2 { torsional_stiffness: l, polar_inertia_per_length: l } -> conn b at (l, l, 0.0)
            -> beam 3 { ..steel } -> fixed at (l, l, l);",
        "
        polar_inertia_per_length: `shaft` has no parameter `polar_inertia_per_length`: did you mean `inertia_per_length`?
        shaft 2: `shaft 2` lacks `length`: between two places take `beam`
        ->: a path that turns acts about an axis: `conn a <- about (0.0, 0.0, 1.0) <- ..`
        ->: a path that turns acts about an axis: `conn b <- about (0.0, 0.0, 1.0) <- ..`",
    );
}

#[test]
fn a_place_too_many() {
    assert_told(
        "
        fixed at [0.0, 0.0, 0.0] -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0, 0.0) -> beam 2 { ..steel }
            -> conn b at (l, l, 0.0);",
        "
        [0.0, 0.0, 0.0]: a place is a tuple, in parentheses: `at (x, y)` or `at (x, y, z)`
        (l, 0.0, 0.0, 0.0): a tuple of four is no place: a point has two coordinates, `at (x, y)`, or three, `at (x, y, z)`; one is written without parentheses, `at x`",
    );
}

#[test]
fn prefixes_and_suffixes() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> spatial_beam 1 { ..steel } -> conn a at (l, 0.0, 0.0) -> beam3d 2 { ..steel }
            -> conn b at (l, l, 0.0) -> truss3d 3 { ..steel } -> pinned at (l, l, l);",
        "
        spatial_beam: `spatial_beam` is not an element: did you mean `beam`?
        beam3d: `beam3d` is not an element: did you mean `beam`?
        truss3d: `truss3d` is not an element: did you mean `bar`?",
    );
}

#[test]
fn members_with_shear() {
    assert_told(
        "
        fixed at (0.0, 0.0, 0.0) -> timoshenko_beam 1 { ..steel, shear_stiffness: l } -> conn a at (l, 0.0, 0.0)
            -> beam 2 { ..steel, shear_area_y: l, axial_load: l } -> conn b at (l, l, 0.0);",
        "
        timoshenko_beam: `timoshenko_beam` is `beam` now: write `beam 1 { shear_stiffness: l, ..steel, rotary_inertia: .. }`
        shear_area_y: `beam` has no parameter `shear_area_y`: did you mean `shear_stiffness_y`?
        axial_load: `beam` has no parameter `axial_load`: did you mean `axial_force`?",
    );
}
