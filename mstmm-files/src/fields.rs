//! Fields of files: those of fixed width, as Fortran writes them, and numbers with all digits.

use crate::error::FileError;

/// A number in so many columns with so many decimals, `1.234500E+02`. What is below 1e-99 is written as zero.
pub(crate) fn exponential(value: f64, columns: usize, decimals: usize) -> Result<String, FileError> {
    let least = 1e-99;
    let value = if value.abs() < least { 0.0 } else { value };
    let text = format!("{value:.decimals$e}");
    let (mantissa, exponent) = text.split_once('e').ok_or(FileError::Columns { value })?;
    let exponent: i32 = exponent.parse().map_err(|_| FileError::Columns { value })?;
    if exponent > 99 {
        return Err(FileError::Columns { value });
    }
    let sign = if exponent < 0 { '-' } else { '+' };
    Ok(format!("{:>columns$}", format!("{mantissa}E{sign}{:02}", exponent.abs())))
}

/// A number with the fewest digits that tell it from all others.
pub(crate) fn number(value: f64) -> String {
    // not -0
    format!("{:?}", value + 0.0)
}

/// A text in columns at their left, `NONE` where there is none.
pub(crate) fn text(text: &str, columns: usize) -> Result<String, FileError> {
    let is_printable = text.bytes().all(|byte| byte == b' ' || byte.is_ascii_graphic());
    if text.len() > columns || !is_printable {
        return Err(FileError::Text { text: text.to_owned(), columns });
    }
    Ok(format!("{:<columns$}", if text.trim().is_empty() { "NONE" } else { text }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_in_their_columns() {
        let written = |value| exponential(value, 20, 12).map_err(|error| error.to_string());
        assert_eq!(written(0.0).as_deref(), Ok("  0.000000000000E+00"));
        assert_eq!(written(-12345.678).as_deref(), Ok(" -1.234567800000E+04"));
        assert_eq!(written(1e-7).as_deref(), Ok("  1.000000000000E-07"));
        assert_eq!(written(1e-120).as_deref(), Ok("  0.000000000000E+00"));
        // rounded up beyond the range
        for beyond in [1e100, -1e300, 9.999_999_999_999_99e99] {
            assert!(written(beyond).is_err_and(|message| message.contains("columns")), "{beyond:e}");
        }
        assert!(written(9.99e99).is_ok_and(|text| text.len() == 20));
    }

    #[test]
    fn numbers_of_tables_are_read_back_bit_by_bit() {
        for value in [0.1, 1e-300, 1.0 / 3.0, -1e22, f64::MAX] {
            assert_eq!(number(value).parse(), Ok(value));
        }
        assert_eq!(number(-0.0), "0.0");
    }

    #[test]
    fn texts_stand_in_their_columns() {
        assert_eq!(text("Hz", 5).ok().as_deref(), Some("Hz   "));
        assert_eq!(text(" ", 6).ok().as_deref(), Some("NONE  "));
        for wrong in ["too long", "μm", "a\nb"] {
            assert!(text(wrong, 5).is_err(), "{wrong}");
        }
    }
}
