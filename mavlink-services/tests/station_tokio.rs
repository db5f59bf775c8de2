//! The asynchronous station over a real link, also when its futures are dropped.
#![cfg(feature = "tokio")]

mod flying;

use std::future::poll_fn;
use std::pin::pin;
use std::task::Poll;
use std::time::Duration;

use mavlink_services::common::{Common, MavCmd};
use mavlink_services::mission::{Access, MissionItem, Upload};
use mavlink_services::param::ParamValue;
use mavlink_services::tokio::Station;
use mavlink_services::{Address, Error, Patience, command};
use mavlink_wire::link::Options;
use mavlink_wire::link::tokio::Link;
use mavlink_wire::{Dialect, Sender};

#[expect(clippy::unwrap_used, reason = "a part of tests")]
async fn meet(thinks: Duration) -> (Station, flying::Running) {
    let options = Options::new(Common::TABLE, Sender::v2(255, 190));
    let link = Link::connect("udpin:127.0.0.1:0", options).await.unwrap();
    let vehicle = flying::vehicle(link.local_addr().unwrap(), thinks);
    (Station::over(link, Patience::DEFAULT).await.unwrap(), vehicle)
}

fn waypoints() -> Vec<MissionItem> {
    (0..8).map(|at| MissionItem::at(MavCmd::NAV_WAYPOINT, 47.0, f64::from(at), 10.0)).collect()
}

/// What can be spawned on any runtime.
fn send<F: Future + Send>(future: F) -> F {
    future
}

/// Lets a future run until it has to wait, and drops it when it could go on.
async fn interrupted<F: Future>(future: F) -> Option<F::Output> {
    let (mut future, mut waited) = (pin!(future), false);
    poll_fn(|context| {
        if waited {
            return Poll::Ready(None);
        }
        waited = true;
        future.as_mut().poll(context).map(Some)
    })
    .await
}

#[tokio::test]
async fn a_station_does_all_of_it() {
    let (mut station, _vehicle) = send(meet(Duration::ZERO)).await;
    assert_eq!(send(station.set_param("RATE_P", 0.2)).await.unwrap(), ParamValue::F32(0.2));
    assert_eq!(send(station.params(|_, _| {})).await.unwrap().len(), 3);
    assert_eq!(send(station.upload(&waypoints())).await.unwrap().count, 8);
    assert_eq!(send(station.download()).await.unwrap().len(), 8);
    assert!(send(station.measure_time()).await.unwrap().round_trip < Duration::from_secs(1));
    let refused = send(station.arm()).await.unwrap_err();
    let Error::Command { failure: command::Failure::Refused { reason: 7, .. }, text } = refused else {
        panic!("{refused}")
    };
    assert_eq!(text.as_deref(), Some("the gyro is warm"));
}

#[tokio::test]
async fn a_future_may_be_dropped_at_any_time() {
    // An answer that is there at once leaves nothing to wait for.
    let (mut station, _vehicle) = meet(Duration::from_millis(2)).await;
    // One operation, gone on with after each drop.
    let access = Access::new(Address::new(255, 190), station.vehicle());
    let mut upload = Upload::new(access, waypoints(), station.now());
    let (mut dropped, mut told) = (0, 0);
    let uploaded = loop {
        match interrupted(station.run(&mut upload, |_| told += 1)).await {
            Some(end) => break end.unwrap(),
            None => dropped += 1,
        }
        assert!(dropped < 100_000, "it comes to no end");
    };
    assert_eq!((uploaded.count, told), (8, 8));
    assert!(dropped > 0, "no future was dropped: the test shows nothing");
    assert!(matches!(station.run(&mut upload, |_| {}).await, Err(Error::Over)));

    // Others are dropped for good; what comes next begins anew.
    for _ in 0..5 {
        let _ = interrupted(station.download()).await;
        let _ = interrupted(station.set_param("RATE_P", 0.1)).await;
    }
    assert_eq!(station.download().await.unwrap().len(), 8);
    assert_eq!(station.set_param("RATE_P", 0.3).await.unwrap(), ParamValue::F32(0.3));
}
