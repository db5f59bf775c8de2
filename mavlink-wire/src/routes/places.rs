//! Who was heard where.

use super::Links;
use crate::{ComponentId, SystemId};

/// The components that were heard, up to `N`.
#[derive(Clone, Debug)]
pub(super) struct Places<const N: usize> {
    places: [Place; N],
    /// Frames so far: when a component was heard last.
    heard: u64,
}

/// The links from which a component was heard.
#[derive(Clone, Copy, Debug)]
struct Place {
    system_id: SystemId,
    component_id: ComponentId,
    links: Links,
    heard: u64,
}

impl<const N: usize> Places<N> {
    pub(super) const EMPTY: Self = {
        let (system_id, component_id) = (SystemId::BROADCAST, ComponentId::BROADCAST);
        Self { places: [Place { system_id, component_id, links: Links::NONE, heard: 0 }; N], heard: 0 }
    };

    /// A component was heard there. Nobody is system 0, which means everybody.
    pub(super) fn hear(&mut self, system_id: SystemId, component_id: ComponentId, link: u8) {
        if system_id.is_broadcast() {
            return;
        }
        self.heard += 1;
        let known = |place: &&mut Place| (place.system_id, place.component_id) == (system_id, component_id);
        let place = match self.places.iter_mut().find(known) {
            Some(place) => Some(place),
            // One that nobody has, or else the one that was silent for longest.
            None => self.places.iter_mut().min_by_key(|place| place.heard).map(|place| {
                *place = Place { system_id, component_id, links: Links::NONE, heard: 0 };
                place
            }),
        };
        if let Some(place) = place {
            (place.links, place.heard) = (place.links.with(link), self.heard);
        }
    }

    pub(super) fn of_system(&self, system: u8) -> Links {
        self.links(|place| place.system_id == system)
    }

    pub(super) fn of_component(&self, system: u8, component: u8) -> Links {
        self.links(|place| place.system_id == system && place.component_id == component)
    }

    fn links(&self, is_meant: impl Fn(&Place) -> bool) -> Links {
        self.places.iter().filter(|place| is_meant(place)).fold(Links::NONE, |all, place| all.and(place.links))
    }

    /// Nobody is there any more.
    pub(super) fn forget(&mut self, link: u8) {
        for place in &mut self.places {
            place.links = place.links.without(link);
        }
    }
}
