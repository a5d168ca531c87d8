//! Shapes and responses of plane structures.

use crate::families::random::Spread;
use crate::families::{named_structures, random_structures};
use crate::reference_cases::reference_cases;
use crate::structure::Structure;
use crate::through_library::{Moving, asked_to_move};
use mstmm::motion::{MotionError, PlanePoint, PlaneStates};
use mstmm::prelude::*;

fn larger(a: f64, b: f64) -> f64 {
    if a >= b { a } else { b }
}

/// How far node and ends are from equilibrium and from each other, of the largest.
fn misfits(structure: &Structure, states: &PlaneStates<'_, Moving<'_>, f64>) -> [f64; 2] {
    let nodes: Vec<[f64; 3]> = (0..structure.nodes.len()).map(|node| states.node(node).unwrap()).collect();
    let largest = |k: &[usize]| nodes.iter().flat_map(|node| k.iter().map(|&k| node[k].abs())).fold(0.0, larger);
    let sizes = [largest(&[0, 1]), largest(&[2])];
    let ends = (0..structure.members.len()).flat_map(|member| *states.member(member).unwrap());
    let ends: Vec<_> = ends.collect();
    let forces = [
        ends.iter().flat_map(|end| [end.forces[0].abs(), end.forces[1].abs()]).fold(0.0, larger),
        ends.iter().map(|end| end.forces[2].abs()).fold(0.0, larger),
    ];
    let mut worst = [0.0; 2];
    for (index, node) in structure.nodes.iter().enumerate() {
        let point = PlanePoint::node(index);
        let reaction =
            [point.reaction_x(), point.reaction_y(), point.reaction_z()].map(|entry| states.value(entry).unwrap());
        let free = match node.along {
            Some([x, y]) => vec![((reaction[0] * x + reaction[1] * y) / x.hypot(y), 0), (reaction[2], 1)],
            None => vec![(reaction[0], 0), (reaction[1], 0), (reaction[2], 1)],
        };
        let held = match node.along {
            Some(_) => [false, node.held.rz].to_vec(),
            None => [node.held.x, node.held.y, node.held.rz].to_vec(),
        };
        for ((force, kind), is_held) in free.into_iter().zip(held) {
            if !is_held && force != 0.0 {
                let _ = kind;
                worst[0] = larger(worst[0], force.abs() / forces[0].max(forces[1]));
            }
        }
    }
    let _ = sizes;
    worst
}

#[test]
fn survey() {
    let random = [Spread::Moderate, Spread::Stiff].into_iter().flat_map(|spread| random_structures(0..60, spread));
    let mut all = vec![];
    for (name, structure) in named_structures().into_iter().chain(random) {
        if structure.nodes.len() > 60 || structure.members.len() > 80 {
            continue;
        }
        let told = asked_to_move(&structure, |network| {
            let roots = network.first_frequencies::<10>().map_err(|error| error.to_string())?;
            let mut worst = [0.0_f64; 2];
            for root in roots.iter() {
                let shapes = match network.mode_shapes::<8, _>(root) {
                    Ok(shapes) => shapes,
                    Err(MotionError::Capacity { .. }) => continue,
                    Err(error) => {
                        println!("{name} {:e} x{}: {error}", root.omega, root.multiplicity);
                        continue;
                    }
                };
                for shape in shapes.iter() {
                    let found = misfits(&structure, shape);
                    if !(found[0] < 1e-11) {
                        println!("   {name} {:e} x{}: {:e}", root.omega, root.multiplicity, found[0]);
                    }
                    worst = [larger(worst[0], found[0]), larger(worst[1], found[1])];
                }
            }
            Ok(worst)
        });
        match told {
            Ok(worst) => all.push((name, worst)),
            Err(error) => println!("{name}: {error}"),
        }
    }
    all.sort_by(|a, b| b.1[0].total_cmp(&a.1[0]));
    for (name, worst) in all.iter().take(40) {
        println!("{name} {:.1e} {:.1e}", worst[0], worst[1]);
    }
    println!("{}", all.len());
}

#[test]
fn quick() {
    for case in reference_cases() {
        if case.name != "l_frame" {
            continue;
        }
        asked_to_move(&case.structure, |network| {
            let roots = network.first_frequencies::<8>().unwrap();
            for root in roots.iter().take(2) {
                let shape = network.mode_shape(root).unwrap();
                println!("{:?}", [0, 1, 2].map(|node| shape.node(node).unwrap()));
            }
            Ok(())
        })
        .unwrap();
    }
}

#[test]
fn debug() {
    for seed in [51, 56] {
        let structure = crate::families::random::random_structure(seed, Spread::Stiff);
        asked_to_move(&structure, |network| {
            let roots = network.first_frequencies::<10>().unwrap();
            let root = roots.iter().find(|root| root.omega > 0.0).unwrap();
            println!("{root:?}");
            println!("{:?}", network.mode_shape(root).map(|_| ()));
            Ok(())
        })
        .unwrap();
    }
}
