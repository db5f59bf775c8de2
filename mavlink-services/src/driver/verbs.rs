//! What a station can do: the same words, blocking and asynchronous.

/// The verbs of a station, on the two that the type brings: `run` an operation, and its `session`.
macro_rules! verbs {
    ($($async:ident $await:ident)?) => {
        /// Sends a `COMMAND_LONG` or `COMMAND_INT` of any dialect to the vehicle, and waits until it has been carried out.
        ///
        /// # Errors
        ///
        /// The vehicle refuses it (the error has its reason and its `STATUSTEXT`), or does not answer; or the message is no command.
        pub $($async)? fn command(&mut self, command: &(impl Encode + ?Sized)) -> Result<Accepted, Error> {
            let mut sending = self.session.command(command)?;
            self.run(&mut sending, |_| {})$(.$await)?
        }

        /// As [`command`](Self::command), and reports progress.
        ///
        /// # Errors
        ///
        /// As [`command`](Self::command).
        pub $($async)? fn command_with(
            &mut self,
            command: &(impl Encode + ?Sized),
            progress: impl FnMut(Progress),
        ) -> Result<Accepted, Error> {
            let mut sending = self.session.command(command)?;
            self.run(&mut sending, progress)$(.$await)?
        }

        /// As [`command`](Self::command), and asks the vehicle to stop when `go_on` returns `false` for a report of progress.
        ///
        /// # Errors
        ///
        /// As [`command`](Self::command). If the vehicle stopped, the error is `MAV_RESULT_CANCELLED`; if it finished before, there
        /// is none.
        pub $($async)? fn command_while(
            &mut self,
            command: &(impl Encode + ?Sized),
            go_on: impl FnMut(Progress) -> bool,
        ) -> Result<Accepted, Error> {
            let mut sending = While::new(self.session.command(command)?, go_on);
            self.run(&mut sending, |_| {})$(.$await)?
        }

        /// Arms the motors.
        ///
        /// # Errors
        ///
        /// As [`command`](Self::command); the vehicle says why it does not arm.
        pub $($async)? fn arm(&mut self) -> Result<Accepted, Error> {
            self.command(&arming(true))$(.$await)?
        }

        /// Disarms the motors.
        ///
        /// # Errors
        ///
        /// As [`command`](Self::command); vehicles in flight refuse.
        pub $($async)? fn disarm(&mut self) -> Result<Accepted, Error> {
            self.command(&arming(false))$(.$await)?
        }

        /// Requests one message, which may be of your dialect, and waits for it. `argument` is an index for some messages, else 0.
        ///
        /// The table of the link has to have the message.
        ///
        /// # Errors
        ///
        /// The vehicle does not send it.
        pub $($async)? fn fetch<M: Message>(&mut self, argument: f32) -> Result<M, Error> {
            let mut fetching = self.session.fetch(argument);
            self.run(&mut fetching, |()| {})$(.$await)?
        }

        /// Requests the version and the capabilities of the vehicle; from old autopilots with the old command.
        ///
        /// # Errors
        ///
        /// The vehicle does not say.
        pub $($async)? fn version(&mut self) -> Result<AutopilotVersion, Error> {
            let refused = match self.fetch(0.0)$(.$await)? {
                Err(error @ Error::Command { failure: command::Failure::Refused { .. }, .. }) => error,
                other => return other,
            };
            let (own, peer, retry) = (self.session.own(), self.session.peer(), self.session.patience.retry);
            let Ok(mut fetching) = Fetch::with_command(own, peer, retry, &OLD_VERSION, self.session.now()) else {
                return Err(refused);
            };
            self.run(&mut fetching, |()| {})$(.$await)?
        }

        /// Requests the vehicle's capabilities once, to know how it encodes parameters and which mission items it takes. If the
        /// vehicle does not answer, its heartbeat decides. Operations that need this call it themselves.
        ///
        /// # Errors
        ///
        /// The link has failed.
        pub $($async)? fn learn(&mut self) -> Result<(), Error> {
            if self.session.encoding.is_some() {
                return Ok(());
            }
            let capabilities = match self.version()$(.$await)? {
                Ok(version) => Some(version.capabilities),
                Err(Error::Command { .. }) => None,
                Err(error) => return Err(error),
            };
            self.session.learn(capabilities);
            Ok(())
        }

        /// Reads a parameter.
        ///
        /// # Errors
        ///
        /// The vehicle has no parameter of this name, or does not answer.
        pub $($async)? fn param(&mut self, name: &str) -> Result<ParamValue, Error> {
            let name = Name::try_from(name)?;
            self.learn()$(.$await)??;
            let access = self.session.params();
            let mut reading = Read::new(access, Which::Name(name), self.session.now());
            Ok(self.run(&mut reading, |_| {})$(.$await)??.value)
        }

        /// Sets a parameter, converting the value to the parameter's type, and returns the new value.
        ///
        /// # Errors
        ///
        /// The vehicle has no parameter of this name, the type cannot hold the value, or the vehicle keeps another value.
        pub $($async)? fn set_param(&mut self, name: &str, value: impl Into<ParamValue>) -> Result<ParamValue, Error> {
            let name = Name::try_from(name)?;
            self.learn()$(.$await)??;
            let access = self.session.params();
            let mut writing = Write::new(access, name, value, self.session.now());
            Ok(self.run(&mut writing, |_| {})$(.$await)??.value)
        }

        /// Lists all parameters in the order of their indices. Reports how many were received, and how many there are.
        ///
        /// # Errors
        ///
        /// Some parameters do not arrive, even after all retries.
        pub $($async)? fn params(&mut self, mut progress: impl FnMut(u16, u16)) -> Result<Vec<Listed>, Error> {
            self.learn()$(.$await)??;
            let access = self.session.params();
            let mut listing = List::new(access, vec![0; 4096], self.session.now());
            let mut listed = BTreeMap::new();
            self.run(&mut listing, |told| match told {
                ListProgress::Value(value) => {
                    if let Some(index) = value.index {
                        listed.insert(index, value);
                    }
                    progress(value.received, value.count);
                }
                ListProgress::Restarted => listed.clear(),
                _ => {}
            })$(.$await)??;
            Ok(listed.into_values().collect())
        }

        /// Replaces the vehicle's mission.
        ///
        /// # Errors
        ///
        /// The vehicle refuses an item, or does not answer. It keeps its old mission.
        pub $($async)? fn upload(&mut self, items: &[MissionItem]) -> Result<Uploaded, Error> {
            self.upload_plan(MavMissionType::MISSION, items, |_| {})$(.$await)?
        }

        /// Replaces the mission, the fence or the rally points, and reports progress.
        ///
        /// # Errors
        ///
        /// As [`upload`](Self::upload).
        pub $($async)? fn upload_plan(
            &mut self,
            plan: MavMissionType,
            items: &[MissionItem],
            progress: impl FnMut(Sent),
        ) -> Result<Uploaded, Error> {
            self.learn()$(.$await)??;
            let access = self.session.plan(plan);
            let mut uploading = Upload::new(access, items, self.session.now());
            self.run(&mut uploading, progress)$(.$await)?
        }

        /// Downloads the vehicle's mission.
        ///
        /// # Errors
        ///
        /// The vehicle refuses, or does not send all items.
        pub $($async)? fn download(&mut self) -> Result<Vec<MissionItem>, Error> {
            self.download_plan(MavMissionType::MISSION, |_, _| {})$(.$await)?
        }

        /// Downloads the mission, the fence or the rally points. Reports how many items were received, and how many there are.
        ///
        /// # Errors
        ///
        /// As [`download`](Self::download).
        pub $($async)? fn download_plan(
            &mut self,
            plan: MavMissionType,
            mut progress: impl FnMut(u16, u16),
        ) -> Result<Vec<MissionItem>, Error> {
            self.learn()$(.$await)??;
            let access = self.session.plan(plan);
            let mut downloading = Download::new(access, self.session.now());
            let mut items = Vec::new();
            self.run(&mut downloading, |told| {
                items.push(told.item);
                progress(told.seq.saturating_add(1), told.count);
            })$(.$await)??;
            Ok(items)
        }

        /// Clears the mission, the fence or the rally points.
        ///
        /// # Errors
        ///
        /// The vehicle refuses, or does not answer.
        pub $($async)? fn clear(&mut self, plan: MavMissionType) -> Result<(), Error> {
            let access = self.session.plan(plan);
            let mut clearing = Clear::new(access, self.session.now());
            self.run(&mut clearing, |_| {})$(.$await)??;
            Ok(())
        }

        /// Sets the current item of the mission, by command, or by `MISSION_SET_CURRENT` if the vehicle does not know the command.
        ///
        /// # Errors
        ///
        /// The mission has no such item, or the vehicle does not answer.
        pub $($async)? fn set_current(&mut self, seq: u16) -> Result<(), Error> {
            match self.command(&making_current(seq))$(.$await)? {
                Err(Error::Command { failure: command::Failure::Refused { result: MavResult::UNSUPPORTED, .. }, .. }) => {}
                other => return other.map(|_| ()),
            }
            let access = self.session.plan(MavMissionType::MISSION);
            let mut setting = SetCurrent::new(access, seq, self.session.now());
            self.run(&mut setting, |_| {})$(.$await)??;
            Ok(())
        }

        /// Asks the vehicle to send the message with this id at this interval.
        ///
        /// # Errors
        ///
        /// As [`command`](Self::command).
        pub $($async)? fn set_interval(&mut self, message_id: u32, interval: Interval) -> Result<Accepted, Error> {
            let (own, peer, options) = (self.session.own(), self.session.peer(), self.session.patience.command);
            let mut setting = interval::set(own, peer, options, (message_id, interval), self.session.now());
            self.run(&mut setting, |_| {})$(.$await)?
        }

        /// Asks how often the vehicle sends a message.
        ///
        /// # Errors
        ///
        /// The vehicle does not say.
        pub $($async)? fn interval(&mut self, message_id: u16) -> Result<Interval, Error> {
            let (own, peer, retry) = (self.session.own(), self.session.peer(), self.session.patience.retry);
            let mut getting = interval::Get::new(own, peer, retry, message_id, self.session.now());
            self.run(&mut getting, |()| {})$(.$await)?
        }

        /// Measures how far the vehicle's clock is ahead of this station's [`now`](Self::now).
        ///
        /// # Errors
        ///
        /// The vehicle does not answer.
        pub $($async)? fn measure_time(&mut self) -> Result<Offset, Error> {
            let (own, peer, options) = (self.session.own(), self.session.peer(), self.session.patience.time);
            let mut measuring = Measure::new(own, peer, options, self.session.now());
            self.run(&mut measuring, |_| {})$(.$await)?
        }

        /// The vehicle: the first one that was heard, or the one of [`set_vehicle`](Self::set_vehicle).
        #[must_use]
        pub fn vehicle(&self) -> Address {
            self.session.peer()
        }

        /// From now on, sends operations to this component: another vehicle, or a camera.
        ///
        /// # Errors
        ///
        /// An id is zero, which stands for several components.
        pub fn set_vehicle(&mut self, vehicle: Address) -> Result<(), Error> {
            if vehicle.system_id.is_broadcast() || vehicle.component_id.is_broadcast() {
                return Err(Error::Nobody(vehicle));
            }
            self.session.set_peer(vehicle);
            Ok(())
        }

        /// The vehicle's last heartbeat.
        #[must_use]
        pub fn heartbeat(&self) -> &Heartbeat {
            self.session.heartbeat()
        }

        /// Whether the vehicle's heartbeat was heard in the last five seconds. The station hears only while it waits for something.
        #[must_use]
        pub fn is_alive(&self) -> bool {
            self.session.is_alive()
        }

        /// The station's clock, which started when the station was made.
        #[must_use]
        pub fn now(&self) -> Instant {
            self.session.now()
        }

        /// The station's own heartbeat, which you may change.
        pub fn beacon(&mut self) -> &mut Beacon {
            self.session.beacon()
        }

        /// The timeouts and retries of the station.
        pub fn patience(&mut self) -> &mut Patience {
            &mut self.session.patience
        }

        /// Passes every received frame to this closure, also while the station waits for an answer.
        pub fn listen(&mut self, listener: impl FnMut(&Frame<'_>) + ::core::marker::Send + 'static) {
            self.session.listener = Some(Box::new(listener));
        }

        /// The link, to send other messages.
        #[must_use]
        pub fn link(&self) -> &Link {
            &self.link
        }
    };
}

pub(crate) use verbs;
