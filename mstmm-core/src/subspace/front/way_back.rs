//! The way back through fronts: from the last node to the first, each node's own variables follow from those of its boundary.
//!
//! Before its elimination each interior variable v of a front gets a rider s with the entry 1 between both, so that Π grows by `s v`. No
//! pivot changes `v = ∂Π/∂s`: at the end the row of the rider is what v is of the load and of the boundary, whatever has flipped. A load
//! is a rider too, which goes on from front to front.

use crate::model::EndMotion;
use crate::number::{Scalar, power_of_two};
use crate::subspace::front::chart::{Chart, JoinedEnd, MOST_FREEDOMS, MOST_VARIABLES};
use crate::subspace::front::fronts::{FrontNode, Fronts};
use crate::subspace::front::matrix::Front;
use crate::subspace::front::target::{Kind, Target};
use mstmm_plan::Freedoms;

/// The load of a node.
#[derive(Clone, Copy, Debug)]
pub enum NodeLoad<S> {
    /// None.
    Nothing,
    /// Forces on its motions.
    Motions([S; MOST_FREEDOMS]),
    /// Forces, and perhaps dislocations.
    Everywhere(LoadEverywhere),
}

/// Forces on all displacements of the size of their units, other ones for each number, and perhaps dislocations.
#[derive(Clone, Copy, Debug)]
pub struct LoadEverywhere {
    pub(crate) number: u32,
    pub(crate) dislocates: bool,
}

/// A variable of the boundary of a front that was left.
#[derive(Clone, Copy, Debug)]
pub(super) struct Left {
    /// The factor of its value in the object, given in the units of the front.
    power: f64,
    /// What the gradient of the front is of its value before it changed its kind; zero if it has not.
    sign: f64,
}

impl Left {
    pub(super) const NONE: Left = Left { power: 0.0, sign: 0.0 };
}

/// What is kept of a node: where it begins, and sizes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mark {
    number: usize,
    source: usize,
    left: usize,
    /// Variables that it has eliminated, and logarithms of the units of displacements and of rotations.
    interior: usize,
    units: [i32; 2],
}

impl Mark {
    pub(super) const FIRST: Mark = Mark { number: 0, source: 0, left: 0, interior: 0, units: [0; 2] };
}

/// What the way back needs of all nodes, in memory of the caller's.
#[derive(Debug)]
pub struct Kept<'r, S> {
    /// What interior variables and those of the boundary are of the load and of the boundary.
    pub(super) numbers: &'r mut [S],
    /// What each variable of the objects was in the front, with the parts of motions in displacements.
    pub(super) sources: &'r mut [Target],
    pub(super) rows: &'r mut [[S; MOST_FREEDOMS]],
    pub(super) left: &'r mut [Left],
    pub(super) marks: &'r mut [Mark],
    pub(super) count: usize,
    /// The quadratic form of the load and its motion, negative.
    pub(crate) form: S,
}

impl<S: Scalar> Kept<'_, S> {
    /// Notes where the variables of objects have gone.
    fn open(&mut self, fronts: &Fronts<'_, S>, node: &FrontNode<S>, from: usize) {
        let (front, mark) = (&fronts.front, &mut self.marks[self.count]);
        mark.interior = front.count - front.boundary;
        let unit = |wanted: bool| {
            let is_wanted = |motion: &usize| node.is_rotation(*motion) == wanted;
            let motion = (0..node.motions).find(is_wanted);
            motion.map_or(0, |motion| front.variables[front.boundary + motion].unit)
        };
        mark.units = [unit(false), unit(true)];
        let mut next = mark.source;
        for place in fronts.objects.last(from) {
            let variable = &fronts.objects.variables[place];
            if variable.is_load() {
                continue;
            }
            let restrained = variable.restrained.filter(|_| variable.node == node.index);
            self.sources[next] = match restrained {
                Some(unit) => Target { kind: Kind::Motions, place: 0, power: power_of_two(variable.unit - unit) },
                None if fronts.targets[place].kind == Kind::Motions => Target { power: 1.0, ..fronts.targets[place] },
                None => fronts.targets[place],
            };
            self.rows[next] = fronts.objects.rows[place];
            next += 1;
        }
        for (k, variable) in front.variables[front.riders..front.boundary].iter().enumerate() {
            let sign = if variable.is_force { 1.0 } else { -1.0 };
            self.left[mark.left + k] = Left { power: 1.0, sign };
        }
        let (number, left) = (mark.number, mark.left + front.boundary - front.riders);
        self.marks[self.count + 1] = Mark { number, source: next, left, ..Mark::FIRST };
    }

    /// Keeps the rows of riders and of the boundary once the node is eliminated, whose front is left in units `2^shift` times as large.
    fn close(&mut self, front: &Front<'_, S>, shift: i32) {
        let mark = self.marks[self.count];
        let variables = &front.variables[front.riders..front.boundary];
        for (left, variable) in self.left[mark.left..].iter_mut().zip(variables) {
            let was_force = left.sign > 0.0;
            let shift = if variable.is_force { -shift } else { shift };
            let sign = if was_force == variable.is_force { 0.0 } else { left.sign };
            *left = Left { power: power_of_two(shift), sign };
        }
        let mut next = mark.number;
        for row in (0..mark.interior).chain(front.riders..front.boundary) {
            for column in front.riders - 1..front.boundary {
                self.numbers[next] = front.entry(row, column);
                next += 1;
            }
        }
        self.count += 1;
        self.marks[self.count].number = next;
        if front.boundary == front.riders {
            self.form += front.entry(front.riders - 1, front.riders - 1);
        }
    }
}

impl<S: Scalar> Fronts<'_, S> {
    /// Joins the last objects at a node under a load, eliminates it, leaves its front as an object and keeps what the way back needs.
    pub(super) fn take_up_and_keep(&mut self, node: &FrontNode<S>, load: &NodeLoad<S>, kept: &mut Kept<'_, S>) {
        let from = self.objects.count - node.objects;
        self.total.node = node.index;
        self.join(node, from);
        self.front.read_interior();
        self.front.add_load(node, load);
        kept.open(self, node, from);
        self.front.eliminate(self.choice, &mut self.total);
        let shift = self.front.balance();
        kept.close(&self.front, shift);
        self.objects.replace_last(from, node.index, &self.front, shift);
    }
}

impl<S: Scalar> Front<'_, S> {
    /// Gives each interior variable a rider.
    fn read_interior(&mut self) {
        for place in self.boundary..self.count {
            self.add(place, place - self.boundary, S::one());
        }
    }

    /// Adds a load.
    fn add_load(&mut self, node: &FrontNode<S>, load: &NodeLoad<S>) {
        let rider = self.riders - 1;
        match load {
            NodeLoad::Nothing => {}
            NodeLoad::Motions(forces) => {
                for (motion, force) in forces[..node.motions].iter().enumerate() {
                    let place = self.boundary + motion;
                    self.add(place, rider, -force.scaled(power_of_two(self.variables[place].unit)));
                }
            }
            NodeLoad::Everywhere(LoadEverywhere { number, dislocates }) => {
                for place in self.boundary..self.count {
                    if self.variables[place].is_force && !dislocates {
                        continue;
                    }
                    self.add(place, rider, S::from_f64(scattered([node.index, place as u32, *number])));
                }
            }
        }
    }
}

/// The way back at work: values of the variables of objects, those that were taken up last on top.
#[derive(Debug)]
pub struct Back<'r, S> {
    pub(crate) kept: Kept<'r, S>,
    pub(super) values: &'r mut [S],
    pub(super) count: usize,
    /// Values of the variables of a front.
    pub(super) of_front: &'r mut [S],
}

impl<S: Scalar> Back<'_, S> {
    /// Goes back through the last node. Returns its motions.
    pub(super) fn node(&mut self, node: &FrontNode<S>) -> [S; MOST_FREEDOMS] {
        let Back { kept, values, count, of_front } = self;
        kept.count -= 1;
        let [mark, next] = [kept.marks[kept.count], kept.marks[kept.count + 1]];
        let left = &kept.left[mark.left..next.left];
        *count -= left.len();
        let boundary = &mut values[*count..][..left.len()];
        for (value, left) in boundary.iter_mut().zip(left) {
            *value = value.scaled(left.power);
        }
        let of_front = &mut of_front[..mark.interior + left.len()];
        let rows = kept.numbers[mark.number..next.number].chunks_exact(1 + left.len());
        for (value, row) in of_front.iter_mut().zip(rows) {
            let terms = row[1..].iter().zip(&*boundary).map(|(part, value)| *part * *value);
            *value = terms.fold(row[0], |sum, term| sum + term);
        }
        let (interior, outer) = of_front.split_at_mut(mark.interior);
        for ((gradient, left), value) in outer.iter_mut().zip(left).zip(boundary) {
            *gradient = if left.sign == 0.0 { *value } else { gradient.scaled(left.sign) };
        }
        let motions = &interior[..node.motions];
        for (source, row) in kept.sources[mark.source..next.source].iter().zip(&kept.rows[mark.source..]) {
            let value = match source.kind {
                Kind::Nowhere => S::zero(),
                Kind::Motions => row.iter().zip(motions).fold(S::zero(), |sum, (part, motion)| sum + *part * *motion),
                Kind::Place => {
                    // behind the riders of a front stand those of the boundary, then the interior ones
                    let place = source.place as usize - mark.interior - 1;
                    if place < outer.len() { outer[place] } else { interior[place - outer.len()] }
                }
            };
            values[*count] = value.scaled(source.power);
            *count += 1;
        }
        let mut of_node = [S::zero(); MOST_FREEDOMS];
        for (motion, (value, own)) in of_node.iter_mut().zip(motions).enumerate() {
            let unit = mark.units[usize::from(node.is_rotation(motion))];
            *value = own.scaled(power_of_two(unit));
        }
        of_node
    }

    /// Takes the values of a member from the top, whose ends are moved besides what their nodes do, and which may be loaded.
    pub(crate) fn member(
        &mut self,
        chart: &Chart<S>,
        ends: &[JoinedEnd<S>; 2],
        moved: &[[S; MOST_FREEDOMS]; 2],
        load: &[S; MOST_VARIABLES],
    ) -> [EndMotion<S>; 2] {
        // the end and the freedom of each variable of the chart
        let mut variables = [(0, Freedoms::NONE); MOST_VARIABLES];
        let mut count = 0;
        for end in [0, 1] {
            for kind in Freedoms::SINGLE.into_iter().filter(|kind| chart.freedoms.contains(*kind)) {
                variables[count] = (end, kind);
                count += 1;
            }
        }
        let mut values = [S::zero(); MOST_VARIABLES];
        for (place, (end, kind)) in variables[..count].iter().enumerate().rev() {
            if ends[*end].keeps(chart.is_force(place), *kind) {
                self.count -= 1;
                values[place] = self.values[self.count];
            }
        }
        for (place, (value, moved)) in values.iter_mut().zip(chart.moved(moved)).enumerate() {
            if !chart.is_force(place) {
                *value += moved;
            }
        }
        chart.motion(&values, load)
    }
}

/// A number of the size of 1 that follows from three others without any order, so that loads of several numbers are independent on whatever
/// variables, and no motion is at rest under all of them.
fn scattered(from: [u32; 3]) -> f64 {
    let mut bits = 0_u64;
    for part in from {
        // the mixing steps of SplitMix64
        bits = bits.wrapping_add(u64::from(part)).wrapping_add(0x9E37_79B9_7F4A_7C15);
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^= bits >> 31;
    }
    let part = (bits >> 33) as f64 / f64::from(1_u32 << 31);
    if part < 0.5 { part + 0.5 } else { -part }
}
