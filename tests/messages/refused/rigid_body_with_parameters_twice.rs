use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> rigid_body 1 { mass: l, inertia: l, centre: (l, l) } -> conn a at (l, 0.0);
    rigid_body 1 { mass: l, inertia: l, centre: (l, l) } -> conn b at (l, l);
//  ^^^^^^^^^^^^ name it again without braces, `rigid_body 1`
    conn a -> rigid_body 2 -> conn b;
//            ^^^^^^^^^^^^ (x, y) }`
    rigid_body 2 -> conn c at (0.0, 2.0);
}

fn main() {}
