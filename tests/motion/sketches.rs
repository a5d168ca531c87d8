//! What `sketch()` says of trees: names, lengths and arms, how paths join, and labels that motions take.

use mstmm::elements::{Beam, Body, Spring};
use mstmm::list::{AnyUndamped, ListStep, Room, StepList, Support};
use mstmm::motion::{DrawnPart, DrawnStep, DrawnTree, Extent};
use mstmm::network::Freedoms;
use mstmm::prelude::*;

system! {
    /// A beam that carries a body, on a spring in its middle, beside an equal beam.
    struct Carrier { length: f64, arm: f64, centre: f64, stiffness: f64 }

    fixed -> beam 1 { length, bending_stiffness: 2e4, mass_per_length: 3.0 } -> conn middle
          -> beam 2 { length, bending_stiffness: 2e4, mass_per_length: 3.0 }
          -> body 3 { mass: 5.0, inertia_about_input: 2.0, output_x: arm, centre_x: centre } -> free;
    conn middle <- spring 4 { stiffness } <- fixed;
}

fn carrier() -> Carrier {
    Carrier { length: 1.25, arm: 0.5, centre: -0.125, stiffness: 1e5 }
}

/// Names, inputs, kinds with extents, and spaces.
type Told = (String, Vec<usize>, Option<(&'static str, Extent)>, Freedoms);

fn told<M>(step: &DrawnStep<'_, M>) -> Told {
    let element = match step.part {
        DrawnPart::Element { kind, extent } => Some((kind, extent)),
        DrawnPart::Support(_) | DrawnPart::Connection => None,
    };
    (step.name.to_string(), step.inputs.into(), element, step.space)
}

fn steps<Y: DrawnTree>(tree: &Y) -> Vec<Told> {
    ModalAnalysis::sketch(tree).steps().map(|step| told(&step)).collect()
}

#[test]
fn a_tree_tells_its_names_lengths_and_arms() {
    let bending = Freedoms::Y.union(Freedoms::RZ);
    let beam = Some(("Beam", Extent { output: [1.25, 0.0], bending_stiffness: 2e4, ..Extent::default() }));
    let body = Some(("Body", Extent { output: [0.5, 0.0], centre: Some([-0.125, 0.0]), ..Extent::default() }));
    let spring = Some(("Spring", Extent { output: [0.0, 0.0], ..Extent::default() }));
    let expected: [Told; 8] = [
        ("fixed".into(), vec![], None, bending),
        ("beam 1".into(), vec![0], beam, bending),
        ("fixed".into(), vec![], None, Freedoms::Y),
        ("spring 4".into(), vec![2], spring, Freedoms::Y),
        ("conn middle".into(), vec![1, 3], None, bending),
        ("beam 2".into(), vec![4], beam, bending),
        ("body 3".into(), vec![5], body, bending),
        ("free".into(), vec![6], None, bending),
    ];
    assert_eq!(steps(&carrier().build().unwrap()), expected);
}

/// A list tells the same, with the names of types and the indices of steps.
#[test]
fn a_list_tells_what_its_model_tells() {
    let Carrier { length, arm, centre, stiffness } = carrier();
    let beam = || AnyUndamped::try_from(Beam { length, bending_stiffness: 2e4, mass_per_length: 3.0 }).unwrap();
    let body = Body { mass: 5.0, inertia: 2.0, output_x: arm, centre_x: centre };
    let list = [
        ListStep::Tip(Support::Fixed),
        ListStep::Element(beam()),
        ListStep::Tip(Support::Fixed),
        ListStep::Element(Spring { stiffness }.try_into().unwrap()),
        ListStep::Connection(2),
        ListStep::Element(beam()),
        ListStep::Element(body.try_into().unwrap()),
        ListStep::Root(Support::Free),
    ];
    let mut room = Room::<8>::new();
    let list = StepList::new(&list).unwrap().planned(&mut room).unwrap();
    let of_model = steps(&carrier().build().unwrap());
    for (index, (told, model)) in steps(&list).iter().zip(&of_model).enumerate() {
        assert_eq!(told.0, format!("step {index}"));
        assert_eq!((&told.1, told.3), (&model.1, model.3));
        let name = |(kind, extent): (&str, Extent)| (kind.to_lowercase(), extent);
        assert_eq!(told.2.map(name), model.2.map(name));
    }
    assert_eq!(of_model.len(), 8);
}

/// Labels and points of the sketch are those of the model.
#[test]
fn motions_take_the_labels_of_a_sketch() {
    let system = carrier().build().unwrap();
    let shape = system.mode_shape(&system.first_frequencies::<2>().unwrap()[1]).unwrap();
    let sketch: Vec<_> = system.sketch().steps().collect();
    let label = sketch[5].label.unwrap();
    assert!(sketch[4].label.is_none());
    assert_eq!(shape.along(label, 0.5).unwrap(), shape.along(Carrier::beam_2, 0.5).unwrap());
    assert_eq!(shape.state(sketch[4].point), shape.state(Carrier::conn_middle));
    assert_eq!(shape.state(sketch[6].point), shape.state(Carrier::body_3.output()));
    assert!(shape.state(sketch[6].point).y.abs() > 0.0);
}

system! {
    /// One of each element with a length of its own, damped ones and those under axial force too.
    struct Lengths { l: f64 }

    fixed -> beam 1 { length: 1.0 * l, bending_stiffness: 1.0, mass_per_length: 1.0, rotary_inertia: 0.1 }
        -> beam 2 { length: 2.0 * l, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 9.0, rotary_inertia: 0.1 }
        -> beam 3 { length: 3.0 * l, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: 0.1 }
        -> beam 4 { length: 4.0 * l, bending_stiffness: 1.0, mass_per_length: 1.0, foundation_stiffness: 1.0 }
        -> beam 5 { length: 5.0 * l, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> tapered_beam 6 { length: 6.0 * l, bending_stiffness: 1.0, mass_per_length: 1.0, width_taper: 0.5 }
        -> beam 7 { length: 7.0 * l, bending_stiffness: 1.0, mass_per_length: 1.0, loss_factor: 0.1 }
        -> beam 8 { length: 8.0 * l, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 9.0, rotary_inertia: 0.1, kelvin_voigt_time: 0.1 }
        -> rigid_link 9 { output_x: 9.0 * l } -> rigid_link 10 { output_x: -10.0 * l, axial_force: 1.0 }
        -> body 11 { mass: 1.0, inertia_about_input: 500.0, output_x: 11.0 * l, centre_x: 5.0, axial_force: 1.0 } -> conn end;
    conn end <- string 12 { length: 12.0 * l, tension: 1.0, mass_per_length: 1.0 } <- rod 13 { length: 13.0 * l, axial_stiffness: 1.0, mass_per_length: 1.0 }
        <- string 14 { length: 14.0 * l, tension: 1.0, mass_per_length: 1.0, external_damping: 0.1 }
        <- rod 15 { length: 15.0 * l, axial_stiffness: 1.0, mass_per_length: 1.0, loss_factor: 0.1 } <- free;
    free -> shaft 16 { length: 16.0 * l, torsional_stiffness: 1.0, inertia_per_length: 1.0 }
        -> shaft 17 { length: 17.0 * l, torsional_stiffness: 1.0, inertia_per_length: 1.0, loss_factor: 0.1 } -> conn end;
    conn end -> point_mass 18 { mass: 1.0, inertia: 0.0 } -> free;
}

system! {
    /// One of each planar element.
    struct PlanarLengths { l: f64 }

    fixed -> beam 1 { length: 1.0 * l, axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> beam 2 { length: 2.0 * l, axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, rotary_inertia: 0.1 }
        -> beam 3 { length: 3.0 * l, axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 9.0, rotary_inertia: 0.1 }
        -> beam 4 { length: 4.0 * l, axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: 0.1 }
        -> beam 5 { length: 5.0 * l, axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, foundation_stiffness: 0.1 }
        -> beam 6 { length: 6.0 * l, axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> beam 7 { length: 7.0 * l, axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, loss_factor: 0.1 }
        -> beam 8 { length: 8.0 * l, axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, shear_stiffness: 9.0, rotary_inertia: 0.1, loss_factor: 0.1 }
        -> body 9 { mass: 1.0, inertia_about_input: 500.0, output_x: 9.0 * l, output_y: 2.0, centre_x: 3.0, centre_y: 4.0 } -> free;
}

/// Each label is the length in units of l, so that none has that of another.
#[test]
fn each_element_with_a_length_tells_it() {
    let check = |steps: Vec<Told>, count: usize| {
        let mut checked = 0;
        for (name, _, element, _) in steps {
            let (Some((_, extent)), Some((keyword, label))) = (element, name.rsplit_once(' ')) else { continue };
            let label: f64 = label.parse().unwrap();
            let expected = match keyword {
                "point_mass" => 0.0,
                _ if label == 10.0 => -10.0,
                _ => label,
            };
            assert_eq!(extent.output[0], 0.5 * expected, "{name}");
            checked += 1;
        }
        assert_eq!(checked, count);
    };
    check(steps(&Lengths { l: 0.5 }.build().unwrap()), 18);
    check(steps(&PlanarLengths { l: 0.5 }.build().unwrap()), 9);
    let body = steps(&PlanarLengths { l: 0.5 }.build().unwrap()).into_iter().find(|step| step.0 == "body 9");
    assert_eq!(
        body.unwrap().2.unwrap().1,
        Extent { output: [4.5, 2.0], centre: Some([3.0, 4.0]), ..Extent::default() }
    );
}
