//! Files that are there whole or not at all, whenever the power goes.

use crate::error::PartError;
use std::fs::{File, Permissions};
use std::path::Path;
use std::{io, process};
use tempfile::Builder;

/// Writes a file under a temporary name, has it on the disk, and only then gives it its own. What fails leaves nothing behind; what is
/// killed leaves the temporary file, whose name starts with a dot.
pub(crate) fn write(path: &Path, write: impl FnOnce(&File) -> Result<(), PartError>) -> Result<(), PartError> {
    let failed = |source: io::Error| PartError::File { path: path.to_owned(), source };
    // the folder of a bare name is the one where the program runs
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    // in containers every process may have the same number: what is random tells them apart
    let prefix = format!(".{stem}.{}.", process::id());
    let mut builder = Builder::new();
    builder.prefix(&prefix);
    if let Some(permissions) = as_the_user_creates_files() {
        builder.permissions(permissions);
    }
    let file = builder.tempfile_in(folder).map_err(failed)?;
    write(file.as_file())?;
    file.as_file().sync_all().map_err(failed)?;
    file.persist(path).map_err(|error| failed(error.error))?;
    sync(folder).map_err(failed)
}

/// Readable for all whom the user's mask lets, and not for the user alone as temporary files are.
#[cfg(unix)]
fn as_the_user_creates_files() -> Option<Permissions> {
    use std::os::unix::fs::PermissionsExt;
    Some(Permissions::from_mode(0o666))
}

#[cfg(not(unix))]
fn as_the_user_creates_files() -> Option<Permissions> {
    None
}

/// Has the new name on the disk, too.
#[cfg(unix)]
fn sync(folder: &Path) -> io::Result<()> {
    File::open(folder)?.sync_all()
}

/// Elsewhere folders are no files.
#[cfg(not(unix))]
fn sync(_folder: &Path) -> io::Result<()> {
    Ok(())
}
