//! What prose becomes; [`hostile`] is prose that nobody would write.

mod hostile;

use super::*;

#[test]
fn paragraphs_are_folded() {
    assert_eq!(prose("  One\n\t two.\n\n\n    three\n"), ["One two.", "", "three"]);
    assert_eq!(prose(" \n "), [""; 0]);
    assert_eq!(first_sentence("One two. Three."), "One two.");
    assert!(prose(&"word ".repeat(1000)).iter().all(|line| line.len() <= WIDTH));
}

#[test]
fn markdown_is_defused() {
    for (text, safe) in [
        ("see [0..10] *x* ``` <b> */", r"see \[0..10\] \*x\* \`\`\` \<b\> \*/"),
        ("- not a list", r"\- not a list"),
        ("1. not a list", r"1\. not a list"),
        ("# not a heading", r"\# not a heading"),
        ("=====", r"\====="),
        ("use MAV_CMD_NAV_LAND.", "use `MAV_CMD_NAV_LAND`."),
        ("snake_case _edge_", r"snake_case \_edge\_"),
        ("(https://mavlink.io/en/).", "(<https://mavlink.io/en/>)."),
        ("ftp://[x]", r"ftp: //\[x\]"),
        ("a&amp;b | c", r"a\&amp;b \| c"),
        ("right\u{202e}left\u{0}", "rightleft"),
    ] {
        assert_eq!(prose(text).join("\n"), safe);
    }
}
