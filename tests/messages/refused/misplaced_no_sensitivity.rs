use mstmm::prelude::*;

system! {
    #[no_sensitivity]
//  ^^^^^^^^^^^^^^^^^ marks a field: write it in front of the field that is meant
    struct Model {
        #[no_sensitivity(stiffness)]
//      ^^^^^^^^^^^^^^^^^^^^^^^^^^^^ takes no arguments
        stiffness: f64,
    }

    #[no_sensitivity]
//  ^ attributes stand in front of the struct and of its fields alone
    let double = 2.0 * stiffness;
    fixed -> spring 1 { stiffness: double } -> free
}

fn main() {}
