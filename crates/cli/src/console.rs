//! Standard error: notes, the summary, and a bar when it takes long.

use crate::failure::{located, one_line};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use splitstar::formats::Place;
use std::io::{self, IsTerminal, Write};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::JoinHandle;
use std::time::Duration;

/// What a command tells its user while it runs.
pub(crate) struct Console {
    quiet: bool,
    bar: Option<Bar>,
}

/// A bar that shows itself after a second, and goes when dropped.
struct Bar {
    bar: ProgressBar,
    finished: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

const PATIENCE: Duration = Duration::from_secs(1);
const REDRAW: Duration = Duration::from_millis(100);

impl Console {
    /// A console for a command of so many steps. There is a bar only on a terminal.
    pub(crate) fn new(quiet: bool, steps: usize) -> Self {
        let bar = (!quiet && io::stderr().is_terminal()).then(|| Bar::new(steps as u64));
        Self { quiet, bar }
    }

    /// Begins a step.
    pub(crate) fn step(&self, what: &str) {
        if let Some(Bar { bar, .. }) = &self.bar {
            bar.set_message(one_line(what));
        }
    }

    /// Says how far a step has come.
    pub(crate) fn step_at(&self, what: &str, done: usize, total: usize) {
        if let Some(Bar { bar, .. }) = &self.bar {
            let percent = (done as u128 * 100) / (total as u128).max(1);
            bar.set_message(format!("{what} {percent} %"));
        }
    }

    /// Ends a step.
    pub(crate) fn step_done(&self) {
        if let Some(Bar { bar, .. }) = &self.bar {
            bar.inc(1);
        }
    }

    /// Something the user should know about a file.
    pub(crate) fn note(&self, file: &str, place: Option<Place>, sentence: &str) {
        self.say(&format!("note: {} {}", located(file, place), one_line(sentence)));
    }

    /// Whether what is said is shown.
    pub(crate) fn speaks(&self) -> bool {
        !self.quiet
    }

    /// One line, without a mark.
    pub(crate) fn say(&self, text: &str) {
        if self.quiet {
            return;
        }
        let print = || {
            // That nobody reads standard error changes no result.
            let _ = writeln!(io::stderr(), "{text}");
        };
        match &self.bar {
            Some(Bar { bar, .. }) => bar.suspend(print),
            None => print(),
        }
    }

    /// Removes the bar, if there is one.
    pub(crate) fn close(&mut self) {
        self.bar = None;
    }
}

impl Bar {
    fn new(steps: u64) -> Self {
        let bar = ProgressBar::with_draw_target(Some(steps), ProgressDrawTarget::hidden());
        let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} {msg}")
            .expect("the template of the bar is well formed");
        bar.set_style(style);
        let (finished, wait) = mpsc::channel::<()>();
        let shown = bar.clone();
        let thread = std::thread::spawn(move || {
            if wait.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                shown.set_draw_target(ProgressDrawTarget::stderr());
                shown.enable_steady_tick(REDRAW);
            }
        });
        Self { bar, finished: Some(finished), thread: Some(thread) }
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        self.finished = None;
        if let Some(thread) = self.thread.take() {
            // The thread only waits and draws; what it might panic about is no concern of the result.
            let _ = thread.join();
        }
        self.bar.finish_and_clear();
    }
}
