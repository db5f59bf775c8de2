use super::*;

/// What somebody wrote, for an earlier state of the definitions.
const OLD: [(&str, &str); 2] = [
    (
        "old/a.xml",
        "<?xml version='1.0'?>\n<!--\n  Ours.\n-->\n<mavlink>\n  <include>common.xml</include>\n  <!-- all of them -->\n  <messages>\n\
         <message id='9000' name='KEPT'><description>Kept &amp; <![CDATA[<dear>]]>.</description>\
         <!-- in units --><field type='uint8_t' name='level'>How\r\n        full.</field>\
         <field type='uint8_t' name='gone'>Lost.</field></message>\n\
         <message id='9001' name='MOVED'><description>Moves.</description><field type='uint8_t' name='x'>Goes along.</field></message>\n\
         <!-- the end --></messages></mavlink>",
    ),
    (
        "old/common.xml",
        "<mavlink><enums><enum name='STATE'><deprecated since='2020-01' replaced_by=''>Too coarse.</deprecated>\
         <description>States.</description><entry value='0' name='STATE_OFF'><description>Off.</description>\
         <param index='1'>One.</param></entry></enum></enums><messages/></mavlink>",
    ),
];

/// The definitions as they are now, with prose that nobody wants.
const NEW: [(&str, &str); 2] = [
    (
        "a.xml",
        "<mavlink><!-- THEIRS --><include>common.xml</include><enums><enum name='STATE'><entry value='9' name='STATE_OWN'/></enum></enums>\
         <messages><message id='9000' name='KEPT'><description>THEIRS</description>\
         <field type='uint8_t' name='new'>THEIRS</field><field type='uint8_t' name='level' units='%'>THEIRS</field></message></messages></mavlink>",
    ),
    (
        "common.xml",
        "<mavlink><enums><enum name='STATE'><deprecated since='2020-01' replaced_by='X'>THEIRS</deprecated>\
         <entry value='0' name='STATE_OFF'><description>THEIRS</description><param index='1' label='L'>THEIRS</param></entry></enum></enums>\
         <messages><message id='9001' name='MOVED'><description>THEIRS</description><field type='uint8_t' name='x'>THEIRS</field></message></messages></mavlink>",
    ),
];

fn both() -> tempfile::TempDir {
    folder(&[&OLD[..], &NEW[..]].concat())
}

fn described(folder: &Path) -> Vendored {
    copies(folder, &Prose::From(folder.join("old")))
}

#[test]
fn new_facts_with_old_words() {
    let folder = both();
    let vendored = described(folder.path());
    let a = r#"<!--
  Ours.
-->
<mavlink>
  <include>common.xml</include>
  <enums>
    <enum name="STATE">
      <entry value="9" name="STATE_OWN"/>
    </enum>
  </enums>
  <!-- all of them -->
  <messages>
    <message id="9000" name="KEPT">
      <description>Kept &amp; <![CDATA[<dear>]]>.</description>
      <field type="uint8_t" name="new"/>
      <!-- in units -->
      <field type="uint8_t" name="level" units="%">How
        full.</field>
    </message>
    <!-- the end -->
  </messages>
</mavlink>
"#;
    assert_eq!(below_header(text(&vendored, "a.xml")), a);
    let common = r#"<mavlink>
  <enums>
    <enum name="STATE">
      <deprecated since="2020-01" replaced_by="X">Too coarse.</deprecated>
      <description>States.</description>
      <entry value="0" name="STATE_OFF">
        <description>Off.</description>
        <param index="1" label="L">One.</param>
      </entry>
    </enum>
  </enums>
  <messages>
    <message id="9001" name="MOVED">
      <description>Moves.</description>
      <field type="uint8_t" name="x">Goes along.</field>
    </message>
  </messages>
</mavlink>
"#;
    assert_eq!(below_header(text(&vendored, "common.xml")), common);
}

#[test]
fn what_is_lost_and_what_is_new_is_said() {
    let folder = both();
    let vendored = described(folder.path());
    let lost: Vec<(&str, &str)> =
        vendored.unplaced.iter().map(|lost| (lost.name.as_str(), lost.words.as_str())).collect();
    assert_eq!(lost, [("message KEPT field gone", "Lost.")]);
    assert_eq!(vendored.unplaced[0].file, folder.path().join("old/a.xml"));
    let items = || vendored.files.iter().flat_map(|file| &file.items);
    let bare: Vec<(&str, bool)> =
        items().filter(|item| !item.described).map(|item| (item.name.as_str(), item.new)).collect();
    assert_eq!(bare, [("enum STATE", false), ("enum STATE entry STATE_OWN", true), ("message KEPT field new", true)]);
    assert_eq!(items().filter(|item| item.described).count(), 7);
}

/// The folder of the copies may be the one that the descriptions are in: that is how definitions are kept current.
#[test]
fn again_is_the_same() {
    let folder = both();
    let out = written(&described(folder.path()), folder.path());
    let again = copies(folder.path(), &Prose::From(out.clone()));
    assert_eq!(again.unplaced, []);
    let done = super::super::write(&out, &again).unwrap();
    assert_eq!((done.written, done.kept), (0, 2));
}

#[test]
fn a_broken_file_of_descriptions_is_an_error() {
    let folder = both();
    put(&folder.path().join("old/common.xml"), "<mavlink><enums></mavlink>");
    let failure =
        vendor(&Builder::new(folder.path().join("a.xml")), &Prose::From(folder.path().join("old"))).unwrap_err();
    assert!(failure.to_string().contains("common.xml:1"), "{failure}");
    let failure =
        vendor(&Builder::new(folder.path().join("a.xml")), &Prose::From(folder.path().join("none"))).unwrap_err();
    assert!(failure.to_string().contains("no such folder"), "{failure}");
}
