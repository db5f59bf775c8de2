//! Binds the fields of a topic to the places where a log's records have them, by name.

use core::fmt;

use super::format::{DEEPEST, FormatField, Formats, fields};
use crate::uorb::{Element, Field, Place, Topic, places};

/// How the records of a log are read as a topic.
///
/// [`Log::read`](super::Log::read) makes its own. With somebody else's reader: bind once, read each record of data behind its
/// message id.
///
/// ```
/// # use mavlink_wire::uorb::{CdrError, Definition, Topic, ulog::Binding};
/// # #[derive(Clone, Copy, Debug, PartialEq)]
/// # struct CpuLoad { timestamp: u64, load: f32 }
/// # impl CpuLoad { const UNKNOWN: Self = Self { timestamp: 0, load: f32::NAN }; }
/// # impl Topic for CpuLoad {
/// #     const NAME: &'static str = "Cpuload";
/// #     const TOPICS: &'static [&'static str] = &["cpuload"];
/// #     const DEFINITIONS: &'static [Definition] = &[];
/// #     fn store_record(&self, _: &mut [u8]) -> Result<(), CdrError> { Ok(()) }
/// #     fn read_cdr(_: usize, _: &[u8]) -> Result<Self, CdrError> { Err(CdrError::Definition) }
/// #     fn store_cdr(&self, _: usize, _: &mut [u8]) -> Result<(), CdrError> { Err(CdrError::Definition) }
/// # }
/// # mavlink_wire::topic!(CpuLoad { timestamp, load });
/// let formats = |name: &str| (name == "cpuload").then_some("uint64_t timestamp;float load;float ram_usage;");
/// let binding = Binding::<CpuLoad>::of("cpuload", formats).ok_or("this log does not have it")?;
/// let record = [7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x3f, 0, 0, 0, 0];
/// assert_eq!(binding.read(&record), Some(CpuLoad { timestamp: 7, load: 0.5 }));
/// # Ok::<_, &str>(())
/// ```
pub struct Binding<T: Topic> {
    places: T::Places,
    needed: u32,
}

impl<T: Topic> Clone for Binding<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Topic> Copy for Binding<T> {}

impl<T: Topic> fmt::Debug for Binding<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Binding").field("topic", &T::NAME).field("places", &self.places.as_ref()).finish()
    }
}

impl<T: Topic> Binding<T> {
    /// Binds to the format of this name, `esc_status`. `formats` gives the fields of a format, as its definition has them
    /// behind the colon. `None` if there is no such format, or if it is no format.
    ///
    /// A field is bound if the log has one of its name whose type [widens](crate::uorb::Kind::widens_to) to it, and no longer
    /// an array. Formats that nest deeper than four levels, or of more than 4 GiB, are none.
    pub fn of<'a>(format: &str, formats: impl Fn(&str) -> Option<&'a str>) -> Option<Self> {
        let mut places = T::ABSENT;
        let mut formats = Formats::new(&formats);
        let text = formats.find(format)?;
        let needed = bind(Message { fields: T::FIELDS, places: places.as_mut(), depth: 0 }, text, &mut formats)?.needed;
        Some(Self { places, needed })
    }

    /// Reads a record of data, without its message id; `None` if it is too short.
    #[inline]
    #[must_use]
    pub fn read(&self, record: &[u8]) -> Option<T> {
        if record.len() < usize::try_from(self.needed).ok()? {
            return None;
        }
        let mut topic = T::UNKNOWN;
        topic.read_record(self.places.as_ref(), record);
        Some(topic)
    }
}

/// A message of the topic, and the places of its fields.
struct Message<'t> {
    fields: &'t [Field],
    places: &'t mut [Place],
    /// How deep it is nested.
    depth: u32,
}

/// Bytes of a format, and up to the end of the last field that is read.
struct Extent {
    size: u32,
    needed: u32,
}

fn bind(mut message: Message<'_>, text: &str, formats: &mut Formats<'_, '_>) -> Option<Extent> {
    let mut extent = Extent { size: 0, needed: 0 };
    for found in fields(text) {
        let found = found?;
        let at = extent.size;
        let bound = message.fields.iter().position(|field| field.is_called(found.name));
        let size = match bound {
            Some(i) => bind_field(&mut message, i, at, &found, formats)?,
            None => formats.size(&found, message.depth)?,
        };
        extent.size = at.checked_add(size.checked_mul(found.len.into())?)?;
        if bound.and_then(|i| message.places.get(i)).is_some_and(Place::is_bound) {
            extent.needed = extent.size;
        }
    }
    Some(extent)
}

/// Binds one field, and what is nested in it; gives the size of one element.
fn bind_field(
    message: &mut Message<'_>,
    i: usize,
    at: u32,
    found: &FormatField<'_>,
    formats: &mut Formats<'_, '_>,
) -> Option<u32> {
    let field = message.fields.get(i)?;
    let (size, place) = match (field.element, found.kind()) {
        (Element::Message { fields, .. }, None) if message.depth < DEEPEST => {
            let before: usize = message.fields.iter().take(i).map(|field| field.element.places()).sum();
            let places = message.places.get_mut(message.fields.len() + before..)?.get_mut(..places(fields))?;
            let nested = Message { fields, places, depth: message.depth + 1 };
            let size = bind(nested, formats.find(found.element)?, formats)?.size;
            (size, Place::nested_messages(at, size, found.len))
        }
        (Element::Scalar(kind), Some(narrower)) if narrower.widens_to(kind) => {
            (narrower.size(), Place::scalars(at, narrower, found.len))
        }
        _ => (formats.size(found, message.depth)?, Place::ABSENT),
    };
    if found.len <= field.len {
        *message.places.get_mut(i)? = place;
    }
    Some(size)
}
