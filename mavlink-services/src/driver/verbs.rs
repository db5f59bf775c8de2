//! What a station can do: the same words, blocking and asynchronous.

/// The verbs of a station, on the two that the type brings: `run` an operation, and its `session`.
macro_rules! verbs {
    ([$($async:tt)?] [$($wait:tt)*]) => {
        /// Sends a `COMMAND_LONG` or `COMMAND_INT` of any dialect to the vehicle, and waits until it is carried out.
        ///
        /// # Errors
        ///
        /// It is refused, with the vehicle's reason and what it says about it; or it is not answered; or it is no command.
        pub $($async)? fn command(&mut self, command: &(impl Encode + ?Sized)) -> Result<Accepted, Error> {
            let mut sending = self.session.command(command)?;
            self.run(&mut sending, |_| {}) $($wait)*
        }

        /// The same, telling how far it is.
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
            self.run(&mut sending, progress) $($wait)*
        }

        /// The same, until `go_on` says `false` to a report of progress: then the vehicle is asked to stop.
        ///
        /// # Errors
        ///
        /// As [`command`](Self::command). A vehicle that stopped refuses with `MAV_RESULT_CANCELLED`; one that was faster does not.
        pub $($async)? fn command_while(
            &mut self,
            command: &(impl Encode + ?Sized),
            go_on: impl FnMut(Progress) -> bool,
        ) -> Result<Accepted, Error> {
            let mut sending = While::new(self.session.command(command)?, go_on);
            self.run(&mut sending, |_| {}) $($wait)*
        }

        /// Arms the motors.
        ///
        /// # Errors
        ///
        /// As [`command`](Self::command); vehicles say why not.
        pub $($async)? fn arm(&mut self) -> Result<Accepted, Error> {
            self.command(&arming(true)) $($wait)*
        }

        /// Disarms the motors.
        ///
        /// # Errors
        ///
        /// As [`command`](Self::command); vehicles in flight refuse.
        pub $($async)? fn disarm(&mut self) -> Result<Accepted, Error> {
            self.command(&arming(false)) $($wait)*
        }

        /// Asks for one message, which may be of your dialect, and waits for it; `argument` is often an index, else 0.
        ///
        /// The link has to know it: give it a table that has the message.
        ///
        /// # Errors
        ///
        /// The vehicle does not send it.
        pub $($async)? fn fetch<M: Message>(&mut self, argument: f32) -> Result<M, Error> {
            let mut fetching = self.session.fetch(argument);
            self.run(&mut fetching, |()| {}) $($wait)*
        }

        /// Which firmware it is, and what it can do. Old ones are asked in the old way.
        ///
        /// # Errors
        ///
        /// The vehicle does not say.
        pub $($async)? fn version(&mut self) -> Result<AutopilotVersion, Error> {
            let refused = match self.fetch(0.0) $($wait)* {
                Err(error @ Error::Command { failure: command::Failure::Refused { .. }, .. }) => error,
                other => return other,
            };
            let (own, peer, retry) = (self.session.own(), self.session.peer(), self.session.patience.retry);
            let Ok(mut fetching) = Fetch::with_command(own, peer, retry, &OLD_VERSION, self.session.now()) else {
                return Err(refused);
            };
            self.run(&mut fetching, |()| {}) $($wait)*
        }

        /// Learns from the vehicle's capabilities, once, how it encodes the values of parameters and takes the items of plans; a
        /// vehicle that does not tell its capabilities is judged by its heartbeat. Whatever needs to know calls this itself.
        ///
        /// # Errors
        ///
        /// The link has failed.
        pub $($async)? fn learn(&mut self) -> Result<(), Error> {
            if self.session.encoding.is_some() {
                return Ok(());
            }
            let capabilities = match self.version() $($wait)* {
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
        /// There is none of this name, or it is not told.
        pub $($async)? fn param(&mut self, name: &str) -> Result<ParamValue, Error> {
            let name = Name::try_from(name)?;
            self.learn() $($wait)*?;
            let access = self.session.params();
            let mut reading = Read::new(access, Which::Name(name), self.session.now());
            Ok(self.run(&mut reading, |_| {}) $($wait)*?.value)
        }

        /// Sets a parameter, of whatever type it is, and gives the value that it has then.
        ///
        /// # Errors
        ///
        /// There is none of this name, its type cannot hold the value, or the vehicle keeps another one.
        pub $($async)? fn set_param(&mut self, name: &str, value: impl Into<ParamValue>) -> Result<ParamValue, Error> {
            let name = Name::try_from(name)?;
            self.learn() $($wait)*?;
            let access = self.session.params();
            let mut writing = Write::new(access, name, value, self.session.now());
            Ok(self.run(&mut writing, |_| {}) $($wait)*?.value)
        }

        /// Lists all parameters, by their place; tells how many have come, and how many there are.
        ///
        /// # Errors
        ///
        /// Some do not come, however often they are asked for.
        pub $($async)? fn params(&mut self, mut progress: impl FnMut(u16, u16)) -> Result<Vec<Listed>, Error> {
            self.learn() $($wait)*?;
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
            }) $($wait)*?;
            Ok(listed.into_values().collect())
        }

        /// Replaces the vehicle's mission.
        ///
        /// # Errors
        ///
        /// The vehicle refuses an item, or does not answer. It keeps the mission that it has.
        pub $($async)? fn upload(&mut self, items: &[MissionItem]) -> Result<Uploaded, Error> {
            self.upload_plan(MavMissionType::MISSION, items, |_| {}) $($wait)*
        }

        /// Replaces the mission, the fence or the rally points, telling how far it is.
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
            self.learn() $($wait)*?;
            let access = self.session.plan(plan);
            let mut uploading = Upload::new(access, items, self.session.now());
            self.run(&mut uploading, progress) $($wait)*
        }

        /// Gives the vehicle's mission.
        ///
        /// # Errors
        ///
        /// The vehicle does not tell all of it.
        pub $($async)? fn download(&mut self) -> Result<Vec<MissionItem>, Error> {
            self.download_plan(MavMissionType::MISSION, |_, _| {}) $($wait)*
        }

        /// Gives the mission, the fence or the rally points; tells how many items have come, and how many there are.
        ///
        /// # Errors
        ///
        /// As [`download`](Self::download).
        pub $($async)? fn download_plan(
            &mut self,
            plan: MavMissionType,
            mut progress: impl FnMut(u16, u16),
        ) -> Result<Vec<MissionItem>, Error> {
            self.learn() $($wait)*?;
            let access = self.session.plan(plan);
            let mut downloading = Download::new(access, self.session.now());
            let mut items = Vec::new();
            self.run(&mut downloading, |told| {
                items.push(told.item);
                progress(told.seq.saturating_add(1), told.count);
            }) $($wait)*?;
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
            self.run(&mut clearing, |_| {}) $($wait)*?;
            Ok(())
        }

        /// Sends the vehicle to an item of its mission, by command, or in the old way if it does not know that.
        ///
        /// # Errors
        ///
        /// The mission has no such item, or the vehicle does not answer.
        pub $($async)? fn set_current(&mut self, seq: u16) -> Result<(), Error> {
            match self.command(&making_current(seq)) $($wait)* {
                Err(Error::Command { failure: command::Failure::Refused { result: MavResult::UNSUPPORTED, .. }, .. }) => {}
                other => return other.map(|_| ()),
            }
            let access = self.session.plan(MavMissionType::MISSION);
            let mut setting = SetCurrent::new(access, seq, self.session.now());
            self.run(&mut setting, |_| {}) $($wait)*?;
            Ok(())
        }

        /// Asks the vehicle to send the message with this id so often.
        ///
        /// # Errors
        ///
        /// As [`command`](Self::command).
        pub $($async)? fn set_interval(&mut self, message_id: u32, interval: Interval) -> Result<Accepted, Error> {
            let (own, peer, options) = (self.session.own(), self.session.peer(), self.session.patience.command);
            let mut setting = interval::set(own, peer, options, (message_id, interval), self.session.now());
            self.run(&mut setting, |_| {}) $($wait)*
        }

        /// Asks how often the vehicle sends a message.
        ///
        /// # Errors
        ///
        /// The vehicle does not say.
        pub $($async)? fn interval(&mut self, message_id: u16) -> Result<Interval, Error> {
            let (own, peer, retry) = (self.session.own(), self.session.peer(), self.session.patience.retry);
            let mut getting = interval::Get::new(own, peer, retry, message_id, self.session.now());
            self.run(&mut getting, |()| {}) $($wait)*
        }

        /// Measures how far the vehicle's clock is ahead of this station's [`now`](Self::now).
        ///
        /// # Errors
        ///
        /// The vehicle does not answer.
        pub $($async)? fn measure_time(&mut self) -> Result<Offset, Error> {
            let (own, peer, options) = (self.session.own(), self.session.peer(), self.session.patience.time);
            let mut measuring = Measure::new(own, peer, options, self.session.now());
            self.run(&mut measuring, |_| {}) $($wait)*
        }

        /// The vehicle: the first one that was heard, or who was [named](Self::set_vehicle).
        #[must_use]
        pub fn vehicle(&self) -> Address {
            self.session.peer()
        }

        /// Speaks to this component from now on: another vehicle, or a camera.
        ///
        /// # Errors
        ///
        /// It stands for several.
        pub fn set_vehicle(&mut self, vehicle: Address) -> Result<(), Error> {
            if vehicle.system_id.is_broadcast() || vehicle.component_id.is_broadcast() {
                return Err(Error::Nobody(vehicle));
            }
            self.session.set_peer(vehicle);
            Ok(())
        }

        /// What the vehicle's last heartbeat said.
        #[must_use]
        pub fn heartbeat(&self) -> &Heartbeat {
            self.session.heartbeat()
        }

        /// Whether the vehicle's heartbeat was heard within five seconds, as far as the station has listened.
        #[must_use]
        pub fn is_alive(&self) -> bool {
            self.session.is_alive()
        }

        /// The station's clock, which began when it was made.
        #[must_use]
        pub fn now(&self) -> Instant {
            self.session.now()
        }

        /// The station's own heartbeat, to be changed.
        pub fn beacon(&mut self) -> &mut Beacon {
            self.session.beacon()
        }

        /// How patient the station is.
        pub fn patience(&mut self) -> &mut Patience {
            &mut self.session.patience
        }

        /// Shows every frame that comes to this closure, also those that come while something else is waited for.
        pub fn listen(&mut self, listener: impl FnMut(&Frame<'_>) + ::core::marker::Send + 'static) {
            self.session.listener = Some(Box::new(listener));
        }

        /// The link, to send what else there is to say.
        #[must_use]
        pub fn link(&self) -> &Link {
            &self.link
        }
    };
}

pub(super) use verbs;
