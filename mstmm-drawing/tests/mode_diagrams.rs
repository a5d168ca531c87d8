//! Diagrams of modes: what is in them, and what is refused.

use mstmm::prelude::*;
use mstmm::search::ToleranceBox;
use mstmm_drawing::{DrawingError, ModeDiagram};

system! {
    #[derive(Clone, Copy)]
    struct Tower { ei: f64 }
    fixed -> beam 1 { length: 20.0, bending_stiffness: ei, mass_per_length: 300.0 } -> point_mass 2 { mass: 5000.0 } -> free;
}

#[test]
fn each_mode_has_its_bar_and_its_point() {
    let tower = Tower { ei: 4e8 }.build().unwrap();
    let roots = tower.first_frequencies::<4>().unwrap();
    let participation = tower.participation::<4, _>(&roots, Direction::y()).unwrap();
    let masses = ModeDiagram::masses(&roots, &participation).unwrap().to_string();
    assert_eq!(masses.matches("class=\"bar\"").count(), 4);
    let share = 100.0 * participation.effective_mass(0) / participation.total();
    assert!(masses.contains(&format!("{:.3} Hz: {share:.2} %, all up to here {share:.2} %", roots[0].hertz())));
    let spectrum = (|omega: f64, _ratio: f64| 4.0_f64.min(200.0 / omega), 1.5);
    let peaks = ModeDiagram::spectrum(&roots, &spectrum, 0.05).unwrap().to_string();
    assert_eq!(peaks.matches("class=\"critical\"").count(), 4);

    let lot =
        ToleranceBox::between(Tower { ei: 3.8e8 }.build().unwrap(), Tower { ei: 4.2e8 }.build().unwrap()).unwrap();
    let ranges = lot.first_frequencies::<3>().unwrap();
    let diagram = ModeDiagram::ranges(&ranges).unwrap().marked(2.0, 3.0).to_string();
    assert_eq!((diagram.matches("class=\"bar\"").count(), diagram.matches("class=\"marked\"").count()), (3, 1));
    assert!(diagram.contains(&format!("{:.3} to {:.3} Hz", ranges[0].lowest.hertz(), ranges[0].highest.hertz())));
}

#[test]
fn a_peak_stands_on_its_response_below_its_bound() {
    let tower = Tower { ei: 4e8 }.build().unwrap();
    let roots = tower.first_frequencies::<4>().unwrap();
    let (load, entry) = (Tower::point_mass_2.output().force(), Tower::point_mass_2.output().deflection());
    let response = tower.modal_response::<4, _>(&roots, load, entry).unwrap().with_damping_ratio(0.05).unwrap();
    let peak = response.peak(0.5..=20.0, 1e-6).unwrap();
    let samples = [1.0, 2.0, peak.hertz()].map(|hertz| [hertz, response.at_hertz(hertz).unwrap().norm()]);
    let diagram = ModeDiagram::peak(&samples, &peak).unwrap().to_string();
    assert_eq!((diagram.matches("class=\"forward\"").count(), diagram.matches("class=\"critical\"").count()), (1, 1));
    assert!(diagram.contains(&format!("{:.3} Hz: from {:.6e} to {:.6e}", peak.hertz(), peak.lower, peak.upper)));
    // ticks of millionths would be all zeros
    assert!(peak.upper < 1e-4 && diagram.contains("size of the response, times 1e-6"), "{}", peak.upper);
    assert!(matches!(ModeDiagram::peak(&[], &peak), Err(DrawingError::Empty)));
    assert!(matches!(ModeDiagram::peak(&[[1.0, f64::NAN]], &peak), Err(DrawingError::NotFinite { .. })));
}

#[test]
fn what_is_no_diagram_is_refused() {
    let tower = Tower { ei: 4e8 }.build().unwrap();
    let roots = tower.first_frequencies::<4>().unwrap();
    let few = tower.participation::<4, _>(&roots[..2], Direction::y()).unwrap();
    assert!(matches!(ModeDiagram::masses(&roots, &few), Err(DrawingError::Roots { roots: 4, of_shapes: 2 })));
    let spectrum = (|_omega: f64, _ratio: f64| f64::NAN, 1.5);
    assert!(matches!(ModeDiagram::spectrum(&roots, &spectrum, 0.05), Err(DrawingError::NotFinite { .. })));
    assert!(matches!(ModeDiagram::spectrum(&[], &spectrum, 0.05), Err(DrawingError::Empty)));
    assert!(matches!(ModeDiagram::ranges(&[]), Err(DrawingError::Empty)));
    let [mut bad, good] = [roots[0], roots[1]];
    bad.omega = f64::NAN;
    let spectrum = (|_omega: f64, _ratio: f64| 1.0, 1.5);
    assert!(matches!(ModeDiagram::spectrum(&[bad, good], &spectrum, 0.05), Err(DrawingError::NotFinite { .. })));
}
