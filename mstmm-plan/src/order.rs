//! The order of evaluation.

/// Sorts the vertices of a tree so that each stands behind all its inputs: depth first from the root, inputs in the order of the
/// edges `(from, to)`. There is room for `order.len()` vertices; those that lead to the root are returned.
///
/// ```
/// let edges = [(3, 1), (0, 1), (1, 2)];
/// assert_eq!(mstmm_plan::inputs_first(&edges, 2, &mut [0; 4]), [3, 0, 1, 2]);
/// ```
pub const fn inputs_first<'a>(edges: &[(usize, usize)], root: usize, order: &'a mut [usize]) -> &'a [usize] {
    // the list is filled from its end; what waits for its turn stands at its beginning
    let (mut waiting, mut first) = (1, order.len());
    order[0] = root;
    while waiting > 0 {
        waiting -= 1;
        first -= 1;
        let vertex = order[waiting];
        order[first] = vertex;
        let mut edge = 0;
        while edge < edges.len() {
            if edges[edge].1 == vertex {
                order[waiting] = edges[edge].0;
                waiting += 1;
            }
            edge += 1;
        }
    }
    order.split_at(first).1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two branches that are written in turns: each is kept together.
    #[test]
    fn a_path_is_followed_to_its_tip_before_the_next() {
        let edges = [(1, 0), (2, 0), (3, 1), (4, 2), (5, 3), (6, 4)];
        assert_eq!(inputs_first(&edges, 0, &mut [0; 7]), [5, 3, 1, 6, 4, 2, 0]);
    }

    #[test]
    fn what_does_not_lead_to_the_root_is_left_out() {
        assert_eq!(inputs_first(&[(1, 2)], 0, &mut [0; 3]), [0]);
    }
}
