//! `autoquad plot`: a recording as a picture.

mod flight;
mod picture;
mod trace;

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use mavlink_autoquad::wire::SystemId;
use plotters::prelude::{BitMapBackend, FontStyle, IntoDrawingArea, SVGBackend};
use plotters::style::register_font;

use crate::failure::Failure;
use crate::input::named_after;
use crate::output::{Overwriting, is_standard};
use crate::recording::Recording;
use crate::telemetry::Firmware;
use flight::Flight;

/// DejaVu Sans, the characters that are needed: `font/LICENSE`.
const FONT: &[u8] = include_bytes!("../font/DejaVuSans.ttf");

/// Draws speed, current, voltage and temperature of each controller over time, and marks where one failed or fell silent.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(crate) struct Plot {
    /// The recording, a tlog; `-` is standard input.
    log: PathBuf,
    /// The picture to write, .svg or .png; `-` is standard output, as SVG. By default, the recording's name with .svg.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    overwriting: Overwriting,
    /// The system id of the vehicle, if there are several. By default, the first.
    #[arg(long, value_name = "ID")]
    system: Option<u8>,
    /// Width and height in pixels.
    #[arg(long, value_name = "WxH", default_value = "1600x1200", value_parser = size)]
    size: (u32, u32),
    #[command(flatten)]
    firmware: Firmware,
}

const AFTER_HELP: &str = "\
Examples:
  autoquad plot flight.tlog                   (flight.svg)
  autoquad plot flight.tlog --out flight.png --size 2400x1600
  autoquad plot fleet.tlog --system 3 --out third.svg";

/// The formats that a name can ask for.
#[derive(Clone, Copy)]
enum Format {
    Svg,
    Png,
}

fn size(text: &str) -> Result<(u32, u32), String> {
    let sides = text.split_once('x').and_then(|(width, height)| Some((width.parse().ok()?, height.parse().ok()?)));
    match sides {
        Some((width, height)) if (400..=8000).contains(&width) && (400..=8000).contains(&height) => Ok((width, height)),
        Some(_) => Err("each side has 400 to 8000 pixels".to_owned()),
        None => Err("write it like 1600x1200".to_owned()),
    }
}

impl Plot {
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let out = self.out.clone().unwrap_or_else(|| named_after(&self.log, "svg"));
        let format = format(&out)?;
        let wanted = self.system.map(SystemId::from_u8);
        let recording = Recording::open(&self.log)?;
        let name = recording.name.clone();
        let Some(flight) = Flight::read(recording, wanted, self.firmware)? else {
            let whose = self.system.map(|id| format!(" of system {id}")).unwrap_or_default();
            return Err(Failure::with(name, format!("has no motor telemetry (AQ_ESC_TELEMETRY){whose} to plot")));
        };
        let bytes = match format {
            Format::Svg => svg(&flight, self.size),
            Format::Png => png(&flight, self.size),
        };
        let bytes = bytes.map_err(|error| Failure::file(&out, format!("the picture could not be drawn: {error}")))?;
        let mut output = self.overwriting.whole(&out, Some(&self.log))?;
        output.write_all(&bytes).map_err(Failure::written)?;
        output.finish_saying(format_args!("{} controllers, {} marks", flight.motors.len(), flight.events.len()))
    }
}

fn format(out: &Path) -> Result<Format, Failure> {
    if is_standard(out) {
        return Ok(Format::Svg);
    }
    match out.extension().map(|extension| extension.to_ascii_lowercase()) {
        Some(extension) if extension == "svg" => Ok(Format::Svg),
        Some(extension) if extension == "png" => Ok(Format::Png),
        _ => Err(Failure::file(out, "a picture is called .svg or .png")),
    }
}

fn svg(flight: &Flight, size: (u32, u32)) -> Result<Vec<u8>, String> {
    let mut text = String::new();
    use_font()?;
    picture::draw(&SVGBackend::with_string(&mut text, size).into_drawing_area(), flight)
        .map_err(|error| error.to_string())?;
    Ok(text.into_bytes())
}

fn png(flight: &Flight, size: (u32, u32)) -> Result<Vec<u8>, String> {
    let (width, height) = size;
    let mut pixels = vec![0; 3 * width as usize * height as usize];
    use_font()?;
    let backend = BitMapBackend::with_buffer(&mut pixels, size);
    picture::draw(&backend.into_drawing_area(), flight).map_err(|error| error.to_string())?;
    let mut bytes = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(::png::ColorType::Rgb);
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&pixels));
    written.map_err(|error| error.to_string())?;
    Ok(bytes)
}

/// No font of the system is looked for, so that pictures are the same everywhere.
fn use_font() -> Result<(), String> {
    register_font("sans-serif", FontStyle::Normal, FONT).map_err(|_| "the font is damaged".to_owned())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::simulate::flight as simulated;

    fn plot(motors: u8, out: &str) -> Vec<u8> {
        let folder = tempfile::tempdir().unwrap();
        let log = folder.path().join("flight.tlog");
        simulated(&log, motors, 30, 1_462_017_600_000_000);
        let out = folder.path().join(out);
        let plot = Plot {
            log,
            out: Some(out.clone()),
            overwriting: Overwriting::default(),
            system: None,
            size: (1200, 900),
            firmware: Firmware::default(),
        };
        plot.run().unwrap();
        assert!(matches!(plot.run(), Err(Failure::Sentence(_))), "overwritten");
        fs::read(out).unwrap()
    }

    #[test]
    fn a_vector_picture_has_a_line_and_a_name_for_each_controller() {
        let svg = String::from_utf8(plot(16, "flight.svg")).unwrap();
        for port in 1..=16 {
            assert!(svg.contains(&format!("ESC {port}\n")), "ESC {port}");
        }
        for text in
            ["speed (rpm)", "current (A)", "voltage (V)", "temperature (°C)", "2016-04-30 12:00:00 UTC", ": silent"]
        {
            assert!(svg.contains(text), "{text}");
        }
        // Four panels of sixteen lines, but for the temperatures that four controllers do not measure.
        assert!(svg.matches("<polyline").count() >= 4 * 16 - 4);
    }

    #[test]
    fn a_pixel_picture_is_as_large_as_asked_for_and_not_white() {
        let png = plot(1, "flight.PNG");
        let mut reader = ::png::Decoder::new(std::io::Cursor::new(png)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((info.width, info.height), (1200, 900));
        let dark = pixels.chunks(3).filter(|pixel| pixel.iter().all(|&part| part < 100)).count();
        assert!(dark > 1000, "{dark}: no text was drawn");
    }

    #[test]
    fn sizes_and_names_that_make_no_picture_are_refused() {
        assert_eq!(size("1600x1200"), Ok((1600, 1200)));
        for text in ["", "1600", "x", "0x0", "99999x1200", "axb"] {
            assert!(size(text).is_err(), "{text}");
        }
        assert!(format(Path::new("flight.gif")).is_err() && format(Path::new("svg")).is_err());
    }
}
