//! The page needs nothing but itself, and shows all that it should.

mod support;

/// Oracle: counts by hand. Eight scenes, six landscapes, six examples with shapes, two plots of digits, two of growth.
const FIGURES: usize = 8 + 6 + 6 + 2 + 2;

/// What would load something, or run.
const FOREIGN: [&str; 7] = ["<script", "<link", "<img", "<iframe", "@import", "url(", "src="];

#[test]
fn the_page_is_self_contained() {
    let page = report::page(support::measurements()).unwrap();
    for text in FOREIGN {
        assert!(!page.contains(text), "{text}");
    }
    // the one address is the name of SVG, which is not loaded
    let addresses = page.match_indices("http").map(|(start, _)| &page[start..]);
    assert!(addresses.into_iter().all(|address| address.starts_with("http://www.w3.org/2000/svg\"")));
}

#[test]
fn every_figure_and_table_is_there() {
    let page = report::page(support::measurements()).unwrap();
    assert_eq!(page.matches("<figure>").count(), FIGURES);
    for section in ["summary", "paper", "error-time", "landscapes", "shapes", "digits", "growth"] {
        assert!(page.contains(&format!("<section id=\"{section}\">")), "{section}");
    }
    // one of factors, one of each example
    assert_eq!(page.matches("<table>").count(), 1 + 6);
    assert!(page.contains("a win for plain method"));
}

/// Every element is closed where it must be, in order.
#[test]
fn the_page_is_well_formed() {
    let page = report::page(support::measurements()).unwrap();
    let mut open: Vec<&str> = Vec::new();
    for tag in page.split('<').skip(1) {
        let (tag, _) = tag.split_once('>').unwrap();
        let name = tag.trim_start_matches('/').split([' ', '/', '\n']).next().unwrap();
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name), "<{tag}>");
        } else if !(tag.starts_with('!') || tag.ends_with('/') || ["meta", "br"].contains(&name)) {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{open:?}");
}

#[test]
fn a_method_without_a_style_is_an_error() {
    let mut runs = support::runs();
    runs[0].method = "guessing".to_owned();
    let page = report::page(&support::measurements_of(runs));
    assert_eq!(page.unwrap_err().to_string(), "the report has no style for the method `guessing`");
}

#[test]
fn the_table_of_the_readme_is_replaced() {
    let readme = "# a\n<!-- factors -->\nold\n<!-- end of factors -->\nb\n";
    let table = report::markdown(&support::runs());
    let text = report::with_table(readme, &table).unwrap();
    assert_eq!(text, format!("# a\n<!-- factors -->\n\n{table}\n<!-- end of factors -->\nb\n"));
    assert_eq!(report::with_table(&text, &table).unwrap(), text);
    assert!(report::with_table("# a", &table).is_err());
    assert!(report::with_table(include_str!("../../../docs/speed.md"), &table).is_ok());
}

#[test]
fn pictures_are_drawings_with_a_background() {
    for picture in report::pictures(support::measurements()).unwrap() {
        assert!(picture.starts_with("<svg width=\"800\" height=\"316\" viewBox=\"0 0 8000 3160\" xmlns="));
        assert!(picture.contains("<style>") && picture.ends_with("</svg>\n"), "{picture}");
    }
}
