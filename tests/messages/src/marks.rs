//! What a file of a wrong model says of its messages, under the tokens they are about: `//  ^^^^ hint`.

/// A place in a file, and words.
#[derive(Debug)]
struct Mark {
    line: usize,
    column: usize,
    width: usize,
    text: String,
}

impl Mark {
    /// Whether a message stands where the file says, under all tokens that the file says, and gives the hint.
    fn is_of(&self, message: &Mark) -> bool {
        let place = |mark: &Mark| (mark.line, mark.column, mark.width);
        place(self) == place(message) && message.text.contains(&self.text)
    }
}

/// The marks of a file, each about the line of code above it.
fn marks(source: &str) -> Vec<Mark> {
    let mut marks = Vec::new();
    let mut code = 0;
    for (index, line) in source.lines().enumerate() {
        let comment = line.strip_prefix("//").map(str::trim_start).filter(|rest| rest.starts_with('^'));
        let Some(comment) = comment else {
            code = index + 1;
            continue;
        };
        let text = comment.trim_start_matches('^');
        let width = comment.len() - text.len();
        marks.push(Mark { line: code, column: line.len() - comment.len() + 1, width, text: text.trim().to_owned() });
    }
    marks
}

/// The errors that the compiler shows, each with all its text.
fn messages(shown: &str) -> Option<Vec<Mark>> {
    shown.split("\n\n").filter(|block| block.starts_with("error")).map(message).collect()
}

/// One error: `--> file:line:column`, the line of code, and carets under it.
fn message(block: &str) -> Option<Mark> {
    let place = block.lines().find_map(|line| line.trim_start().strip_prefix("--> "))?;
    let mut numbers = place.rsplit(':').map_while(|number| number.parse::<usize>().ok());
    let (column, line) = (numbers.next()?, numbers.next()?);
    let code = format!("{line} |");
    let below = block.lines().skip_while(|text| !text.trim_start().starts_with(&code)).nth(1)?;
    // behind the bar and a space, columns are those of the file
    let carets = below.split_once('|')?.1.chars().skip(column).take_while(|c| *c == '^');
    Some(Mark { line, column, width: carets.count(), text: block.to_owned() })
}

/// Every message stands where the file says, with the hint that the file says, and there are no others.
#[test]
fn each_message_stands_where_its_file_says() {
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/refused")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        let marks = marks(&std::fs::read_to_string(&path).unwrap());
        let messages = messages(&std::fs::read_to_string(path.with_extension("stderr")).unwrap()).unwrap();
        assert!(!marks.is_empty(), "{}: no mark", path.display());
        assert_eq!(marks.len(), messages.len(), "{}: a mark for each message", path.display());
        for mark in &marks {
            assert!(!mark.text.is_empty(), "{}: no hint", path.display());
            assert!(messages.iter().any(|message| mark.is_of(message)), "{}: {mark:#?}", path.display());
        }
        for message in &messages {
            assert!(marks.iter().any(|mark| mark.is_of(message)), "{}: unmarked {message:#?}", path.display());
        }
    }
}
