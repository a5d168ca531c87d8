//! Members that do not share all freedoms with their nodes: what is not shared leaves before the member joins a front.

use crate::number::Scalar;
use crate::pass::network::stiffness::front::StiffnessFront;
use crate::pass::network::stiffness::member::{Seat, StiffnessMember};
use crate::pass::network::stiffness::waves::{Bending, Line};

/// The dynamic stiffness of a member over `N` freedoms of its ends.
pub(super) struct OwnStiffness<S: Scalar, const N: usize> {
    /// End and freedom of each row: displacement along, across, rotation.
    freedoms: [[usize; 2]; N],
    entries: [[S; N]; N],
}

impl<S: Scalar> OwnStiffness<S, 2> {
    /// A spring in a freedom.
    #[cfg(feature = "std")]
    #[inline(always)]
    pub(super) fn of_spring(own: S, freedom: usize) -> Self {
        OwnStiffness { freedoms: [0, 1].map(|end| [end, freedom]), entries: [[own, -own], [-own, own]] }
    }

    /// A line in a freedom.
    #[inline(always)]
    pub(super) fn of_line(line: &Line<S>, freedom: usize) -> Self {
        let [own, across] = line.stiffness;
        OwnStiffness { freedoms: [0, 1].map(|end| [end, freedom]), entries: [[own, across], [across, own]] }
    }
}

impl<S: Scalar> OwnStiffness<S, 4> {
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
        OwnStiffness { freedoms, entries }
    }
}

impl<S: Scalar, const N: usize> OwnStiffness<S, N> {
    /// Eliminates what is released, and adds the rest to a front.
    #[inline(always)]
    pub(super) fn join(&mut self, front: &mut StiffnessFront<'_, S>, member: &StiffnessMember) {
        let rows = self.freedoms.map(|[end, freedom]| member.row(end, freedom));
        self.join_of(front, &member.seat, &rows);
    }

    /// The same in space, given the rows of both ends.
    #[cfg(feature = "std")]
    #[inline(always)]
    pub(super) fn join_rows(&mut self, front: &mut StiffnessFront<'_, S>, seat: &Seat, rows: &[[[f64; 6]; 3]; 2]) {
        let rows = self.freedoms.map(|[end, freedom]| rows[end][freedom]);
        self.join_of(front, seat, &rows);
    }

    /// Eliminates what is released, and adds the rest to a front, given the rows of its freedoms.
    #[inline(always)]
    fn join_of<const R: usize>(&mut self, front: &mut StiffnessFront<'_, S>, seat: &Seat, rows: &[[f64; R]; N]) {
        for k in 0..N {
            if !seat.has(self.freedoms[k]) {
                self.eliminate(k, front);
            }
        }
        let places = self.freedoms.map(|[end, freedom]| seat.places(end).filter(|_| seat.has([end, freedom])));
        for k in 0..N {
            let Some(place) = places[k] else { continue };
            front.add_own(self.entries[k][k], place, &rows[k]);
            for l in 0..k {
                let Some(other) = places[l] else { continue };
                front.add_across(self.entries[k][l], [place, other], [&rows[k], &rows[l]]);
            }
        }
    }

    /// Pivots on a freedom.
    #[inline(always)]
    fn eliminate(&mut self, released: usize, front: &mut StiffnessFront<'_, S>) {
        let row = self.entries[released];
        let inverse = S::one() / row[released];
        for k in 0..N {
            if k != released {
                let solved = row[k] * inverse;
                for (entry, factor) in self.entries[k].iter_mut().zip(row) {
                    *entry -= solved * factor;
                }
            }
        }
        front.take(row[released]);
    }
}
