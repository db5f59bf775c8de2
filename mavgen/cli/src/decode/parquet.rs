//! Typed tables in a folder: a Parquet file for each message, `ATTITUDE.parquet`.
//!
//! Columns are those of CSV, without units in their names: units are in the metadata of the file, as JSON under the key `units`.
//! `time` is a timestamp in UTC. What the sender does not know is null.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use mavgen::Failure;
use mavgen::decode::{Contents, Node};
use parquet::basic::{Compression, LogicalType, Repetition, TimeUnit, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, FloatType, Int32Type, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::Type;
use serde_json::{Map, Value};

use super::columns::{Columns, Kind, cells};
use super::received::Received;
use super::text::plain;

/// What the files say that made them, and what they are recognised by.
const CREATED_BY: &str = concat!("mavgen decode ", env!("CARGO_PKG_VERSION"));

/// Rows that are held in memory before they are written.
const GROUP: usize = 16_384;

/// The columns in front of those of the message.
const FRAME: [(&str, Kind); 3] = [
    ("system_id", Kind::Integer { bits: 8, signed: false }),
    ("component_id", Kind::Integer { bits: 8, signed: false }),
    ("sequence", Kind::Integer { bits: 8, signed: false }),
];

/// The tables of a run.
pub(super) struct Folder {
    path: PathBuf,
    /// By the name of the message.
    tables: BTreeMap<String, Table>,
}

struct Table {
    columns: Columns,
    /// Made when the first row comes.
    open: Option<Open>,
}

/// A file, and the rows that are not in it yet.
struct Open {
    path: PathBuf,
    writer: SerializedFileWriter<File>,
    buffers: Vec<Buffer>,
    rows: usize,
}

/// The values of one column, and which rows have one.
struct Buffer {
    values: Values,
    present: Vec<i16>,
}

enum Values {
    Int32(Vec<i32>),
    Int64(Vec<i64>),
    Float(Vec<f32>),
    Double(Vec<f64>),
    Flag(Vec<bool>),
    Text(Vec<ByteArray>),
}

impl Folder {
    /// A folder for these messages. Nothing is written before there is something to write.
    pub(super) fn new(path: &Path, messages: impl Iterator<Item = (String, Columns)>) -> Self {
        let tables = messages.map(|(name, columns)| (name, Table { columns, open: None }));
        Self { path: path.to_owned(), tables: tables.collect() }
    }

    /// Adds a row to the table of a message.
    pub(super) fn add(&mut self, name: &str, received: &Received<'_>, contents: &Contents) -> Result<(), Failure> {
        let Some(Table { columns, open }) = self.tables.get_mut(name) else { return Ok(()) };
        let open = match open {
            Some(open) => open,
            None => open.insert(Open::create(&self.path, name, columns)?),
        };
        open.add(columns, received, contents)
    }

    /// Writes what is left; how many files there are.
    pub(super) fn finish(self) -> Result<usize, Failure> {
        let mut count = 0;
        for open in self.tables.into_values().filter_map(|table| table.open) {
            open.finish()?;
            count += 1;
        }
        Ok(count)
    }
}

impl Open {
    fn create(folder: &Path, message: &str, columns: &Columns) -> Result<Self, Failure> {
        let path = folder.join(format!("{message}.parquet"));
        let file = create(folder, &path).map_err(|error| refused(&path, error))?;
        let units =
            columns.columns.iter().filter_map(|column| Some((column.path.1.clone(), column.units.clone()?.into())));
        let units = Value::Object(units.collect::<Map<String, Value>>()).to_string();
        let metadata = [("message", message.to_owned()), ("units", units)];
        let metadata = metadata.map(|(key, value)| KeyValue { key: key.to_owned(), value: Some(value) });
        let properties = WriterProperties::builder()
            .set_created_by(CREATED_BY.to_owned())
            .set_compression(Compression::SNAPPY)
            .set_key_value_metadata(Some(metadata.to_vec()))
            .build();
        let schema = schema(message, columns).map_err(|error| refused(&path, error))?;
        let writer = SerializedFileWriter::new(file, schema, Arc::new(properties));
        let writer = writer.map_err(|error| refused(&path, error))?;
        let kinds = FRAME.iter().map(|&(_, kind)| kind).chain(columns.columns.iter().map(|column| column.kind));
        let time = Buffer { values: Values::Int64(Vec::new()), present: Vec::new() };
        let buffers = [time].into_iter().chain(kinds.map(Buffer::new)).collect();
        Ok(Self { path, writer, buffers, rows: 0 })
    }

    fn add(&mut self, columns: &Columns, received: &Received<'_>, contents: &Contents) -> Result<(), Failure> {
        let (frame, cells) = (&received.frame, cells(contents));
        let time = received.time.map(|time| Node::Unsigned(time.0.into()));
        let sender = [frame.system_id().to_u32(), frame.component_id().to_u32(), frame.sequence().into()];
        let sender = sender.map(|id| Some(Node::Unsigned(id.into())));
        let head: Vec<Option<Node>> = [time].into_iter().chain(sender).collect();
        let values = columns.columns.iter().map(|column| cells.get(&column.path).copied());
        for (buffer, value) in self.buffers.iter_mut().zip(head.iter().map(Option::as_ref).chain(values)) {
            buffer.push(value);
        }
        self.rows += 1;
        if self.rows == GROUP { self.write_group() } else { Ok(()) }
    }

    /// Writes the rows that are held.
    fn write_group(&mut self) -> Result<(), Failure> {
        self.rows = 0;
        let path = &self.path;
        let mut group = self.writer.next_row_group().map_err(|error| refused(path, error))?;
        for buffer in &mut self.buffers {
            let Some(mut column) = group.next_column().map_err(|error| refused(path, error))? else { break };
            buffer.write(&mut column).map_err(|error| refused(path, error))?;
            column.close().map_err(|error| refused(path, error))?;
        }
        group.close().map(drop).map_err(|error| refused(path, error))
    }

    fn finish(mut self) -> Result<(), Failure> {
        if self.rows > 0 {
            self.write_group()?;
        }
        let Self { path, writer, .. } = self;
        writer.close().map_err(|error| refused(&path, error))?;
        fs::rename(unfinished(&path), &path).map_err(|error| refused(&path, error))
    }
}

impl Buffer {
    fn new(kind: Kind) -> Self {
        let values = match kind {
            Kind::Integer { bits: 64, .. } => Values::Int64(Vec::new()),
            Kind::Integer { .. } => Values::Int32(Vec::new()),
            Kind::Float => Values::Float(Vec::new()),
            Kind::Double => Values::Double(Vec::new()),
            Kind::Flag => Values::Flag(Vec::new()),
            Kind::Text => Values::Text(Vec::new()),
        };
        Self { values, present: Vec::new() }
    }

    fn push(&mut self, node: Option<&Node>) {
        let pushed = node.is_some_and(|node| self.values.push(node));
        debug_assert!(pushed || node.is_none(), "{node:?} is of another type than its column");
        self.present.push(pushed.into());
    }

    fn write(&mut self, column: &mut SerializedColumnWriter<'_>) -> Result<(), ParquetError> {
        fn put<T: DataType>(
            column: &mut SerializedColumnWriter<'_>,
            values: &mut Vec<T::T>,
            present: &[i16],
        ) -> Result<(), ParquetError> {
            column.typed::<T>().write_batch(values, Some(present), None)?;
            values.clear();
            Ok(())
        }
        let present = std::mem::take(&mut self.present);
        match &mut self.values {
            Values::Int32(values) => put::<Int32Type>(column, values, &present),
            Values::Int64(values) => put::<Int64Type>(column, values, &present),
            Values::Float(values) => put::<FloatType>(column, values, &present),
            Values::Double(values) => put::<DoubleType>(column, values, &present),
            Values::Flag(values) => put::<BoolType>(column, values, &present),
            Values::Text(values) => put::<ByteArrayType>(column, values, &present),
        }
    }
}

impl Values {
    /// Adds a value; whether it has the type of the column. Unsigned integers are kept by their bits.
    fn push(&mut self, node: &Node) -> bool {
        match (self, node) {
            (Self::Int32(values), &Node::Unsigned(value)) => values.push(value as u32 as i32),
            (Self::Int32(values), &Node::Signed(value)) => values.push(value as i32),
            (Self::Int64(values), &Node::Unsigned(value)) => values.push(value as u64 as i64),
            (Self::Int64(values), &Node::Signed(value)) => values.push(value as i64),
            (Self::Float(values), &Node::Float(value)) => values.push(value),
            (Self::Double(values), node) => match double(node) {
                Some(value) => values.push(value),
                None => return false,
            },
            (Self::Flag(values), &Node::Flag(value)) => values.push(value),
            (Self::Text(values), node) => values.push(plain(node).as_str().into()),
            _ => return false,
        }
        true
    }
}

fn double(node: &Node) -> Option<f64> {
    Some(match *node {
        Node::Double(value) => value,
        Node::Float(value) => value.into(),
        Node::Scaled(ratio) => ratio.to_f64(),
        Node::Unsigned(value) => value as f64,
        Node::Signed(value) => value as f64,
        _ => return None,
    })
}

/// The types of the columns: all may be null.
fn schema(message: &str, columns: &Columns) -> Result<Arc<Type>, ParquetError> {
    let instant = LogicalType::timestamp(true, TimeUnit::MICROS);
    let time = column("time", Physical::INT64, Some(instant))?;
    let frame = FRAME.iter().map(|&(name, kind)| (name, kind));
    let values = columns.columns.iter().map(|column| (column.path.1.as_str(), column.kind));
    let typed = frame.chain(values).map(|(name, kind)| {
        let (physical, logical) = types(kind);
        column(name, physical, logical)
    });
    let fields = [Ok(time)].into_iter().chain(typed).collect::<Result<Vec<_>, _>>()?;
    Ok(Arc::new(Type::group_type_builder(message).with_fields(fields).build()?))
}

fn column(name: &str, physical: Physical, logical: Option<LogicalType>) -> Result<Arc<Type>, ParquetError> {
    let column = Type::primitive_type_builder(name, physical).with_repetition(Repetition::OPTIONAL);
    column.with_logical_type(logical).build().map(Arc::new)
}

fn types(kind: Kind) -> (Physical, Option<LogicalType>) {
    match kind {
        Kind::Integer { bits, signed } => {
            let physical = if bits == 64 { Physical::INT64 } else { Physical::INT32 };
            (physical, Some(LogicalType::integer(bits, signed)))
        }
        Kind::Float => (Physical::FLOAT, None),
        Kind::Double => (Physical::DOUBLE, None),
        Kind::Flag => (Physical::BOOLEAN, None),
        Kind::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
    }
}

/// A new file, in place of one of an earlier run; no other file is written over.
fn create(folder: &Path, path: &Path) -> io::Result<File> {
    fs::create_dir_all(folder)?;
    match File::open(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
        Err(_) => {}
        Ok(file) => {
            if !is_own(file)? {
                return Err(io::Error::other(
                    "`mavgen decode` did not write this file: remove it, or choose another folder",
                ));
            }
        }
    }
    File::create(unfinished(path))
}

/// What a table is called until it is whole: no reader finds a part of one.
fn unfinished(path: &Path) -> PathBuf {
    path.with_extension("parquet.part")
}

/// Whether a file is an earlier table: its last part says what made it.
fn is_own(mut file: File) -> io::Result<bool> {
    let length = file.metadata()?.len();
    if length < 8 {
        return Ok(false);
    }
    let mut end = [0; 8];
    file.seek(SeekFrom::End(-8))?;
    file.read_exact(&mut end)?;
    let [a, b, c, d, b'P', b'A', b'R', b'1'] = end else { return Ok(false) };
    let footer = u64::from(u32::from_le_bytes([a, b, c, d])).min(length - 8);
    file.seek(SeekFrom::Start(length - 8 - footer))?;
    let mut text = Vec::new();
    file.take(footer).read_to_end(&mut text)?;
    let mark = b"mavgen decode ";
    Ok(text.windows(mark.len()).any(|window| window == mark))
}

fn refused(path: &Path, error: impl std::fmt::Display) -> Failure {
    Failure::Usage(format!("{}: {error}", path.display()))
}
