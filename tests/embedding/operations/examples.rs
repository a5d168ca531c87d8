//! The paper's five examples, and the table of docs/speed.md.

use super::counted::{ADD, COS, Counted, Counts, DIV, EXP, MUL, SIN, SQRT, count};
use super::{
    Step, assert_counts, assert_same, at_lambda, at_omega, behind_pinned_tip, from_pin_to_pin, functions,
    into_pinned_root, models,
};
use mstmm::number::Parameter;
use mstmm::prelude::*;

/// Counts at frequencies where all beams have `1 < |z| < 100`: below there are series, above one exponent more.
fn counts() -> [(&'static str, Counts); 5] {
    [
        ("4.1", at_omega!(models::light_tip_body(), 300.0)),
        ("4.2", at_omega!(models::restrained_beam(), 1000.0)),
        ("4.3", at_omega!(models::spring_and_mass(), 2000.0)),
        ("4.4", at_omega!(models::two_spans(), 10_000.0)),
        ("4.5", at_lambda!(models::damped_oscillator(), -10.0, 12_000.0)),
    ]
}

#[test]
fn the_readme_shows_the_counts() {
    let mut table = String::from("| example | × | + | ÷ | √ | sin | cos | exp |\n|---|---|---|---|---|---|---|---|\n");
    for (example, counts) in counts() {
        table += &format!("| {example} |{}\n", counts.needed);
    }
    assert!(include_str!("../../../docs/speed.md").contains(&table), "{table}");
}

#[test]
fn the_tip_body() {
    let by_hand = [
        ("s; 1/s, s⁻², s⁻³, s⁻⁴", SQRT + DIV + 3 * MUL),
        ("z, four products, a, b, d, e", functions() + 4 * MUL + 4 * ADD),
        ("the column behind a fixed tip: e/EI²β⁴, d/EIβ³, f/EIβ², b/EIβ, a", 8 * MUL),
        ("λ², A = m λ², J = J_C λ²", 3 * MUL),
        ("at the mass centre p_YM + (w + w + p_ΘQ c₁) c₁", 2 * MUL + 3 * ADD),
        ("p_MQ + A p_YM + J (p_ΘQ + A p_YΘ)", 3 * MUL + 3 * ADD),
    ];
    assert_counts(counts()[0].1, &by_hand);
}

/// Springs at both ends: κ and τ of the left one in units of the beam.
#[test]
fn the_restrained_beam() {
    let by_hand = [
        ("s, s³, λ²; 1/s, s⁻², s⁻³", SQRT + DIV + 4 * MUL),
        ("z, four products, a, b, c, d, e", functions() + 4 * MUL + 5 * ADD),
        ("κ = K_y / EIβ³, τ = K_θ / EIβ, κ τ, 2κ, 2τ", 5 * MUL + 2 * ADD),
        ("p_YΘ = (a + b τ) + (d κ + e κτ)", 3 * MUL + 3 * ADD),
        ("p_YM = (c τ - d) + (f 2κ + d κτ), times EIβ", 5 * MUL + 3 * ADD),
        ("p_ΘQ = (c κ - b) + (b κτ - f 2τ), times EIβ³", 5 * MUL + 3 * ADD),
        ("p_MQ = (a κτ + e) - (b τ + d κ), times EI²β⁴", 5 * MUL + 3 * ADD),
        ("(p_MQ + K_y p_YM) + (K_θ p_ΘQ + K_y K_θ p_YΘ): one product more, a shorter chain", 4 * MUL + 3 * ADD),
    ];
    assert_counts(counts()[1].1, &by_hand);
}

/// A beam between connections, which takes a whole plane to a whole plane.
fn through() -> Step {
    let own = 4 * MUL + 5 * ADD;
    let units = 8 * MUL;
    let minors = 4 * MUL + 3 * ADD + 5 * (5 * MUL + 4 * ADD) + 4 * MUL;
    (
        "z, products, a, b, c, d, e; eight units; times minors, doubles, five sums, times units",
        functions() + own + units + minors,
    )
}

#[test]
fn the_spring_and_the_mass() {
    let by_hand = [
        ("s, s³, λ²; 1/s, s⁻², s⁻³, s⁻⁴", SQRT + DIV + 5 * MUL),
        behind_pinned_tip(),
        ("p_ΘQ + K p_YΘ, p_MQ + K p_YM", 2 * (MUL + ADD)),
        through(),
        ("k = m λ²; p_ΘQ + k p_YΘ, p_MQ + k p_YM", MUL + 2 * (MUL + ADD)),
        into_pinned_root(),
    ];
    assert_counts(counts()[2].1, &by_hand);
}

#[test]
fn the_two_spans() {
    let by_hand = [
        ("s, s³, λ²; 1/s, s⁻², s⁻³, s⁻⁴", SQRT + DIV + 5 * MUL),
        from_pin_to_pin(),
        ("beam 3: z, products, a, b, c, d, e", functions() + 4 * MUL + 5 * ADD),
        ("p_ΘQ / EIβ³, p_MQ / EI²β⁴, 2p_ΘQ", 4 * MUL + ADD),
        ("five sums of two products, four units, times them", 5 * (2 * MUL + ADD) + 8 * MUL),
        ("k = m λ²; behind the spring y = K + k, q = -K k", 2 * MUL + ADD),
        ("y times all minors, y p_ΘQ - q p_YΘ, y p_MQ - q p_YM", 7 * MUL + 2 * ADD),
        into_pinned_root(),
    ];
    assert_counts(counts()[3].1, &by_hand);
}

/// A step of real steps as one over complex numbers: products are four multiplications and two additions, but two
/// multiplications where one factor is a parameter, as it is in z and in every unit; the functions are those of both parts,
/// and four complex numbers of two products each.
fn complex((what, real): Step, with_parameters: usize) -> Step {
    let beams = real.sines;
    let products = real.multiplications - with_parameters;
    let functions = 2 * beams * (SIN + COS + EXP) + beams * 8 * MUL;
    let multiplications = products * (4 * MUL + 2 * ADD) + with_parameters * 2 * MUL;
    (what, functions + multiplications + real.additions * 2 * ADD)
}

/// Spring stiffnesses take part as complex numbers.
#[test]
fn the_damped_oscillator() {
    let by_hand = [
        ("s = √(-iλ): modulus, two parts", 4 * MUL + 2 * ADD + 2 * SQRT + DIV),
        ("1/s: 1 conj s / |s|²", 4 * MUL + 3 * ADD + 2 * DIV),
        complex(("s³, λ², s⁻², s⁻³, s⁻⁴", 5 * MUL), 0),
        complex(behind_pinned_tip(), 4),
        complex(("p_ΘQ + K p_YΘ, p_MQ + K p_YM", 2 * (MUL + ADD)), 0),
        complex(through(), 9),
        complex(("κ = K + C λ, k = m λ²", 2 * MUL + ADD), 2),
        complex(("y = κ + k, q = -κ k", MUL + ADD), 0),
        complex(("y times all minors, y p_ΘQ - q p_YΘ, y p_MQ - q p_YM", 7 * MUL + 2 * ADD), 0),
        complex(through(), 9),
        complex(("p_YM + K p_YΘ, p_MQ + K p_ΘQ", 2 * (MUL + ADD)), 0),
        complex(into_pinned_root(), 6),
    ];
    assert_counts(counts()[4].1, &by_hand);
}
