//! How members and bodies are added to a front.

use crate::number::Scalar;
use crate::pass::network::stiffness::front::StiffnessFront;
use crate::pass::network::stiffness::group::Group;
use crate::pass::network::stiffness::member::StiffnessMember;
use crate::structure::triangle::{place, row};

impl<S: Scalar> StiffnessFront<'_, S> {
    /// Adds a number times a body's mass matrix over motions, given its lower triangle.
    #[inline(always)]
    pub(super) fn add_body(&mut self, group: &Group, masses: &[f64; 6], lambda_squared: S) {
        let [first, count] = group.places();
        for k in 0..count {
            for l in 0..=k {
                self.entries[row(first + k) + first + l] += lambda_squared * S::from_f64(masses[row(k) + l]);
            }
        }
    }

    /// Adds forces that tie a freedom of both ends, at a place.
    #[inline(always)]
    pub(super) fn add_tie(&mut self, at: usize, freedom: usize, member: &StiffnessMember) {
        for end in 0..2 {
            let Some([first, count]) = member.seat.places(end) else { continue };
            for (k, part) in member.row(end, freedom)[..count].iter().enumerate() {
                self.entries[place(at, first + k)] += if end == 0 { -S::from_f64(*part) } else { S::from_f64(*part) };
            }
        }
    }

    /// Adds a stiffness between the displacements of both ends in a freedom: of each end, and across.
    #[inline(always)]
    pub(super) fn add_line(&mut self, [own, across]: [S; 2], freedom: usize, member: &StiffnessMember) {
        for end in 0..2 {
            let Some(place) = member.seat.places(end) else { continue };
            self.add_own(own, place, &member.row(end, freedom));
        }
        let [Some(place), Some(other)] = [member.seat.places(0), member.seat.places(1)] else { return };
        self.add_across(across, [place, other], [&member.row(0, freedom), &member.row(1, freedom)]);
    }

    /// Adds a stiffness of a displacement, given what that is of the motions of its node.
    #[inline(always)]
    pub(super) fn add_own<const R: usize>(&mut self, own: S, [first, count]: [usize; 2], parts: &[f64; R]) {
        for (k, part) in parts[..count].iter().enumerate() {
            let term = own * S::from_f64(*part);
            let start = row(first + k) + first;
            for (entry, part) in self.entries[start..=start + k].iter_mut().zip(parts) {
                *entry += term * S::from_f64(*part);
            }
        }
    }

    /// Adds a stiffness between two displacements, given what these are of the motions of their nodes.
    #[inline(always)]
    pub(super) fn add_across<const R: usize>(&mut self, across: S, places: [[usize; 2]; 2], rows: [&[f64; R]; 2]) {
        let [[first, count], [other_first, other_count]] = places;
        for (k, part) in rows[0][..count].iter().enumerate() {
            let term = across * S::from_f64(*part);
            for (l, part) in rows[1][..other_count].iter().enumerate() {
                self.add([first + k, other_first + l], term * S::from_f64(*part));
            }
        }
    }

    /// Adds the stiffness of a beam: of deflection and rotation of one end, and with those of the other end; of displacements along it.
    #[inline(always)]
    pub(super) fn add_beam(&mut self, bending: &[S; 6], along: &[S; 2], member: &StiffnessMember) {
        let [yy, yt, tt, yy_across, yt_across, tt_across] = *bending;
        let [xx, xx_across] = *along;
        let (ends, between) = ([[xx, yy, yt, tt], [xx, yy, -yt, tt]], [xx_across, yy_across, yt_across, tt_across]);
        // loops are written out for the usual numbers of motions
        for (end, stiffness) in ends.into_iter().enumerate() {
            match member.seat.places(end) {
                Some([first, 3]) => self.add_end(stiffness, [first, 3], end, member),
                Some(place) => self.add_end(stiffness, place, end, member),
                None => {}
            }
        }
        match [member.seat.places(0), member.seat.places(1)] {
            [Some([first, 3]), Some([other, 3])] => self.add_between(between, [[first, 3], [other, 3]], member),
            [Some(place), Some(other)] => self.add_between(between, [place, other], member),
            _ => {}
        }
    }

    /// Adds what a beam has of an end, where its last motion may be the rotation.
    #[inline(always)]
    fn add_end(&mut self, [xx, yy, yt, tt]: [S; 4], [first, count]: [usize; 2], end: usize, member: &StiffnessMember) {
        let ([along, across], rotation) = (&member.rows[end], member.seat.rotation(end));
        for k in 0..count {
            let (of_along, mut of_across) = (xx * S::from_f64(along[k]), yy * S::from_f64(across[k]));
            if rotation == Some(k) {
                of_across += yt;
            }
            let start = row(first + k) + first;
            for (l, entry) in self.entries[start..=start + k].iter_mut().enumerate() {
                *entry += of_along * S::from_f64(along[l]) + of_across * S::from_f64(across[l]);
            }
            if rotation == Some(k) {
                self.entries[start + k] += yt * S::from_f64(across[k]) + tt;
            }
        }
    }

    /// Adds what a beam has between both ends.
    #[inline(always)]
    fn add_between(
        &mut self,
        [xx, yy, yt, tt]: [S; 4],
        [[first, count], [other_first, other_count]]: [[usize; 2]; 2],
        member: &StiffnessMember,
    ) {
        let [[along, across], [other_along, other_across]] = &member.rows;
        let rotations = [member.seat.rotation(0), member.seat.rotation(1)];
        for k in 0..count {
            let (of_along, mut of_across, mut of_rotation) =
                (xx * S::from_f64(along[k]), yy * S::from_f64(across[k]), yt * S::from_f64(across[k]));
            if rotations[0] == Some(k) {
                (of_across, of_rotation) = (of_across - yt, of_rotation + tt);
            }
            for l in 0..other_count {
                let mut term = of_along * S::from_f64(other_along[l]) + of_across * S::from_f64(other_across[l]);
                if rotations[1] == Some(l) {
                    term += of_rotation;
                }
                self.add([first + k, other_first + l], term);
            }
        }
    }

    /// Adds an entry and its mirror image, which on the diagonal is the same place.
    #[inline(always)]
    pub(super) fn add(&mut self, [one, other]: [usize; 2], term: S) {
        let place = place(one, other);
        self.entries[place] += term;
        if one == other {
            self.entries[place] += term;
        }
    }
}
