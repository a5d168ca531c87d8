//! Counts of motions of frames that grow, where a spring between two points has negative stiffness.
#![expect(clippy::unwrap_used, reason = "a network that cannot be built fails the test")]

use mstmm::__private::ChartScalar;
use mstmm::element::{FrequencyEstimates, FrequencyPowers, InvalidParameter, MemberNumbers};
use mstmm::elements::Spring;
use mstmm::network::{
    Chart, Charted, Freedoms, Member, MemberChart, MemberElement, Network, Node, Section, UndampedMember,
};
use mstmm::number::{Frequency, Size};
use mstmm::prelude::*;
use mstmm::search::{SearchError, System};

const SECTION: Section<f64> = Section { axial_stiffness: 400.0, bending_stiffness: 2.0, mass_per_length: 1.5 };

/// A member of a frame, or a spring of either sign.
#[derive(Clone, Copy, Debug)]
enum Piece {
    Stable(UndampedMember<f64>),
    Link(f64),
}

/// A built piece.
#[derive(Clone, Copy, Debug)]
#[expect(clippy::large_enum_variant, reason = "a test has few of them")]
enum BuiltPiece {
    Stable(<UndampedMember<f64> as MemberElement>::Built),
    Link(Spring<f64>),
}

impl From<Section<f64>> for Piece {
    fn from(section: Section<f64>) -> Self {
        Piece::Stable(section.into())
    }
}

impl MemberElement for Piece {
    type Parameter = f64;
    type Built = BuiltPiece;
    const MAY_BUCKLE: bool = true;

    fn may_buckle(built: &BuiltPiece) -> bool {
        matches!(built, BuiltPiece::Link(_))
    }

    fn build(self, length: f64) -> Result<BuiltPiece, InvalidParameter> {
        Ok(match self {
            Piece::Stable(member) => BuiltPiece::Stable(member.build(length)?),
            // a spring as `build` would refuse it
            Piece::Link(stiffness) => BuiltPiece::Link(Spring { stiffness }),
        })
    }

    fn name(&self) -> &'static str {
        "piece"
    }

    fn member_numbers(built: &BuiltPiece) -> MemberNumbers {
        match built {
            BuiltPiece::Stable(built) => UndampedMember::member_numbers(built),
            BuiltPiece::Link(Spring { stiffness }) => MemberNumbers::Spring(0, [*stiffness, 0.0]),
        }
    }

    fn freedoms(&self) -> Freedoms {
        match self {
            Piece::Stable(member) => member.freedoms(),
            Piece::Link(_) => Freedoms::X,
        }
    }

    fn is_joint(&self) -> bool {
        false
    }

    fn estimate(built: &BuiltPiece, estimates: &mut FrequencyEstimates) {
        match built {
            BuiltPiece::Stable(built) => UndampedMember::estimate(built, estimates),
            BuiltPiece::Link(Spring { stiffness }) => estimates.translational_stiffness(stiffness.abs()),
        }
    }
}

impl<S: Frequency<f64> + ChartScalar> MemberChart<S> for Piece {
    fn chart(built: &BuiltPiece, at: &FrequencyPowers<S>, length: S) -> Chart<S> {
        match built {
            BuiltPiece::Stable(built) => <UndampedMember<f64> as MemberChart<S>>::chart(built, at, length),
            BuiltPiece::Link(spring) => {
                let mut chart = <Spring<f64> as Charted<S>>::chart(spring, at, length);
                // with a force as variable its end is free, and falls
                chart.below = chart.below + S::Size::of(f64::from(u8::from(spring.stiffness < 0.0)));
                chart
            }
        }
    }
}

/// Asserts that so many motions of a frame grow; else that so many are at rest.
fn assert_modes(nodes: &[Node<f64>], members: &[Member<Piece>], unstable: u64, at_rest: u64) {
    let frame = Network::new(nodes, members).unwrap();
    assert_eq!(frame.unstable_modes(), Ok(unstable));
    let found = frame.natural_frequencies::<20>(0.0..=2.0);
    if unstable > 0 {
        assert_eq!(found.unwrap_err(), SearchError::Unstable { modes: unstable });
        assert_eq!(frame.count_below(1.0), Err(SearchError::Unstable { modes: unstable }));
        return;
    }
    let zero = found.unwrap().first().filter(|root| root.omega == 0.0).map_or(0, |root| root.multiplicity);
    assert_eq!(zero, at_rest);
}

fn clamped(place: [f64; 2]) -> Node<f64> {
    Node::at(place).held(Freedoms::PLANE)
}

fn link(from: usize, to: usize, stiffness: f64) -> Member<Piece> {
    Member::new(from, to, Piece::Link(stiffness))
}

fn beam(from: usize, to: usize) -> Member<Piece> {
    Member::new(from, to, SECTION)
}

/// Oracle: the tip has the stiffness 3EI/l³ across and EA/l along, whatever the direction of the beam, in one part or in two.
#[test]
fn a_cantilever_buckles_at_the_stiffness_of_its_tip() {
    let length = 2.0;
    let [along, across] = [400.0 / length, 3.0 * 2.0 / (length * length * length)];
    for angle in [0.0, 0.7, 2.0] {
        let (s, c) = f64::sin_cos(angle);
        let at = |x: f64, y: f64| [c * x - s * y, s * x + c * y];
        for (to, critical) in [(at(length, 1.0), across), (at(length + 1.0, 0.0), along)] {
            let nodes = [clamped([0.0, 0.0]), Node::at(at(1.2, 0.0)), Node::at(at(length, 0.0)), clamped(to)];
            for (factor, modes) in [(-1.0 - 1e-9, 1), (-1.0 + 1e-9, 0), (-1e6, 1), (1.0, 0)] {
                let members = [beam(0, 1), beam(1, 2), link(2, 3, factor * critical)];
                assert_modes(&nodes, &members, modes, 0);
            }
        }
    }
}

/// A square in the air with a diagonal, and with springs to the ground, each of which takes a motion of the rigid square.
#[test]
fn a_square_in_the_air() {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(Node::at);
    let ground = [[-1.0, 0.0], [1.0, -1.0], [0.0, 3.0]].map(clamped);
    let nodes: Vec<_> = corners.into_iter().chain(ground).collect();
    let sides = || vec![beam(0, 1), beam(1, 2), beam(2, 3), beam(3, 0)];
    let with = |links: &[(usize, usize, f64)]| -> Vec<_> {
        sides().into_iter().chain(links.iter().map(|(from, to, stiffness)| link(*from, *to, *stiffness))).collect()
    };
    assert_modes(&corners, &sides(), 0, 3);
    assert_modes(&corners, &with(&[(0, 2, 0.1)]), 0, 3);
    // beyond the stiffness of the frame, which is of the size of EI/l³
    assert_modes(&corners, &with(&[(0, 2, -1e-3)]), 0, 3);
    assert_modes(&corners, &with(&[(0, 2, -1e3)]), 1, 0);
    assert_modes(&corners, &with(&[(0, 2, -1e3), (1, 3, -1e3)]), 2, 0);
    for signs in 0..8_u32 {
        let stiffness = |k: u32| if signs >> k & 1 == 1 { -0.01 } else { 0.02 };
        let members = with(&[(0, 4, stiffness(0)), (1, 5, stiffness(1)), (3, 6, stiffness(2))]);
        assert_modes(&nodes, &members, u64::from(signs.count_ones()), 0);
    }
}

/// A mass that slides on a link alone.
#[test]
fn a_mass_on_a_link() {
    let slide = Freedoms::Y.union(Freedoms::RZ);
    let nodes = [clamped([0.0, 0.0]), Node { mass: 3.0, ..Node::at([1.0, 0.0]).held(slide) }];
    for (stiffness, modes) in [(-12.0, 1), (12.0, 0)] {
        assert_modes(&nodes, &[link(0, 1, stiffness)], modes, 0);
    }
}

#[test]
fn a_frame_without_a_link_is_not_asked() {
    let nodes = [clamped([0.0, 0.0]), Node::at([1.0, 0.0])];
    let members = [beam(0, 1)];
    let pieces = Network::new(&nodes, &members).unwrap();
    assert_eq!((pieces.may_buckle(), pieces.unstable_modes()), (false, Ok(0)));
}
