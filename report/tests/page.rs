//! The page needs nothing but itself.

mod support;

#[test]
fn the_page_is_self_contained() {
    let page = report::page(&support::measurements()).unwrap();
    std::fs::write(concat!(env!("CARGO_TARGET_TMPDIR"), "/page.html"), &page).unwrap();
}
