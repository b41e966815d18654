//! Files are written whole or not at all.

use crate::args::Place;
use crate::failure::Failure;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The temporary file that exists now. The handler of Ctrl-C removes it.
static TEMPORARY: Mutex<Option<PathBuf>> = Mutex::new(None);

fn temporary() -> MutexGuard<'static, Option<PathBuf>> {
    TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Makes Ctrl-C and termination remove the temporary file before the process ends.
pub(crate) fn guard_against_interrupt() {
    // Without a handler an interrupt may leave the temporary file behind; nothing else depends on it.
    let _ = ctrlc::set_handler(|| {
        let mut current = temporary();
        if let Some(path) = current.take() {
            let _ = fs::remove_file(path);
        }
        // The lock is held: no other thread can create or rename a file between here and the end.
        std::process::exit(130);
    });
}

/// Finds out before the work whether the result can be written.
pub(crate) fn probe(place: &Place) -> Result<(), Failure> {
    let Place::File(path) = place else { return Ok(()) };
    let attempt = || -> io::Result<()> {
        match target(path)? {
            Target::Stream => Ok(()),
            Target::Regular(path) => Temporary::create(&path).map(drop),
        }
    };
    attempt().map_err(|error| failure(path, &error))
}

/// Writes the whole of `bytes`. A file appears, or changes, only after the last byte was written.
pub(crate) fn write(place: &Place, bytes: &[u8]) -> Result<(), Failure> {
    let Place::File(path) = place else { return write_to_stdout(bytes) };
    let attempt = || -> io::Result<()> {
        match target(path)? {
            // A pipe or a device cannot be replaced by a file.
            Target::Stream => OpenOptions::new().write(true).open(path)?.write_all(bytes),
            Target::Regular(path) => {
                let mut temporary = Temporary::create(&path)?;
                temporary.file.write_all(bytes)?;
                temporary.file.sync_all()?;
                temporary.rename(&path)
            }
        }
    };
    attempt().map_err(|error| failure(path, &error))
}

/// A report on standard output. That its reader went away is no error.
pub(crate) fn report(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    match stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()) {
        Ok(()) => Ok(()),
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Err(Failure::Closed),
        Err(error) => Err(Failure::file("-", None, cannot_write(&error))),
    }
}

fn write_to_stdout(bytes: &[u8]) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(bytes).and_then(|()| stdout.flush()).map_err(|error| match error.kind() {
        io::ErrorKind::BrokenPipe => {
            Failure::file("-", None, "not written: what reads standard output has gone; let it read all")
        }
        _ => Failure::file("-", None, cannot_write(&error)),
    })
}

enum Target {
    /// To be replaced; links are followed.
    Regular(PathBuf),
    /// To be written through.
    Stream,
}

fn target(path: &Path) -> io::Result<Target> {
    match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => Err(io::ErrorKind::IsADirectory.into()),
        Ok(metadata) if metadata.is_file() => {
            if metadata.permissions().readonly() {
                return Err(io::ErrorKind::PermissionDenied.into());
            }
            Ok(Target::Regular(fs::canonicalize(path)?))
        }
        Ok(_) => Ok(Target::Stream),
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            if path.file_name().is_none() {
                return Err(io::ErrorKind::IsADirectory.into());
            }
            Ok(Target::Regular(path.to_path_buf()))
        }
        Err(error) => Err(error),
    }
}

fn failure(path: &Path, error: &io::Error) -> Failure {
    Failure::file(&path.to_string_lossy(), None, cannot_write(error))
}

fn cannot_write(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::IsADirectory => "cannot be written: it is a directory; give the name of a file".into(),
        io::ErrorKind::NotFound => "cannot be written: its directory does not exist; create it".into(),
        io::ErrorKind::PermissionDenied => {
            "cannot be written: permission denied; write to another place, or change the permission".into()
        }
        _ => format!("cannot be written: {error}; make room, or write to another place"),
    }
}

/// A file beside the one to be written, gone when dropped.
struct Temporary {
    file: File,
    path: PathBuf,
}

impl Temporary {
    fn create(target: &Path) -> io::Result<Self> {
        let name = target.file_name().unwrap_or_default().to_string_lossy();
        // Long names are cut: a name has at most 255 bytes.
        let name: String = name.chars().take(40).collect();
        let process = std::process::id();
        for attempt in 0..1000 {
            let path = target.with_file_name(format!(".{name}.{process}-{attempt}.part"));
            let mut current = temporary();
            match OpenOptions::new().write(true).create_new(true).open(&path) {
                Ok(file) => {
                    *current = Some(path.clone());
                    return Ok(Self { file, path });
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(io::ErrorKind::AlreadyExists.into())
    }

    fn rename(self, target: &Path) -> io::Result<()> {
        if let Ok(metadata) = fs::metadata(target) {
            // A file that is written again keeps who may read it. That this may be refused loses nothing.
            let _ = self.file.set_permissions(metadata.permissions());
        }
        let mut current = temporary();
        fs::rename(&self.path, target)?;
        *current = None;
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let mut current = temporary();
        if current.take().is_some() {
            let _ = fs::remove_file(&self.path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_temporary_file_is_known_while_it_exists() {
        let folder = std::env::temp_dir().join(format!("splitstar-output-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let target = folder.join("out.off");
        let dropped = Temporary::create(&target).unwrap();
        // What the handler of Ctrl-C would remove.
        assert_eq!(temporary().as_ref(), Some(&dropped.path));
        assert!(dropped.path.exists());
        let path = dropped.path.clone();
        drop(dropped);
        assert!(!path.exists() && temporary().is_none());

        let mut renamed = Temporary::create(&target).unwrap();
        renamed.file.write_all(b"all of it").unwrap();
        renamed.rename(&target).unwrap();
        assert_eq!(fs::read(&target).unwrap(), b"all of it");
        assert!(temporary().is_none());
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(&folder).unwrap();
    }
}
