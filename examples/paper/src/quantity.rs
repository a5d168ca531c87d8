//! The quantities that the paper's tables list, computed from an eigenvalue λ; undamped λ = iω.

use core::fmt;
use mstmm::prelude::*;

/// First root of cos z cosh z = -1: the bare cantilever vibrates at ω_1B = z² sqrt(EI/(m l⁴)).
const BARE_CANTILEVER: f64 = 1.875_104_068_711_961_2;

/// An entry of a table.
#[derive(Clone, Copy, Debug)]
pub enum Value {
    /// Of an undamped example.
    Real(f64),
    /// Of a damped example.
    Complex(Complex<f64>),
}

impl Value {
    /// Modulus of the difference.
    pub fn distance(self, other: Value) -> f64 {
        (self.complex() - other.complex()).norm()
    }

    /// Distance to `reference`, divided by its modulus.
    pub fn relative_error(self, reference: Value) -> f64 {
        self.distance(reference) / reference.complex().norm()
    }

    fn complex(self) -> Complex<f64> {
        match self {
            Value::Real(value) => value.into(),
            Value::Complex(value) => value,
        }
    }
}

/// As many digits as the precision says, all significant; without one, the shortest text that stands for the number.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = |value: f64| match f.precision() {
            Some(digits) if value != 0.0 => {
                let decimals = digits as i32 - 1 - value.abs().log10().floor() as i32;
                format!("{value:.*}", decimals.max(0) as usize)
            }
            _ => value.to_string(),
        };
        match *self {
            Value::Real(value) => write!(f, "{}", text(value)),
            Value::Complex(value) => {
                let sign = if value.im < 0.0 { '-' } else { '+' };
                write!(f, "{} {sign} {}i", text(value.re), text(value.im.abs()))
            }
        }
    }
}

/// What a table lists. The frequency unit is sqrt(EI/(m l⁴)), Ω = ω / unit.
#[derive(Clone, Copy, Debug)]
pub enum Quantity {
    /// sqrt(Ω)
    RootOfOmega,
    /// Ω
    Omega,
    /// ω / ω_1B
    ToBareCantilever,
    /// ω in rad/s
    AngularFrequency,
    /// λ / unit
    Eigenvalue,
}

impl Quantity {
    /// The quantity with this symbol in the reference data.
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        Some(match symbol {
            "sqrt(Omega)" => Quantity::RootOfOmega,
            "Omega" => Quantity::Omega,
            "omega/omega_1B" => Quantity::ToBareCantilever,
            "omega [rad/s]" => Quantity::AngularFrequency,
            "lambda/sqrt(EI/(m l^4))" => Quantity::Eigenvalue,
            _ => return None,
        })
    }

    /// The quantity of an eigenvalue λ [rad/s].
    pub fn of(self, lambda: Complex<f64>, unit: f64) -> Value {
        let omega = lambda.im;
        match self {
            Quantity::RootOfOmega => Value::Real((omega / unit).sqrt()),
            Quantity::Omega => Value::Real(omega / unit),
            Quantity::ToBareCantilever => Value::Real(omega / (BARE_CANTILEVER * BARE_CANTILEVER * unit)),
            Quantity::AngularFrequency => Value::Real(omega),
            Quantity::Eigenvalue => Value::Complex(lambda / unit),
        }
    }
}
