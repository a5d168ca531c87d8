//! The determinant of the overall matrix against Δ of the dynamic stiffness: one constant for all frequencies.
#![expect(clippy::unwrap_used, reason = "a structure that cannot be built fails the test")]

use crate::families::damped::damped_structure;
use crate::families::named::{
    free_square, hinged_zigzag, ladder, mass_on_springs, portal, portal_on_sliders, portal_with_ties, ring, star,
    storeys,
};
use crate::families::random::Spread;
use crate::families::random_structures;
use crate::structure::{Element, Structure};
use crate::through_library::{first, freedoms};
use mstmm::elements::{Damper, PlanarHinge, Spring, TorsionDamper, TorsionSpring};
use mstmm::network::{
    AnyMember, End, Freedoms, Joint, Member, MemberElement, MemberMatrix, Network, NetworkError, Node, Section,
    UndampedMember, Vectors,
};
use mstmm::number::{DoubleDouble, Frequency, Scaled, Single};
use mstmm::prelude::*;

type Double = DoubleDouble;
type InDouble<E> = Network<E, Vectors>;

pub(crate) fn double(number: f64) -> Double {
    Double::from(number)
}

fn node(node: &crate::structure::Node) -> Node<Double> {
    let body = (double(node.mass), double(node.inertia), node.centre.map(double));
    let other = Node::at(node.position.map(double)).held(freedoms(node.held)).with_body(body.0, body.1, body.2);
    node.along.map_or(other, |direction| other.along(direction.map(double)))
}

/// An element without dashpots.
fn undamped<E>(element: Element) -> E
where
    E: From<Section<Double>> + From<Spring<Double>> + From<TorsionSpring<Double>> + From<Joint<Double>>,
{
    match element {
        Element::Beam(section) => Section {
            axial_stiffness: double(section.axial_stiffness),
            bending_stiffness: double(section.bending_stiffness),
            mass_per_length: double(section.mass_per_length),
        }
        .into(),
        Element::Spring { stiffness } => Spring { stiffness: double(stiffness) }.into(),
        Element::TorsionSpring { stiffness } => TorsionSpring { stiffness: double(stiffness) }.into(),
        Element::Hinge { stiffness } => {
            let [stiffness_x, stiffness_y, stiffness_theta] = stiffness.map(double);
            Joint::from(PlanarHinge { stiffness_x, stiffness_y, stiffness_theta }).into()
        }
        Element::Weld { freedoms: shared } => Joint::rigid(freedoms(shared)).into(),
        Element::Damper { .. } | Element::TorsionDamper { .. } => unreachable!("undamped structures have no dashpot"),
    }
}

fn any(element: Element) -> AnyMember<Double> {
    match element {
        Element::Damper { damping } => Damper { damping: double(damping) }.into(),
        Element::TorsionDamper { damping } => TorsionDamper { damping: double(damping) }.into(),
        other => undamped(other),
    }
}

fn members<E: MemberElement<Parameter = Double>>(
    structure: &Structure,
    element: impl Fn(Element) -> E,
) -> Vec<Member<E>> {
    let member = |member: &crate::structure::Member| {
        let [from, to] = member.ends.map(|end| {
            let other = End::of(end.node).releasing(freedoms(end.released));
            end.position.map_or(other, |position| other.at(position.map(double)))
        });
        let other = Member::new(from, to, element(member.element));
        member.along.map_or(other, |direction| other.along(direction.map(double)))
    };
    structure.members.iter().map(member).collect()
}

/// The number of unknowns of a network.
fn unknowns<E: MemberElement>(network: &InDouble<E>) -> usize {
    match network.overall::<0>() {
        Err(NetworkError::Unknowns { needed }) => needed,
        other => unreachable!("no unknowns: {other:?}"),
    }
}

/// The overall determinant of a network of any of these sizes.
fn determinant<E, S>(network: &InDouble<E>, x: S) -> Scaled<S>
where
    E: MemberMatrix<S>,
    S: Frequency<E::Parameter> + Single,
{
    macro_rules! of_size {
        ($($size:literal)*) => {
            match unknowns(network) {
                $($size => network.overall::<$size>().unwrap().overall_determinant(x),)*
                other => unreachable!("{other} unknowns"),
            }
        };
    }
    of_size!(3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39 40
        41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59 60)
}

/// The largest relative difference of the quotients of overall determinants and Δ.
fn spread<E, S>(structure: &Structure, element: impl Fn(Element) -> E, points: &[S]) -> (usize, f64)
where
    E: MemberMatrix<S, Parameter = Double>,
    S: Frequency<Double> + Single,
    InDouble<E>: Characteristic<S>,
{
    let nodes: Vec<Node<Double>> = structure.nodes.iter().map(node).collect();
    let members = members(structure, element);
    let network = InDouble::new(&nodes, &members).unwrap();
    let quotients: Vec<S> =
        points.iter().map(|&x| quotient(determinant(&network, x), network.characteristic(x))).collect();
    (unknowns(&network), largest_difference(&quotients))
}

/// The largest relative difference of numbers from the first one; a NaN is largest.
pub(crate) fn largest_difference<S: Single>(numbers: &[S]) -> f64 {
    let difference = |one: &S| (*one / numbers[0] - S::one()).size();
    numbers.iter().map(difference).fold(0.0, |worst, one| if one <= worst { worst } else { one })
}

pub(crate) fn quotient<S: Single>(one: Scaled<S>, other: Scaled<S>) -> S {
    let shift = (one.exponent() - other.exponent()).clamp(-900, 900);
    (one.mantissa() / other.mantissa()).times_power_of_two(shift as i32)
}

/// Frequencies as parts of the first one, below it and among those behind, where the overall matrix has its digits.
pub(crate) const LOW: [f64; 6] = [0.29, 0.73, 1.37, 2.19, 3.31, 4.87];

/// The difference of two quotients that is rounding: 32 digits less those that go to waves and to stiffness ratios.
const ROUNDING: f64 = 1e-20;

fn frequencies(structure: &Structure) -> [f64; 6] {
    let found = first(structure).unwrap();
    let first = found.iter().find(|root| root.omega > 0.0).unwrap().omega;
    LOW.map(|part| part * first)
}

/// What was compared.
#[derive(Default)]
pub(crate) struct Report {
    structures: usize,
    worst: f64,
    wrong: Vec<String>,
}

impl Report {
    pub(crate) fn add(&mut self, name: &str, from: f64, (unknowns, difference): (usize, f64)) {
        self.structures += 1;
        println!("{name}: N = {unknowns}, from {from:.3} rad/s on constant up to {difference:.1e}");
        self.worst = self.worst.max(difference);
        // a NaN is not constant
        if difference.is_nan() || difference > ROUNDING {
            self.wrong.push(format!("{name}: {difference:e}"));
        }
    }

    fn undamped(&mut self, name: &str, structure: &Structure) {
        let omegas = frequencies(structure);
        self.add(name, omegas[0], spread(structure, undamped::<UndampedMember<Double>>, &omegas.map(double)));
    }

    pub(crate) fn judge(self) {
        println!("{} structures, the worst constant up to {:.1e}", self.structures, self.worst);
        assert!(self.wrong.is_empty(), "{:#?}", self.wrong);
    }
}

#[test]
fn overall_determinants_of_named_structures_are_proportional_to_delta() {
    let mut report = Report::default();
    for (name, structure) in [
        ("portal", portal(1e4, 1.0)),
        ("portal on sliders", portal_on_sliders(1.0)),
        ("portal with ties", portal_with_ties(1e-2, false)),
        ("portal with hinged ties", portal_with_ties(1e-2, true)),
        ("zigzag with hinges", hinged_zigzag(6, 1e-4)),
        ("mass on springs", mass_on_springs(3.0)),
        ("ladder", ladder(3, 1.0)),
        ("storeys", storeys(2, 2)),
        ("ring", ring(7)),
        ("free square", free_square(1e4)),
        ("star", star(1e4)),
    ] {
        report.undamped(name, &structure);
    }
    report.judge();
}

#[test]
fn overall_determinants_of_random_structures_are_proportional_to_delta() {
    let mut report = Report::default();
    for (name, structure) in random_structures(0..40, Spread::Moderate) {
        report.undamped(&name, &structure);
    }
    report.judge();
}

/// A released freedom is a jump: the hinge of a portal has one unknown, and it is said how many there are.
#[test]
fn another_number_of_unknowns_is_refused() {
    let section =
        Section { axial_stiffness: double(1e4), bending_stiffness: double(1.0), mass_per_length: double(1.0) };
    let nodes = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]].map(|place| Node::at(place.map(double)));
    let nodes = [nodes[0].held(Freedoms::PLANE), nodes[1], nodes[2], nodes[3].held(Freedoms::PLANE)];
    let hinge = End::of(2).releasing(Freedoms::RZ);
    type Beam = Member<UndampedMember<Double>>;
    let members = [Beam::new(0, 1, section), Beam::new(1, hinge, section), Beam::new(3, 2, section)];
    let network = InDouble::new(&nodes, &members).unwrap();
    assert!(network.overall::<7>().is_ok());
    let message = "the overall transfer equation has 7 unknowns: ask for `overall::<7>()`";
    assert_eq!(network.overall::<6>().unwrap_err().to_string(), message);
}

/// λ with decay and growth.
#[test]
fn overall_determinants_of_damped_structures_are_proportional_to_delta() {
    let mut report = Report::default();
    for seed in 0..12 {
        let structure = damped_structure(seed);
        let points = LOW.map(|part| Complex::new(double(0.2 - 0.3 * part), double(part)));
        report.add(&format!("damped_structure({seed})"), LOW[0], spread(&structure, any, &points));
    }
    report.judge();
}
