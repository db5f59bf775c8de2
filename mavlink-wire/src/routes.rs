//! Which links a received frame goes on to.

mod links;
mod places;
mod recent;

pub use links::{LinkNumbers, Links};

use core::time::Duration;

use crate::{Frame, SystemId, Table};
use places::Places;
use recent::Recent;

/// How long a frame is remembered if nothing else is said.
const WINDOW: Duration = Duration::from_millis(500);

/// Says where the frames go that a router receives, by the rule of the MAVLink guide ("Routing"); the links are yours.
///
/// - Where a frame came from, it never goes back to.
/// - One that is for everybody goes to all links: without an addressee, with system 0, or of a message that the table does not
///   have.
/// - One that is for a system goes to the links from which that system was heard, and nowhere if it was not. Of the router's
///   own system ([`with_own_system`](Self::with_own_system)), the component has to be heard there.
/// - `RADIO_STATUS` and `SETUP_SIGNING` go nowhere: the one is about a single link, the other carries a key.
/// - What came before, within half a second, goes nowhere: over a second way, or round a loop of routers. So a loop does not
///   storm.
///
/// It remembers up to `COMPONENTS` senders, of which the one that was silent for longest is forgotten first, and the last
/// `RECENT` frames. Unverified frames are routed, but teach nothing.
///
/// ```
/// use core::time::Duration;
/// use mavlink_wire::{Frame, Links, MessageInfo, Routes, Table};
///
/// # const HEARTBEAT: &MessageInfo = &MessageInfo::new(0, "HEARTBEAT", 50, 9);
/// static TABLE: Table = Table::of(&[HEARTBEAT]);
/// // Link 0 is a radio, 1 and 2 are sockets.
/// let mut routes: Routes = Routes::new(&TABLE, Links::of(&[0, 1, 2]));
///
/// # let bytes = [0xfe, 9, 0, 1, 1, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0x90, 0x43];
/// let frame = Frame::parse(&bytes, &TABLE)?;
/// let to = routes.route(&frame, 0, Duration::ZERO);
/// assert_eq!(to, Links::of(&[1, 2]));
/// for link in to {
///     // sockets[link].write_all(frame.bytes())
/// }
/// # Ok::<_, mavlink_wire::FrameError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Routes<'t, const COMPONENTS: usize = 64, const RECENT: usize = 256> {
    table: &'t Table<'t>,
    links: Links,
    private: Links,
    own: Option<SystemId>,
    window: Duration,
    places: Places<COMPONENTS>,
    recent: Recent<RECENT>,
}

impl<'t, const COMPONENTS: usize, const RECENT: usize> Routes<'t, COMPONENTS, RECENT> {
    /// Routes between these links. The table should have every message with an addressee: a whole dialect's.
    #[must_use]
    pub const fn new(table: &'t Table<'t>, links: Links) -> Self {
        Self {
            table,
            links,
            private: Links::NONE,
            own: None,
            window: WINDOW,
            places: Places::EMPTY,
            recent: Recent::EMPTY,
        }
    }

    /// The same for a router that is a component of this system, as a vehicle's is.
    #[must_use]
    pub fn with_own_system(mut self, own: impl Into<SystemId>) -> Self {
        self.own = Some(own.into());
        self
    }

    /// The same that sends to these links only what is for somebody there, and nothing that is for everybody: slow ones, say.
    #[must_use]
    pub const fn with_private_links(mut self, private: Links) -> Self {
        self.private = private;
        self
    }

    /// The same that remembers a frame for so long. Zero lets every frame pass; a loop storms then.
    #[must_use]
    pub const fn with_window(mut self, window: Duration) -> Self {
        self.window = window;
        self
    }

    /// Where a frame goes that came from this link, `now` by any clock that does not go back. Learns who is there.
    pub fn route(&mut self, frame: &Frame<'_>, from: u8, now: Duration) -> Links {
        if frame.carries_key() || frame.is_of_radio() || self.recent.take(frame, now, self.window) {
            return Links::NONE;
        }
        if frame.is_verified() {
            self.places.hear(frame.system_id(), frame.component_id(), from);
        }
        self.to(frame).without(from)
    }

    /// The links that there are.
    #[must_use]
    pub const fn links(&self) -> Links {
        self.links
    }

    /// Routes over this link, too, from now on.
    pub const fn add_link(&mut self, link: u8) {
        self.links = self.links.with(link);
    }

    /// Sends nothing to this link any more, and forgets who was heard there.
    pub fn remove_link(&mut self, link: u8) {
        self.links = self.links.without(link);
        self.places.forget(link);
    }

    fn to(&self, frame: &Frame<'_>) -> Links {
        let (system, component) = self.target(frame);
        let heard = match component {
            _ if system == 0 => return self.links.except(self.private),
            1.. if self.own.is_some_and(|own| own == system) => self.places.of_component(system, component),
            _ => self.places.of_system(system),
        };
        heard.among(self.links)
    }

    /// System and component that a frame is for; 0 is all of them.
    fn target(&self, frame: &Frame<'_>) -> (u8, u8) {
        let info = self.table.get(frame.message_id()).filter(|info| info.crc_extra == frame.crc_extra());
        let byte = |offset: Option<u8>| offset.and_then(|at| frame.payload().get(usize::from(at)).copied());
        let (system, component) = info.map_or((None, None), |info| (info.target_system, info.target_component));
        (byte(system).unwrap_or_default(), byte(component).unwrap_or_default())
    }
}
