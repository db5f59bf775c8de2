//! What one would write first: the programs are in `src/bin`. The library only holds the examples of each README.md and of `docs` to
//! their word.

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
mod readme {}

#[cfg(doctest)]
#[doc = include_str!("../../docs/commands.md")]
mod commands {}

#[cfg(doctest)]
#[doc = include_str!("../../docs/escs.md")]
mod escs {}

#[cfg(doctest)]
#[doc = include_str!("../../docs/firmware.md")]
mod firmware {}

#[cfg(doctest)]
#[doc = include_str!("../../docs/links.md")]
mod links {}

#[cfg(doctest)]
#[doc = include_str!("../../docs/own-dialect.md")]
mod own_dialect {}

#[cfg(doctest)]
#[doc = include_str!("../../docs/px4.md")]
mod px4 {}

#[cfg(doctest)]
#[doc = include_str!("../../docs/rust-mavlink.md")]
mod rust_mavlink {}

#[cfg(doctest)]
#[doc = include_str!("../../docs/services.md")]
mod services {}

#[cfg(doctest)]
#[doc = include_str!("../../mavgen/README.md")]
mod mavgen_readme {}

#[cfg(doctest)]
#[doc = include_str!("../../mavlink-wire/README.md")]
mod mavlink_wire_readme {}

#[cfg(doctest)]
#[doc = include_str!("../../mavlink-services/README.md")]
mod mavlink_services_readme {}

#[cfg(doctest)]
#[doc = include_str!("../../mavlink-autoquad/README.md")]
mod mavlink_autoquad_readme {}
