//! What XML allows and readers get wrong: the same definition, spelled in unusual ways, means the same.

#![expect(clippy::unwrap_used, reason = "a test may panic")]

use mavgen::Resolved;
use mavgen::diag::Diagnostics;
use mavgen::ir::Dialect;
use mavgen::read::{Loaded, read};
use mavgen::source::Sources;

const PLAIN: &str = "\
<?xml version=\"1.0\"?>
<mavlink>
  <version>3</version>
  <enums>
    <enum name=\"PUMP_STATE\" bitmask=\"true\">
      <description>Is &lt;on&gt; &amp; \"off\".</description>
      <entry value=\"1\" name=\"PUMP_STATE_ON\"/>
    </enum>
  </enums>
  <messages>
    <message id=\"100\" name=\"PUMP_STATUS\">
      <description>State of a pump.</description>
      <field type=\"uint8_t\" name=\"state\" enum=\"PUMP_STATE\" units=\"us\">What it's at.</field>
      <extensions/>
      <field type=\"float\" name=\"flow\" units=\"m/s\" invalid=\"NaN\">How fast.</field>
    </message>
  </messages>
</mavlink>
";

/// Resolves a text of which nothing is to be said, and takes what it means without the places.
fn meaning(text: &str) -> String {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let file = read(sources.add("a.xml", text), &sources, &mut diagnostics);
    let loaded =
        Loaded { name: "a".to_owned(), files: vec![file.into()], includes: vec![Vec::new()], ..Loaded::default() };
    let resolved = Resolved::of(loaded, sources, diagnostics).unwrap();
    assert!(resolved.diagnostics.is_empty(), "{:?}\n{text}", resolved.diagnostics);
    facts(&resolved.dialect)
}

fn facts(dialect: &Dialect) -> String {
    let mut facts = format!("version {}\n", dialect.version);
    for values in &dialect.enums {
        facts += &format!("{} {} {}\n", values.name.text, values.bitmask, values.origin.description);
        for entry in &values.entries {
            facts += &format!("  {} {} {}\n", entry.value, entry.name.text, entry.origin.description);
        }
    }
    for message in &dialect.messages {
        let (name, about) = (&message.name.text, &message.origin.description);
        facts += &format!("{} {name} {} {} {about}\n", message.id, message.crc_extra, message.len_v1);
        for field in &message.fields {
            let (name, about) = (&field.name.text, &field.origin.description);
            facts += &format!("  {name} {:?} {} {:?} ", field.ty, field.offset, field.values);
            facts += &format!("{:?} {:?} {} {about}\n", field.units, field.invalid, field.extension);
        }
    }
    facts
}

/// A spelling with one thing changed; what is changed has to be there.
fn with(from: &str, to: &str) -> String {
    assert!(PLAIN.contains(from), "{from}");
    PLAIN.replace(from, to)
}

#[test]
fn texts_and_attributes_can_be_spelled_in_many_ways() {
    let plain = meaning(PLAIN);
    for text in [
        with("State of a pump.", "&#83;tate of &#x61; pump."),
        with("State of a pump.", "<![CDATA[State of a pump.]]>"),
        with("State of a pump.", "State <![CDATA[of]]> a pump."),
        with("State of a pump.", "State<!-- hidden --> of a pump."),
        with("State of a pump.", "State of<?php echo 1 ?> a pump."),
        with("&lt;on&gt; &amp; \"off\"", "<![CDATA[<on> & \"off\"]]>"),
        with("&lt;on&gt; &amp; \"off\"", "&#60;on> &#38; &quot;off&quot;"),
        with("it's", "it&apos;s"),
        with("name=\"flow\"", "name='flow'"),
        with("name=\"flow\"", "name\n=\n\t\"flow\""),
        with("name=\"flow\"", "name=\"fl&#111;w\""),
        with("id=\"100\" name=\"PUMP_STATUS\"", "name=\"PUMP_STATUS\" id=\"100\""),
        with("id=\"100\" name=\"PUMP_STATUS\"", "name='PUMP_STATUS'\r\n\tid='100'"),
        with("value=\"1\"", "value=\" 1 \""),
        with("value=\"1\"", "value=\"0x01\""),
        with("<extensions/>", "<extensions></extensions>"),
        with("<extensions/>", "<extensions />"),
        with("<extensions/>", "<extensions>\n<!-- later -->\n</extensions>"),
        with("<version>3</version>", "<version>\n3\n</version>"),
        with("<version>3</version>", "<version><!-- 4 -->3</version>"),
        with("<entry value=\"1\" name=\"PUMP_STATE_ON\"/>", "<entry value=\"1\" name=\"PUMP_STATE_ON\"></entry >"),
    ] {
        assert_eq!(meaning(&text), plain, "{text}");
    }
}

#[test]
fn files_can_be_spelled_in_many_ways() {
    let plain = meaning(PLAIN);
    for text in [
        format!("\u{feff}{PLAIN}"),
        PLAIN.replace('\n', "\r\n"),
        PLAIN.replace('\n', "").replace("  ", ""),
        PLAIN.replace("  ", "\t"),
        with("<?xml version=\"1.0\"?>\n", ""),
        with("<?xml version=\"1.0\"?>", "<?xml version='1.0' encoding='utf-8' standalone='yes'?>"),
        with("<?xml version=\"1.0\"?>", "<?xml version=\"1.0\"?><?xml-stylesheet href=\"a.xsl\"?><!-- a -->"),
        with(
            "<mavlink>",
            "<mavlink xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' xsi:noNamespaceSchemaLocation='a.xsd'>",
        ),
        with("<mavlink>", "<mavlink file=\"a.xml\" >"),
        with("</mavlink>\n", "</mavlink>"),
        with("</mavlink>\n", "</mavlink>\n<!-- the end -->\n<?done?>\n\n"),
        with("  <messages>", "  <enums/><messages></messages><messages>"),
    ] {
        assert_eq!(meaning(&text), plain, "{text}");
    }
}
