//! Every element that proofs know in numbers, with random parameters of two words, against its [transfer matrix](super::transfer).

use crate::DoubleDouble;
use crate::element::{Element, MemberNumbers, space_of};
use crate::elements::*;
use crate::number::{Parameter, Scalar};
use crate::proof::tests::random::Random;
use crate::proof::tests::transfer::{Seen, beside_pole, rows, step};
use crate::{Freedoms, Joint};
use std::vec::Vec;

/// Random parameters.
struct Parameters {
    random: Random,
}

impl Parameters {
    /// Positive, within so many decades, with a second word.
    fn size(&mut self, decades: f64) -> DoubleDouble {
        let value = 10f64.powf(decades * self.random.signed());
        DoubleDouble::from_sum(value, value * 1e-17 * self.random.signed())
    }

    /// Of either sign.
    fn any(&mut self) -> DoubleDouble {
        let value = self.size(0.5);
        if self.random.below(2) == 0 { value } else { -value }
    }

    /// A part of a number.
    fn part(&mut self, least: f64, most: f64) -> DoubleDouble {
        let value = least + (most - least) * self.random.unit();
        DoubleDouble::from_sum(value, value * 1e-17)
    }

    /// Zero half of the time.
    fn maybe(&mut self) -> DoubleDouble {
        if self.random.below(2) == 0 { DoubleDouble::from_f64(0.0) } else { self.size(0.5) }
    }
}

/// An inertia about the input end that a body may have.
fn of_body(mass: DoubleDouble, centre: DoubleDouble, own: DoubleDouble) -> DoubleDouble {
    mass * centre * centre + own
}

/// An element with these parameters, which stretches where it has an axial stiffness.
macro_rules! element {
    ($element:ident { axial_stiffness: $axial:expr, $($field:ident: $value:expr),* }) => {
        InPlane { axial_stiffness: $axial, across: $element { $($field: $value),* } }
    };
    ($element:ident { $($field:ident: $value:expr),* }) => { $element { $($field: $value),* } };
}

/// The type of an element, over a number.
macro_rules! type_of {
    ($element:ident over $number:ty, axial_stiffness $($field:ident)*) => { InPlane<$element<$number>> };
    ($element:ident over $number:ty, $($field:ident)*) => { $element<$number> };
}

/// Holds elements with these parameters to their transfer matrices so many times; lists those that have no numbers.
macro_rules! held_to_matrices {
    ($p:ident, $runs:ident, $($element:ident of $length:expr => { $($field:ident: $value:expr),* $(,)? })*) => {{
        let mut table = Vec::new();
        $({
            let mut seen = Seen::default();
            for run in 0..$runs {
                $(let $field: DoubleDouble = $value;)*
                let length: DoubleDouble = $length;
                let omega = 10f64.powf(0.6 * $p.random.signed());
                let built = Element::build(element!($element { $($field: $field),* })).unwrap();
                let numbers = <type_of!($element over DoubleDouble, $($field)*) as Element>::member_numbers(&built);
                if numbers == MemberNumbers::Other {
                    continue;
                }
                let space = space_of::<type_of!($element over DoubleDouble, $($field)*)>();
                let at = |omega: f64| rows::<type_of!($element over DoubleDouble, $($field)*)>(&built, omega);
                // some beside a frequency with both ends held, where the proof has another form
                let omega = if run % 4 == 3 { beside_pole(&mut $p.random, space, omega, at) } else { omega };
                let u = rows::<type_of!($element over DoubleDouble, $($field)*)>(&built, omega);
                step(&mut $p.random, (space, numbers), &u, (length, omega), &mut seen);
                // parameters of one word are the same numbers
                let of_words = element!($element { $($field: $field.to_f64()),* });
                let of_pairs = element!($element { $($field: DoubleDouble::from_f64($field.to_f64())),* });
                if let (Ok(one), Ok(other)) = (Element::build(of_words), Element::build(of_pairs)) {
                    let other = <type_of!($element over DoubleDouble, $($field)*) as Element>::member_numbers(&other);
                    assert_eq!(<type_of!($element over f64, $($field)*) as Element>::member_numbers(&one), other);
                }
            }
            table.push((stringify!($element), seen));
        })*
        table
    }};
}

/// A beam's parameters, those of shear and rotation small beside its length.
macro_rules! beam {
    ($p:ident: length) => {
        $p.size(0.4)
    };
    ($p:ident: small) => {
        $p.size(0.4) * DoubleDouble::from_f64(0.02)
    };
}

fn lines(p: &mut Parameters, runs: usize) -> Vec<(&'static str, Seen)> {
    let one = DoubleDouble::from_f64(1.0);
    held_to_matrices!(p, runs,
        Spring of one => { stiffness: p.size(1.0) }
        TorsionSpring of one => { stiffness: p.size(1.0) }
        Mass of one => { mass: p.size(1.0) }
        Inertia of one => { inertia: p.size(1.0) }
        TautString of length => {
            length: p.size(0.5), tension: p.size(0.5), mass_per_length: p.size(0.5), foundation_stiffness: p.maybe(),
        }
        Rod of length => {
            length: p.size(0.5), axial_stiffness: p.size(0.5), mass_per_length: p.size(0.5), foundation_stiffness: p.maybe(),
        }
        Shaft of length => { length: p.size(0.5), torsional_stiffness: p.size(0.5), inertia_per_length: p.size(0.5) }
    )
}

fn rigid(p: &mut Parameters, runs: usize) -> Vec<(&'static str, Seen)> {
    let one = DoubleDouble::from_f64(1.0);
    held_to_matrices!(p, runs,
        PointMass of one => { mass: p.size(1.0), inertia: p.size(1.0) }
        Disc of one => { mass: p.size(1.0), inertia: p.size(1.0), polar_inertia: p.size(1.0), speed: p.any() }
        ElasticHinge of one => { stiffness_y: p.size(1.0), stiffness_theta: p.size(1.0) }
        Body of one => {
            mass: p.size(1.0), centre_x: p.any(), output_x: p.any(), inertia: of_body(mass, centre_x, p.size(1.0)),
        }
        BodyColumn of one => {
            mass: p.size(1.0), centre_x: p.any(), output_x: p.any(), inertia: of_body(mass, centre_x, p.size(1.0)),
            axial_force: p.any(),
        }
        CentralBody of one => { mass: p.size(1.0), centre_x: p.any(), output_x: p.any(), inertia: p.size(1.0) }
        CentralBodyColumn of one => {
            mass: p.size(1.0), centre_x: p.any(), output_x: p.any(), inertia: p.size(1.0), axial_force: p.any(),
        }
        RotationalHinge of one => { stiffness: p.size(1.0) }
        ShearHinge of one => { stiffness: p.size(1.0) }
        Lever of one => { output_x: p.any() }
        LeverColumn of one => { output_x: p.any(), axial_force: p.any() }
        PlanarBody of one => {
            mass: p.size(1.0), centre_x: p.any(), centre_y: p.any(), output_x: p.any(), output_y: p.any(),
            inertia: of_body(mass, centre_x, p.size(1.0)) + of_body(mass, centre_y, p.size(1.0)),
        }
        PlanarCentralBody of one => {
            mass: p.size(1.0), centre_x: p.any(), centre_y: p.any(), output_x: p.any(), output_y: p.any(), inertia: p.size(1.0),
        }
        PlanarHinge of one => { stiffness_x: p.size(1.0), stiffness_y: p.size(1.0), stiffness_theta: p.size(1.0) }
    )
}

fn beams(p: &mut Parameters, runs: usize) -> Vec<(&'static str, Seen)> {
    held_to_matrices!(p, runs,
        Beam of length => { length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5) }
        RayleighBeam of length => {
            length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5), rotary_inertia: p.size(0.5),
        }
        TimoshenkoBeam of length => {
            length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5),
            shear_stiffness: p.size(0.5), rotary_inertia: p.size(0.5),
        }
        BeamColumn of length => {
            length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5), axial_force: p.any(),
        }
        FoundationBeam of length => {
            length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5),
            foundation_stiffness: p.size(0.5), foundation_shear_stiffness: p.size(0.5),
        }
        GeneralBeam of length => {
            length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5),
            shear_stiffness: DoubleDouble::from_f64(10.0) + p.size(0.5), rotary_inertia: beam!(p: small), axial_force: p.any(),
            foundation_stiffness: p.maybe(), foundation_shear_stiffness: p.maybe(),
        }
        SpinningBeam of length => {
            length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5),
            shear_stiffness: DoubleDouble::from_f64(10.0) + p.size(0.5), rotary_inertia: beam!(p: small), axial_force: p.any(),
            foundation_stiffness: p.maybe(), foundation_shear_stiffness: p.maybe(),
            polar_inertia_per_length: p.size(0.5), speed: p.any(),
        }
        TaperedBeam of length => {
            length: p.size(0.2), bending_stiffness: p.size(0.3), mass_per_length: p.size(0.3), width_taper: p.part(-0.5, 0.5),
            height_taper: p.part(-0.5, 0.5), rotary_inertia: beam!(p: small), axial_force: p.any(), axial_load: p.any(), rotation_speed: p.maybe(),
            hub_radius: p.any(), setting_angle: p.part(0.0, 1.5), foundation_stiffness: p.maybe(),
        }
    )
}

fn planar_beams(p: &mut Parameters, runs: usize) -> Vec<(&'static str, Seen)> {
    held_to_matrices!(p, runs,
        Beam of length => {
            axial_stiffness: p.size(1.0), length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5),
        }
        RayleighBeam of length => {
            axial_stiffness: p.size(1.0), length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5),
            rotary_inertia: p.size(0.5),
        }
        TimoshenkoBeam of length => {
            axial_stiffness: p.size(1.0), length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5),
            shear_stiffness: p.size(0.5), rotary_inertia: p.size(0.5),
        }
        BeamColumn of length => {
            axial_stiffness: p.size(1.0), length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5),
            axial_force: p.any(),
        }
        FoundationBeam of length => {
            axial_stiffness: p.size(1.0), length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5),
            foundation_stiffness: p.size(0.5), foundation_shear_stiffness: p.size(0.5),
        }
        GeneralBeam of length => {
            axial_stiffness: p.size(1.0), length: beam!(p: length), bending_stiffness: p.size(0.5), mass_per_length: p.size(0.5),
            shear_stiffness: DoubleDouble::from_f64(10.0) + p.size(0.5), rotary_inertia: beam!(p: small), axial_force: p.any(),
            foundation_stiffness: p.maybe(), foundation_shear_stiffness: p.maybe(),
        }
    )
}

/// Joints of frames, elastic and rigid.
fn joints(p: &mut Parameters, runs: usize) -> Vec<(&'static str, Seen)> {
    let mut seen = Seen::default();
    for run in 0..runs {
        let hinge = PlanarHinge { stiffness_x: p.size(1.0), stiffness_y: p.size(1.0), stiffness_theta: p.size(1.0) };
        let joint = if run % 4 == 3 { Joint::rigid(Freedoms::PLANE) } else { Joint::from(hinge) };
        let built = joint.build().unwrap();
        let numbers = <Joint<DoubleDouble> as Element>::member_numbers(&built);
        let (one, space) = (DoubleDouble::from_f64(1.0), space_of::<Joint<DoubleDouble>>());
        step(&mut p.random, (space, numbers), &rows::<Joint<DoubleDouble>>(&built, 1.0), (one, 1.0), &mut seen);
    }
    [("Joint", seen)].into()
}

/// Elements without numbers: what a frame makes of them has some, bodies of nodes and joints.
const WITHOUT_NUMBERS: [&str; 3] = ["PlanarBody", "PlanarCentralBody", "PlanarHinge"];

fn check(runs: usize) {
    let mut p = Parameters { random: Random::new(21) };
    let kinds = [lines, rigid, beams, planar_beams, joints];
    let table = kinds.into_iter().flat_map(|kind| kind(&mut p, runs)).collect::<Vec<_>>();
    for (name, Seen { tried, sharp, stepped, wrong }) in &table {
        std::println!("{name}: {tried} tried, {sharp} sharp, {stepped} step where the transfer matrix is singular");
        let has_numbers = !WITHOUT_NUMBERS.contains(name);
        assert_eq!(has_numbers, *tried > 0, "{name}");
        assert!(2 * sharp >= *tried, "{name}: no test");
        assert!(wrong.is_empty(), "{name}: {wrong:?}");
    }
    let mut names: Vec<&str> = table.iter().map(|row| row.0).filter(|name| *name != "Joint").collect();
    // what stretches is tested twice, but a string, which is two lines
    let in_plane = STRETCHING.iter().copied().filter(|name| !name.contains("String"));
    let mut rows: Vec<&str> = ELEMENTS.iter().map(|row| row.name).chain(in_plane).collect();
    rows.retain(|name| !name.contains("Damp") && !name.contains("CrossCoupled"));
    names.sort_unstable();
    rows.sort_unstable();
    assert_eq!(names, rows, "elements that are tested, and undamped ones");
}

#[test]
fn counts_step_where_the_transfer_matrix_is_singular() {
    check(8);
}

#[test]
#[ignore = "long: .ci/long"]
fn counts_step_where_many_transfer_matrices_are_singular() {
    check(1_000);
}

/// A string in the plane is a rod and a string of a path.
#[test]
fn a_string_in_the_plane_is_two_lines() {
    let mut p = Parameters { random: Random::new(23) };
    let [length, tension, mass_per_length, foundation_stiffness] = [0.5; 4].map(|decades| p.size(decades));
    let axial_stiffness = p.size(0.5);
    let across = TautString { length, tension, mass_per_length, foundation_stiffness };
    let zero = DoubleDouble::from_f64(0.0);
    let along = Rod { length, axial_stiffness, mass_per_length, foundation_stiffness: zero };
    let lines = [TautString::member_numbers(&across.build().unwrap()), Rod::member_numbers(&along.build().unwrap())];
    let [MemberNumbers::Line(_, across_it), MemberNumbers::Line(_, along_it)] = lines else { panic!("no lines") };
    let string = InPlane { axial_stiffness, across }.build().unwrap();
    assert_eq!(InPlane::<TautString<_>>::member_numbers(&string), MemberNumbers::String([along_it, across_it]));
}

/// Numbers that are off by the last word of a parameter are seen: a test of the test above.
#[test]
fn numbers_that_are_off_are_seen() {
    type Stretched = InPlane<TimoshenkoBeam<DoubleDouble>>;
    let mut p = Parameters { random: Random::new(22) };
    let off = |number: [f64; 2]| [number[0], number[1] + 1e-17 * number[0]];
    for _ in 0..4 {
        let length = p.size(0.3);
        let axial_stiffness = p.size(0.5);
        let across = TimoshenkoBeam {
            length,
            bending_stiffness: p.size(0.5),
            mass_per_length: p.size(0.5),
            shear_stiffness: p.size(0.5),
            rotary_inertia: p.size(0.5),
        };
        let built = InPlane { axial_stiffness, across }.build().unwrap();
        let MemberNumbers::Beam(numbers) = <Stretched as Element>::member_numbers(&built) else {
            panic!("no beam");
        };
        let mut all = [numbers; 5];
        all[0].bending_stiffness = off(numbers.bending_stiffness);
        all[1].mass_per_length = off(numbers.mass_per_length);
        all[2].axial_stiffness = off(numbers.axial_stiffness);
        all[3].shear_stiffness = off(numbers.shear_stiffness);
        all[4].rotary_inertia = off(numbers.rotary_inertia);
        for (which, wrong) in all.into_iter().enumerate() {
            let mut seen = Seen::default();
            // the spring that is sought changes from one displacement to the next
            for _ in 0..3 {
                let omega = 1.0 + p.random.unit();
                let u = rows::<Stretched>(&built, omega);
                let space = space_of::<Stretched>();
                step(&mut p.random, (space, MemberNumbers::Beam(wrong)), &u, (length, omega), &mut seen);
            }
            assert!(seen.sharp == 3 && !seen.wrong.is_empty(), "{which}");
        }
    }
}
