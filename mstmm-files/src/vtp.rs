//! VTK XML PolyData, the file of lines that ParaView reads.

use crate::error::FileError;
use crate::fields::number;
use crate::geometry::{Geometry, motions};
use crate::modes::Mode;
use std::io::Write;

/// Writes lines and the modes of their points as VTK XML PolyData, `.vtp`, in text with all digits: the filter "Warp By Vector" of ParaView shows
/// each mode.
///
/// Each mode is an array of three components for each point, of a complex shape one for its real part and one for its imaginary part. Its name
/// is `mode 1 (12.3 Hz)`, unless [`Mode::named`] says another. Each line has its index as `line`. What is below 2.3e-308 is zero.
///
/// ```
/// use mstmm_core::search::NaturalFrequency;
/// use mstmm_files::{Geometry, Mode, write_vtp};
///
/// let mut mast = Geometry::default();
/// mast.add_line("mast", [[0.0, 0.0, 0.0], [0.0, 0.0, 4.0], [0.0, 0.0, 8.0]]);
/// let root = NaturalFrequency { omega: 12.5, ..NaturalFrequency::default() };
/// let sway = Mode::from(root).with_vectors([[0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [1.0, 0.0, 0.0]]);
/// let mut file = Vec::new(); // or File::create("mast.vtp")?
/// write_vtp(&mut file, &mast, [sway])?;
/// assert!(String::from_utf8(file)?.contains("Name=\"mode 1 (1.9894 Hz)\""));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FileError`] for no points, lines to points that are not there, places and shapes that are not finite or have not as many numbers as points
/// ask for, two modes of one name, and a writer that fails. Nothing is written before all is checked.
///
/// # Source
/// VTK file formats, XML formats, Kitware.
pub fn write_vtp<M: Into<Mode>>(
    mut writer: impl Write,
    geometry: &Geometry,
    modes: impl IntoIterator<Item = M>,
) -> Result<(), FileError> {
    let motions = motions(geometry, modes)?;
    let arrays: Vec<_> = motions.iter().flat_map(|motion| motion.arrays()).collect();
    let (points, lines) = (&geometry.points, &geometry.lines);
    let mut file = String::from("<?xml version=\"1.0\"?>\n");
    file +=
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n";
    file +=
        &format!("<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\"", points.len(), lines.len());
    file += " NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n";
    let first = arrays.first().map(|(name, _)| format!(" Vectors=\"{}\"", escaped(name)));
    file += &format!("<PointData{}>\n", first.unwrap_or_default());
    for (name, vectors) in &arrays {
        file += &vector_array(name, vectors);
    }
    file += "</PointData>\n<CellData>\n";
    file += &index_array("line", "Int32", 0..lines.len());
    file += "</CellData>\n<Points>\n";
    file += &vector_array("Points", points);
    file += "</Points>\n<Lines>\n";
    file += &index_array("connectivity", "Int64", lines.iter().flat_map(|line| line.points.iter().copied()));
    let ends = lines.iter().scan(0, |end, line| {
        *end += line.points.len();
        Some(*end)
    });
    file += &index_array("offsets", "Int64", ends);
    file += "</Lines>\n</Piece>\n</PolyData>\n</VTKFile>\n";
    Ok(writer.write_all(file.as_bytes())?)
}

/// An array of vectors, one in a line.
fn vector_array(name: &str, vectors: &[[f64; 3]]) -> String {
    let mut array =
        format!("<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"3\" format=\"ascii\">\n", escaped(name));
    for vector in vectors {
        let [x, y, z] = vector.map(|part| number(normal(part)));
        array += &format!("{x} {y} {z}\n");
    }
    array + "</DataArray>\n"
}

/// An array of whole numbers.
fn index_array(name: &str, kind: &str, indices: impl Iterator<Item = usize>) -> String {
    let indices: Vec<String> = indices.map(|index| index.to_string()).collect();
    let indices: Vec<String> = indices.chunks(20).map(|line| line.join(" ")).collect();
    format!("<DataArray type=\"{kind}\" Name=\"{name}\" format=\"ascii\">\n{}\n</DataArray>\n", indices.join("\n"))
}

/// A number without those that are smaller than normal ones: readers take them for errors.
fn normal(number: f64) -> f64 {
    if number.is_normal() { number } else { 0.0 }
}

/// A text as the value of an attribute.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
