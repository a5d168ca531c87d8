//! Rules that need the states. The macro applies them where it knows all states. Where elements are the user's own it emits each check as a
//! constant at the user's token: a failing one is a compile error there, and the compiler shows the caller instead of what is written here.

use crate::scheme::Scheme;
use crate::space::Space;
use crate::step::Step;
use crate::support::Support;

/// Fails with a message where a model is what it may not be, as elements of the user's own decide.
#[track_caller]
#[allow(clippy::panic)] // how a constant reports an error
pub const fn refuse_if(is_wrong: bool, message: &'static str) {
    if is_wrong {
        panic!("{}", message);
    }
}

impl Scheme<'_> {
    /// Fails where the states at a step do not fit.
    #[track_caller]
    #[allow(clippy::panic)] // how a constant reports an error
    pub const fn check(&self, step: usize) {
        if let Some(misfit) = self.misfit(step) {
            panic!("{}", misfit);
        }
    }

    /// What is wrong with the states at a step, if anything is.
    pub const fn misfit(&self, step: usize) -> Option<&'static str> {
        match self.steps[step] {
            Step::Tip(support) | Step::Root(_, support) => self.misfit_of_support(step, support),
            Step::Element(input, space) => self.misfit_of_arrow(input, space),
            Step::Connection(_) => self.misfit_of_connection(step),
        }
    }

    /// A support must exist in the space of the state to which it belongs.
    const fn misfit_of_support(&self, step: usize, support: Support) -> Option<&'static str> {
        let space = self.space(step);
        // where paths cannot meet there is no state to adopt, and the connection says so
        if space.is_empty() || support.exists_in(space) {
            return None;
        }
        Some(match space {
            Space::Translation => "a translation path ends in `fixed` or `free` only",
            Space::Rotation => "a rotation path ends in `fixed` or `free` only",
            Space::Bending => "a bending path ends in `fixed`, `pinned`, `free` or `guided`",
            _ => "a planar path ends in `fixed`, `pinned`, `free`, `guided` or `roller`",
        })
    }

    /// An arrow between two elements needs equal states on both sides.
    const fn misfit_of_arrow(&self, input: usize, space: Space) -> Option<&'static str> {
        let before = self.space(input);
        if !matches!(self.steps[input], Step::Element(..)) || before.is(space) {
            return None;
        }
        if before.join(space).is_none() {
            return Some(
                "planar paths meet planar paths only: use planar elements on both sides of this arrow, or on none",
            );
        }
        Some(if before.contains(space) {
            "an arrow joins equal states only: put a connection between these two elements, `-> conn .. ->`, where \
             the path goes on with fewer states"
        } else {
            "an arrow joins equal states only: put a connection with a free tip between these two elements, \
             `-> conn .. ->` and `free -> conn ..`"
        })
    }

    /// The states around a connection must be able to meet there, and its widest input must fill its output.
    const fn misfit_of_connection(&self, step: usize) -> Option<&'static str> {
        let space = self.space(step);
        let [widest, ..] = self.inputs(step) else { return None };
        if space.is_empty() {
            return Some("planar paths meet planar paths only: join all planar elements here, or none");
        }
        if !self.space(*widest).is(space) {
            return Some(
                "the output of this connection has more states than any input: give it a free tip, `free -> conn ..`",
            );
        }
        if self.is_held_twice(step) {
            return Some("two supports at this connection hold the same displacement: one of them is enough");
        }
        None
    }

    /// Whether two supports at a connection, the root among them, hold one displacement.
    const fn is_held_twice(&self, connection: usize) -> bool {
        let (space, inputs) = (self.space(connection), self.inputs(connection));
        let mut held = match self.steps[self.downstream(connection)] {
            Step::Root(_, root) => root.holds(),
            _ => Space::NONE,
        };
        let mut k = 0;
        while k < inputs.len() {
            if let Step::Tip(tip) = self.steps[inputs[k]] {
                if !held.intersection(tip.holds()).intersection(space).is_empty() {
                    return true;
                }
                held = held.union(tip.holds());
            }
            k += 1;
        }
        false
    }
}

/// One scene per rule; what each says is in the attribute of the test.
#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::Layout;
    use crate::support::Support::{Fixed, Free, Guided, Pinned, Roller};

    /// A path of one element between two supports.
    fn path(tip: Support, space: Space, root: Support) -> Layout<'static, 3> {
        Layout::new([Step::Tip(tip), Step::Element(0, space), Step::Root(1, root)])
    }

    /// Two elements that meet, and what the connection leads on to.
    fn meeting(inputs: [Space; 2], output: Space) -> Layout<'static, 7> {
        Layout::new([
            Step::Tip(Fixed),
            Step::Element(0, inputs[0]),
            Step::Tip(Fixed),
            Step::Element(2, inputs[1]),
            Step::Connection(&[1, 3]),
            Step::Element(4, output),
            Step::Root(5, Pinned),
        ])
    }

    #[test]
    fn what_fits_passes() {
        for (space, supports) in [
            (Space::Translation, &[Fixed, Free] as &[Support]),
            (Space::Rotation, &[Fixed, Free]),
            (Space::Bending, &[Fixed, Pinned, Free, Guided]),
            (Space::Planar, &[Fixed, Pinned, Free, Guided, Roller]),
        ] {
            for &support in supports {
                let path = path(support, space, support);
                path.scheme().check(0);
                path.scheme().check(2);
            }
        }
        for layout in [
            meeting([Space::Translation, Space::Bending], Space::Bending),
            meeting([Space::Bending, Space::Rotation], Space::Translation),
        ] {
            layout.scheme().check(4);
            layout.scheme().check(5);
        }
    }

    #[test]
    #[should_panic(expected = "a translation path ends in `fixed` or `free` only")]
    fn a_translation_path_has_no_pin() {
        path(Pinned, Space::Translation, Free).scheme().check(0);
    }

    #[test]
    #[should_panic(expected = "a rotation path ends in `fixed` or `free` only")]
    fn a_rotation_path_has_no_guide() {
        path(Fixed, Space::Rotation, Guided).scheme().check(2);
    }

    #[test]
    #[should_panic(expected = "a bending path ends in `fixed`, `pinned`, `free` or `guided`")]
    fn a_bending_path_has_no_roller() {
        path(Roller, Space::Bending, Free).scheme().check(0);
    }

    /// Two elements with an arrow between them.
    fn arrow(before: Space, behind: Space) -> Layout<'static, 4> {
        Layout::new([Step::Tip(Fixed), Step::Element(0, before), Step::Element(1, behind), Step::Root(2, Free)])
    }

    #[test]
    #[should_panic(expected = "put a connection between these two elements, `-> conn .. ->`, where the path goes on")]
    fn an_arrow_does_not_narrow() {
        arrow(Space::Bending, Space::Translation).scheme().check(2);
    }

    #[test]
    #[should_panic(expected = "put a connection with a free tip between these two elements")]
    fn an_arrow_does_not_widen() {
        arrow(Space::Rotation, Space::Bending).scheme().check(2);
    }

    #[test]
    #[should_panic(expected = "put a connection with a free tip between these two elements")]
    fn an_arrow_does_not_turn_a_force_into_a_moment() {
        arrow(Space::Translation, Space::Rotation).scheme().check(2);
    }

    #[test]
    #[should_panic(expected = "use planar elements on both sides of this arrow, or on none")]
    fn no_connection_joins_a_planar_path_to_a_spring() {
        arrow(Space::Planar, Space::Translation).scheme().check(2);
    }

    /// What the messages advise is right.
    #[test]
    fn the_advised_connections_pass() {
        for (before, behind) in [(Space::Bending, Space::Translation), (Space::Bending, Space::Rotation)] {
            let steps = [
                Step::Tip(Fixed),
                Step::Element(0, before),
                Step::Connection(&[1]),
                Step::Element(2, behind),
                Step::Root(3, Free),
            ];
            Layout::new(steps).scheme().check(2);
        }
        for (before, behind) in [
            (Space::Translation, Space::Bending),
            (Space::Rotation, Space::Bending),
            (Space::Translation, Space::Rotation),
            (Space::Rotation, Space::Translation),
        ] {
            let steps = [
                Step::Tip(Fixed),
                Step::Element(0, before),
                Step::Tip(Free),
                Step::Connection(&[1, 2]),
                Step::Element(3, behind),
                Step::Root(4, Free),
            ];
            Layout::new(steps).scheme().check(3);
            Layout::new(steps).scheme().check(2);
        }
    }

    #[test]
    #[should_panic(expected = "planar paths meet planar paths only: join all planar elements here, or none")]
    fn a_planar_path_and_a_spring_do_not_meet() {
        meeting([Space::Planar, Space::Translation], Space::Planar).scheme().check(4);
    }

    /// The root is pinned, which no translation path has; but what is wrong is the connection.
    #[test]
    fn where_paths_cannot_meet_their_supports_are_not_judged() {
        let steps = [
            Step::Tip(Fixed),
            Step::Element(0, Space::Planar),
            Step::Tip(Pinned),
            Step::Element(2, Space::Translation),
            Step::Connection(&[1, 3]),
            Step::Root(4, Pinned),
        ];
        Layout::new(steps).scheme().check(5);
    }

    #[test]
    #[should_panic(expected = "the output of this connection has more states than any input: give it a free tip")]
    fn two_springs_do_not_carry_a_beam() {
        meeting([Space::Translation, Space::Translation], Space::Bending).scheme().check(4);
    }

    /// It is a name for a point.
    #[test]
    fn a_connection_of_one_path_may_go_on_with_its_state() {
        let steps = [
            Step::Tip(Fixed),
            Step::Element(0, Space::Bending),
            Step::Connection(&[1]),
            Step::Element(2, Space::Bending),
            Step::Root(3, Free),
        ];
        let layout = Layout::new(steps);
        layout.scheme().check(2);
        layout.scheme().check(3);
        assert_eq!(layout.scheme().size(), 4);
    }

    #[test]
    #[should_panic(expected = "the output of this connection has more states than any input: give it a free tip")]
    fn a_connection_of_one_path_does_not_widen() {
        let steps = [
            Step::Tip(Fixed),
            Step::Element(0, Space::Translation),
            Step::Connection(&[1]),
            Step::Element(2, Space::Bending),
            Step::Root(3, Free),
        ];
        Layout::new(steps).scheme().check(2);
    }
}
