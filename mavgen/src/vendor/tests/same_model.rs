use std::path::Path;

use super::*;
use crate::ir::{Dialect, Lifecycle, Origin};
use crate::source::{Sources, Span};

/// Everything that XML can do, and prose wherever it can hide: each piece of it has the word PROSE.
const HOSTILE: &str = "\u{feff}<?xml version='1.0' encoding='UTF-8' standalone='yes'?>\r\n\
<!-- PROSE -->\r\n\
<?instruction PROSE?>\r\n\
<mavlink xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance' xsi:noNamespaceSchemaLocation='mavlink.xsd' note='PROSE'>\r\n\
  <include><![CDATA[ parts/common.xml ]]></include><include>d&#46;xml</include>\r\n\
  <version> <!-- PROSE -->7</version>\r\n\
  <authors>PROSE <name>PROSE</name></authors>\r\n\
  <enums>\r\n\
    <enum bitmask='true' name='A&#95;FLAGS'><description>PROSE <![CDATA[<b>PROSE & more</b>]]> &lt;PROSE&gt;</description>\r\n\
      <!-- PROSE --><entry value='2**3' name='A_FLAGS_X' note=\"PROSE\"><description/></entry>\r\n\
      <entry name='A_FLAGS_Y' value='0b10000'><deprecated since='2020-01' replaced_by='the \"other\" one'>PROSE\r\n\
      </deprecated></entry></enum>\r\n\
    <enum name='A_CMD'><entry value='7' name='A_CMD_GO' hasLocation='true' isDestination='false'><description>PROSE</description><wip/>\r\n\
      <param index='1' label='How &lt;far&gt;' units='m' minValue='-1' maxValue='1e3' increment='0.5' enum='COMMON_STATE' decimalPlaces='2'>PROSE</param>\r\n\
      <param index='2' reserved='true' default='NaN'/></entry><entry name='A_CMD_STOP'/></enum>\r\n\
  </enums>\r\n\
  <messages>\r\n\
    <message name='A_MESSAGE' id='9000'><wip since='2024-07'>PROSE<description>PROSE</description></wip><description>\r\nPROSE,\r\n\r\nin lines.\r\n</description>\r\n\
      <field type='uint8_t' name='b'\r\n\t enum='COMMON_STATE'>PROSE <!-- PROSE --> PROSE</field>\r\n\
      <field name='its' type='uint16_t[4]' units='c%' invalid='[UINT16_MAX:]' minValue='1' maxValue='5' increment='2' multiplier='1E-2' print_format='0x%04x'>PROSE</field>\r\n\
      <field type='uint8_t_mavlink_version' name='version'><description>PROSE</description></field>\r\n\
      <extensions><!-- PROSE --></extensions>\r\n\
      <field type='char[20]' name='text' default='0' instance='true'/>\r\n\
      <field type='uint8_t' name='flags' enum='A_FLAGS' display='bitmask'>PROSE</field></message>\r\n\
  </messages>\r\n\
</mavlink>\r\n\
<!-- PROSE -->";

const COMMON: &str = "<mavlink><include>../d.xml</include><enums><enum name='COMMON_STATE'><entry value='0' name='COMMON_STATE_OFF'/>\
    <entry value='1' name='COMMON_STATE_ON'><description>PROSE</description></entry></enum></enums><messages/></mavlink>";

const D: &str = "<mavlink><version>3</version><enums/><messages><message id='1' name='D'><description>PROSE</description>\
    <field type='uint8_t_mavlink_version' name='version'/></message></messages></mavlink>";

fn hostile() -> tempfile::TempDir {
    folder(&[("a.xml", HOSTILE), ("parts/common.xml", COMMON), ("d.xml", D)])
}

fn model(xml: &Path, prose: bool) -> String {
    shown(Builder::new(xml).resolve().unwrap_or_else(|failure| panic!("{failure}")).dialect, prose)
}

/// The model, all of it, without places; `prose` says whether descriptions are part of it.
pub(super) fn shown(mut dialect: Dialect, prose: bool) -> String {
    let nowhere = Span::new(Sources::default().add("", ""), 0..0);
    for origin in origins(&mut dialect) {
        origin.span = nowhere;
        if prose {
            // As XML reads line ends.
            origin.description = origin.description.replace("\r\n", "\n");
            continue;
        }
        origin.description.clear();
        if let Some(Lifecycle::Deprecated(successor) | Lifecycle::Superseded(successor)) = &mut origin.lifecycle {
            successor.description.clear();
        }
    }
    format!("{dialect:#?}")
}

fn origins(dialect: &mut Dialect) -> Vec<&mut Origin> {
    let mut origins = Vec::new();
    for enum_ in &mut dialect.enums {
        origins.push(&mut enum_.origin);
        for entry in &mut enum_.entries {
            origins.push(&mut entry.origin);
            origins.extend(
                entry.command.iter_mut().flat_map(|command| &mut command.params).map(|param| &mut param.origin),
            );
        }
    }
    for message in &mut dialect.messages {
        origins.push(&mut message.origin);
        origins.extend(message.fields.iter_mut().map(|field| &mut field.origin));
    }
    origins
}

#[test]
fn a_whole_copy() {
    let folder = hostile();
    let out = written(&copies(folder.path(), &Prose::Keep), folder.path());
    assert_eq!(model(&out.join("a.xml"), true), model(&folder.path().join("a.xml"), true));
}

#[test]
fn a_whole_copy_is_its_source_byte_for_byte() {
    let folder = hostile();
    let vendored = copies(folder.path(), &Prose::Keep);
    let (head, below) = text(&vendored, "a.xml").split_once("<!-- PROSE -->").unwrap();
    let (source_head, source_below) = HOSTILE.split_once("<!-- PROSE -->").unwrap();
    assert!(
        head.starts_with(source_head.trim_start_matches('\u{feff}'))
            && head.contains("unchanged below but for its includes")
    );
    assert_eq!(below, source_below.replace("<![CDATA[ parts/common.xml ]]>", "common.xml"));
    let (header, common) = text(&vendored, "common.xml").split_once('\n').unwrap();
    assert!(header.contains("from common.xml"));
    assert_eq!(common, COMMON.replace("../d.xml", "d.xml"));
}

#[test]
fn the_facts_alone() {
    let folder = hostile();
    let vendored = copies(folder.path(), &Prose::Drop);
    for file in &vendored.files {
        assert!(!file.text.contains("PROSE"), "{}", file.text);
    }
    let out = written(&vendored, folder.path());
    assert_eq!(model(&out.join("a.xml"), false), model(&folder.path().join("a.xml"), false));
    assert_ne!(model(&out.join("a.xml"), true), model(&folder.path().join("a.xml"), true), "there was prose");
}

/// One element a line, two spaces a level, the order of `mavlink.xsd`, and the description that it demands of a message.
#[test]
fn facts_are_laid_out_for_people() {
    let folder = hostile();
    let vendored = copies(folder.path(), &Prose::Drop);
    let expected = r#"<mavlink xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="mavlink.xsd">
  <include>common.xml</include>
  <include>d.xml</include>
  <version>7</version>
  <enums>
    <enum bitmask="true" name="A&#95;FLAGS">
      <entry value="2**3" name="A_FLAGS_X"/>
      <entry name="A_FLAGS_Y" value="0b10000">
        <deprecated since="2020-01" replaced_by='the "other" one'/>
      </entry>
    </enum>
    <enum name="A_CMD">
      <entry value="7" name="A_CMD_GO" hasLocation="true" isDestination="false">
        <wip/>
        <param index="1" label="How &lt;far&gt;" units="m" minValue="-1" maxValue="1e3" increment="0.5" enum="COMMON_STATE" decimalPlaces="2"/>
        <param index="2" reserved="true" default="NaN"/>
      </entry>
      <entry name="A_CMD_STOP"/>
    </enum>
  </enums>
  <messages>
    <message name="A_MESSAGE" id="9000">
      <wip since="2024-07"/>
      <description/>
      <field type="uint8_t" name="b" enum="COMMON_STATE"/>
      <field name="its" type="uint16_t[4]" units="c%" invalid="[UINT16_MAX:]" minValue="1" maxValue="5" increment="2" multiplier="1E-2" print_format="0x%04x"/>
      <field type="uint8_t_mavlink_version" name="version"/>
      <extensions/>
      <field type="char[20]" name="text" default="0" instance="true"/>
      <field type="uint8_t" name="flags" enum="A_FLAGS" display="bitmask"/>
    </message>
  </messages>
</mavlink>
"#;
    assert_eq!(below_header(text(&vendored, "a.xml")), expected);
}

#[test]
fn a_copy_of_a_copy_says_the_same() {
    let folder = hostile();
    let out = written(&copies(folder.path(), &Prose::Drop), folder.path());
    let again = copies(&out, &Prose::Drop);
    for file in &again.files {
        assert_eq!(below_header(&file.text), below_header(&fs::read_to_string(out.join(&file.name)).unwrap()));
    }
}
