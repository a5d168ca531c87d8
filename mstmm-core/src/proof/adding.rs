//! Parts are added to a front: each is a symmetric matrix of balls over rows of variables, and a count with its rows held.

use crate::element::{BeamNumbers, Exact, LineNumbers, SpinNumbers};
use crate::proof::ball::Ball;
use crate::proof::bending::{Bending, bending};
use crate::proof::general_bending::{General, general_bending};
use crate::proof::join::Join;
use crate::proof::joining::{Joining, Terms};
use crate::proof::level::Level;
use crate::proof::line::line;
use crate::proof::member::{Member, any, place};
use crate::proof::number::Number;
use crate::proof::row::is_zero;
use crate::proof::word::{Word, apart};

/// Size of a coefficient, beside the largest one of its row, below which it says nothing of the stiffness of its variable: what rounding leaves
/// of zero is as small. The weights of rows follow from it, and are valid whatever they are.
const LEAST_COEFFICIENT: f64 = 1e-9;

apart! {
    /// Adds a matrix over rows, given the sizes of the stiffnesses of these.
    fn add<N: Level, const F: usize, const E: usize>(
        joining: &mut Joining<'_, N>,
        stiffness: &[Ball<N>; E],
        rows: &[Terms<'_, N>; F],
        sizes: [f64; F],
    ) {
        let front = &mut joining.front;
        for (row, size) in rows.iter().zip(sizes) {
            let largest = row.iter().map(|term| term.coefficient.mid.size()).fold(0.0, f64::max);
            for term in *row {
                let coefficient = term.coefficient.mid.size().max(LEAST_COEFFICIENT * largest);
                front.grow(term.variable, size * coefficient * coefficient);
            }
        }
        for a in 0..F {
            for b in 0..=a {
                let entry = stiffness[place(a, b)];
                if is_zero(&entry) {
                    continue;
                }
                for (i, first) in rows[a].iter().enumerate() {
                    let scaled = first.times(entry);
                    for (j, second) in rows[b].iter().enumerate() {
                        if a == b && j > i {
                            break;
                        }
                        let term = second.times(scaled);
                        // an entry between two rows stands twice in the form
                        let is_double = a != b && first.variable == second.variable;
                        let term = if is_double { term.scaled(2.0) } else { term };
                        front.add(first.variable, second.variable, term);
                    }
                }
            }
        }
    }

    /// Adds a member, in the units of its displacements' stiffnesses, with its border.
    pub(crate) fn add_member<N: Level, const F: usize, const E: usize>(
        joining: &mut Joining<'_, N>,
        member: &Member<N, F, E>,
        rows: &[Terms<'_, N>; F],
        factors: &[Ball<N::Alone>; 3],
        is_rotation: [bool; F],
    ) {
        // force per displacement, force per rotation or moment per displacement, moment per rotation
        let [force, mixed, moment] = *factors;
        let factors: [Ball<N>; 3] = [Ball::everywhere(force), Ball::everywhere(mixed), Ball::everywhere(moment)];
        let mut stiffness = member.stiffness;
        let mut sizes = member.sizes;
        for a in 0..F {
            for b in 0..=a {
                let factor = factors[usize::from(is_rotation[a]) + usize::from(is_rotation[b])];
                stiffness[place(a, b)] = stiffness[place(a, b)] * factor;
            }
            sizes[a] *= if is_rotation[a] { moment.mid.size() } else { force.mid.size() };
        }
        add(joining, &stiffness, rows, sizes);
        let upper = joining.front.is_bounded_above();
        joining.held = joining.held + N::Word::select(upper, member.held[1], member.held[0]);
        joining.front.total.multiply(member.minor);
        let Some(border) = &member.border else { return };
        let variable = joining.enter();
        joining.front.grow(variable, sizes[0]);
        joining.front.add(variable, variable, -(border.flexibility * factors[0]));
        for a in 0..F {
            // the displacement of a rotation is its lever: one factor for the force, of which the other half is in σ
            let force = border.forces[a] * factors[usize::from(is_rotation[a])];
            for term in rows[a] {
                joining.front.add(variable, term.variable, term.times(force));
            }
        }
        joining.leaves_behind(variable);
    }

    /// A general beam, and whether it is beside a pole in one lane.
    pub(crate) fn general<N: Level>(
        joining: &Joining<'_, N>,
        beam: (&BeamNumbers, &SpinNumbers),
        length: Ball<N::Alone>,
    ) -> (Bending<N>, bool) {
        let (numbers, spin) = beam;
        let moment = (!spin.is_none()).then(|| Ball::everywhere(momentum::<N::Alone>(spin)) * joining.omega);
        let General { member, is_beside_pole } =
            general_bending(numbers, Ball::everywhere(length), joining.square, moment);
        (member, any::<N::Word>(is_beside_pole))
    }

    /// Adds a stiffness between two rows that nobody has proven, with its count with held ends.
    pub(crate) fn add_counted<N: Level>(
        joining: &mut Joining<'_, N>,
        stiffness: [Exact; 3],
        held: f64,
        rows: [Terms<'_, N>; 2],
    ) {
        let [input, between, output] = stiffness;
        let stiffness = [Ball::<N>::of_pair(input), Ball::of_pair(between), Ball::of_pair(output)];
        let [input, between, output] = [input[0].abs(), between[0].abs(), output[0].abs()];
        add(joining, &stiffness, &rows, [input.max(between), output.max(between)]);
        joining.held = joining.held + N::Word::of(held);
    }

    /// Adds a line over the rows of its ends.
    pub(crate) fn add_line<N: Level>(
        joining: &mut Joining<'_, N>,
        numbers: &LineNumbers,
        length: Ball<N::Alone>,
        rows: [Terms<'_, N>; 2],
    ) {
        let over = length * Ball::of_pair(numbers.stiffness).inverse();
        let inertia = Ball::of_pair(numbers.inertia) * joining.square;
        let loads = if numbers.foundation == [0.0; 2] { inertia } else { inertia - Ball::of_pair(numbers.foundation) };
        let member = line(loads * Ball::everywhere(length * over));
        add_member(joining, &member, &rows, &[over.inverse(); 3], [false; 2]);
    }

    /// Adds the bending of a plain beam.
    pub(crate) fn add_plain_bending<N: Level>(
        joining: &mut Joining<'_, N>,
        numbers: &BeamNumbers,
        length: Ball<N::Alone>,
        rows: [Terms<'_, N>; 4],
    ) {
        let square = length * length;
        let of_mass = Ball::of_pair(numbers.mass_per_length)
            * (square * square * Ball::of_pair(numbers.bending_stiffness).inverse());
        let x = Ball::everywhere(of_mass) * joining.square;
        add_bent(joining, &bending(x), &numbers.bending_stiffness, length, rows);
    }

    /// Adds the bending of a beam, known over `EI/l³`.
    pub(crate) fn add_bent<N: Level>(
        joining: &mut Joining<'_, N>,
        member: &Bending<N>,
        stiffness: &Exact,
        length: Ball<N::Alone>,
        rows: [Terms<'_, N>; 4],
    ) {
        let inverse = length.inverse();
        let moment = Ball::of_pair(*stiffness) * inverse;
        let mixed = moment * inverse;
        add_member(joining, member, &rows, &[mixed * inverse, mixed, moment], [false, true, false, true]);
    }

    /// See [`Joining::add_term`].
    pub(crate) fn add_term<N: Level>(joining: &mut Joining<'_, N>, k: Ball<N::Alone>, row: Terms<'_, N>) {
        add(joining, &[Ball::everywhere(k)], &[row], [k.mid.size()]);
    }

    /// See [`Joining::add_mass`].
    pub(crate) fn add_mass<N: Level>(joining: &mut Joining<'_, N>, mass: Exact, row: Terms<'_, N>) {
        let entry = -(Ball::of_pair(mass) * joining.square);
        add(joining, &[entry], &[row], [entry.mid.size().first()]);
    }

    /// See [`Join::add_spin`].
    pub(crate) fn add_spin<N: Level>(joining: &mut Joining<'_, N>, spin: &SpinNumbers, row: Terms<'_, N>) {
        let entry = Ball::everywhere(momentum::<N::Alone>(spin)) * joining.omega;
        add(joining, &[entry], &[row], [entry.mid.size().first()]);
    }

    /// Adds the inertia of a body over rows of displacement and rotation of a point, given its mass, its mass moment and its moment of inertia
    /// about the point.
    pub(crate) fn add_inertia<N: Level>(joining: &mut Joining<'_, N>, inertia: [Ball<N::Alone>; 3], rows: [Terms<'_, N>; 2]) {
        let mut entries = [Ball::of(0.0); 3];
        for (entry, inertia) in entries.iter_mut().zip(inertia) {
            if !is_zero(&inertia) {
                *entry = -(Ball::everywhere(inertia) * joining.square);
            }
        }
        let sizes = [entries[0].mid.size().first(), entries[2].mid.size().first()];
        add(joining, &entries, &rows, sizes);
    }

    /// Adds the inertia of a body over the rows of its three rotations, given the lower triangle of its tensor.
    pub(crate) fn add_tensor<N: Level>(joining: &mut Joining<'_, N>, tensor: [Ball<N::Alone>; 6], rows: [Terms<'_, N>; 3]) {
        let mut entries = [Ball::of(0.0); 6];
        for (entry, part) in entries.iter_mut().zip(tensor) {
            if !is_zero(&part) {
                *entry = -(Ball::everywhere(part) * joining.square);
            }
        }
        let sizes = [0, 2, 5].map(|diagonal| entries[diagonal].mid.size().first());
        add(joining, &entries, &rows, sizes);
    }

    /// Adds the force of a rigid joint over the displacements that are equal, given about its flexibility, and takes off its negative pivot.
    pub(crate) fn add_force<N: Level>(
        joining: &mut Joining<'_, N>,
        force: usize,
        flexibility: f64,
        gap: Terms<'_, N>,
    ) {
        joining.front.grow(force, flexibility);
        for term in gap {
            joining.front.add(force, term.variable, Ball::everywhere(term.coefficient));
        }
        joining.held = joining.held + N::Word::of(-1.0);
    }
}

/// The angular momentum of what spins, of which ω times is a stiffness against rotations.
pub(crate) fn momentum<N: Level>(spin: &SpinNumbers) -> Ball<N> {
    Ball::of_pair(spin.polar_inertia) * Ball::of_pair(spin.speed)
}
