//! glTF, the file of moving figures that Blender and browsers read.

use crate::error::FileError;
use crate::geometry::{Geometry, Motion, motions};
use crate::modes::Mode;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use std::f64::consts::TAU;
use std::io::Write;

/// Moments of a period at which weights stand in the file; between them they are straight lines.
const MOMENTS: u32 = 32;

/// The largest displacement of a mode, as a part of the diagonal of the figure.
const LARGEST: f64 = 0.1;

/// Writes lines and their modes as one file of glTF 2.0, `.gltf`, with all its numbers inside.
///
/// Each mode is a morph target, of a complex shape one for each of its parts, and an animation of one second in which it vibrates once: its weight
/// is `sin(2πt)`, that of an imaginary part `cos(2πt)`. Blender imports targets as shape keys and animations as actions. The largest
/// displacement of a mode is a tenth of the diagonal of the box around the figure.
///
/// A figure in the plane z = 0 that moves in this plane stands upright with y upwards, every other one with z. Numbers have the seven digits of
/// single precision.
///
/// ```
/// use mstmm_core::search::NaturalFrequency;
/// use mstmm_files::{Geometry, Mode, write_gltf};
///
/// let mut mast = Geometry::default();
/// mast.add_line("mast", [[0.0, 0.0, 0.0], [0.0, 0.0, 4.0], [0.0, 0.0, 8.0]]);
/// let root = NaturalFrequency { omega: 12.5, ..NaturalFrequency::default() };
/// let sway = Mode::from(root).with_vectors([[0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [1.0, 0.0, 0.0]]);
/// let mut file = Vec::new(); // or File::create("mast.gltf")?
/// write_gltf(&mut file, &mast, [sway])?;
/// assert!(String::from_utf8(file)?.contains("\"targetNames\":[\"mode 1 (1.9894 Hz)\"]"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`FileError`] for no points or lines, lines to points that are not there, places and shapes that are not finite in single precision or have not as
/// many numbers as points ask for, two modes of one name, and a writer that fails. Nothing is written before all is checked.
///
/// # Source
/// glTF 2.0 Specification, Khronos Group, ISO/IEC 12113:2022.
pub fn write_gltf<M: Into<Mode>>(
    mut writer: impl Write,
    geometry: &Geometry,
    modes: impl IntoIterator<Item = M>,
) -> Result<(), FileError> {
    let motions = motions(geometry, modes)?;
    if geometry.lines.is_empty() {
        return Err(FileError::NoLines);
    }
    let places = single(&geometry.points, 1.0);
    if let Some(point) = places.iter().position(|place| !place.iter().all(|part| part.is_finite())) {
        return Err(FileError::Place { point });
    }
    let mut parts = Parts::default();
    let position = parts.vectors(&places);
    let pairs = geometry.lines.iter().flat_map(|line| line.points.windows(2)).flatten();
    let indices = parts.indices(pairs.map(|point| *point as u32).collect());
    let (mut targets, mut names) = (Vec::new(), Vec::new());
    for motion in &motions {
        let factor = LARGEST * diagonal(&geometry.points) / largest(motion);
        for (name, vectors) in motion.arrays() {
            let vectors = single(vectors, if factor.is_finite() { factor } else { 0.0 });
            targets.push(format!("{{\"POSITION\":{}}}", parts.vectors(&vectors)));
            names.push(quoted(&name));
        }
    }
    let mut primitive = format!("\"attributes\":{{\"POSITION\":{position}}},\"indices\":{indices},\"mode\":1");
    let (mut weights, mut moving) = (String::new(), String::new());
    if !targets.is_empty() {
        primitive += &format!(",\"targets\":[{}]", targets.join(","));
        let zeros = vec!["0"; targets.len()].join(",");
        weights = format!(",\"weights\":[{zeros}],\"extras\":{{\"targetNames\":[{}]}}", names.join(","));
        moving = format!("\"animations\":[{}],\n", animations(&motions, targets.len(), &mut parts).join(",\n"));
    }
    // a quarter of a turn about x leads from z to y, which points upwards in the format
    let half = 0.5_f64.sqrt();
    let turn =
        if is_upright(geometry, &motions) { String::new() } else { format!(",\"rotation\":[-{half},0,0,{half}]") };
    let mut file = String::from("{\"asset\":{\"version\":\"2.0\",\"generator\":\"mstmm\"},\n");
    file += &format!("\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\"nodes\":[{{\"mesh\":0{turn}}}],\n");
    file += &format!("\"meshes\":[{{\"primitives\":[{{{primitive}}}]{weights}}}],\n{moving}");
    file += &format!("\"accessors\":[{}],\n", parts.accessors.join(",\n"));
    file += &format!("\"bufferViews\":[{}],\n", parts.views.join(",\n"));
    file +=
        &format!("\"buffers\":[{{\"byteLength\":{},\"uri\":\"data:application/octet-stream;base64,", parts.bytes.len());
    file += &(BASE64_STANDARD.encode(&parts.bytes) + "\"}]}\n");
    Ok(writer.write_all(file.as_bytes())?)
}

/// An animation for each motion, given the number of all targets.
fn animations(motions: &[Motion], targets: usize, parts: &mut Parts) -> Vec<String> {
    let part = |moment: u32| f64::from(moment) / f64::from(MOMENTS);
    let times = parts.numbers((0..=MOMENTS).map(|moment| part(moment) as f32).collect(), ",\"min\":[0],\"max\":[1]");
    let (mut animations, mut first) = (Vec::new(), 0);
    for motion in motions {
        let mut weights = vec![0.0; targets * (MOMENTS as usize + 1)];
        for (moment, weights) in (0..=MOMENTS).zip(weights.chunks_mut(targets)) {
            // the last moment is the first one
            let angle = TAU * part(moment % MOMENTS);
            weights[first] = angle.sin() as f32;
            if motion.imaginary.is_some() {
                weights[first + 1] = angle.cos() as f32;
            }
        }
        first += motion.arrays().len();
        animations.push(format!(
            "{{\"name\":{},\"samplers\":[{{\"input\":{times},\"output\":{},\"interpolation\":\"LINEAR\"}}],\
             \"channels\":[{{\"sampler\":0,\"target\":{{\"node\":0,\"path\":\"weights\"}}}}]}}",
            quoted(&motion.name),
            parts.numbers(weights, ""),
        ));
    }
    animations
}

/// The numbers of a file, and how they are found.
#[derive(Default)]
struct Parts {
    bytes: Vec<u8>,
    views: Vec<String>,
    accessors: Vec<String>,
}

impl Parts {
    /// Adds numbers of four bytes each, in a view with these properties. The result is the index of their accessor.
    fn add(&mut self, bytes: impl Iterator<Item = [u8; 4]>, view: &str, accessor: &str) -> usize {
        let start = self.bytes.len();
        self.bytes.extend(bytes.flatten());
        let length = self.bytes.len() - start;
        self.views.push(format!("{{\"buffer\":0,\"byteOffset\":{start},\"byteLength\":{length}{view}}}"));
        self.accessors.push(format!("{{\"bufferView\":{}{accessor}}}", self.views.len() - 1));
        self.accessors.len() - 1
    }

    /// Vectors of vertices, with the least and the largest of each coordinate.
    fn vectors(&mut self, vectors: &[[f32; 3]]) -> usize {
        let bound = |start: f32, of: fn(f32, f32) -> f32| {
            let bound = [0, 1, 2].map(|k| f64::from(vectors.iter().map(|vector| vector[k]).fold(start, of)));
            format!("{bound:?}")
        };
        let (least, largest) = (bound(f32::INFINITY, f32::min), bound(f32::NEG_INFINITY, f32::max));
        let bytes = vectors.iter().flatten().map(|number| number.to_le_bytes());
        let count = vectors.len();
        let accessor =
            format!(",\"componentType\":5126,\"count\":{count},\"type\":\"VEC3\",\"min\":{least},\"max\":{largest}");
        self.add(bytes, ",\"target\":34962", &accessor)
    }

    /// Indices of vertices.
    fn indices(&mut self, indices: Vec<u32>) -> usize {
        let accessor = format!(",\"componentType\":5125,\"count\":{},\"type\":\"SCALAR\"", indices.len());
        self.add(indices.into_iter().map(u32::to_le_bytes), ",\"target\":34963", &accessor)
    }

    /// Numbers of animations, with the text of their bounds.
    fn numbers(&mut self, numbers: Vec<f32>, bounds: &str) -> usize {
        let accessor = format!(",\"componentType\":5126,\"count\":{},\"type\":\"SCALAR\"{bounds}", numbers.len());
        self.add(numbers.into_iter().map(f32::to_le_bytes), "", &accessor)
    }
}

/// Vectors times a factor in single precision, without -0.
fn single(vectors: &[[f64; 3]], factor: f64) -> Vec<[f32; 3]> {
    vectors.iter().map(|vector| vector.map(|part| (part * factor) as f32 + 0.0)).collect()
}

/// The diagonal of the box around points.
fn diagonal(points: &[[f64; 3]]) -> f64 {
    let bound = |k: usize, of: fn(f64, f64) -> f64| points.iter().map(|point| point[k]).fold(points[0][k], of);
    let [x, y, z] = [0, 1, 2].map(|k| bound(k, f64::max) - bound(k, f64::min));
    x.hypot(y).hypot(z)
}

/// The largest displacement of a motion, both of its parts together.
fn largest(motion: &Motion) -> f64 {
    let size = |[x, y, z]: [f64; 3]| x.hypot(y).hypot(z);
    let imaginary = |point: usize| motion.imaginary.as_ref().map_or(0.0, |imaginary| size(imaginary[point]));
    motion.real.iter().enumerate().map(|(point, real)| size(*real).hypot(imaginary(point))).fold(0.0, f64::max)
}

/// Whether nothing leads out of the plane z = 0.
fn is_upright(geometry: &Geometry, motions: &[Motion]) -> bool {
    let is_flat = |vectors: &[[f64; 3]]| vectors.iter().all(|vector| vector[2] == 0.0);
    is_flat(&geometry.points) && motions.iter().flat_map(Motion::arrays).all(|(_, vectors)| is_flat(vectors))
}

/// A text without control characters as a string of JSON.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}
