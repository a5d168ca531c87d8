//! Members that do not share all freedoms with their nodes: what is not shared leaves before the member joins a front.

use crate::number::{Scalar, Size};
use crate::pass::network::stiffness::front::{StiffnessFront, inherited};
use crate::pass::network::stiffness::member::StiffnessMember;
use crate::pass::network::stiffness::numbers::StiffnessNumber;
use crate::pass::network::stiffness::waves::{Bending, Line};

/// The dynamic stiffness of a member over `N` freedoms of its ends.
pub(super) struct OwnStiffness<S: Scalar, const N: usize> {
    /// End and freedom of each row: displacement along, across, rotation.
    freedoms: [[usize; 2]; N],
    entries: [[S; N]; N],
    /// The size of the terms that each diagonal entry is made of, which are as large as that between both ends.
    errors: [S::Size; N],
}

impl<S: StiffnessNumber> OwnStiffness<S, 2> {
    /// A line in a freedom.
    #[inline(always)]
    pub(super) fn of_line(line: &Line<S>, freedom: usize) -> Self {
        let [own, across] = line.stiffness;
        OwnStiffness::new([0, 1].map(|end| [end, freedom]), [[own, across], [across, own]])
    }
}

impl<S: StiffnessNumber> OwnStiffness<S, 4> {
    /// Bending, over deflection and rotation of each end.
    #[inline(always)]
    pub(super) fn of_bending(bending: &Bending<S>) -> Self {
        let [yy, yt, tt, yy_across, yt_across, tt_across] = bending.stiffness;
        let freedoms = [[0, 1], [0, 2], [1, 1], [1, 2]];
        let entries = [
            [yy, yt, yy_across, yt_across],
            [yt, tt, -yt_across, tt_across],
            [yy_across, -yt_across, yy, -yt],
            [yt_across, tt_across, -yt, tt],
        ];
        OwnStiffness::new(freedoms, entries)
    }
}

impl<S: StiffnessNumber, const N: usize> OwnStiffness<S, N> {
    /// A stiffness over freedoms.
    #[inline(always)]
    fn new(freedoms: [[usize; 2]; N], entries: [[S; N]; N]) -> Self {
        let mut errors = [S::Size::of(0.0); N];
        for (k, error) in errors.iter_mut().enumerate() {
            *error = entries[k][k].size().or_larger(entries[k][(k + N / 2) % N].size());
        }
        OwnStiffness { freedoms, entries, errors }
    }

    /// Eliminates what is released, and adds the rest to a front.
    #[inline(always)]
    pub(super) fn join(&mut self, front: &mut StiffnessFront<'_, S>, member: &StiffnessMember<S::Part>) {
        for k in 0..N {
            if !member.seat.has(self.freedoms[k]) {
                self.eliminate(k, front);
            }
        }
        let rows = self.freedoms.map(|[end, freedom]| member.row(end, freedom));
        let places =
            self.freedoms.map(|[end, freedom]| member.seat.places(end).filter(|_| member.seat.has([end, freedom])));
        for k in 0..N {
            let Some(place) = places[k] else { continue };
            front.add_own(self.entries[k][k], place, &rows[k]);
            front.note_own(self.errors[k], place, &rows[k]);
            for l in 0..k {
                let Some(other) = places[l] else { continue };
                front.add_across(self.entries[k][l], [place, other], [&rows[k], &rows[l]]);
            }
        }
    }

    /// Pivots on a freedom.
    #[inline(always)]
    fn eliminate(&mut self, released: usize, front: &mut StiffnessFront<'_, S>) {
        let (row, error) = (self.entries[released], self.errors[released]);
        let inverse = S::one() / row[released];
        for k in 0..N {
            if k != released {
                let solved = row[k] * inverse;
                for (entry, factor) in self.entries[k].iter_mut().zip(row) {
                    *entry -= solved * factor;
                }
                self.errors[k] = inherited(self.errors[k], [solved.size(), row[k].size()], error);
            }
        }
        front.take(row[released], error);
    }
}
