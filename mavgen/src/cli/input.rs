//! The arguments that commands share: what to read, and where to write.

use std::path::PathBuf;

use clap::Args;
use mavgen::Builder;

/// The definitions.
#[derive(Args)]
pub(super) struct Input {
    /// The dialect's XML file.
    pub(super) xml: PathBuf,
    /// Where to look for includes that do not lie beside the file that names them; may be given several times.
    #[arg(long, value_name = "DIR")]
    include_dir: Vec<PathBuf>,
    /// A file that says what the XML cannot, like the meaning of packed bits; may be given several times.
    #[arg(long, value_name = "FILE")]
    pub(super) overlay: Vec<PathBuf>,
    /// Only these messages and what they need: names separated by commas; in a pattern, a star stands for any characters.
    #[arg(long, value_name = "NAME,PREFIX_*", value_delimiter = ',')]
    messages: Option<Vec<String>>,
}

/// The definitions, and a folder for what becomes of them.
#[derive(Args)]
pub(super) struct Output {
    #[command(flatten)]
    pub(super) input: Input,
    /// The folder for the sources.
    #[arg(long, value_name = "DIR")]
    pub(super) out: PathBuf,
}

impl Input {
    pub(super) fn builder(&self) -> Builder {
        let builder = Builder::new(&self.xml);
        let builder = self.include_dir.iter().fold(builder, |builder, folder| builder.include_dir(folder));
        let builder = self.overlay.iter().fold(builder, |builder, file| builder.overlay(file));
        self.messages.iter().fold(builder, |builder, names| builder.messages(names))
    }
}

impl Output {
    pub(super) fn builder(&self) -> Builder {
        self.input.builder().out_dir(&self.out)
    }
}
