use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    conn a at (0.0, 0.0) <- held;
//                          ^^^^ `held` names in parentheses what it holds, such as `held(x, rz)`
    conn a <- held { x };
//            ^^^^ `held` names in parentheses what it holds, such as `held(x, rz)`
    conn a <- held(1);
//                 ^ expected a freedom, such as `x`, `y` or `rz`
    conn a <- held(x y);
//                   ^ expected `,` between freedoms
}

fn main() {}
