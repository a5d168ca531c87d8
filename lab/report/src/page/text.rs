//! Numbers and symbols as text.

/// A time with three digits and the unit that fits.
pub(super) fn time(seconds: f64) -> String {
    let (value, unit) = match seconds {
        seconds if seconds < 1e-3 => (seconds * 1e6, "µs"),
        seconds if seconds < 1.0 => (seconds * 1e3, "ms"),
        seconds => (seconds, "s"),
    };
    let decimals = (2 - value.log10().floor() as i32).clamp(0, 2) as usize;
    format!("{value:.decimals$} {unit}")
}

/// An error with one digit.
pub(super) fn error(error: f64) -> String {
    if error == 0.0 { "0".to_owned() } else { format!("{error:.0e}").replace('-', "−") }
}

/// The symbol of a quantity, which the reference data spell in Latin letters.
pub(super) fn symbol(spelt: &str) -> String {
    let letters =
        [("sqrt(Omega)", "√Ω"), ("sqrt(EI/(m l^4))", "√(EI/(m l⁴))"), ("Omega", "Ω"), ("omega", "ω"), ("lambda", "λ")];
    letters.iter().fold(spelt.to_owned(), |text, (latin, letter)| text.replace(latin, letter))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_have_three_digits_and_a_unit() {
        let texts = [2.6e-6, 26.04e-6, 260.4e-6, 0.0026, 0.26, 2.6].map(time);
        assert_eq!(texts, ["2.60 µs", "26.0 µs", "260 µs", "2.60 ms", "260 ms", "2.60 s"]);
    }

    #[test]
    fn symbols_are_greek() {
        assert_eq!(symbol("lambda/sqrt(EI/(m l^4))"), "λ/√(EI/(m l⁴))");
        assert_eq!(symbol("omega/omega_1B"), "ω/ω_1B");
        assert_eq!(symbol("sqrt(Omega)"), "√Ω");
    }
}
