//! Text that the page reads in place.

use core::fmt;
use core::sync::atomic::{AtomicU8, AtomicUsize, Ordering::Relaxed};

/// Bytes of a text in UTF-8; what does not fit is cut off.
#[derive(Debug)]
pub struct Text<const CAP: usize> {
    length: AtomicUsize,
    bytes: [AtomicU8; CAP],
}

impl<const CAP: usize> Text<CAP> {
    /// An empty text.
    pub const fn new() -> Self {
        Text { length: AtomicUsize::new(0), bytes: [const { AtomicU8::new(0) }; CAP] }
    }

    /// Forgets what was written.
    pub fn clear(&self) {
        self.length.store(0, Relaxed);
    }

    /// How many bytes were written.
    pub fn length(&self) -> usize {
        self.length.load(Relaxed)
    }

    /// Where the first byte is.
    pub fn start(&self) -> *const u8 {
        self.bytes.as_ptr().cast()
    }
}

impl<const CAP: usize> Default for Text<CAP> {
    fn default() -> Self {
        Text::new()
    }
}

impl<const CAP: usize> fmt::Write for &Text<CAP> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let length = self.length();
        let room = self.bytes.get(length..length + text.len()).ok_or(fmt::Error)?;
        for (place, byte) in room.iter().zip(text.bytes()) {
            place.store(byte, Relaxed);
        }
        self.length.store(length + text.len(), Relaxed);
        Ok(())
    }
}
