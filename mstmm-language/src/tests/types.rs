//! Parameters select types: beams, hinges, springs, links, along a line and in the plane.

use super::{assert_refused, expanded, messages};

/// The types that stand in the code of a model.
fn types(paths: &str) -> Vec<String> {
    let code = expanded(&format!("struct M {{ l: f64, k: f64 }} {paths}"));
    let parts = code.split("elements :: ").skip(1);
    let mut names: Vec<String> = parts.filter_map(|part| Some(part.split_whitespace().next()?.to_owned())).collect();
    names.sort_unstable();
    names.dedup();
    names
}

#[test]
fn naming_a_parameter_of_a_beam_selects_its_type() {
    let line = "length: l, bending_stiffness: k, mass_per_length: k";
    for (more, name) in [
        ("", "Beam"),
        (", rotary_inertia: k", "RayleighBeam"),
        (", shear_stiffness: k", "TimoshenkoBeam"),
        (", axial_force: k, foundation_stiffness: k", "GeneralBeam"),
        (", external_damping: k", "DampedBeam"),
    ] {
        assert_eq!(types(&format!("fixed -> beam 1 {{ {line}{more} }} -> free")), [name]);
        let planar = format!("fixed -> beam 1 {{ {line}, axial_stiffness: k{more} }} -> free");
        let mut in_plane = ["InPlane", name];
        in_plane.sort_unstable();
        assert_eq!(types(&planar), in_plane);
    }
}

/// What is rigid is infinite, all else zero.
#[test]
fn what_is_left_out_is_neutral() {
    let code = expanded(
        "struct M { k: f64 } fixed -> beam 1 { length: k, bending_stiffness: k, mass_per_length: k, rotary_inertia: k, axial_force: k } -> free",
    );
    assert!(
        code.contains(
            "shear_stiffness : mstmm :: __private :: Scalar :: from_f64 (:: core :: primitive :: f64 :: INFINITY)"
        ),
        "{code}"
    );
    assert!(code.contains("foundation_stiffness : mstmm :: __private :: Scalar :: from_f64 (0.0)"), "{code}");
}

#[test]
fn springs_links_and_hinges_are_what_they_name() {
    for (paths, name) in [
        ("fixed -> spring 1 { stiffness: k } -> free", "Spring"),
        ("fixed -> spring 1 { stiffness: k, damping: k } -> free", "SpringDamper"),
        ("fixed -> spring 1 { stiffness: k, damping: k, loss_factor: k } -> free", "DampedSpring"),
        ("fixed -> torsion_spring 1 { stiffness: k, damping: k } -> free", "TorsionSpringDamper"),
        ("fixed -> hinge 1 { stiffness_rz: k } -> free", "RotationalHinge"),
        ("fixed -> hinge 1 { stiffness_y: k } -> free", "ShearHinge"),
        ("fixed -> hinge 1 { stiffness_rz: k, stiffness_y: k } -> free", "ElasticHinge"),
        ("fixed -> hinge 1 { stiffness_rz: k, stiffness_x: k } -> free", "PlanarHinge"),
        ("fixed -> rigid_link 1 { output_x: l } -> free", "Lever"),
        ("fixed -> rigid_link 1 { output_x: l, axial_force: k } -> free", "LeverColumn"),
        ("fixed -> rigid_link 1 { output_x: l, output_y: l } -> free", "PlanarBody"),
    ] {
        assert_eq!(types(paths), [name], "{paths}");
    }
}

/// Errors of `build` speak of the parameters that were written.
#[test]
fn fields_of_other_names_are_called_by_the_words_of_the_model() {
    let code = expanded("struct M { k: f64 } fixed -> hinge 1 { stiffness_rz: k } -> free");
    assert!(code.contains("called (error , & [(\"stiffness\" , \"stiffness_rz\")])"), "{code}");
    assert!(code.contains("stiffness : number (0usize)"), "{code}");
    let code =
        expanded("struct M { k: f64 } fixed -> beam 1 { length: k, bending_stiffness: k, mass_per_length: k } -> free");
    assert!(!code.contains("called"), "{code}");
}

/// Between places a hinge is a joint, with springs where it names a stiffness and rigid elsewhere.
#[test]
fn a_hinge_between_places_is_rigid_where_it_names_nothing() {
    let beam = "bending_stiffness: k, mass_per_length: k";
    let line = expanded(&format!(
        "struct M {{ k: f64 }} fixed at 0.0 -> beam 1 {{ {beam} }} -> conn a at 1.0 -> hinge 2 {{ stiffness_rz: k }} -> beam 3 {{ {beam} }} -> free at 2.0"
    ));
    let [none, some] = [":: core :: option :: Option :: None", ":: core :: option :: Option :: Some (number ("];
    assert!(line.contains(&format!("[{none} , {none} , {some}")), "{line}");
    assert!(line.contains("Joint < T > > :: hinge ("), "{line}");
    assert!(line.contains("called (error , & [(\"stiffness_theta\" , \"stiffness_rz\")])"), "{line}");
    assert!(line.contains("gradient . stiffness_theta"), "{line}");
}

#[test]
fn a_hinge_in_which_nothing_gives_way_is_refused() {
    assert_refused(
        "
        struct M { k: f64 }
        fixed -> hinge 1 { } -> hinge 2 { stiffnes_rz: k } -> free
                 ^^^^^^^ `hinge 1` names no freedom that gives way, so it would be rigid: write `stiffness_rz:
                 | 0.0`, which lets the rotation go, or another stiffness
                                          ^^^^^^^^^^^ `hinge` has no parameter `stiffnes_rz`: did you mean
                                          | `stiffness_rz`?
        ",
    );
    let located = messages(
        "struct M { k: f64 } fixed at 0.0 -> beam 1 { bending_stiffness: k, mass_per_length: k } -> conn a at 1.0 -> hinge 4 {} -> free",
    );
    assert_eq!(
        located,
        "`hinge 4` names no freedom that gives way, so it would be rigid: write `pin 4 {}`, which lets the rotation go, or name a stiffness"
    );
}

/// One parameter of the plane makes all paths planar.
#[test]
fn a_beam_in_the_plane_says_how_it_stretches() {
    assert_refused(
        "
        struct M { k: f64 }
        fixed -> beam 1 { length: k, bending_stiffness: k, mass_per_length: k } -> rigid_link 2 { output_x: k, output_y: k }
                 ^^^^^^ `beam 1` lacks `axial_stiffness`: in the plane a beam stretches, too; a large number
                 | is one that hardly does
            -> free;
        ",
    );
    let rod = "struct M { k: f64 } fixed -> rod 1 { length: k, axial_stiffness: k, mass_per_length: k } -> free";
    expanded(rod);
}

/// A body says its inertia in one of two ways.
#[test]
fn a_body_has_one_inertia() {
    assert_refused(
        "
        struct M { k: f64 }
        fixed -> body 1 { mass: k, output_x: k, centre_x: k }
                 ^^^^^^ `body 1` lacks `inertia`, about its mass centre, or `inertia_about_input`
            -> body 2 { mass: k, inertia: k, output_x: k, centre_x: k, inertia_about_input: k } -> free;
                                                                       ^^^^^^^^^^^^^^^^^^^ `body 2` gives its
                                                                       | inertia twice: remove `inertia` or
                                                                       | `inertia_about_input`
        ",
    );
    for (parameters, name) in [
        ("inertia: k", "CentralBody"),
        ("inertia_about_input: k", "Body"),
        ("inertia: k, axial_force: k", "CentralBodyColumn"),
        ("inertia_about_input: k, axial_force: k", "BodyColumn"),
        ("inertia: k, output_y: k, centre_y: k", "PlanarCentralBody"),
        ("inertia_about_input: k, output_y: k, centre_y: k", "PlanarBody"),
    ] {
        assert_eq!(
            types(&format!("fixed -> body 1 {{ mass: k, output_x: k, centre_x: k, {parameters} }} -> free")),
            [name]
        );
    }
}

/// A rigid link ties points as a rigid body does, and may be named again.
#[test]
fn a_rigid_link_between_places_may_be_named_again() {
    let beam = "axial_stiffness: k, bending_stiffness: k, mass_per_length: k";
    let model = |link: &str| {
        format!(
            "struct M {{ k: f64 }} fixed at (0.0, 0.0) -> beam 1 {{ {beam} }} -> conn a at (1.0, 0.0) -> rigid_link 2 {link};
             rigid_link 2 -> conn b at (1.0, 1.0) -> beam 3 {{ {beam} }} -> free at (2.0, 1.0)"
        )
    };
    expanded(&model("{}"));
    let refused = messages(&model(""));
    assert_eq!(refused, "`rigid_link 2` lacks its braces, at one of its mentions: `rigid_link 2 {}`");
}
