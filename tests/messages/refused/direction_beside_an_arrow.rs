use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    along (1.0, 0.0) -> spring 1 { stiffness: l } -> fixed;
//  ^^^^^ `along` stands between a connection and the path that acts on it, `conn a <- along (dx,
    conn a at (0.0, 0.0) <- along (1.0, 0.0);
//                          ^^^^^ `along` stands between a connection and the path that acts on it, `conn a <- along (dx,
    conn a <- along (1.0, 0.0) -> spring 2 { stiffness: l } -> fixed;
//                             ^^ turn one of them round, so that both point one way
    conn a <- along (1.0, 0.0) <- along (0.0, 1.0) <- spring 3 { stiffness: l } <- fixed;
//                                ^^^^^ remove this `along`
    conn a along (1.0, 0.0) <- spring 4 { stiffness: l } <- fixed;
//         ^^^^^ write it between arrows, `conn a <- along (dx, dy) <- ..`
    conn a <- spring 5 { stiffness: l } along (1.0, 0.0) <- fixed;
//                                      ^^^^^ write it between arrows, `conn a <- along (dx, dy) <- ..`
    conn a -> at (1.0, 0.0) -> spring 6 { stiffness: l } -> fixed;
//            ^^ remove the arrow between
}

fn main() {}
