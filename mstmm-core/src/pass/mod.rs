//! Carrying subspaces through a plan: from the tips to the root, and back.

pub(crate) mod at_once;
pub(crate) mod both_ways;
pub(crate) mod characteristic;
pub(crate) mod drawn_tree;
pub(crate) mod formulas;
pub(crate) mod in_proportion;
pub(crate) mod inlining;
pub(crate) mod jump;
pub(crate) mod model;
pub(crate) mod network;
pub(crate) mod overall;
pub(crate) mod own;
pub(crate) mod phase;
pub(crate) mod planned_list;
pub(crate) mod route;
pub(crate) mod searched;
pub(crate) mod side_by_side;
pub(crate) mod state_recovery;
pub(crate) mod step_list;
pub(crate) mod transfer_path;
pub(crate) mod tree;
