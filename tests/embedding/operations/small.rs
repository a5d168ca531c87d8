//! Small scenes, each for something that is not there.

use super::counted::{ADD, Counted, DIV, MUL, SQRT, count};
use super::{
    Step, assert_counts, assert_same, at_lambda, at_omega, behind_pinned_tip, from_pin_to_pin, functions,
    into_pinned_root, scenes,
};
use mstmm::number::Parameter;
use mstmm::prelude::*;

#[test]
fn without_a_beam_there_is_neither_root_nor_division() {
    let by_hand = [("λ² = -ω ω", MUL), ("m λ²", MUL), ("K + m λ²: a grounded spring needs no line", ADD)];
    assert_counts(at_omega!(scenes::Oscillator, 3.0), &by_hand);
    assert_counts(at_omega!(scenes::TorsionOscillator, 3.0), &by_hand);
}

#[test]
fn only_behind_a_second_spring_there_is_a_line() {
    let by_hand = [
        ("λ²", MUL),
        ("k = K₁ + m₁ λ²", MUL + ADD),
        ("behind K₂: y = K₂ + k, q = -K₂ k", ADD + MUL),
        ("m₂ λ²", MUL),
        ("q - m₂ λ² y", MUL + ADD),
    ];
    assert_counts(at_omega!(scenes::TwoMasses, 3.0), &by_hand);
}

#[test]
fn only_with_a_dashpot_there_is_complex_arithmetic() {
    let by_hand = [
        ("λ² = λ λ", 4 * MUL + 2 * ADD),
        ("m λ²", 2 * MUL),
        ("C λ", 2 * MUL),
        ("K + C λ", 2 * ADD),
        ("K + C λ + m λ²", 2 * ADD),
    ];
    assert_counts(at_lambda!(scenes::DampedOscillator, -0.1, 3.0), &by_hand);
}

/// Of the column that a fixed tip leaves, `[e i₃, d i₂, f i₁, b i₀, a]`, the root needs one entry.
#[test]
fn one_beam_is_evaluated_for_the_one_minor_of_its_root() {
    let to_fixed = [
        ("s, z", SQRT + functions()),
        ("e = 1 - ch c", MUL + ADD),
        ("1/s, s⁻², s⁻⁴", DIV + 2 * MUL),
        ("e / EI²β⁴", 2 * MUL),
    ];
    assert_counts(at_omega!(scenes::ToFixed, 20.0), &to_fixed);
    let to_pinned = [
        ("s, z", SQRT + functions()),
        ("d = ch s - sh c", 2 * MUL + ADD),
        ("1/s, s⁻², s⁻³", DIV + 2 * MUL),
        ("d / EIβ³", 2 * MUL),
    ];
    assert_counts(at_omega!(scenes::ToPinned, 20.0), &to_pinned);
    let to_guided = [("s, z", SQRT + functions()), ("b = ch s + sh c", 2 * MUL + ADD), ("b / EIβ", DIV + 2 * MUL)];
    assert_counts(at_omega!(scenes::ToGuided, 20.0), &to_guided);
    let to_free = [("s, z", SQRT + functions()), ("a = 1 + ch c", MUL + ADD)];
    assert_counts(at_omega!(scenes::ToFree, 20.0), &to_free);
}

#[test]
fn a_mass_at_the_root_is_one_addition() {
    let by_hand = [
        ("s, z", SQRT + functions()),
        ("ch c, ch s, sh c; a, d", 3 * MUL + 2 * ADD),
        ("1/s, s⁻², s⁻³", DIV + 2 * MUL),
        ("p_YM = d / EIβ³", 2 * MUL),
        ("λ², k = m λ²", 2 * MUL),
        ("p_MQ + k p_YM = a + k p_YM", MUL + ADD),
    ];
    assert_counts(at_omega!(scenes::MassAtRoot, 20.0), &by_hand);
}

/// The same Δ from the other end.
#[test]
fn a_mass_at_the_tip_is_no_plane() {
    let by_hand = [
        ("s, z", SQRT + functions()),
        ("ch c, ch s, sh c; a, d", 3 * MUL + 2 * ADD),
        ("λ², k = m λ²", 2 * MUL),
        ("1/s, s⁻², s⁻³", DIV + 2 * MUL),
        ("κ = k / EIβ³", 2 * MUL),
        ("p_YΘ = a + d κ", MUL + ADD),
    ];
    assert_counts(at_omega!(scenes::MassAtTip, 20.0), &by_hand);
}

/// A hinge at a fixed tip is two springs: stiffnesses κ = K_y / EIβ³ and τ = K_θ / EIβ at the beam's own end.
#[test]
fn a_hinge_at_the_tip_is_no_plane() {
    let by_hand = [
        ("s, z", SQRT + functions()),
        ("ch c, ch s, sh c; a, b, d, e", 3 * MUL + 4 * ADD),
        ("1/s, s⁻², s⁻³", DIV + 2 * MUL),
        ("κ, τ, κ τ", (2 + 2 + 1) * MUL),
        ("(a κτ + e) - (b τ + d κ)", 3 * MUL + 3 * ADD),
        ("λ², EI²β⁴, times it", 3 * MUL),
    ];
    assert_counts(at_omega!(scenes::HingeAtTip, 20.0), &by_hand);
}

/// `K_y K_θ` is made by `build()`.
#[test]
fn a_hinge_at_the_root_is_one_sum() {
    let by_hand = [
        ("s, z", SQRT + functions()),
        ("ch c, ch s, sh c; a, b, d, e", 3 * MUL + 4 * ADD),
        ("1/s, s⁻², s⁻³, s⁻⁴", DIV + 3 * MUL),
        ("p_YΘ = e / EI²β⁴, p_YM = d / EIβ³, p_ΘQ = b / EIβ", 6 * MUL),
        ("K_y K_θ, in the arithmetic of the evaluation", MUL),
        ("K_y K_θ p_YΘ + K_y p_YM + K_θ p_ΘQ + p_MQ", 3 * MUL + 3 * ADD),
    ];
    assert_counts(at_omega!(scenes::HingeAtRoot, 20.0), &by_hand);
}

/// The last beam before a free root: a whole plane comes in, `p_MQ = (a p_MQ + e p_YΘ) - (b p_YM + f 2w) - d p_ΘQ` goes out.
fn into_free_root() -> Step {
    let (minors, sum) = (4 * MUL, 5 * MUL + 4 * ADD + ADD);
    ("four minors times 1/units; the sum; EI²β⁴, times it", minors + sum + 2 * MUL)
}

#[test]
fn beams_in_a_chain_are_not_joined() {
    let by_hand = [
        ("s; 1/s, s⁻², s⁻³, s⁻⁴; λ²", SQRT + DIV + 4 * MUL),
        ("beam 1: z, four products, a, b, d, e", functions() + 4 * MUL + 4 * ADD),
        ("beam 1: units of four minors, times them", 8 * MUL),
        ("beam 2: z, four products, a, b, d, e", functions() + 4 * MUL + 4 * ADD),
        ("beam 2: one over units", 4 * MUL),
        into_free_root(),
    ];
    assert_counts(at_omega!(scenes::TwoBeams, 20.0), &by_hand);
}

#[test]
fn equal_beams_are_evaluated_once() {
    let by_hand = [
        ("s; 1/s, s⁻², s⁻³, s⁻⁴; λ²", SQRT + DIV + 4 * MUL),
        ("z, four products, a, b, d, e", functions() + 4 * MUL + 4 * ADD),
        ("one over units", 4 * MUL),
        ("the column behind beam 1", 4 * MUL),
        into_free_root(),
    ];
    assert_counts(at_omega!(scenes::TwoEqualBeams, 20.0), &by_hand);
}

#[test]
fn what_is_at_a_connection_costs_its_join_and_no_more() {
    let powers = ("s; 1/s, s⁻², s⁻³, s⁻⁴", SQRT + DIV + 3 * MUL);
    let chain = [powers, behind_pinned_tip(), into_pinned_root()];
    assert_counts(at_omega!(scenes::BetweenPins, 20.0), &chain);
    let [a, b, c] = chain;
    let with_spring = [a, b, ("p_ΘQ + K p_YΘ, p_MQ + K p_YM: no line", 2 * (MUL + ADD)), c];
    assert_counts(at_omega!(scenes::WithSpring, 20.0), &with_spring);
    let with_torsion_spring = [a, b, ("p_YM + K p_YΘ, p_MQ + K p_ΘQ: no line", 2 * (MUL + ADD)), c];
    assert_counts(at_omega!(scenes::WithTorsionSpring, 20.0), &with_torsion_spring);
    let with_mass = [a, b, ("λ², k = m λ²", 2 * MUL), ("p_ΘQ + k p_YΘ, p_MQ + k p_YM", 2 * (MUL + ADD)), c];
    assert_counts(at_omega!(scenes::WithMass, 20.0), &with_mass);
    let with_sprung_mass = [
        a,
        b,
        ("λ², k = m λ²", 2 * MUL),
        ("behind the spring: y = K + k, q = -K k", ADD + MUL),
        ("y times all minors, y p_ΘQ - q p_YΘ, y p_MQ - q p_YM", 7 * MUL + 2 * ADD),
        c,
    ];
    assert_counts(at_omega!(scenes::WithSprungMass, 20.0), &with_sprung_mass);
}

#[test]
fn a_support_at_a_connection_leaves_two_minors() {
    let by_hand = [
        ("s; 1/s, s⁻², s⁻³", SQRT + DIV + 2 * MUL),
        from_pin_to_pin(),
        ("s⁻⁴", MUL),
        ("beam 3: z, ch s, sh c, f; d", functions() + 3 * MUL + ADD),
        ("p_ΘQ / EIβ³, p_MQ / EI²β⁴", 4 * MUL),
        ("p_YM = f 2p_ΘQ + d p_MQ", 2 * MUL + 2 * ADD),
        ("EIβ, times it", 2 * MUL),
    ];
    assert_counts(at_omega!(scenes::WithSupport, 20.0), &by_hand);
}

/// The moment is left behind: `y = p_YM`, `q = -p_MQ`.
#[test]
fn a_narrowing_path_needs_two_minors() {
    let by_hand = [
        ("s; 1/s, s⁻²", SQRT + DIV + MUL),
        ("z, ch s, sh c, f; d, 2f", functions() + 3 * MUL + 2 * ADD),
        ("EIβ, 1/EIβ², L, L²", 4 * MUL),
        ("p_YM = 2f L², p_MQ = -d EIβ", 2 * MUL),
        ("K p_YM + p_MQ", MUL + ADD),
        ("q = -K p_MQ: not for Δ, but for a look at the range of the line", MUL),
    ];
    assert_counts(at_omega!(scenes::Narrowing, 20.0), &by_hand);
}
