//! Definitions, frames of them, and the command.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use mavgen::Builder;
use mavgen::decode::Tables;
use mavlink_wire::{Encode, MAX_FRAME, MAX_PAYLOAD, MessageInfo, Sender};

pub(crate) const ACME: &str = r#"<mavlink>
  <version>3</version>
  <enums>
    <enum name="SPRAY_STATE">
      <entry value="0" name="SPRAY_STATE_OFF"/>
      <entry value="1" name="SPRAY_STATE_ON"/>
    </enum>
    <enum name="SPRAY_FLAGS" bitmask="true">
      <entry value="1" name="SPRAY_FLAGS_LEAK"/>
      <entry value="4" name="SPRAY_FLAGS_COLD"/>
    </enum>
  </enums>
  <messages>
    <message id="100" name="SPRAYER">
      <description/>
      <field type="uint8_t" name="state" enum="SPRAY_STATE"/>
      <field type="uint8_t" name="flags" enum="SPRAY_FLAGS"/>
      <field type="uint16_t" name="level" units="cm" invalid="UINT16_MAX"/>
      <field type="float[2]" name="flow" units="g/min" invalid="[NaN]"/>
      <field type="double" name="total"/>
      <field type="char[8]" name="label"/>
    </message>
    <message id="101" name="NOZZLES">
      <description/>
      <field type="uint8_t" name="count"/>
      <field type="uint8_t[3]" name="id"/>
      <field type="uint16_t[3]" name="word"/>
      <field type="uint8_t" name="mode"/>
    </message>
  </messages>
</mavlink>
"#;

pub(crate) const SIGNING: &str = r#"<mavlink>
  <messages>
    <message id="256" name="SETUP_SIGNING">
      <description/>
      <field type="uint8_t[32]" name="secret_key"/>
      <field type="uint8_t" name="target_system"/>
    </message>
  </messages>
</mavlink>
"#;

const OVERLAY: &str = r#"<mavlink-overlay version="1" for="acme.xml">
  <message name="SPRAYER">
    <bind name="mode" field="level" enum="SPRAY_LEVEL" if="state" is="SPRAY_STATE_ON"/>
  </message>
  <enums><enum name="SPRAY_LEVEL"><entry value="7" name="SPRAY_LEVEL_LOW"/><entry value="300" name="SPRAY_LEVEL_HIGH"/></enum></enums>
  <message name="NOZZLES">
    <view name="NOZZLE_STATUS" words="word[i]" item="nozzle" items="nozzles" count="count">
      <key name="id" field="id[i]" invalid="255"/>
      <invalid value="0"/>
      <bits name="state" at="0" width="1" enum="SPRAY_STATE"/>
      <bits name="angle" at="1" width="7" signed="true" scale="1/4" units="deg"/>
      <switch field="mode">
        <case value="1"><bits name="open" at="8" width="1" repeat="8"/></case>
        <default><bits name="speed" at="8" width="8" units="mm/s"/></default>
      </switch>
    </view>
  </message>
</mavlink-overlay>
"#;

/// A message in bytes.
struct Sent {
    info: &'static MessageInfo,
    payload: Vec<u8>,
}

impl Encode for Sent {
    fn info(&self) -> &'static MessageInfo {
        self.info
    }

    fn write(&self, payload: &mut [u8; MAX_PAYLOAD]) {
        payload[..self.payload.len()].copy_from_slice(&self.payload);
    }
}

/// A folder with the definitions, and frames of them.
pub(crate) struct Bench {
    pub(crate) folder: tempfile::TempDir,
    pub(crate) tables: Tables,
    sender: Sender,
}

impl Bench {
    pub(crate) fn new() -> Self {
        let bench = Self::of(ACME);
        fs::write(bench.folder.path().join("acme.overlay.xml"), OVERLAY).unwrap();
        bench
    }

    pub(crate) fn of(xml: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("acme.xml"), xml).unwrap();
        let dialect = Builder::new(folder.path().join("acme.xml")).resolve().unwrap().dialect;
        Self { folder, tables: Tables::leak(&dialect), sender: Sender::v2(1, 2) }
    }

    pub(crate) fn frame(&mut self, id: u32, payload: &[u8]) -> Vec<u8> {
        let sent = Sent { info: self.tables.table().get(id).unwrap(), payload: payload.to_vec() };
        self.sender.encode(&sent, &mut [0; MAX_FRAME]).unwrap().to_vec()
    }

    pub(crate) fn sprayer(&mut self) -> Vec<u8> {
        let mut payload = vec![];
        payload.extend(0.1_f64.to_le_bytes());
        payload.extend(f32::NAN.to_le_bytes());
        payload.extend(0.1_f32.to_le_bytes());
        payload.extend(300_u16.to_le_bytes());
        payload.extend([1, 0x45]);
        payload.extend(b"a,\"b\xff");
        self.frame(100, &payload)
    }

    /// Three slots, of which the second says nothing and the third is not in use.
    pub(crate) fn nozzles(&mut self, mode: u8) -> Vec<u8> {
        let words = [0x03fd_u16, 0, 0xffff].map(u16::to_le_bytes).concat();
        self.frame(101, &[&words[..], &[2, 9, 255, 7, mode]].concat())
    }

    pub(crate) fn decode(&self, arguments: &[&str], input: &[u8]) -> Output {
        decode(self.folder.path(), arguments, input)
    }

    /// What is printed with the overlay, from standard input.
    pub(crate) fn printed(&self, arguments: &[&str], input: &[u8]) -> String {
        self.printed_without(&[&["--overlay", "acme.overlay.xml"], arguments].concat(), input)
    }

    pub(crate) fn printed_without(&self, arguments: &[&str], input: &[u8]) -> String {
        let output = self.decode(&[&["acme.xml"], arguments].concat(), input);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        String::from_utf8(output.stdout).unwrap()
    }
}

pub(crate) fn decode(folder: &Path, arguments: &[&str], input: &[u8]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_mavgen"));
    let command = command.current_dir(folder).arg("decode").args(arguments);
    let command = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    // A command that refuses its arguments does not read.
    let _ = child.stdin.take().unwrap().write_all(input);
    child.wait_with_output().unwrap()
}

pub(crate) fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}
