//! Whatever a text contains, rustdoc's own markdown parser finds paragraphs in it and nothing else.

use proptest::prelude::*;
use pulldown_cmark::{Event, LinkType, Options, Parser, Tag, TagEnd};

use super::super::{first_sentence, is_constant, is_invisible, line, prose};

/// What markdown, rustdoc, Rust and terminals act on, and words between.
const PIECES: [&str; 64] = [
    " ",
    "\n",
    "\n\n",
    "    ",
    "\t",
    "\r\n",
    "a",
    "word",
    "é",
    "漢字",
    "`",
    "``",
    "```",
    "```rust\n",
    "~~~\n",
    "*",
    "**",
    "_",
    "__",
    "~~",
    "[",
    "]",
    "[[",
    "]]",
    "(",
    ")",
    "[a](b)",
    "![a](b)",
    "[a]: b\n",
    "[^1]",
    "[^1]: a\n",
    "[x]",
    "- [ ] ",
    "<",
    ">",
    "<b>",
    "</b>",
    "<!--",
    "-->",
    "<script>",
    "&amp;",
    "&#65;",
    "&",
    "\\",
    "|",
    "|---|\n",
    "#",
    "# ",
    "=",
    "===\n",
    "---\n",
    "- ",
    "+ ",
    "1. ",
    "2) ",
    "> ",
    ": ",
    "*/",
    "/**",
    "https://a.b/c_d",
    "http://",
    "A_B",
    "\u{202e}",
    "\u{200b}",
];

/// What rustdoc switches on.
fn parse(markdown: &str) -> Vec<Event<'_>> {
    let options = Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_TASKLISTS
        | Options::ENABLE_SMART_PUNCTUATION;
    Parser::new_ext(markdown, options).collect()
}

/// Whether an event is a part of plain prose: text, a constant as code, a whole URL.
fn is_prose(event: &Event<'_>) -> bool {
    match event {
        Event::Text(_) | Event::SoftBreak | Event::Start(Tag::Paragraph) => true,
        Event::End(end) => matches!(end, TagEnd::Paragraph | TagEnd::Link),
        Event::Code(code) => is_constant(code),
        Event::Start(Tag::Link { link_type, dest_url, .. }) => {
            *link_type == LinkType::Autolink && (dest_url.starts_with("https://") || dest_url.starts_with("http://"))
        }
        _ => false,
    }
}

/// The letters and digits that a reader sees.
fn seen(events: &[Event<'_>]) -> String {
    let texts = events.iter().map(|event| match event {
        Event::Text(text) | Event::Code(text) => text.as_ref(),
        _ => "",
    });
    texts.flat_map(str::chars).filter(|letter| letter.is_alphanumeric()).collect()
}

fn letters(text: &str) -> String {
    text.chars().filter(|&letter| letter.is_alphanumeric() && !is_invisible(letter)).collect()
}

/// Everything that holds for a text, as prose, as a cell of a table, and as an item of a list.
fn check(text: &str) {
    let lines = prose(text);
    let markdown = lines.join("\n");
    let events = parse(&markdown);
    let strangers: Vec<_> = events.iter().filter(|event| !is_prose(event)).collect();
    assert!(strangers.is_empty(), "{text:?} became {markdown:?}: {strangers:?}");
    assert_eq!(seen(&events), letters(text), "{text:?} became {markdown:?}");
    for line in &lines {
        assert!(!line.starts_with([' ', '\t']) && !line.ends_with(' ') && !line.chars().any(is_invisible), "{line:?}");
    }
    let table = format!("| a | b |\n|---|---|\n| {} | c |\n", line(text));
    let cells = parse(&table).iter().filter(|event| matches!(event, Event::Start(Tag::TableCell))).count();
    assert_eq!(cells, 4, "{text:?} in a table is {table:?}");
    let item = format!("- x: {}\n", first_sentence(text));
    let list = |event: &&Event<'_>| {
        !matches!(event, Event::Start(Tag::List(None) | Tag::Item) | Event::End(TagEnd::List(_) | TagEnd::Item))
    };
    let events = parse(&item);
    assert!(events.iter().filter(list).all(is_prose), "{text:?} in a list is {item:?}");
}

#[test]
fn long_texts() {
    for piece in PIECES {
        check(&piece.repeat(10_000 / piece.len()));
        check(&format!("{piece} ").repeat(10_000 / (piece.len() + 1)));
        check(&format!("word {piece}\n").repeat(500));
    }
    check(&"word ".repeat(2000));
    check(&"w".repeat(10_000));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_mixture_is_prose(pieces in prop::collection::vec(prop::sample::select(&PIECES[..]), 0..24)) {
        check(&pieces.concat());
    }

    #[test]
    fn any_text_is_prose(text in "\\PC{0,80}") {
        check(&text);
    }
}
