//! Typed tables in a folder: a Parquet file for each message, `ATTITUDE.parquet`.
//!
//! Columns are those of CSV, without units in their names: units are in the metadata of the file, as JSON under the key `units`.
//! `time` is a timestamp in UTC. What the sender does not know is null.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::sync::Arc;

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
use super::folder::Table;
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

/// A file, and the rows that are not in it yet.
pub(super) struct Parquet {
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

impl Table for Parquet {
    const EXTENSION: &str = "parquet";
    type Error = ParquetError;

    /// The last part of a table says what made it.
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

    fn begin(file: File, message: &str, columns: &Columns) -> Result<Self, ParquetError> {
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
        let writer = SerializedFileWriter::new(file, schema(message, columns)?, Arc::new(properties))?;
        let kinds = FRAME.iter().map(|&(_, kind)| kind).chain(columns.columns.iter().map(|column| column.kind));
        let time = Buffer { values: Values::Int64(Vec::new()), present: Vec::new() };
        let buffers = [time].into_iter().chain(kinds.map(Buffer::new)).collect();
        Ok(Self { writer, buffers, rows: 0 })
    }

    fn add(&mut self, columns: &Columns, received: &Received<'_>, contents: &Contents) -> Result<(), ParquetError> {
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

    fn finish(mut self) -> Result<(), ParquetError> {
        if self.rows > 0 {
            self.write_group()?;
        }
        self.writer.close().map(drop)
    }
}

impl Parquet {
    /// Writes the rows that are held.
    fn write_group(&mut self) -> Result<(), ParquetError> {
        self.rows = 0;
        let mut group = self.writer.next_row_group()?;
        for buffer in &mut self.buffers {
            let Some(mut column) = group.next_column()? else { break };
            buffer.write(&mut column)?;
            column.close()?;
        }
        group.close().map(drop)
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
