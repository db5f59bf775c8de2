//! A station that blocks.

use mavlink_wire::link::Link;

use super::station::station;
use super::*;

/// A ground station: waits for a vehicle, and has a method for each operation.
///
/// ```no_run
/// use mavlink_services::Station;
///
/// let mut station = Station::connect("udpin:0.0.0.0:14550")?;
/// println!("{} is a {}", station.vehicle(), station.heartbeat().r#type);
/// station.set_param("RATE_P", 0.2)?;
/// station.arm()?;
/// # Ok::<(), mavlink_services::Error>(())
/// ```
///
/// It sends its heartbeat and watches the vehicle's only while it waits for something. Between two operations, call
/// [`receive_until`](Self::receive_until).
pub struct Station {
    link: Link,
    session: Session,
}

station!();
