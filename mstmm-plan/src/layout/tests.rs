//! Sizes and order of columns and rows, on the scenes of the paper and at their limits.

use super::*;
use crate::space::Space;
use crate::support::Support;

/// Section 4.4 of the paper, with the spring-mass written before the beam it hangs on.
const TWO_SPANS: Layout<'_, 11> = Layout::new([
    Step::Tip(Support::Free),
    Step::Element(0, Space::Translation),
    Step::Element(1, Space::Translation),
    Step::Tip(Support::Pinned),
    Step::Tip(Support::Pinned),
    Step::Element(4, Space::Bending),
    Step::Connection(&[3, 5]),
    Step::Element(6, Space::Bending),
    Step::Connection(&[2, 7]),
    Step::Element(8, Space::Bending),
    Step::Root(9, Support::Pinned),
]);

#[test]
fn the_widest_input_comes_first_whatever_the_source_order() {
    assert_eq!(TWO_SPANS.scheme().size(), 7);
    assert_eq!(TWO_SPANS.places[2].first_column, 4, "the spring-mass stands behind the four beam columns");
    assert_eq!(TWO_SPANS.places[3].first_column, 0, "equal states keep the source order");
    assert_eq!(TWO_SPANS.places[4].first_column, 2);
}

/// A hundred springs and beams, alternating, that meet at one connection.
#[test]
fn a_constant_has_room_for_a_connection_of_two_hundred_paths() {
    const ENDS: [usize; 200] = {
        let mut ends = [0; 200];
        let mut k = 0;
        while k < 200 {
            ends[k] = 2 * k + 1;
            k += 1;
        }
        ends
    };
    const STAR: Layout<'_, 402> = {
        let mut steps = [Step::Tip(Support::Fixed); 402];
        let mut k = 0;
        while k < 200 {
            steps[ENDS[k]] = Step::Element(2 * k, if k % 2 == 0 { Space::Translation } else { Space::Bending });
            k += 1;
        }
        steps[400] = Step::Connection(&ENDS);
        steps[401] = Step::Root(400, Support::Free);
        Layout::new(steps)
    };
    assert_eq!(STAR.scheme().size(), 100 + 200 + 2);
    assert_eq!(STAR.scheme().inputs(400)[..3], [3, 7, 11], "beams first, in the order of the source");
    assert_eq!(STAR.scheme().inputs(400)[100..102], [1, 5]);
    STAR.scheme().check(400);
}

#[test]
fn geometrical_equations_follow_the_main_equation_from_the_tips_down() {
    assert_eq!((TWO_SPANS.places[6].first_row, TWO_SPANS.places[6].rows), (4, 2));
    assert_eq!((TWO_SPANS.places[8].first_row, TWO_SPANS.places[8].rows), (4, 3));
}

#[test]
fn supports_adopt_the_state_of_what_they_hold() {
    assert_eq!(TWO_SPANS.places[0].space, Space::Translation);
    assert_eq!(TWO_SPANS.places[3].space, Space::Bending);
}
