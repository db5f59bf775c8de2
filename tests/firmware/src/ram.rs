//! What each machine takes of the RAM: nothing uses these, `nm` shows how large they are.

use core::mem::MaybeUninit;

use mavlink_services::common::AutopilotVersion;
use mavlink_services::mission::{MissionItem, PlanStore};
use mavlink_services::param::Param;
use mavlink_services::{command, heartbeat, interval, mission, param, timesync};

macro_rules! sizes {
    ($($name:ident: $machine:ty),* $(,)?) => {
        $(#[used]
        #[unsafe(no_mangle)]
        #[unsafe(link_section = ".uninit.ram")]
        static $name: MaybeUninit<$machine> = MaybeUninit::uninit();)*
    };
}

sizes! {
    RAM_heartbeat_Beacon: heartbeat::Beacon,
    RAM_heartbeat_Monitor_of_4: heartbeat::Monitor<4>,
    RAM_command_Send: command::Send,
    RAM_command_Fetch_AUTOPILOT_VERSION: command::Fetch<AutopilotVersion>,
    RAM_command_Component_of_2: command::Component<2>,
    RAM_interval_Get: interval::Get,
    RAM_interval_Streams_of_8: interval::Streams<8>,
    RAM_mission_Upload: mission::Upload<&'static [MissionItem]>,
    RAM_mission_Download: mission::Download,
    RAM_mission_Clear: mission::Clear,
    RAM_mission_SetCurrent: mission::SetCurrent,
    RAM_mission_Component_of_60: mission::Component<PlanStore<[MissionItem; 20]>>,
    RAM_param_List_of_1024: param::List<[u8; 128]>,
    RAM_param_Read: param::Read,
    RAM_param_Write: param::Write,
    RAM_param_Component_of_10: param::Component<[Param; 10]>,
    RAM_timesync_Measure: timesync::Measure,
    RAM_timesync_Responder: timesync::Responder,
}
