//! Whose clock is asked for.

use core::convert::Infallible;

use mavlink_wire::Frame;

use crate::common::Timesync;
use crate::{Address, Instant, Output, Service};

/// Answers with its clock, the caller's [`Instant`].
///
/// ```text
///   Idle ──TIMESYNC, tc1 = 0──▶ Asked ──TIMESYNC, tc1 = its clock──▶ Idle
/// ```
///
/// Poll it right after the frame came: whatever passes in between is an error of the other side's measurement. Of several requests
/// between two polls the last is answered.
#[derive(Clone, Debug)]
pub struct Responder {
    own: Address,
    asked: Option<Timesync>,
}

impl Responder {
    /// A responder with this address.
    #[must_use]
    pub fn new(own: Address) -> Self {
        Self { own, asked: None }
    }
}

impl Service for Responder {
    type Event = Infallible;

    fn handle(&mut self, frame: &Frame<'_>, _: Instant) {
        let Some(request) = frame.decode::<Timesync>() else { return };
        if request.tc1 == 0 && self.own.is_target(request.target_system, request.target_component) {
            let (target_system, target_component) = Address::of(frame).target();
            self.asked = Some(Timesync { target_system, target_component, ..request });
        }
    }

    fn poll(&mut self, now: Instant) -> Option<Output<Infallible>> {
        let answer = Timesync { tc1: super::measure::clock(now).max(1), ..self.asked.take()? };
        Some(Output::Send(answer.into()))
    }

    fn deadline(&self) -> Option<Instant> {
        None
    }
}
