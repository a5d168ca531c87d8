//! The first three frequencies of a million models, on all cores, into a Parquet file.

use indicatif::ProgressBar;
use mstmm::prelude::*;
use mstmm::search::SweepError;
use parquet::data_type::DoubleType;
use parquet::file::{properties::WriterProperties, writer::SerializedFileWriter};
use rayon::prelude::*;
use std::{env, error::Error, fs, iter, path::Path, time::Instant};

system! {
    /// Beam on two supports with a spring to the ground and a mass (section 4.3 of the paper); ω in units of sqrt(EI/(m l⁴)).
    #[derive(Clone, Copy, Debug)]
    pub struct SpringAndMass { spring_at: f64, mass_at: f64, stiffness: f64, mass: f64 }

    pinned -> beam 1 { length: spring_at, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> conn 2 -> beam 4 { length: mass_at - spring_at, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> conn 5 -> beam 7 { length: 1.0 - mass_at, bending_stiffness: 1.0, mass_per_length: 1.0 }
           -> pinned;
    conn 2 <- spring 3 { stiffness } <- fixed;
    conn 5 <- mass 6 { mass } <- free;
}

/// Parameters, then frequencies.
const SCHEMA: &str = "message sweep { required double spring_at; required double mass_at; required double stiffness;
    required double mass; required double omega_1; required double omega_2; required double omega_3; }";
/// Models that are solved before they are written.
const BLOCK: u64 = 1 << 16;
/// Models that a thread solves in a row.
const ROW: usize = 256;

/// A model of the sweep: points that fill the ranges evenly, by steps of irrational numbers.
pub fn model(index: u64) -> SpringAndMass {
    let part = |step: f64| (index as f64 * step).fract();
    let (spring_at, mass_at) = (0.05 + 0.40 * part(2_f64.sqrt()), 0.55 + 0.40 * part(3_f64.sqrt()));
    SpringAndMass { spring_at, mass_at, stiffness: 1.0 + 99.0 * part(5_f64.sqrt()), mass: part(7_f64.sqrt()) }
}

/// Rows of the file; an error where there is no certified list of frequencies.
pub fn rows(models: &[SpringAndMass]) -> impl Iterator<Item = Result<[f64; 7], SweepError>> {
    models.iter().first_frequencies::<3>().zip(models).map(|(roots, model)| {
        let roots = roots?;
        let omegas = roots.iter().flat_map(|root| iter::repeat_n(root.omega, root.multiplicity as usize));
        let mut row = [model.spring_at, model.mass_at, model.stiffness, model.mass, 0.0, 0.0, 0.0];
        row[4..].iter_mut().zip(omegas).for_each(|(place, omega)| *place = omega);
        Ok(row)
    })
}

/// Solves as many models, writes their rows in order, and counts those without a certified list, which are left out.
pub fn sweep(count: u64, file: &Path, progress: &ProgressBar) -> Result<u64, Box<dyn Error>> {
    let schema = parquet::schema::parser::parse_message_type(SCHEMA)?.into();
    // no two numbers are equal: a dictionary would not shorten the file
    let properties = WriterProperties::builder().set_dictionary_enabled(false).build().into();
    let mut writer = SerializedFileWriter::new(fs::File::create(file)?, schema, properties)?;
    let mut errors = 0;
    for start in (0..count).step_by(BLOCK as usize) {
        let block = start..count.min(start + BLOCK);
        let models: Vec<_> = block.clone().map(model).collect();
        let rows: Vec<_> = models.par_chunks(ROW).flat_map_iter(|models| rows(models).map(Result::ok)).collect();
        errors += rows.iter().filter(|row| row.is_none()).count() as u64;
        let (mut group, mut index) = (writer.next_row_group()?, 0);
        while let Some(mut column) = group.next_column()? {
            let values: Vec<f64> = rows.iter().flatten().map(|row| row[index]).collect();
            column.typed::<DoubleType>().write_batch(&values, None, None)?;
            column.close()?;
            index += 1;
        }
        group.close()?;
        progress.inc(block.end - block.start);
    }
    writer.close()?;
    Ok(errors)
}

fn main() -> Result<(), Box<dyn Error>> {
    let count = env::args().nth(1).map_or(Ok(1_000_000), |text| text.parse())?;
    fs::create_dir_all("target")?;
    let (file, begin) = (Path::new("target/sweep.parquet"), Instant::now());
    // the bar is shown on a terminal alone
    let errors = sweep(count, file, &ProgressBar::new(count))?;
    let (seconds, cores) = (begin.elapsed().as_secs_f64(), rayon::current_num_threads());
    println!("{} of {count} models with three certified frequencies each, in {}", count - errors, file.display());
    println!("{seconds:.2} s, {:.0} models per second and core", count as f64 / seconds / cores as f64);
    Ok(())
}
