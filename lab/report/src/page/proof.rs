//! What proves a list of roots complete, as pictures and digits.

use super::figures::{figure, panels};
use super::text::error;
use crate::data::counts::{Certified, Counts};
use crate::error::ReportError;
use crate::plots::{cells, staircase};
use maud::{Markup, html};

/// Counts over frequency and in the plane, and the intervals that they leave.
pub(super) fn section(counts: &Counts) -> Result<Markup, ReportError> {
    let Counts { spans, mode, twins, pair, cells } = counts;
    let lead = html! {
        p {
            "N(ω) is the number of natural frequencies below ω. It is counted, not searched: nodes of a shape and poles passed, after \
            Wittrick and Williams. It steps at a frequency and nowhere else."
        }
        p {
            "Where N is k − 1 at one end of an interval and k at the other, the frequency k is inside; where it is k at the end of a \
            range, no more than the k of the list are in it. No grid can step over one."
        }
        p {
            "The certified intervals below are as wide as 32 roundings of their frequency. In the two magnified pictures every decade \
            of the distance has the same width: from a tenth down to the last digit the count stands still."
        }
    };
    let figures = [
        figure("Counts", "4.4, two spans with an oscillator", &staircase::svg(spans)?),
        figure("The third step, magnified", "4.4, fourteen decades to each side", &staircase::magnified(mode)?),
        figure("Two frequencies that look like one", "close pair, magnified", &staircase::magnified(pair)?),
        figure("Counts in rectangles", "4.5, the argument principle", &cells::svg(cells)?),
    ];
    Ok(panels(lead, figures.into_iter().chain([intervals(spans.roots.as_slice(), twins)])))
}

/// The ends of all intervals, digit under digit.
fn intervals(spans: &[Certified], twins: &[Certified]) -> Markup {
    html! {
        div class="intervals" {
            h3 { "Digits of the intervals" }
            p class="quiet" { "Both ends, in rad/s, each with its count. What the ends have in common is proved." }
            table {
                thead { tr { th { "mode" } th { "ends" } th { "N" } th { "width / ω" } } }
                tbody {
                    (group("4.4", spans)) (group("close pair", twins))
                }
            }
        }
    }
}

fn group(scene: &str, roots: &[Certified]) -> Markup {
    html! {
        tr class="group" { th colspan="4" { (scene) } }
        @for (mode, Certified { root, counts: [below, above] }) in (1..).zip(roots) {
            @let [common, low, high] = digits([root.lower, root.upper]);
            tr {
                td { (mode) }
                td { (common) b { (low) } br; (common) b { (high) } }
                td { (below) br; (above) }
                td { (error((root.upper - root.lower) / root.omega)) }
            }
        }
    }
}

/// What two numbers of 17 digits have in common, and the rest of each.
fn digits(ends: [f64; 2]) -> [String; 3] {
    let decimals = (16 - ends[1].log10().floor() as i32).max(0) as usize;
    let [low, high] = ends.map(|end| format!("{end:.decimals$}"));
    let common = low.bytes().zip(high.bytes()).take_while(|(one, other)| one == other).count();
    [low[..common].to_owned(), low[common..].to_owned(), high[common..].to_owned()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_are_parted_where_their_digits_differ() {
        assert_eq!(digits([0.375, 0.4375]), ["0.", "37500000000000000", "43750000000000000"]);
        assert_eq!(digits([1234.25, 1234.5]), ["1234.", "2500000000000", "5000000000000"]);
        assert_eq!(digits([999.5, 1000.5]), ["", "999.5000000000000", "1000.5000000000000"]);
    }
}
