//! A station for tokio.

use mavlink_wire::link::tokio::Link;

use super::station::station;
use super::*;

/// A ground station: waits for a vehicle, and has a method for each operation.
///
/// ```no_run
/// # async fn fly() -> Result<(), mavlink_services::Error> {
/// use mavlink_services::tokio::Station;
///
/// let mut station = Station::connect("udpin:0.0.0.0:14550").await?;
/// println!("{} is a {}", station.vehicle(), station.heartbeat().r#type);
/// station.set_param("RATE_P", 0.2).await?;
/// station.arm().await?;
/// # Ok(())
/// # }
/// ```
///
/// It sends its heartbeat and watches the vehicle's only while it waits for something. Between two operations, call
/// [`receive_until`](Self::receive_until).
///
/// Every future may be dropped before its end: no frame is torn, and the next operation starts afresh. To continue an operation,
/// keep it and [`run`](Self::run) it again.
pub struct Station {
    link: Link,
    session: Session,
}

station!(async await);
