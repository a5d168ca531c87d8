//! Records of fixed columns, read as Fortran's formats have them and not otherwise.

/// A field of so many columns, at the start of what is left of a line.
pub(crate) fn field<'l>(line: &mut &'l str, columns: usize) -> &'l str {
    let (field, rest) = line.split_at(columns);
    *line = rest;
    field
}

/// A whole number at the right of its columns.
pub(crate) fn integer(line: &mut &str, columns: usize) -> i64 {
    let field = field(line, columns);
    assert!(!field.ends_with(' '), "`{field}` is not at the right");
    field.trim_start().parse().unwrap()
}

/// A number in so many columns with a point, which Fortran's `E` takes as it stands.
pub(crate) fn real(line: &mut &str, columns: usize) -> f64 {
    let field = field(line, columns);
    let mark = field.len() - 4;
    assert!(field[mark..].starts_with('E') && "+-".contains(&field[mark + 1..mark + 2]), "`{field}`");
    assert!(field.contains('.'), "`{field}`");
    field.trim_start().parse().unwrap()
}

/// A text after a blank: `1X, nA1`.
pub(crate) fn text<'l>(line: &mut &'l str, columns: usize) -> &'l str {
    assert_eq!(field(line, 1), " ");
    field(line, columns).trim_end()
}

/// A record of whole numbers, each in so many columns, and no more.
pub(crate) fn integers(mut line: &str, columns: usize) -> Vec<i64> {
    let line = &mut line;
    let mut numbers = Vec::new();
    while !line.is_empty() {
        numbers.push(integer(line, columns));
    }
    numbers
}

/// A record of numbers with a point, `nE13.5`, and no more: one digit before the point and five behind.
pub(crate) fn reals(mut line: &str) -> Vec<f64> {
    let line = &mut line;
    let mut numbers = Vec::new();
    while !line.is_empty() {
        assert_eq!(line.find('.'), Some(3), "`{line}`");
        numbers.push(real(line, 13));
    }
    numbers
}
