//! Rows as a Parquet file.

use crate::error::PartError;
use crate::label::Label;
use crate::model::{FREQUENCIES, PARAMETERS, SpringAndMass};
use crate::shard::Shard;
use crate::solve::{Row, rows};
use crate::whole_file;
use indicatif::ProgressBar;
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType};
use parquet::errors::{ParquetError, Result as ParquetResult};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::parser::parse_message_type;
use std::fs::File;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;

/// Models that are solved before they are written.
const BLOCK: u64 = 1 << 16;

/// Solves the models of a shard, writes their rows in order into a file that is there whole or not at all, and counts those without
/// a certified list, which have an error in place of frequencies.
///
/// # Errors
/// The file cannot be written.
pub fn write(
    path: &Path,
    label: &Label,
    shard: Shard,
    model: impl Fn(u64) -> SpringAndMass,
    progress: &ProgressBar,
) -> Result<u64, PartError> {
    let mut errors = 0;
    whole_file::write(path, |file| {
        let written = write_blocks(file, label, shard, model, progress);
        errors = written.map_err(|source| PartError::Table { path: path.to_owned(), source })?;
        Ok(())
    })?;
    Ok(errors)
}

fn write_blocks(
    file: &File,
    label: &Label,
    shard: Shard,
    model: impl Fn(u64) -> SpringAndMass,
    progress: &ProgressBar,
) -> ParquetResult<u64> {
    // no two numbers are equal: a dictionary would not shorten the file
    let properties = WriterProperties::builder()
        .set_dictionary_enabled(false)
        .set_key_value_metadata(Some(label.metadata(shard)))
        .build();
    let schema = Arc::new(parse_message_type(&schema())?);
    let mut writer = SerializedFileWriter::new(file, schema, Arc::new(properties))?;
    let (models, mut errors) = (shard.models(label.models), 0);
    for start in models.clone().step_by(BLOCK as usize) {
        let block = start..models.end.min(start.saturating_add(BLOCK));
        let rows = rows(&block.clone().map(&model).collect::<Vec<_>>());
        errors += rows.iter().filter(|row| row.omegas.is_err()).count() as u64;
        write_block(writer.next_row_group()?, &rows)?;
        progress.inc(block.end - block.start);
    }
    writer.close()?;
    Ok(errors)
}

/// Parameters, then frequencies, then what was wrong where there are none.
fn schema() -> String {
    let parameters = PARAMETERS.iter().map(|name| format!("required double {name};"));
    let omegas = (1..=FREQUENCIES).map(|number| format!("optional double omega_{number};"));
    let columns: String = parameters.chain(omegas).collect();
    format!("message sweep {{ {columns} optional binary error (UTF8); }}")
}

fn write_block<W: Write + Send>(mut group: SerializedRowGroupWriter<'_, W>, rows: &[Row]) -> ParquetResult<()> {
    let levels = |is_there: fn(&Row) -> bool| rows.iter().map(|row| i16::from(is_there(row))).collect::<Vec<_>>();
    let (solved, failed) = (levels(|row| row.omegas.is_ok()), levels(|row| row.omegas.is_err()));
    for index in 0..PARAMETERS.len() {
        let values: Vec<_> = rows.iter().map(|row| row.parameters[index]).collect();
        write_column::<DoubleType, _>(&mut group, &values, None)?;
    }
    for index in 0..FREQUENCIES {
        let values: Vec<_> = rows.iter().flat_map(|row| &row.omegas).map(|omegas| omegas[index]).collect();
        write_column::<DoubleType, _>(&mut group, &values, Some(&solved))?;
    }
    let errors = rows.iter().filter_map(|row| row.omegas.as_ref().err());
    let errors: Vec<_> = errors.map(|error| ByteArray::from(error.as_str())).collect();
    write_column::<ByteArrayType, _>(&mut group, &errors, Some(&failed))?;
    group.close()?;
    Ok(())
}

/// Writes the values of the next column; of an optional one those that are there, and a level of 1 or 0 for each row.
fn write_column<T: DataType, W: Write + Send>(
    group: &mut SerializedRowGroupWriter<'_, W>,
    values: &[T::T],
    levels: Option<&[i16]>,
) -> ParquetResult<()> {
    let mut column =
        group.next_column()?.ok_or_else(|| ParquetError::General("the schema has too few columns".to_owned()))?;
    column.typed::<T>().write_batch(values, levels, None)?;
    column.close()
}
