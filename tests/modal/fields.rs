//! Ranges of frequencies over boxes of fields: values of the file, corners and what is between them, and fields that are none.

use crate::models::{number, reference};
use crate::numbers::Random;
use mstmm::prelude::*;
use mstmm::search::{FrequencyRange, ToleranceError};

system! {
    /// The portal of the file, with all that its box moves.
    #[derive(Clone, Copy)]
    struct Portal {
        column_ea: f64, column_ei: f64, column_m: f64, girder_ea: f64, girder_ei: f64, girder_m: f64, mass: f64
    }
    section column { axial_stiffness: column_ea, bending_stiffness: column_ei, mass_per_length: column_m }
    fixed at (0.0, 0.0) -> beam 1 { ..column } -> conn b at (0.0, 3.0)
        -> beam 2 { axial_stiffness: girder_ea, bending_stiffness: girder_ei, mass_per_length: girder_m } -> conn c at (4.0, 3.0)
        -> beam 3 { ..column } -> pinned at (4.0, 0.0);
    conn b -> point_mass 4 { mass };
}

impl Portal {
    /// The portal with shares of 5 % of each field, from -1 to 1.
    fn at(share: impl Fn(usize) -> f64) -> Self {
        let of = |k: usize, value: f64| value * (1.0 + 0.05 * share(k));
        Portal {
            column_ea: of(0, 4e8),
            column_ei: of(1, 1e6),
            column_m: of(2, 20.0),
            girder_ea: of(3, 4e8),
            girder_ei: of(4, 1e6),
            girder_m: of(5, 20.0),
            mass: of(6, 100.0),
        }
    }
}

/// Fields that are parameters themselves: the ends are the two models of [`ToleranceBox`], to the last bit.
#[test]
fn ranges_over_fields_that_are_parameters_are_those_of_their_corners() {
    let (low, high) = (Portal::at(|_| -1.0), Portal::at(|_| 1.0));
    let lot = Portal::between(&low, &high).unwrap();
    assert!(lot.is_attained().unwrap());
    let is_mass = |k: usize| matches!(k, 2 | 5 | 6);
    let [soft, stiff] = [1.0, -1.0].map(|mass| Portal::at(|k| if is_mass(k) { mass } else { -mass }).build().unwrap());
    let corners = ToleranceBox::between(soft, stiff).unwrap();
    let ranges = lot.first_frequencies::<6>().unwrap();
    assert_eq!(ranges[..], corners.first_frequencies::<6>().unwrap()[..]);
    assert_eq!(lot.frequencies(6).unwrap(), ranges.to_vec());
    let file = reference("ranges")["portal_box"].clone();
    for (root, range) in ranges.iter().enumerate() {
        let [lowest, highest] = ["lowest", "highest"].map(|end| number(&file[end][root]));
        assert!(
            (range.lowest.omega / lowest - 1.0).abs() < 1e-14 && (range.highest.omega / highest - 1.0).abs() < 1e-14
        );
    }
    assert!(lot.is_free_of(41.235..=184.0).unwrap() && !lot.is_free_of(41.2..=184.0).unwrap());
    assert_eq!(lot.count_below(40.0).unwrap(), 0..=1);
    // parts of a field that acts one way tell nothing more
    let parts = lot.in_parts("girder_ei", 3).unwrap().in_parts("mass", 2).unwrap();
    assert_eq!(parts.first_frequencies::<6>().unwrap()[..], ranges[..]);
    assert_eq!(parts.frequencies(6).unwrap(), ranges.to_vec());
    assert_eq!(parts.count_below(40.0).unwrap(), 0..=1);
    assert!(parts.is_free_of(41.235..=184.0).unwrap() && !parts.is_free_of(41.2..=184.0).unwrap());
}

system! {
    /// A portal of square beams.
    #[derive(Clone, Copy)]
    struct Square { side: f64 }
    let area = (side / 0.1).powi(2);
    section beam { axial_stiffness: 4e8 * area, bending_stiffness: 1e6 * area * area, mass_per_length: 20.0 * area }
    fixed at (0.0, 0.0) -> beam 1 { ..beam } -> conn b at (0.0, 3.0) -> beam 2 { ..beam } -> conn c at (4.0, 3.0)
        -> beam 3 { ..beam } -> pinned at (4.0, 0.0);
    conn b -> point_mass 4 { mass: 100.0 };
}

/// The side of a section makes it stiffer and heavier: the range is too wide, as much as the file says, and narrows with parts.
#[test]
fn a_field_that_acts_both_ways_is_enclosed_as_in_the_file() {
    let file = reference("ranges")["mixed_field"]["widest_enclosure_over_true_range"].clone();
    let [low, high] = [0.099, 0.101].map(|side| Square { side });
    let lot = Square::between(&low, &high).unwrap();
    assert!(!lot.is_attained().unwrap());
    let [least, most] = [low, high].map(|model| model.build().unwrap().first_frequencies::<6>().unwrap());
    for row in file.as_array().unwrap() {
        let own = lot.in_parts("side", row[0].as_u64().unwrap() as usize).unwrap().first_frequencies::<6>().unwrap();
        let shares = own
            .iter()
            .enumerate()
            .map(|(root, range)| (range.highest.omega - range.lowest.omega) / (most[root].omega - least[root].omega));
        let widest = shares.fold(0.0, f64::max);
        assert!((widest / number(&row[1]) - 1.0).abs() < 1e-6, "{widest} {row}");
    }
    // a side that is known is no range
    let point = Square::between(&low, &low).unwrap().first_frequencies::<6>().unwrap();
    assert!(point.iter().zip(&least).all(|(range, root)| {
        range.lowest.omega <= root.omega
            && root.omega <= range.highest.omega
            && range.highest.omega - range.lowest.omega < 1e-13 * root.omega
    }));
}

system! {
    /// A mast in steps with a spring: a tree whose parameters go by all kinds of formulas.
    #[derive(Clone, Copy)]
    struct Mast { outer: f64, ratio: f64, steel: f64, density: f64, top: f64, ground: f64, force: f64 }
    let (area, i_y, _, _) = mstmm::sections::tube(outer, ratio * outer);
    let softer = (1.0 - 0.2 * ratio.sin()).max(0.3);
    pinned -> conn foot -> beam 1 {
            length: 4.0, bending_stiffness: steel * i_y, mass_per_length: density * area, axial_force: -force * steel.ln()
        } -> beam 2 {
            length: 3.0, bending_stiffness: 0.5 * softer * (steel * i_y), mass_per_length: density * area * softer.sqrt(),
            axial_force: -force.hypot(3.0 * force)
        } -> point_mass 3 { mass: top / (1.0 + ratio) } -> conn tip <- spring 4 { stiffness: 1e3 * top.powf(0.3 * ratio) } <- fixed;
    conn tip -> free;
    fixed -> torsion_spring 0 { stiffness: ground.exp() } -> conn foot;
}

impl Mast {
    fn at(mut share: impl FnMut() -> f64) -> Self {
        let mut of = |from: f64, to: f64| from + (to - from) * share();
        Mast {
            outer: of(0.3, 0.31),
            ratio: of(0.8, 0.9),
            steel: of(2.0e11, 2.1e11),
            density: of(7800.0, 7900.0),
            top: of(300.0, 360.0),
            ground: of(15.0, 16.0),
            force: of(1e3, 1.2e3),
        }
    }
}

/// None of all corners and of random models is outside, whatever the parts are; more parts are narrower.
#[test]
fn no_model_of_a_box_is_outside() {
    let mut random = Random(11);
    let (low, high) = (Mast::at(|| 0.0), Mast::at(|| 1.0));
    let lot = Mast::between(&low, &high).unwrap();
    assert!(!lot.is_attained().unwrap());
    let whole = lot.first_frequencies::<5>().unwrap();
    let parts = lot.in_parts("ratio", 5).unwrap().in_parts("outer", 2).unwrap().first_frequencies::<5>().unwrap();
    let is_within = |own: &FrequencyRange<f64>, whole: &FrequencyRange<f64>| {
        own.lowest.omega >= whole.lowest.omega && own.highest.omega <= whole.highest.omega
    };
    assert!(parts.iter().zip(&whole).all(|(own, whole)| is_within(own, whole)));
    let width = |range: &FrequencyRange<f64>| range.highest.omega - range.lowest.omega;
    assert!(width(&parts[1]) < 0.8 * width(&whole[1]), "{} {}", width(&parts[1]), width(&whole[1]));
    let corners = (0..128_u32).map(|corner| {
        let mut field = 0;
        Mast::at(|| {
            field += 1;
            f64::from(corner >> (field - 1) & 1)
        })
    });
    let corners: Vec<Mast> = corners.collect();
    let between = (0..100).map(|_| Mast::at(|| random.unit()));
    for model in corners.into_iter().chain(between) {
        let roots = model.build().unwrap().first_frequencies::<5>().unwrap();
        for (root, range) in roots.iter().zip(&parts) {
            assert!(range.lowest.omega <= root.omega && root.omega <= range.highest.omega, "{root:?} {range:?}");
        }
    }
}

system! {
    /// A beam whose length, foundation, shear and other things are fields.
    #[derive(Clone, Copy)]
    struct Own {
        height: f64, foundation: f64, shear: f64, ei: f64, rod: f64,
        #[no_sensitivity]
        table: f64,
    }
    fixed at (0.0, 0.0) -> beam 1 {
            axial_stiffness: 1e4, bending_stiffness: ei, mass_per_length: [1.0, 2.0][table as usize], shear_stiffness: shear
        } -> conn b at (0.0, height)
        -> bar 2 { axial_stiffness: 1e3 * (rod - 1.0).sqrt(), bending_stiffness: 1.0, mass_per_length: 0.1 } -> pinned at (1.0, 2.0);
    conn b -> spring 3 { stiffness: foundation } -> pinned at (-1.0, 2.0);
    conn b -> point_mass 4 { mass: 1.0 };
}

#[test]
fn fields_that_are_no_box_are_refused() {
    let own = Own { height: 2.0, foundation: 10.0, shear: 50.0, ei: 3.0, rod: 2.0, table: 0.0 };
    let error = |low: Own, high: Own| {
        let asked = Own::between(&low, &high).and_then(|lot| lot.first_frequencies::<2>().map(|_| ()));
        asked.unwrap_err()
    };
    assert!(
        Own::between(&own, &Own { foundation: 11.0, shear: 70.0, ei: 4.0, rod: 3.0, ..own })
            .unwrap()
            .is_attained()
            .unwrap()
    );
    let text = |low: Own, high: Own| error(low, high).to_string();
    assert_eq!(
        text(own, Own { height: 2.1, ..own }),
        "field `height` moves `geometry` of beam 1, which acts both ways on frequencies: give it the same value in both models"
    );
    assert_eq!(error(own, Own { ei: 2.0, ..own }), ToleranceError::Field { field: "ei", low: 3.0, high: 2.0 });
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(matches!(error(own, Own { ei: bad, ..own }), ToleranceError::Field { field: "ei", .. }));
    }
    let unbounded = error(Own { rod: 0.5, ..own }, own);
    assert!(matches!(unbounded, ToleranceError::Unbounded { field: "rod", .. }), "{unbounded}");
    let unseen = error(own, Own { table: 1.0, ..own });
    let expected = ToleranceError::Unseen {
        element: mstmm::search::Spot::Named("beam 1"),
        parameter: "mass_per_length",
        low: 1.0,
        high: 2.0,
    };
    assert_eq!(unseen, expected);
    for out in [Own { foundation: -3.0, ..own }, Own { shear: 0.0, ..own }] {
        assert!(matches!(error(out, own), ToleranceError::Parameter(_)));
    }
    let lot = Own::between(&own, &own).unwrap();
    assert_eq!(lot.in_parts("ei", 0).map(|_| ()), Err(ToleranceError::NoParts { field: "ei" }));
    assert_eq!(lot.in_parts("table", 2).map(|_| ()), Err(ToleranceError::NoSuchField { field: "table" }));
    assert!(lot.is_free_of(2.0..=1.0).is_err());
}

system! {
    /// An oscillator whose stiffness is a formula that turns, jumps or breaks within a box, by its kind.
    #[derive(Clone, Copy)]
    struct Turning { x: f64, y: f64, mass: f64 }
    fixed -> spring 1 { stiffness: 20.0 + f64::atan2(y, -2.0) - 2.0 * y + x.signum() + (-x).powf(2.0) + x.abs() } -> mass 2 { mass: (1.2 * mass).powi(40) } -> free;
}

/// Formulas that jump: at the negative half of the axis the angle does, a sign at zero; both signs of zero are in a box.
#[test]
fn formulas_that_jump_are_held() {
    let (low, high) = (Turning { x: -1.0, y: -1.0, mass: 1.0 }, Turning { x: 0.5, y: 3.0, mass: 1.0 });
    let lot = Turning::between(&low, &high).unwrap();
    assert!(!lot.is_attained().unwrap());
    let range = lot.first_frequencies::<1>().unwrap()[0];
    for x in [-1.0, -1e-9, -0.0, 0.0, 1e-9, 0.5] {
        for y in [-1.0, -1e-9, -0.0, 0.0, 1e-9, 1.0, 3.0] {
            let root = Turning { x, y, mass: 1.0 }.build().unwrap().first_frequencies::<1>().unwrap()[0];
            assert!(range.lowest.omega <= root.omega && root.omega <= range.highest.omega, "{x} {y}: {root} {range:?}");
        }
    }
    // what is known is a point, but for roundings of its formula, also of forty factors
    let point = Turning::between(&low, &low).unwrap().first_frequencies::<1>().unwrap()[0];
    assert_eq!(point.lowest, point.highest);
}

system! {
    /// A mast of a tube, whose wall may close.
    #[derive(Clone, Copy)]
    struct Tube { outer: f64, inner: f64, e: f64, length: f64 }
    let (area, i_y, _, _) = mstmm::sections::tube(outer, inner);
    let half = 0.5 * length;
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: e * area, bending_stiffness: e * i_y, mass_per_length: 20.0 }
        -> conn middle at (0.0, half) -> beam 2 { axial_stiffness: e * area, bending_stiffness: e * i_y, mass_per_length: 20.0 } -> conn tip at (0.0, length);
}

/// A section that is not one in all of a box is no number there: more parts cure it. A length that is known may stand in any formula.
#[test]
fn sections_that_break_within_a_box_are_refused_until_parts_are_small() {
    let at = |outer: f64, inner: f64| Tube { outer, inner, e: 2e11, length: 3.0 };
    let (low, high) = (at(0.15, 0.1), at(0.16, 0.145));
    let lot = Tube::between(&low, &high).unwrap();
    let whole = lot.first_frequencies::<2>().unwrap();
    for (outer, inner) in [(0.15, 0.1), (0.15, 0.145), (0.16, 0.1), (0.16, 0.145), (0.155, 0.12)] {
        let roots = at(outer, inner).build().unwrap().first_frequencies::<2>().unwrap();
        for (root, range) in roots.iter().zip(&whole) {
            assert!(range.lowest.omega <= root.omega && root.omega <= range.highest.omega);
        }
    }
    assert!(lot.is_attained().unwrap());
    let (low, high) = (at(0.15, 0.1), at(0.2, 0.155));
    let refused = Tube::between(&low, &high).unwrap().first_frequencies::<2>().map(|_| ());
    assert!(matches!(refused, Err(ToleranceError::Unbounded { field: "outer", .. })), "{refused:?}");
    // the places follow from a field that is the same in both
    let moved = Tube { length: 3.1, ..high };
    let refused = Tube::between(&high, &moved).unwrap().first_frequencies::<2>().map(|_| ());
    assert!(matches!(refused, Err(ToleranceError::Mixed { field: "length", .. })), "{refused:?}");
}

/// A model by a macro whose own `x` is another variable than the caller's.
macro_rules! masses {
    ($name:ident, $field:ident) => {
        system! {
            #[derive(Clone, Copy)]
            struct $name { $field: f64, y: f64 }
            let x = y * 10.0;
            fixed at (0.0, 0.0) -> spring 1 { stiffness: 10.0 } -> conn b at (1.0, 0.0) -> spring 2 { stiffness: 10.0 } -> conn c at (2.0, 0.0);
            roller along (1.0, 0.0) -> conn b;
            roller along (1.0, 0.0) -> conn c;
            conn b -> point_mass 3 { mass: $field };
            conn c -> point_mass 4 { mass: x };
        }
    };
}
masses!(Alike, x);
masses!(Apart, z);

/// Names of different origin are different fields, in boxes and in sensitivities.
#[test]
fn names_of_macros_stay_apart() {
    let (low, high) = (Alike { x: 0.5, y: 0.1 }, Alike { x: 1.5, y: 0.2 });
    let alike = Alike::between(&low, &high).unwrap().first_frequencies::<2>().unwrap();
    let (low, high) = (Apart { z: 0.5, y: 0.1 }, Apart { z: 1.5, y: 0.2 });
    let apart = Apart::between(&low, &high).unwrap().first_frequencies::<2>().unwrap();
    assert_eq!(alike[..], apart[..]);
    let system = Alike { x: 0.7, y: 0.15 }.build().unwrap();
    let twin = Apart { z: 0.7, y: 0.15 }.build().unwrap();
    let root = system.first_frequencies::<1>().unwrap()[0];
    let (one, other) = (system.sensitivity(&root).unwrap(), twin.sensitivity(&root).unwrap());
    assert_eq!([one.get("x"), one.get("y")], [other.get("z"), other.get("y")]);
    assert!(one.get("x").unwrap() < 0.0);
}
