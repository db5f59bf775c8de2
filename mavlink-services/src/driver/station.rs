//! How a station waits for what it asked: the same, blocking and asynchronous.

/// What a `Station` is, and its methods around [`verbs!`](super::verbs::verbs): it has a `link` and a `session`.
macro_rules! station {
    ($($async:ident $await:ident)?) => {
        impl Station {
            /// Opens a link as system 255, component 190, and waits for a vehicle.
            ///
            /// # Errors
            ///
            /// The address is wrong, the link cannot be opened, or no vehicle is heard in ten seconds.
            pub $($async)? fn connect(address: &str) -> Result<Self, Error> {
                let (system_id, component_id) = STATION;
                let options = Options::new(Common::TABLE, Sender::v2(system_id, component_id));
                Self::over(Link::connect(address, options)$(.$await)??, Patience::DEFAULT)$(.$await)?
            }

            /// Waits for a vehicle on a link of yours: with other ids, with messages of your dialect, with signatures.
            ///
            /// # Errors
            ///
            /// The link fails, or no vehicle is heard in time.
            pub $($async)? fn over(link: Link, patience: Patience) -> Result<Self, Error> {
                let own = Address::new(link.system_id(), link.component_id());
                let mut station = Self { link, session: Session::new(own, patience) };
                let until = time::Instant::now() + patience.connect;
                while station.session.heard().is_none() {
                    if time::Instant::now() >= until {
                        return Err(Error::NoVehicle { waited: patience.connect });
                    }
                    station.idle(station.session.now(), None, Some(until), |_, _| {})$(.$await)??;
                }
                Ok(station)
            }

            /// Runs an operation to its end. One that was begun before may be continued.
            ///
            /// # Errors
            ///
            /// The operation fails, or the link does.
            pub $($async)? fn run<O: Operation>(
                &mut self,
                operation: &mut O,
                mut progress: impl FnMut(O::Progress),
            ) -> Result<O::Outcome, Error>
            where
                Error: From<O::Failure>,
            {
                let mut now = self.session.now();
                loop {
                    while let Some(output) = operation.poll(now) {
                        match output {
                            Output::Send(message) => say(&self.link, &message)$(.$await)??,
                            Output::Event(Update::Progress(told)) => progress(told),
                            Output::Event(Update::Done(end)) => {
                                flush(&self.link)$(.$await)??;
                                return end.map_err(|why| self.session.explain(why.into()));
                            }
                        }
                    }
                    let Some(deadline) = operation.deadline() else { return Err(Error::Over) };
                    now = self.idle(now, Some(deadline), None, |frame, now| operation.handle(frame, now))$(.$await)??;
                }
            }

            /// Waits for the next frame from any sender; `None` if there is none by the deadline.
            ///
            /// # Errors
            ///
            /// The link fails.
            pub $($async)? fn receive_until(&mut self, deadline: time::Instant) -> Result<Option<FrameBuf>, Error> {
                let mut received = None;
                while received.is_none() && time::Instant::now() < deadline {
                    let take = |frame: &Frame<'_>, _| received = Some(FrameBuf::from(*frame));
                    self.idle(self.session.now(), None, Some(deadline), take)$(.$await)??;
                }
                Ok(received)
            }

            /// Lets a frame come, or the time; gives the time.
            $($async)? fn idle(
                &mut self,
                now: Instant,
                deadline: Option<Instant>,
                until: Option<time::Instant>,
                take: impl FnOnce(&Frame<'_>, Instant),
            ) -> Result<Instant, Error> {
                while let Some(message) = self.session.poll(now) {
                    say(&self.link, &message)$(.$await)??;
                }
                flush(&self.link)$(.$await)??;
                let own = self.session.deadline(deadline, now);
                let received = self.link.receive_until(until.map_or(own, |until| until.min(own)))$(.$await)??;
                let now = self.session.now();
                if let Some(frame) = received {
                    self.session.handle(&frame, now);
                    take(&frame, now);
                }
                Ok(now)
            }
        }

        /// Sends with the next [`flush`]. It borrows the link alone, so that the futures of a station can go to another thread.
        $($async)? fn say(link: &Link, message: &Outgoing) -> Result<(), Error> {
            unless_full(link.queue(message)$(.$await)?.map(drop))
        }

        $($async)? fn flush(link: &Link) -> Result<(), Error> {
            unless_full(link.flush()$(.$await)?)
        }

        impl Station {
            $crate::driver::verbs::verbs!($($async $await)?);
        }
    };
}

pub(super) use station;
