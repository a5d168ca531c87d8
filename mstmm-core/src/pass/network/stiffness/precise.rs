//! Δ and counts of a network by stiffnesses in extended precision: rounding leaves digits enough there also where members are a million times
//! stiffer than others, so that roots are certified by it which stiffnesses alone doubt, in less time than by fronts.

use crate::DoubleDouble;
use crate::number::{FrequencyPowers, Oscillation, Real, Scalar, Scaled};
use crate::pass::network::evaluate::Placed;
use crate::pass::network::stiffness::arrangement::KEPT;
use crate::pass::network::stiffness::front::{StiffnessFront, StiffnessMemory};
use crate::pass::network::stiffness::group::{Group, MOST};
use crate::pass::network::stiffness::member::StiffnessMember;
use crate::pass::network::stiffness::model::StiffnessModel;
use crate::pass::network::stiffness::numbers::Waving;
use crate::pass::network::stiffness::pass::add_member;
use crate::pass::network::stiffness::precise_count::PreciseCount;
use crate::pass::network::stiffness::waves::BeamWaves;

/// A pass in extended precision, for which members are computed once for all of its frequencies.
struct Precise<'m, 'p, 'r> {
    model: &'m StiffnessModel<'m>,
    points: &'p mut [Point<'r>],
    /// The beams whose waves are kept: equal beams of rounded numbers may differ here.
    kept: [Waving<DoubleDouble>; KEPT],
}

/// A frequency with its front.
struct Point<'r> {
    at: FrequencyPowers<DoubleDouble>,
    front: StiffnessFront<'r, DoubleDouble>,
    waves: BeamWaves<DoubleDouble>,
}

impl Precise<'_, '_, '_> {
    /// Adds a member, given its length and what the displacements of its ends are of the motions of their nodes.
    #[inline(never)]
    fn add(&mut self, member: usize, length: DoubleDouble, rows: [[[DoubleDouble; 3]; 2]; 2]) {
        let mut seat = self.model.members[member].seat;
        let waving = Waving::new(&self.model.numbers[member], length);
        if let Waving::Beam(..) = waving {
            let kept = &mut self.kept[usize::from(seat.waves)];
            seat.is_first = *kept != waving;
            *kept = waving;
        }
        let member = StiffnessMember { waving, rows, seat };
        for Point { at, front, waves } in self.points.iter_mut() {
            add_member(front, &member, at, waves);
        }
    }

    /// Adds a body to the motions of its node, and eliminates these.
    #[inline(never)]
    fn eliminate(&mut self, group: &Group, masses: Option<[DoubleDouble; 6]>) {
        for Point { at, front, .. } in self.points.iter_mut() {
            if let Some(masses) = &masses {
                front.add_body(group, masses, at.lambda_squared);
            }
            front.eliminate(group);
        }
    }
}

impl Point<'_> {
    /// What has been counted, if rounding cannot have decided it.
    fn count(&self) -> Option<PreciseCount> {
        let total = &self.front.total;
        let is_known = total.product.size().is_finite() && !total.product.vanishes() && !total.is_doubtful;
        let delta = Scaled::new(total.product, total.exponent);
        is_known.then_some(PreciseCount { delta, below: total.below as u64 })
    }
}

/// A number in extended precision, of another type of extended precision.
fn precise<T: Real>(number: <T as Real>::Extended) -> DoubleDouble {
    let head = T::from_extended(number);
    let tail = T::from_extended(number - head.to_extended());
    DoubleDouble::from(head.to_f64()) + DoubleDouble::from(tail.to_f64())
}

/// Δ and counts at two frequencies in extended precision, of a network that is known in numbers; none where rounding may have decided one.
#[cold]
#[inline(never)]
pub fn precise_counts<Y: Placed + ?Sized>(network: &Y, omega: [f64; 2]) -> [Option<PreciseCount>; 2] {
    // without `std` size counts, and searches know no stiffnesses
    let Some(model) = network.in_numbers().filter(|_| cfg!(feature = "std")) else { return [None; 2] };
    let mut memory = [(); 2].map(|()| StiffnessMemory::<DoubleDouble, MOST, 1176>::new());
    let mut omega = omega.map(DoubleDouble::from).into_iter();
    let mut points = memory.each_mut().map(|memory| Point {
        at: FrequencyPowers::new::<f64>(omega.next().unwrap_or(DoubleDouble::ZERO), true),
        front: memory.front(model.width, true),
        waves: BeamWaves::new(),
    });
    let mut pass = Precise { model: &model, points: &mut points, kept: [Waving::Other; KEPT] };
    let (mut joined, mut parted) = (0, 0);
    for &index in model.order {
        let node = &model.nodes[index];
        for &member in &model.joining[joined..node.joined as usize] {
            add(&mut pass, network, member as usize);
        }
        let (point, motions) = network.node(index);
        let masses = node.masses.is_some().then(|| {
            let rows = motions.masses::<<Y::Parameter as Real>::Extended>(point);
            [rows[0][0], rows[1][0], rows[1][1], rows[2][0], rows[2][1], rows[2][2]].map(precise::<Y::Parameter>)
        });
        pass.eliminate(&node.group, masses);
        for &member in &model.parting[parted..node.parted as usize] {
            pass.eliminate(&model.members[member as usize].seat.ties, None);
        }
        (joined, parted) = (node.joined as usize, node.parted as usize);
    }
    points.each_ref().map(Point::count)
}

/// Adds a member of a network.
fn add<Y: Placed + ?Sized>(pass: &mut Precise<'_, '_, '_>, network: &Y, member: usize) {
    let placement = network.placement(member);
    let nodes = [0, 1].map(|end| placement.node_of(end));
    let ends = placement.joined::<<Y::Parameter as Real>::Extended>(nodes, nodes.map(|node| network.node(node).1));
    let rows = ends.map(|end| [end.rows[0], end.rows[1]].map(|row| row.map(precise::<Y::Parameter>)));
    pass.add(member, precise::<Y::Parameter>(placement.length()), rows);
}
