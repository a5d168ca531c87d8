use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    conn a at (0.0, 0.0) beam 1 { } -> conn b at (l, 0.0);
//                       ^^^^ expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`
    conn a at l < -l -> spring 2 { stiffness: l } -> fixed
    conn b at (l, 0.0) -> spring 3 { stiffness: l } -> fixed;
//  ^^^^ expected an arrow, `->` or `<-`; where a new path begins, end the one before it with `;`
}

fn main() {}
