//! The functions that the page calls: plain ones of numbers and of places in memory.
#![expect(unsafe_code, reason = "names that are exported as they stand")]

use crate::model::{Listed, MODELS, describe};
use crate::problem::Problem;
use crate::shown::Shown;
use crate::table::Table;
use crate::text::Text;
use core::fmt::Write;
use core::panic::PanicInfo;

/// As many sliders as a model may have.
const SLIDERS: usize = 16;

static VALUES: Table<SLIDERS> = Table::new();
static SHOWN: Shown = Shown::new();
static TEXT: Text<8192> = Text::new();

/// Writes models and tables as JSON; the length of the text.
#[unsafe(no_mangle)]
extern "C" fn description() -> usize {
    TEXT.clear();
    // cut off where it did not fit, it is no JSON, which the page says
    let _ = describe(&mut &TEXT, &SHOWN);
    TEXT.length()
}

/// Where the text is.
#[unsafe(no_mangle)]
extern "C" fn text() -> *const u8 {
    TEXT.start()
}

/// Forgets the values of the sliders.
#[unsafe(no_mangle)]
extern "C" fn clear() {
    VALUES.clear();
}

/// Gives the next slider its value; of more than there may be nothing is heard.
#[unsafe(no_mangle)]
extern "C" fn push(value: f64) {
    let _ = VALUES.push(&[value]);
}

/// Solves a model: 0, or the length of the text that says why not.
#[unsafe(no_mangle)]
extern "C" fn show(model: usize) -> usize {
    told(model, Listed::show)
}

/// Finds the roots of a model alone: 0, or the length of the text that says why not.
#[unsafe(no_mangle)]
extern "C" fn show_roots(model: usize) -> usize {
    told(model, Listed::show_roots)
}

fn told(model: usize, show: fn(Listed, &[f64], &Shown) -> Result<(), Problem>) -> usize {
    let mut values = [0.0; SLIDERS];
    values.iter_mut().zip(VALUES.numbers()).for_each(|(place, value)| *place = value);
    let model = MODELS.get(model).copied().ok_or(Problem::NoModel);
    let Err(problem) = model.and_then(|model| show(model, &values[..VALUES.length()], &SHOWN)) else { return 0 };
    TEXT.clear();
    let _ = write!(&TEXT, "{problem}");
    TEXT.length()
}

/// Where the numbers of a table are.
#[unsafe(no_mangle)]
extern "C" fn table(index: usize) -> *const f64 {
    SHOWN.tables().get(index).map_or(core::ptr::null(), |(_, _, table)| table.place().0)
}

/// How many numbers a table has.
#[unsafe(no_mangle)]
extern "C" fn table_length(index: usize) -> usize {
    SHOWN.tables().get(index).map_or(0, |(_, _, table)| table.place().1)
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    core::arch::wasm32::unreachable()
}
