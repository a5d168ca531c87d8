//! The page needs nothing but itself, and shows all that it should.

mod support;

/// Oracle: counts by hand. Nine systems, four pictures of counts, eight scenes, three of frames, six landscapes, six examples with shapes,
/// two plots of digits, two of growth.
const FIGURES: usize = 9 + 4 + 8 + 3 + 6 + 6 + 2 + 2;

/// Drawings: nine systems, six of them again beside their tables, modes of six examples, and four of the portal.
const DRAWINGS: usize = 9 + 6 + (5 + 5 + 3 + 3 + 5 + 5) + 4;

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
    assert_eq!(page.matches("<figure").count(), FIGURES);
    assert_eq!(page.matches("class=\"mstmm\"").count(), DRAWINGS);
    let order =
        ["frames", "systems", "proof", "summary", "error-time", "landscapes", "shapes", "digits", "growth", "paper"];
    let places: Vec<_> =
        order.iter().map(|section| page.find(&format!("<section id=\"{section}\">")).unwrap()).collect();
    assert!(places.is_sorted());
    // for those who do not know the paper: a portal beside programs that they know
    assert!(page.contains("<main><section id=\"frames\">"));
    for section in order {
        assert!(page.contains(&format!("<a href=\"#{section}\">")), "{section}");
    }
    // one of intervals, one of factors, one of frames, one of each example
    assert_eq!(page.matches("<table").count(), 1 + 1 + 1 + 6);
    assert!(page.contains("a win for plain method"));
}

/// Drawings bring the same style along; the page has it once, in its head.
#[test]
fn the_style_of_drawings_is_there_once() {
    let page = report::page(support::measurements()).unwrap();
    assert_eq!(page.matches("\n.mstmm .beam {").count(), 1);
    let (head, body) = page.split_once("</head>").unwrap();
    assert!(head.contains(".mstmm .beam {") && !body.contains("<style"));
}

/// The rounds of `runs` differ by a tenth each way, in every run alike: ratios of a round do not.
#[test]
fn factors_stand_with_their_spread() {
    let mut runs = support::runs();
    assert!(report::markdown(&runs).contains("| 3.00 µs | × 0.80 | "), "{}", report::markdown(&runs));
    for run in runs.iter_mut().filter(|run| run.method == "certified search") {
        run.rounds[0] *= 2.0;
    }
    // the plain method reaches 1e-6 in its second run, 2.4 µs a time against 3 µs
    assert!(report::markdown(&runs).contains("| 3.00 µs | × 0.80 (0.40–0.80) | "), "{}", report::markdown(&runs));
}

#[test]
fn recorded_frames_are_called_recorded() {
    let page = report::page(support::measurements()).unwrap();
    assert!(page.contains("Not measured with the rest of this page") && page.contains("Recorded on 20"));
    assert!(page.contains("OpenSeesPy 3.") && page.contains("PyNite"));
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
