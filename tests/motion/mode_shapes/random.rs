//! Random trees, the models of the comparison with lists: laws, products and energies of their first modes.

use crate::damped_models::*;
use crate::mode_shapes::checks::{check_energies, check_laws, check_orthogonality};
use crate::mode_shapes::multiple::check_basis;
use crate::mode_shapes::recorded::{Recordable, Sketched, recordable};
use crate::undamped_models::*;
use mstmm::prelude::*;

recordable! { without fields in include_str!("../../support/undamped_models.rs");
    Undamped2 Undamped2System
        [beam_13 beam_14 mass_1 spring_2 mass_4 spring_5 mass_7 spring_8 spring_10 spring_11 beam_17 body_19]
        [conn_16 conn_18];
    Undamped6 Undamped6System
        [spring_1 spring_2 elastic_hinge_4 beam_5 spring_7 spring_8 spring_9 point_mass_11 torsion_spring_13
         inertia_14 spring_16 spring_17 mass_18 mass_21 spring_23 spring_24 spring_26]
        [conn_10 conn_20 conn_25];
    Undamped7 Undamped7System
        [body_1 spring_3]
        [conn_2];
    Undamped14 Undamped14System
        [body_3 beam_4 point_mass_1 point_mass_7 beam_8]
        [conn_6 conn_9];
    Undamped15 Undamped15System
        [inertia_1 beam_3 point_mass_4 beam_6 point_mass_7 inertia_11 beam_13 point_mass_14 beam_16
         point_mass_17 body_9 body_19 body_22 body_23]
        [conn_8 conn_18 conn_21];
    Undamped16 Undamped16System
        [mass_1 mass_2 spring_4 spring_5 mass_6 spring_9]
        [conn_8];
    Undamped17 Undamped17System
        [spring_1 spring_2 beam_4 inertia_7 torsion_spring_10 torsion_spring_13]
        [conn_6 conn_9 conn_12];
    Undamped18 Undamped18System
        [elastic_hinge_1 beam_4 beam_5]
        [conn_3];
    Undamped22 Undamped22System
        [beam_4 beam_6 beam_1 beam_2 point_mass_8 body_9]
        [conn_7 conn_10];
    Undamped31 Undamped31System
        [beam_1 spring_3 spring_4 spring_6 spring_7 body_10 beam_11]
        [conn_9];
    Undamped35 Undamped35System
        [spring_1 mass_2 spring_3 beam_6]
        [conn_5];
    Undamped36 Undamped36System
        [torsion_spring_1 torsion_spring_3 torsion_spring_5 beam_8 beam_10]
        [conn_7 conn_11];
    Undamped39 Undamped39System
        [torsion_spring_1 inertia_2 inertia_5 inertia_6]
        [conn_4];
    Undamped43 Undamped43System
        [torsion_spring_1 inertia_2 torsion_spring_3 mass_5 torsion_spring_11 torsion_spring_12 inertia_13
         mass_16 torsion_spring_18 inertia_19 inertia_20 elastic_hinge_8 beam_9 body_23 beam_24 point_mass_26
         beam_27]
        [conn_7 conn_15 conn_22 conn_25];
    Undamped44 Undamped44System
        [beam_4 beam_5 beam_1 body_2 body_8 body_9]
        [conn_7 conn_10];
    Undamped45 Undamped45System
        [beam_1 body_2 beam_4]
        [conn_5];
    Undamped48 Undamped48System
        [body_1 point_mass_4 inertia_6 beam_8 point_mass_9 beam_11 body_12 mass_14 mass_15]
        [conn_3 conn_5 conn_13];
    Undamped51 Undamped51System
        [body_1 beam_4]
        [conn_3];
    Undamped53 Undamped53System
        [elastic_hinge_1 point_mass_3 beam_4 elastic_hinge_9 point_mass_11 beam_12 torsion_spring_6 inertia_7
         torsion_spring_14 inertia_15 body_18 body_19 torsion_spring_22]
        [conn_5 conn_13 conn_17 conn_21];
    Undamped55 Undamped55System
        [beam_1 beam_3]
        [conn_4];
    Undamped63 Undamped63System
        [beam_1 point_mass_2 beam_4 body_5]
        [conn_6];
    Undamped64 Undamped64System
        [inertia_1 torsion_spring_2 mass_4 mass_6 beam_9 point_mass_10 body_12 spring_14 spring_15 mass_16
         inertia_18 inertia_19 spring_21 spring_22 spring_23 beam_26]
        [conn_8 conn_17 conn_25];
    Undamped67 Undamped67System
        [beam_1 beam_4 spring_9 mass_10 mass_11 mass_13 mass_15 spring_16 mass_18 spring_19 beam_7
         torsion_spring_22 torsion_spring_23 inertia_26 torsion_spring_27]
        [conn_3 conn_6 conn_17 conn_21 conn_25];
    Undamped70 Undamped70System
        [beam_3 mass_5 mass_6 mass_8 mass_9 beam_1 point_mass_11]
        [conn_10 conn_12];
}

recordable! { without fields in include_str!("../../support/damped_models.rs");
    Damped2 Damped2System
        [beam_13 beam_14 mass_1 spring_damper_2 mass_4 spring_damper_5 mass_7 spring_damper_8 damper_10
         spring_11 beam_17 body_19]
        [conn_16 conn_18];
    Damped7 Damped7System
        [body_1 damper_3]
        [conn_2];
    Damped16 Damped16System
        [mass_1 mass_2 spring_damper_4 damper_5 mass_6 spring_9]
        [conn_8];
    Damped31 Damped31System
        [beam_1 damper_3 spring_4 damper_6 spring_7 body_10 beam_11]
        [conn_9];
    Damped35 Damped35System
        [damper_1 mass_2 spring_3 beam_6]
        [conn_5];
    Damped39 Damped39System
        [torsion_spring_damper_1 inertia_2 inertia_5 inertia_6]
        [conn_4];
    Damped43 Damped43System
        [torsion_spring_damper_1 inertia_2 torsion_spring_damper_3 mass_5 torsion_spring_11
         torsion_spring_damper_12 inertia_13 mass_16 torsion_spring_18 inertia_19 inertia_20 elastic_hinge_8
         beam_9 body_23 beam_24 point_mass_26 beam_27]
        [conn_7 conn_15 conn_22 conn_25];
    Damped53 Damped53System
        [elastic_hinge_1 point_mass_3 beam_4 elastic_hinge_9 point_mass_11 beam_12 torsion_damper_6 inertia_7
         torsion_damper_14 inertia_15 body_18 body_19 torsion_spring_22]
        [conn_5 conn_13 conn_17 conn_21];
    Damped90 Damped90System
        [beam_4 body_5 spring_damper_7 mass_8 spring_damper_10 beam_1 beam_2 body_12 body_13]
        [conn_11 conn_14];
    Damped102 Damped102System
        [mass_1 inertia_4 torsion_spring_damper_5 torsion_spring_damper_7 inertia_8 beam_11 elastic_hinge_12]
        [conn_3 conn_10];
    Damped116 Damped116System
        [point_mass_1 torsion_damper_3 beam_6]
        [conn_2 conn_5];
    Damped118 Damped118System
        [torsion_damper_1 inertia_2 inertia_3 torsion_spring_5 torsion_spring_damper_6 torsion_spring_9
         mass_12 damper_13 beam_16]
        [conn_8 conn_11 conn_15];
    Damped119 Damped119System
        [damper_1 mass_2 mass_3 beam_6 body_8 body_9]
        [conn_5 conn_10];
    Damped124 Damped124System
        [torsion_spring_damper_3 inertia_4 torsion_spring_damper_5 torsion_spring_damper_7 torsion_spring_8
         inertia_1 inertia_10 torsion_spring_13 torsion_spring_14 torsion_spring_damper_17
         torsion_spring_damper_18]
        [conn_9 conn_12 conn_16];
    Damped132 Damped132System
        [spring_damper_3 mass_4 spring_damper_5 body_7 beam_8 torsion_spring_10 inertia_11 beam_1
         point_mass_13]
        [conn_12 conn_14];
    Damped141 Damped141System
        [torsion_damper_1 inertia_2 torsion_spring_3 torsion_damper_5 inertia_6 torsion_spring_7
         torsion_damper_9 inertia_10 torsion_spring_11 spring_14 spring_15]
        [conn_13];
}

/// The modes that are checked; of a tree with fewer of them, all.
macro_rules! check_each {
    ($roots:ident: $($model:ident)*) => {$(
        let system = $model.build().unwrap();
        let roots = $roots(&$model, &system);
        let residual = check_laws(&$model, &system, &roots);
        let products = check_orthogonality(&system, &roots);
        let energies = check_energies(&$model, &system, &roots);
        println!("{}: {} roots, {residual:?}, {products:e}, {energies:e}", stringify!($model), roots.len());
    )*};
}

/// The first ten natural frequencies, or those of a tree that has fewer.
fn frequencies(system: &impl Undamped<Parameter = f64>) -> Vec<NaturalFrequency> {
    let finite = system.count_below(1e12).unwrap().min(10);
    let mut roots: Vec<NaturalFrequency> = Vec::new();
    let mut upper = 1.0;
    while roots.iter().map(|root| root.multiplicity).sum::<u64>() < finite {
        roots = system.natural_frequencies::<64>(0.0..=upper).unwrap().to_vec();
        upper *= 2.0;
    }
    roots
}

/// The roots of an undamped tree, after the shapes of multiple ones are checked.
fn checked<M, Y>(model: &M, system: &Y) -> Vec<NaturalFrequency>
where
    M: Sketched,
    Y: Recordable<f64> + Undamped<Parameter = f64>,
{
    let roots = frequencies(system);
    roots.iter().filter(|root| root.multiplicity > 1).for_each(|root| check_basis(model, system, root));
    roots
}

#[test]
fn undamped_trees() {
    check_each! { checked: Undamped2 Undamped6 Undamped7 Undamped14 Undamped15 Undamped16 Undamped17 Undamped18 Undamped22
    Undamped31 Undamped35 Undamped36 Undamped39 Undamped43 Undamped44 Undamped45 Undamped48 Undamped51
    Undamped53 Undamped55 Undamped63 Undamped64 Undamped67 Undamped70 }
}

/// The eigenvalues in a rectangle.
fn eigenvalues<M>(_: &M, system: &(impl Eigenvalues<Parameter = f64> + Spectrum)) -> Vec<Eigenvalue> {
    system.eigenvalues::<64>(Region { re: -6.0..=0.5, im: 0.0..=6.0 }).unwrap().to_vec()
}

#[test]
fn damped_trees() {
    check_each! { eigenvalues: Damped2 Damped7 Damped16 Damped31 Damped35 Damped39 Damped43 Damped53 Damped90 Damped102 Damped116
    Damped118 Damped119 Damped124 Damped132 Damped141 }
}
