//! Links that do what they are told.

use std::collections::VecDeque;
use std::io::{ErrorKind, Read, Result, Write};

/// What a link does next.
#[derive(Clone, Debug)]
pub(super) enum Step {
    Take(usize),
    Fail(ErrorKind),
}

/// Gives and takes bytes step by step; without a step, all of them.
#[derive(Clone, Debug, Default)]
pub(super) struct Scripted {
    pub(super) steps: VecDeque<Step>,
    /// To be read.
    pub(super) input: VecDeque<u8>,
    /// Written.
    pub(super) output: Vec<u8>,
}

impl Scripted {
    pub(super) fn new(steps: impl IntoIterator<Item = Step>, input: &[u8]) -> Self {
        Self { steps: steps.into_iter().collect(), input: input.iter().copied().collect(), output: vec![] }
    }

    fn step(&mut self, limit: usize) -> Result<usize> {
        match self.steps.pop_front() {
            None => Ok(limit),
            Some(Step::Take(count)) => Ok(count.min(limit)),
            Some(Step::Fail(kind)) => Err(kind.into()),
        }
    }
}

impl Read for Scripted {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let limit = buffer.len().min(self.input.len());
        let count = self.step(limit)?;
        for byte in &mut buffer[..count] {
            *byte = self.input.pop_front().unwrap();
        }
        Ok(count)
    }
}

impl Write for Scripted {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        let count = self.step(bytes.len())?;
        self.output.extend(&bytes[..count]);
        Ok(count)
    }

    fn flush(&mut self) -> Result<()> {
        Ok(())
    }
}
